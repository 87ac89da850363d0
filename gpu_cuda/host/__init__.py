"""Run kernels on the device: memory, launches, compilation."""
