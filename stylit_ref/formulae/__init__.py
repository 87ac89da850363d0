"""The mathematics of the thesis as ``@njit`` functions of one pixel or one patch.

The smallest are inlined before compilation: each separate function costs every process that
compiles a tenth of a second.
"""
