"""Make ``numba.cuda`` that of numba-cuda; import this before anything that imports it.

Otherwise Numba's own, older CUDA target would be used. numba-cuda installs a .pth file for this,
but Python does not read it after ``pip --target``.
"""

from contextlib import suppress

with suppress(ImportError):
    import _numba_cuda_redirector  # noqa: F401
