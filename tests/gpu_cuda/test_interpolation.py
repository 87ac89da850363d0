"""The kernels of views between others equal the CPU's passes, bit for bit."""

import numpy as np
import pytest
from signatures import signature

import gpu_cuda.interpolation
from oracle.check import check
from oracle.compare import FAILED, PASSED
from oracle.stages.passes_port import PassesPort
from stylit_ref.views.interpolation import passes

VERSION = "interpolation/v1"


def test_names_and_signatures_mirror_the_passes():
    for name in gpu_cuda.interpolation.__all__:
        ours, theirs = getattr(gpu_cuda.interpolation, name), getattr(passes, name)
        assert signature(ours) == signature(theirs)
        if name.startswith("make_"):
            assert signature(ours(5)) == signature(theirs(5))


@pytest.mark.parametrize("stage", ["shift", "fetch", "vote", "search", "mix", "mix_shifted"])
def test_kernels_give_what_they_must(stage):
    outcomes = list(check(PassesPort(VERSION, "gpu_cuda.interpolation"), VERSION, stages=[stage]))
    assert {outcome.status for outcome in outcomes} == {PASSED}


def test_a_frame_is_the_same():
    outcomes = check(PassesPort(VERSION, "gpu_cuda.interpolation"), VERSION, stages=["frame"])
    first = next(iter(outcomes))
    assert first.status != FAILED, first.difference


def test_kernels_read_style_and_picture_of_any_stride():
    rng = np.random.default_rng(2)
    nnf = np.full((3, 4), 7 << 16 | 8, np.int32) + rng.integers(0, 3, (3, 4), np.int32)
    corners = np.empty_like(nnf)
    gpu_cuda.interpolation.find_corners(nnf, 20, 2, corners)
    np.testing.assert_array_equal(corners, 5 * 20 + (nnf & 0xFFFF) - 2)
