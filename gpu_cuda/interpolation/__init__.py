"""Views between views: shifting, votes, the limited search and mixes, with a thread for each pixel.

Arrays may be the device's or the host's. Those of the host are copied there and back by every pass.
What a mesh or points show is found on the CPU; in a viewer the GPU's own rasterizer finds it.
"""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.interpolation.limited import make_limited_search
from gpu_cuda.interpolation.mix import mix, mix_shifted
from gpu_cuda.interpolation.shift import fetch, shift
from gpu_cuda.interpolation.vote import find_corners, make_vote

__all__ = [
    "fetch",
    "find_corners",
    "make_limited_search",
    "make_vote",
    "mix",
    "mix_shifted",
    "shift",
]
