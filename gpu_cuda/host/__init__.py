"""What stands between the kernels and the device: memory, launches, compilation."""
