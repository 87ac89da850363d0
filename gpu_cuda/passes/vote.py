"""Voting: target pixels from the source patches that cover them (Kernel_Vote, thesis 3.4)."""

from functools import lru_cache

import numpy as np
from numba import cuda

from gpu_cuda.formulae import distance_from_mean, rounded_mean, voted_pixel, votes_kept
from gpu_cuda.host.argument_types import IMAGE, INT, NNF
from gpu_cuda.host.device import launch
from gpu_cuda.passes.borders import repeat_own_edge


@lru_cache
def make_kernel(patch_width, style_channels, outliers):
    """Compile Kernel_Vote; ``outliers`` votes farthest from the mean do not count."""
    radius = patch_width // 2
    most = patch_width * patch_width if outliers else 1

    @cuda.jit
    def vote_kernel(source, target, nnf, style_channel):
        x, y = cuda.grid(2)
        height, width = nnf.shape[0], nnf.shape[1]
        if y >= height or x >= width:
            return
        totals = cuda.local.array(style_channels, np.int32)
        for c in range(style_channels):
            totals[c] = 0
        votes = 0
        for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
            for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                if nnf[near_y, near_x, 0] < 0:
                    continue
                source_y, source_x = voted_pixel(nnf, y, x, near_y, near_x)
                for c in range(style_channels):
                    totals[c] += source[source_y, source_x, style_channel + c]
                votes += 1
        kept = votes_kept(votes, outliers)
        if kept < votes:
            distances = cuda.local.array(most, np.int64)
            vote = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] < 0:
                        continue
                    source_y, source_x = voted_pixel(nnf, y, x, near_y, near_x)
                    distances[vote] = 0
                    for c in range(style_channels):
                        value = np.int64(source[source_y, source_x, style_channel + c])
                        distances[vote] += distance_from_mean(value, totals[c], votes)
                    vote += 1
            for _ in range(votes - kept):
                farthest = 0
                for vote in range(1, votes):
                    if distances[vote] > distances[farthest]:
                        farthest = vote
                distances[farthest] = -1
            vote = 0
            for near_y in range(max(y - radius, 0), min(y + radius + 1, height)):
                for near_x in range(max(x - radius, 0), min(x + radius + 1, width)):
                    if nnf[near_y, near_x, 0] < 0:
                        continue
                    if distances[vote] < 0:
                        source_y, source_x = voted_pixel(nnf, y, x, near_y, near_x)
                        for c in range(style_channels):
                            totals[c] -= source[source_y, source_x, style_channel + c]
                    vote += 1
        for c in range(style_channels):
            target[radius + y, radius + x, style_channel + c] = rounded_mean(totals[c], kept)

    return vote_kernel


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    arguments = IMAGE, IMAGE, NNF, INT
    yield "vote", make_kernel(sizes.patch_width, sizes.style_channels, 0), arguments
    some_left_out = make_kernel(sizes.patch_width, sizes.style_channels, 4)
    yield "vote, 4 outliers left out", some_left_out, arguments


def vote(source, target, nnf, patch_width, style_channel, style_channels, outliers=0):
    """As :func:`stylit_ref.passes.vote`, on device arrays."""
    kernel = make_kernel(patch_width, style_channels, outliers)
    launch(kernel, nnf.shape[:2], source, target, nnf, style_channel)
    repeat_own_edge(target, patch_width // 2, style_channel, style_channels)
