"""The passes as CUDA kernels, file for file. No kernels yet."""
