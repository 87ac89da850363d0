"""Retrievals decide as PatchMatch that leaves nothing out, with source and target swapped."""

import brute_force
import numpy as np
import pytest
from small_level import make_level

from stylit_ref.formulae.candidates import (
    PROPAGATION_DISTANCES,
    propagation_candidate,
    random_candidate,
)
from stylit_ref.formulae.claim_state import LOST
from stylit_ref.metric.prefetch_patch import NEAR
from stylit_ref.passes import claim_propagation, claim_search
from stylit_ref.passes.claims import FIXED, FREE
from stylit_ref.randomness.random_stream import (
    RETRIEVAL_NNF,
    RETRIEVAL_SEARCH,
    random_stream,
    random_words,
)
from stylit_ref.stylization.stylit import Retrieval

CASES = [
    {},
    {"smooth": True, "flat_style": True},
    {"patch_width": 3, "guide_channels": (1,), "style_channels": 1},
    {"patch_width": 7, "source_size": (9, 30), "target_size": (3, 20)},
    {"masked": np.eye(14, 12, dtype=bool), "guide_channels": (3,) * 6},
    {"constant": True},
    {"source_size": (12, 39), "target_size": (11, 8), "smooth": True},
]
ROUNDS, ITERATIONS = 3, 2


class PlainRetrieval:
    """Claims in dictionaries, every candidate evaluated by the definition of δ."""

    def __init__(self, level, claims, taken):
        self.level, self.radius = level, level.patch_width // 2
        self.metric = (
            level.textures.source, level.textures.target, brute_force.weights_of(level.packing),
        )  # fmt: skip
        self.size, self.taken = claims.shape[:2], taken.copy()
        self.known = {}
        self.claims = {place: tuple(map(int, claims[place])) for place in np.ndindex(*self.size)}

    def error(self, place, claim):
        """δ of a source patch with a target patch."""
        if (place, claim) not in self.known:
            source = (v + self.radius for v in place)
            self.known[place, claim] = brute_force.delta(
                *self.metric, self.level.patch_width, *claim, *source
            )
        return self.known[place, claim]

    def cost(self, place, claim):
        """Any free target patch is better than all fixed ones."""
        return self.taken[claim] != FREE, self.error(place, claim)

    def offer(self, candidates_of):
        """Every source patch takes its best candidate; of equals the first, its own before."""
        self.claims = {
            place: min(
                [claim, *candidates_of(place, claim)], key=lambda other: self.cost(place, other)
            )
            for place, claim in self.claims.items()
        }

    def propagate(self, distance):
        def candidates_of(place, _):
            for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
                near = place[0] + dy, place[1] + dx
                if near in self.claims:
                    yield propagation_candidate(*self.claims[near], dy, dx, 0, *self.taken.shape)

        self.offer(candidates_of)

    def search(self, stream):
        def candidates_of(place, claim):
            reach, k = 1, 0
            while reach <= max(self.taken.shape) // 2:
                words = random_words(stream, place[0] * self.size[1] + place[1], k // 2)
                pair = words[2 * (k % 2) : 2 * (k % 2) + 2]
                yield random_candidate(*pair, *claim, reach, 0, *self.taken.shape)
                reach, k = 2 * reach, k + 1

        self.offer(candidates_of)


def assert_same(retrieval, plain):
    """Claims and their errors, and who has lost a claim."""
    for place, claim in plain.claims.items():
        assert tuple(retrieval.claims[place]) == claim
        assert retrieval.errors[place] == plain.error(place, claim)
    lost = retrieval.taken[tuple(retrieval.claims.T)].T != FREE
    np.testing.assert_array_equal(retrieval.states >= LOST, lost)


@pytest.mark.parametrize(("share", "near"), [(0.3, NEAR), (0.9, 0)])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_claims_are_those_of_the_plain_search(case, share, near, monkeypatch):
    """Over several retrievals, since the passes remember what they have looked at."""
    for module in (claim_propagation, claim_search):
        monkeypatch.setattr(module, "NEAR", near)
    level = make_level(uniformity=0, **case)
    level.update_moments()
    retrieval = Retrieval(level, random_stream(4, RETRIEVAL_NNF, 1, 1))
    plain = PlainRetrieval(level, retrieval.claims, retrieval.taken)
    assert_same(retrieval, plain)
    rng = np.random.default_rng(5)
    for number in range(ROUNDS):
        for iteration in range(ITERATIONS):
            stream = random_stream(4, RETRIEVAL_SEARCH, 1, 1, ITERATIONS * number + iteration)
            retrieval.improve(stream)
            for distance in PROPAGATION_DISTANCES:
                plain.propagate(distance)
            plain.search(stream)
            assert_same(retrieval, plain)
        fixed = rng.random(plain.taken.shape) < share
        retrieval.taken[fixed] = plain.taken[fixed] = FIXED
        level.passes.lose_claims(retrieval.claims, retrieval.taken, retrieval.states)


def test_all_claims_are_lost_when_everything_is_fixed():
    level = make_level(uniformity=0)
    retrieval = Retrieval(level, random_stream(4, RETRIEVAL_NNF, 1, 1))
    retrieval.taken[:] = FIXED
    level.passes.lose_claims(retrieval.claims, retrieval.taken, retrieval.states)
    before = retrieval.errors.copy()
    retrieval.improve(random_stream(4, RETRIEVAL_SEARCH, 1, 1, 1))
    assert (retrieval.states >= LOST).all()
    assert (retrieval.errors <= before).all()
    assert (retrieval.errors < before).any()
