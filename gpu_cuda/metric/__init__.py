"""The metric as kernels read it: words of packed channels, and the choice of the better patch."""
