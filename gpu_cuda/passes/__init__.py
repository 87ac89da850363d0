"""The passes of :mod:`stylit_ref.passes`, file for file; :mod:`gpu_cuda` offers them."""
