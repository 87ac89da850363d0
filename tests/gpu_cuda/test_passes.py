"""Every kernel equals its CPU pass, bit for bit."""

import numpy as np
import pytest
from device_level import FULL_SIZES, on_device, to_host
from signatures import signature
from small_level import make_level

import gpu_cuda
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.target_patches import make_target_patch
from gpu_cuda.variants import launched_commit, shared_memory
from stylit_ref import InputError, passes
from stylit_ref.randomness.random_stream import (
    COMMIT_ORDER,
    RANDOM_NNF,
    RANDOM_SEARCH,
    random_stream,
)

SMALL = {"source_size": (13, 17), "target_size": (14, 12)}
CASES = [
    {},
    {"uniformity": 0},
    {"patch_width": 3, "guide_channels": (1,), "style_channels": 1, "uniformity": 100000},
    {"patch_width": 7, "guide_channels": (1, 4), "guide_weights": (2.0, 0.5), "style_channels": 4},
    {"masked": np.eye(14, 12, dtype=bool), "smooth": True, "crowded": True},
    {"smooth": True, "uniformity": 200, "epsilon": 520},
    *FULL_SIZES,
]
STREAM = random_stream(7, RANDOM_SEARCH, 1, 2, 3)


def levels(**case):
    """A level on the host and the same on the device."""
    level = make_level(**(SMALL | case))
    return level, on_device(level)


def assert_same(device, host):
    np.testing.assert_array_equal(to_host(device), host)


CPU_ALONE = {
    "box_sum", "claim_errors", "count_assignments", "invert_nnf", "lose_claims",
    "propagate_claims", "replay_vote", "scanline", "search_claims", "settle_claims",
}  # fmt: skip


def test_names_mirror_the_passes():
    assert set(gpu_cuda.__all__) == set(passes.__all__) - CPU_ALONE


@pytest.mark.parametrize("name", gpu_cuda.__all__)
def test_signatures_mirror_the_passes(name):
    mirrored = signature(getattr(passes, name))
    for module in (gpu_cuda, shared_memory.passes, launched_commit.passes):
        assert signature(getattr(module, name)) == mirrored


def test_a_tile_too_large_for_shared_memory_is_one_sentence():
    with pytest.raises(InputError, match="take 59840 bytes of shared memory at patch width 13"):
        make_target_patch(MetricConstants(13, 64, 64, 0), (32, 8), shared=True)


@pytest.mark.parametrize("distance", [1, 4])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_propagation(case, distance):
    level, device = levels(**case)
    passes.propagation(*level.proposal, distance)
    gpu_cuda.propagation(*device.proposal, distance)
    assert_same(device.proposed_nnf, level.proposed_nnf)
    assert_same(device.proposed_delta, level.proposed_delta)
    assert (level.proposed_nnf != level.nnf).any()


@pytest.mark.parametrize("case", CASES, ids=str)
def test_random_search(case):
    level, device = levels(**case)
    passes.random_search(*level.proposal, STREAM)
    gpu_cuda.random_search(*device.proposal, STREAM)
    assert_same(device.proposed_nnf, level.proposed_nnf)
    assert_same(device.proposed_delta, level.proposed_delta)
    assert (level.proposed_nnf != level.nnf).any()


@pytest.mark.parametrize("block", [(8, 8), (16, 16)])
@pytest.mark.parametrize(
    ("name", "parameters"), [("propagation", (2,)), ("random_search", (STREAM, 19))]
)
@pytest.mark.parametrize("case", [CASES[0], CASES[3], CASES[5]], ids=str)
def test_shared_memory_changes_nothing(case, name, parameters, block):
    level, device = levels(**({"target_size": (19, 17)} | case))
    getattr(passes, name)(*level.proposal, *parameters)
    getattr(shared_memory.in_blocks(block, shared=True), name)(*device.proposal, *parameters)
    assert_same(device.proposed_nnf, level.proposed_nnf)
    assert_same(device.proposed_delta, level.proposed_delta)


@pytest.mark.parametrize("case", CASES, ids=str)
@pytest.mark.parametrize("module", [gpu_cuda, launched_commit.passes], ids=["one launch", "many"])
def test_commit(case, module):
    level, device = levels(**case)
    stream = random_stream(7, COMMIT_ORDER, 1, 2, 3)
    for either, proposing in ((level, passes), (device, gpu_cuda)):
        proposing.random_search(*either.proposal, STREAM)
    passes.commit(*level.commitment(stream))
    module.commit(*device.commitment(stream))
    assert level.moves[0] > 0
    for name in ("nnf", "delta", "proposed_nnf", "omega_sums", "moves"):
        assert_same(getattr(device, name), getattr(level, name))


@pytest.mark.parametrize("case", CASES, ids=str)
def test_similarity(case):
    level, device = levels(**case)
    device.delta.copy_to_device(np.zeros_like(level.delta))
    gpu_cuda.similarity(device.textures, device.patch_width, device.nnf, device.delta)
    assert_same(device.delta, level.delta)


@pytest.mark.parametrize("outliers", [0, 4])
@pytest.mark.parametrize("case", CASES, ids=str)
def test_vote(case, outliers):
    level, device = levels(**case)
    for either, module in ((level, passes), (device, gpu_cuda)):
        module.vote(
            either.textures.source, either.textures.target, either.nnf, either.patch_width,
            level.packing.style_channel, level.packing.style_channels, outliers,
        )  # fmt: skip
    assert_same(device.textures.target, level.textures.target)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_energy(case):
    level, device = levels(**case)
    assert gpu_cuda.energy(device.nnf, device.delta, device.omega_sums) == passes.energy(
        level.nnf, level.delta, level.omega_sums
    )


@pytest.mark.parametrize("case", CASES, ids=str)
def test_occurrence_map(case):
    level, device = levels(**case)
    zeros = np.zeros_like(level.omega)
    device.omega.copy_to_device(zeros + 5)
    device.omega_sums.copy_to_device(zeros + 7)
    gpu_cuda.occurrence_map(device.nnf, device.omega, device.omega_sums, device.patch_width)
    assert_same(device.omega, level.omega)
    assert_same(device.omega_sums, level.omega_sums)


@pytest.mark.parametrize("case", [{}, {"masked": np.eye(14, 12, dtype=bool)}], ids=str)
def test_random_and_upsampled_nnf(case):
    level, device = levels(**case)
    stream = random_stream(1 << 40, RANDOM_NNF, 1)
    for either, module in ((level, passes), (device, gpu_cuda)):
        module.random_nnf(either.nnf, 5, 13, 17, stream)
    assert_same(device.nnf, level.nnf)
    coarse, coarse_device = levels(target_size=(7, 6), source_size=(6, 8))
    passes.upsample_nnf(coarse.nnf, level.nnf, 5, 13, 17)
    gpu_cuda.upsample_nnf(coarse_device.nnf, device.nnf, 5, 13, 17)
    assert_same(device.nnf, level.nnf)


@pytest.mark.parametrize("size", [(14, 12), (15, 13)])
def test_downsample(size):
    level, device = levels(target_size=size)
    assert_same(
        gpu_cuda.downsample(device.textures.target), passes.downsample(level.textures.target)
    )


@pytest.mark.parametrize("patch_width", [3, 17])
def test_means_and_guide_map(patch_width):
    level, device = levels(
        patch_width=patch_width, smooth=True, epsilon=600, source_size=(19, 18), target_size=(9, 8)
    )
    for name in ("target_sums", "source_sums", "guide_map"):
        array = getattr(level.textures, name)
        getattr(device.textures, name).copy_to_device(np.zeros_like(array))
    radius = patch_width // 2
    textures = device.textures
    gpu_cuda.means(textures.source, textures.source_sums, patch_width, radius)
    gpu_cuda.means(textures.target, textures.target_sums, patch_width, 0)
    gpu_cuda.guide_map(
        textures.target,
        textures.target_sums,
        textures.weights,
        patch_width,
        600,
        textures.guide_map,
    )
    for name in ("target_sums", "source_sums", "guide_map"):
        assert_same(getattr(textures, name), getattr(level.textures, name))
