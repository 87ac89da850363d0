"""The passes of :mod:`stylit_ref.passes` as kernels, in files of the same names."""
