"""Every kernel as PTX, for a device that need not be there.

What the simulator cannot know shows here: types that do not fit and, once ``ptxas`` has seen
it, registers, shared memory and spills.
"""

from importlib import import_module
from types import SimpleNamespace
from unittest import mock

from numba import cuda, types

from gpu_cuda.metric import MetricConstants
from gpu_cuda.variants import live

CAPABILITIES = ((7, 5), (9, 0))
BLOCKS = (32, 8), (32, 32)
"""Threads of a block along x and y: the default, and the thesis' (4.1)."""

_IMAGE, _SUMS = types.uint8[:, :, ::1], types.uint16[:, :, ::1]
_WORDS, _MAP, _WHITE = types.uint32[::1], types.int32[:, ::1], types.boolean[:, ::1]
_NNF, _DELTA = types.int32[:, :, ::1], types.int64[:, ::1]
_INT, _STREAM = types.int64, types.UniTuple(types.uint32, 4)
_METRIC = _WORDS, _WORDS, _WORDS, _WHITE, _SUMS, _SUMS
_SEARCH = *_METRIC, _MAP, _INT, _NNF, _DELTA, _NNF, _DELTA


def kernels(block, patch_width=5, channels=32, style_channels=3, guide_channels=16):
    """Name, kernel and argument types of every kernel, at the thesis' sizes by default."""
    part = {name.rpartition(".")[2]: import_module(f"gpu_cuda.{name}") for name in _MODULES}
    weighted_channels = guide_channels + style_channels + style_channels % 2
    plain = MetricConstants(patch_width, channels, weighted_channels, 0)
    with_map = plain._replace(mean_channels=guide_channels)
    for name, parameters in (("propagation", (_INT,)), ("random_search", (_STREAM, _INT))):
        make_kernel, arguments = part[name].make_kernel, (*_SEARCH, *parameters)
        yield name, make_kernel(plain, block), arguments
        yield f"{name}, shared", make_kernel(plain, block, True), arguments
        yield f"{name}, guide map", make_kernel(with_map, block), arguments
    for with_sums, name in ((False, "Ω"), (True, "W")):
        propagation, random_search = live.make_kernels(plain, with_sums)
        arguments = *_METRIC, _MAP, _INT, _NNF
        yield f"live propagation, {name}", propagation, (*arguments, _NNF, _INT)
        yield f"live random search, {name}", random_search, (*arguments, _STREAM, _INT)
    commit = _NNF, _DELTA, _NNF, _DELTA, _MAP, _INT, _STREAM, types.int64[::1]
    yield "commit", part["commit"].make_kernel(patch_width), commit
    launched = part["launched_commit"]
    class_start = _INT, _INT
    decided = *commit[:-2], *class_start, types.int64[::1]
    yield "launched commit, decide", launched.decide_kernel, decided
    follow = launched.make_follow_kernel(patch_width)
    yield "launched commit, follow", follow, (_NNF, _NNF, _MAP, *class_start)
    for outliers in (0, 4):
        vote = part["vote"].make_kernel(patch_width, style_channels, outliers)
        name = "vote, 4 outliers left out" if outliers else "vote"
        yield name, vote, (_IMAGE, _IMAGE, _NNF, _INT)
    yield "repeat edge", part["vote"].repeat_edge_kernel, (_IMAGE, _INT, _INT, _INT)
    for constants, name in ((plain, "similarity"), (with_map, "similarity, guide map")):
        yield name, part["similarity"].make_kernel(constants), (*_METRIC, _INT, _NNF, _DELTA)
    yield "means", part["guide_sums"].means_kernel, (_IMAGE, _SUMS, _INT, _INT)
    guide_map = _IMAGE, _SUMS, types.int64[::1], _INT, _INT, _WHITE
    yield "guide map", part["guide_map"].guide_map_kernel, guide_map
    yield "downsample", part["pyramid"].downsample_kernel, (_IMAGE, _IMAGE)
    yield "upsample NNF", part["pyramid"].upsample_nnf_kernel, (_NNF, _NNF, _INT, _INT, _INT)
    yield "random NNF", part["random_nnf"].random_nnf_kernel, (_NNF, _INT, _INT, _INT, _STREAM)
    yield "fill", part["memory"].fill_kernel, (types.int32[::1], _INT)
    yield "count assignments", part["occurrence"].count_kernel, (_NNF, _MAP)
    yield "box sum", part["occurrence"].make_box_sum_kernel(patch_width), (_MAP, _MAP)
    yield "energy", part["energy"].sum_columns_kernel, (_NNF, _DELTA, _MAP, types.int64[:, ::1])
    yield "pad", part["memory"].repeat_edge_kernel, (_IMAGE, _IMAGE, _INT)


_MODULES = (
    "commit", "energy", "guide_map", "guide_sums", "host.memory", "occurrence", "propagation",
    "pyramid", "random_nnf", "random_search", "similarity", "variants.launched_commit", "vote",
)  # fmt: skip


def compile_to_ptx(kernel, arguments, capability):
    """PTX of a kernel for a compute capability, whatever device there is."""
    # Numba compiles the functions that a kernel calls for the current device: name one.
    device = SimpleNamespace(compute_capability=capability)
    with mock.patch("numba.cuda.dispatcher.get_current_device", return_value=device):
        ptx, _ = cuda.compile(
            kernel.py_func, types.void(*arguments), cc=capability, device=False, abi="numba"
        )
    return ptx
