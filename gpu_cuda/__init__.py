"""The passes as CUDA kernels, file for file, on device arrays.

A kernel handles one target patch, or one pixel, a thread; what it computes is called from
:mod:`stylit_ref.formulae`. Kernels run on a GPU, or with ``NUMBA_ENABLE_CUDASIM=1`` in Numba's
simulator.
"""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.borders import repeat_edge
from gpu_cuda.commit import commit
from gpu_cuda.energy import energy
from gpu_cuda.guide_map import guide_map
from gpu_cuda.guide_sums import means
from gpu_cuda.host.memory import download, upload, wait, zeros
from gpu_cuda.occurrence import occurrence_map
from gpu_cuda.patch_moments import moments_storage, patch_moments
from gpu_cuda.propagation import propagation
from gpu_cuda.pyramid import downsample, upsample_nnf
from gpu_cuda.random_nnf import random_nnf
from gpu_cuda.random_search import random_search
from gpu_cuda.similarity import similarity
from gpu_cuda.vote import vote

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
