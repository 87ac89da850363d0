"""``numba.cuda`` is numba-cuda's; imported before anything that imports it.

numba-cuda installs a .pth file that sees to it, which goes unread with ``pip --target``. Without
it Numba's own, older CUDA target would be taken.
"""

from contextlib import suppress

with suppress(ImportError):
    import _numba_cuda_redirector  # noqa: F401
