"""Everything about the machine: compiled kernels, vector code, signals, timing."""
