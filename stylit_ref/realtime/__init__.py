"""Stylization in real time on a CPU (Heidrich 2017): a sparse grid of patches, blended."""
