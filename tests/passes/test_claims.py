"""Claims of source patches, against plain Python."""

import numpy as np
import pytest

from stylit_ref.passes.claims import CLAIMED, FIXED, FREE, invert_nnf, settle_claims

RADIUS, PATCH_WIDTH = 2, 5
SOURCE, TARGET = (7, 9), (6, 8)
NO_LIMIT = np.iinfo(np.int64).max


def claims_and_errors(seed):
    """Claims to few places, with errors that often are equal."""
    rng = np.random.default_rng(seed)
    claims = np.stack([rng.integers(0, 3, SOURCE), rng.integers(1, 6, SOURCE)], axis=2)
    return claims.astype(np.int32), rng.integers(0, 6, SOURCE)


def expected_settlement(claims, errors, within, most, taken):
    """The closest claims, in order; a target patch keeps the first that it accepts."""
    order = sorted(
        (int(errors[y, x]), y, x)
        for y, x in np.ndindex(*SOURCE)
        if taken[tuple(claims[y, x])] == FREE
    )
    settled = {}
    for error, y, x in order[:within]:
        place = tuple(map(int, claims[y, x]))
        if error <= most[place]:
            settled.setdefault(place, (error, y + RADIUS, x + RADIUS))
    return settled


@pytest.mark.parametrize("within", [1, 5, 13, 30])
@pytest.mark.parametrize("limited", [False, True])
@pytest.mark.parametrize("seed", [0, 1])
def test_claims_are_settled_from_the_closest_on(seed, limited, within):
    claims, errors = claims_and_errors(seed)
    most = np.full(TARGET, NO_LIMIT)
    if limited:
        most = np.random.default_rng(9).integers(0, 4, TARGET)
    taken = np.full(TARGET, FREE, np.uint8)
    taken[1, 2] = FIXED
    nnf, delta = np.full((*TARGET, 2), 77, np.int32), np.full(TARGET, -1)
    expected = expected_settlement(claims, errors, within, most, taken)
    candidates = np.sort(errors[taken[claims[:, :, 0], claims[:, :, 1]] == FREE])
    last = candidates[within - 1]
    settle_claims(
        claims, errors, last, within - np.searchsorted(candidates, last),
        most, taken, PATCH_WIDTH, nnf, delta,
    )  # fmt: skip
    for place in np.ndindex(*TARGET):
        if place in expected:
            assert (delta[place], *nnf[place]) == expected[place]
            assert taken[place] == CLAIMED
        else:
            assert (delta[place], *nnf[place]) == (-1, 77, 77)
            assert taken[place] == (FIXED if place == (1, 2) else FREE)
    assert expected


def test_an_inverse_holds_the_closest_target_patch():
    rng = np.random.default_rng(3)
    nnf = (rng.integers(0, 3, (*TARGET, 2)) + RADIUS).astype(np.int32)
    nnf[1, 2:5] = -1
    delta = rng.integers(0, 5, TARGET)
    inverse, inverse_delta = np.full((*SOURCE, 2), 50, np.int32), np.full(SOURCE, 3)
    invert_nnf(nnf, delta, PATCH_WIDTH, inverse, inverse_delta)
    changed = 0
    for y, x in np.ndindex(*SOURCE):
        assigned = [
            (int(delta[place]), *place)
            for place in np.ndindex(*TARGET)
            if tuple(nnf[place]) == (y + RADIUS, x + RADIUS) and delta[place] < 3
        ]
        error, *place = min(assigned, default=(3, 50, 50))
        assert inverse_delta[y, x] == error
        assert inverse[y, x].tolist() == place
        changed += bool(assigned)
    assert changed >= 7
