"""Views and sequences: the passes of coherence, with a thread for each pixel.

Arrays may be the device's or the host's. Those of the host are copied there and back by every pass.
"""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.views.cancel import cancel
from gpu_cuda.views.fold import fold
from gpu_cuda.views.shift import shift_map, shift_picture
from gpu_cuda.views.silhouettes import find_rims, take_nearer
from gpu_cuda.views.splat import find_beaten, splat

__all__ = [
    "cancel",
    "find_beaten",
    "find_rims",
    "fold",
    "shift_map",
    "shift_picture",
    "splat",
    "take_nearer",
]
