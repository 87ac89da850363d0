"""The passes of views between those of a grid: loops over a whole picture."""

from stylit_ref.views.interpolation.passes.clip import clip
from stylit_ref.views.interpolation.passes.closest import find_closest
from stylit_ref.views.interpolation.passes.follow import follow
from stylit_ref.views.interpolation.passes.limited import make_limited_search
from stylit_ref.views.interpolation.passes.mix import mix, mix_shifted
from stylit_ref.views.interpolation.passes.move import move
from stylit_ref.views.interpolation.passes.rasterize import rasterize
from stylit_ref.views.interpolation.passes.shift import fetch, shift
from stylit_ref.views.interpolation.passes.splat import fill_holes, splat_points
from stylit_ref.views.interpolation.passes.transfer import transfer
from stylit_ref.views.interpolation.passes.vote import find_corners, make_vote

__all__ = [
    "clip",
    "fetch",
    "fill_holes",
    "find_closest",
    "find_corners",
    "follow",
    "make_limited_search",
    "make_vote",
    "mix",
    "mix_shifted",
    "move",
    "rasterize",
    "shift",
    "splat_points",
    "transfer",
]
