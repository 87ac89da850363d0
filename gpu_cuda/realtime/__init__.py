"""Stylization in real time: the passes of the library, with a thread for each pixel or entry.

Arrays may be the device's or the host's. Those of the host are copied there and back by every pass:
a session runs with these passes as it is, exact but slow.
"""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.realtime.blend import make_blend
from gpu_cuda.realtime.dense_finish import make_dense_nnf, make_vote
from gpu_cuda.realtime.labels import decimate_labels, free_lost_labels, mark_labels
from gpu_cuda.realtime.moving import mark_moving
from gpu_cuda.realtime.pixels import make_extend, make_fill, make_insert_style
from gpu_cuda.realtime.pyramid import make_halve
from gpu_cuda.realtime.records import make_box_records, make_mip_records
from gpu_cuda.realtime.renewal import make_renew
from gpu_cuda.realtime.search import make_search
from gpu_cuda.realtime.upsample import random_nnf, upsample_nnf, upsample_picture

__all__ = [
    "decimate_labels",
    "free_lost_labels",
    "make_blend",
    "make_box_records",
    "make_dense_nnf",
    "make_extend",
    "make_fill",
    "make_halve",
    "make_insert_style",
    "make_mip_records",
    "make_renew",
    "make_search",
    "make_vote",
    "mark_labels",
    "mark_moving",
    "random_nnf",
    "upsample_nnf",
    "upsample_picture",
]
