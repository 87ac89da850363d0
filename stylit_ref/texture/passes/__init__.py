"""The passes: loops over a patch or the whole of S that apply the formulae."""

from stylit_ref.passes import download, upload, zeros
from stylit_ref.texture.passes.best_cuts import best_cuts

__all__ = ["best_cuts", "download", "upload", "zeros"]
