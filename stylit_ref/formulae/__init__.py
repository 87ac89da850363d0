"""One pixel or one patch each: the mathematics of the thesis as ``@njit`` functions.

The smallest are inlined before anything is compiled: a function of its own costs the compiler a
tenth of a second in each process that compiles.
"""
