"""The passes of coherence: loops over a whole frame that apply the formulae."""

from stylit_ref.views.passes.fold import fold
from stylit_ref.views.passes.shift import shift_map, shift_picture

__all__ = ["fold", "shift_map", "shift_picture"]
