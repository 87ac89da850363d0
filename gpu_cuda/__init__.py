"""The passes as CUDA kernels on device arrays.

Each thread of a kernel handles one target patch or one pixel, with the functions of
:mod:`stylit_ref.formulae`. Kernels run on a GPU, or with ``NUMBA_ENABLE_CUDASIM=1`` in Numba's
simulator.
"""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.host.memory import download, upload, wait, zeros
from gpu_cuda.passes.borders import repeat_edge
from gpu_cuda.passes.commit import commit
from gpu_cuda.passes.energy import energy
from gpu_cuda.passes.guide_map import guide_map
from gpu_cuda.passes.guide_sums import means
from gpu_cuda.passes.occurrence import occurrence_map
from gpu_cuda.passes.patch_moments import moments_storage, patch_moments
from gpu_cuda.passes.propagation import propagation
from gpu_cuda.passes.pyramid import downsample, upsample_nnf
from gpu_cuda.passes.random_nnf import random_nnf
from gpu_cuda.passes.random_search import random_search
from gpu_cuda.passes.similarity import similarity
from gpu_cuda.passes.vote import vote

__all__ = [
    "commit",
    "download",
    "downsample",
    "energy",
    "guide_map",
    "means",
    "moments_storage",
    "occurrence_map",
    "patch_moments",
    "propagation",
    "random_nnf",
    "random_search",
    "repeat_edge",
    "similarity",
    "upload",
    "upsample_nnf",
    "vote",
    "wait",
    "zeros",
]
