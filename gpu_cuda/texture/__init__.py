"""Texture synthesis: the dynamic programming of section 7 (Lasram & Lefebvre 2012), in blocks."""

import gpu_cuda.host.redirection  # noqa: F401
from gpu_cuda.host.memory import download, upload, zeros
from gpu_cuda.texture.best_cuts import best_cuts

__all__ = ["best_cuts", "download", "upload", "zeros"]
