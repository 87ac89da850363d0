"""The passes of coherence: loops over a whole frame that apply the formulae."""

from stylit_ref.views.passes.cancel import cancel
from stylit_ref.views.passes.fold import fold
from stylit_ref.views.passes.shift import shift_map, shift_picture
from stylit_ref.views.passes.silhouettes import find_rims, take_nearer
from stylit_ref.views.passes.splat import find_beaten, splat

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
