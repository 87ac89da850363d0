"""Loops over whole images and grids; ``make_*`` build those that depend on a pixel's bytes."""

from stylit_ref.realtime.passes.blend import make_blend
from stylit_ref.realtime.passes.border import make_extend
from stylit_ref.realtime.passes.dense_finish import make_dense_nnf, make_vote
from stylit_ref.realtime.passes.fill import make_fill
from stylit_ref.realtime.passes.moving import mark_moving
from stylit_ref.realtime.passes.pyramid import (
    decimate_labels,
    free_lost_labels,
    make_halve,
    mark_labels,
)
from stylit_ref.realtime.passes.records import make_box_records, make_mip_records
from stylit_ref.realtime.passes.renewal import make_renew
from stylit_ref.realtime.passes.search import make_search
from stylit_ref.realtime.passes.style_lanes import make_insert_style
from stylit_ref.realtime.passes.upsample import random_nnf, upsample_nnf, upsample_picture

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
