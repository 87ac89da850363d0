"""What a processor needs and a formula does not say: compiled kernels, vectors, signals, clocks."""
