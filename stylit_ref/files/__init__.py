"""Read and write files: images of any bit depth, and nearest-neighbour fields."""
