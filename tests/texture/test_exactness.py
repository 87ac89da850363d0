"""What iterations say they did is what they did: costs, locks, seeds, threads."""

import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from texture.small_exemplars import blobs, stripes

from stylit_ref.texture.formulae.guide_cost import fixed_guide_weight
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

SMALL = TextureParams(radius=8, iterations=6)


def recounted(session, guide_weight=0.0, guides=None):
    """The cost of S from its coordinates, in NumPy: section 4 for every edge."""
    images = [image.astype(np.int64) for image in session.exemplars.images]
    assert len(images) == 1
    shown = session.exemplars.colours
    addresses = session.exemplars.addresses(session.coordinates).astype(np.int64)

    def colours(at):
        packed = shown[at]
        return np.stack([packed >> shift & 255 for shift in (0, 8, 16)], -1).astype(np.int64)

    def squared(a, b):
        return ((a - b) ** 2).sum(axis=-1)

    total = 0
    for axis, step in ((1, 1), (0, session.exemplars.stride)):
        there = np.roll(addresses, -1, axis)
        here_colours, after = colours(addresses), colours(addresses + step)
        there_colours, before = colours(there), colours(there - step)
        differences = squared(here_colours, before) + squared(there_colours, after)
        gradients = squared(here_colours, after) + squared(there_colours, before)
        eta = session.params.eta
        quotient = differences.astype(np.float32) / (eta + gradients).astype(np.float32)
        power = {1: quotient, 2: quotient * quotient, 3: quotient * quotient * quotient}
        cost = power[session.params.exponent] * np.float32(256)
        total += int(np.minimum(cost, np.float32(1 << 24)).astype(np.int64).sum())
    if guides is not None:
        source, target = guides
        y, x = session.coordinates[..., 1], session.coordinates[..., 2]
        difference = source[y // 4, x // 4].astype(np.int64) - target
        weight = fixed_guide_weight(guide_weight)
        total += int((3 * difference**2 * weight >> 16).sum())
    return total


@settings(max_examples=25, deadline=None)
@given(
    seed=st.integers(0, 2**64 - 1),
    height=st.integers(1, 50),
    width=st.integers(1, 50),
    channels=st.sampled_from([1, 3]),
    deformation=st.sampled_from([0, 6]),
    predicate=st.sampled_from(["exact", "after", "before", "none"]),
    locked=st.booleans(),
)
def test_the_running_total_is_a_recount(
    seed, height, width, channels, deformation, predicate, locked
):
    params = TextureParams(
        radius=8, max_deformation=deformation, predicate=predicate, eta=300, candidates=4
    )
    rng = np.random.default_rng(seed % 1000)
    lock = rng.random((height, width)) < 0.3 if locked else None
    session = TextureSession(
        [blobs(channels=channels)], (height, width), params, seed=seed, lock=lock
    )
    before = session.coordinates
    for _ in range(3):
        session.step()
        assert session.cost == session.recount() == recounted(session)
    if locked:
        np.testing.assert_array_equal(session.coordinates[lock], before[lock])


@pytest.mark.parametrize("image", [blobs(), stripes()], ids=["blobs", "stripes"])
@pytest.mark.parametrize("deformation", [0, 8])
@pytest.mark.parametrize("exponent", [1, 2, 3])
def test_the_cost_never_rises_and_patches_are_accepted(image, deformation, exponent):
    params = TextureParams(radius=8, max_deformation=deformation, exponent=exponent)
    session = TextureSession([image], (70, 90), params)
    costs, accepted = [session.cost], 0
    for _ in range(8):
        accepted += session.step().accepted
        costs.append(session.cost)
    assert accepted > 20
    assert costs == sorted(costs, reverse=True)
    assert costs[-1] < costs[0] // 20


def test_every_accepted_patch_lowers_the_cost_by_itself():
    """One cell: the change of the total is that of its patch."""
    session = TextureSession([blobs()], (16, 16), TextureParams(radius=8))
    changes = []
    for _ in range(20):
        before = session.cost
        if session.step().accepted:
            changes.append(session.cost - before)
    assert len(changes) > 3
    assert max(changes) < 0


def test_deformed_patches_are_accepted_and_recounted():
    params = TextureParams(radius=12, max_deformation=16, predicate="none", candidates=1)
    session = TextureSession([stripes()], (72, 72), params)
    deformed = sum(session.step().deformed for _ in range(10))
    assert deformed > 5
    assert session.cost == recounted(session)
    assert (session.coordinates[..., 1:] % 4 != 0).any()


def test_whole_pixels_are_whole():
    params = TextureParams(
        radius=12, max_deformation=16, predicate="none", candidates=1, whole_pixels=True
    )
    session = TextureSession([stripes()], (72, 72), params)
    assert sum(session.step().deformed for _ in range(6)) > 0
    assert (session.coordinates[..., 1:] % 4 == 0).all()
    assert session.cost == recounted(session)


def test_a_guide_counts_and_is_followed():
    image, size = blobs(), (64, 64)
    source = np.linspace(0, 255, image.shape[1]).astype(np.uint8)[None].repeat(image.shape[0], 0)
    target = np.linspace(0, 255, 64).astype(np.uint8)[None].repeat(64, 0)
    guided = {"source_guides": [source], "target_guide": target}
    misses = []
    for weight in (0.0, 30.0):
        params = TextureParams(radius=8, guide_weight=weight)
        session = TextureSession([image], size, params, **guided)
        for _ in range(12):
            before = session.cost
            session.step()
            assert session.cost <= before
        assert session.cost == recounted(session, weight, (source, target.astype(np.int64)))
        shown = source[0, session.coordinates[..., 2] // 4].astype(int)
        misses.append(abs(shown - target).mean())
    assert misses[1] < misses[0] / 2


def test_a_guide_of_weight_0_changes_nothing():
    image = blobs()
    guide = image[..., 0]
    params = TextureParams(radius=8, guide_weight=0.0)
    plain = TextureSession([image], (48, 48), params)
    guided = TextureSession(
        [image], (48, 48), params, source_guides=[guide], target_guide=np.zeros((48, 48), np.uint8)
    )
    for _ in range(4):
        assert plain.step() == guided.step()
    np.testing.assert_array_equal(plain.coordinates, guided.coordinates)


def test_a_run_resumes():
    whole = TextureSession([blobs()], (60, 60), SMALL, seed=5)
    for _ in range(3):
        whole.step()
    resumed = TextureSession([blobs()], (60, 60), SMALL, seed=5, start=whole.coordinates)
    resumed.iteration = whole.iteration
    assert resumed.cost == whole.cost
    for _ in range(3):
        assert whole.step() == resumed.step()
    np.testing.assert_array_equal(whole.coordinates, resumed.coordinates)


def test_parameters_may_change_between_iterations():
    session = TextureSession([blobs()], (60, 60), SMALL)
    session.step()
    steps = (
        TextureParams(radius=12),  # needs a wider border around the exemplar
        TextureParams(radius=12, max_deformation=8),  # needs fractions of a pixel
        TextureParams(radius=5, eta=50, exponent=1),
        TextureParams(radius=5, max_jump=3, radial_samples=1.0, weighting="printed"),
    )
    for params in steps:
        shown = session.image
        session.step(params)
        assert session.image.shape == shown.shape
        assert session.cost == session.recount() == recounted(session)


@pytest.mark.slow
def test_any_number_of_threads_and_chunks_gives_the_same():
    program = """
import sys, hashlib, numba
sys.path.insert(0, "tests")
from texture.small_exemplars import blobs
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession
digests = set()
for threads in (1, 2, 3, 7):
    for chunk in (0, 1, 5):
        numba.set_num_threads(threads)
        numba.set_parallel_chunksize(chunk)
        params = TextureParams(radius=8, max_deformation=6, tries=2, coherence=0.3)
        session = TextureSession([blobs()], (120, 110), params, seed=3)
        costs = [session.step().cost for _ in range(5)]
        digest = hashlib.sha256(session.coordinates.tobytes()).hexdigest()
        digests.add((digest, tuple(costs)))
print(len(digests), session.iteration)
"""
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True,
        env={**os.environ, "NUMBA_NUM_THREADS": "7"},
    )  # fmt: skip
    assert done.stdout.split() == ["1", "5"], done.stderr


def test_other_seeds_give_other_textures():
    textures = set()
    for seed in (0, 1, 2**63):
        session = TextureSession([blobs()], (40, 40), SMALL, seed=seed)
        session.step()
        textures.add(session.coordinates.tobytes())
    assert len(textures) == 3
