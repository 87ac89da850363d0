"""One pixel or one patch each: the mathematics of the thesis as ``@njit`` functions."""
