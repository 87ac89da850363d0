"""The printed numbers of the thesis (4.1.2), and those of the program that ours is shown beside."""

SECONDS_OF_A_FRAME = 312
"""StyLit with the changes of 2.4, 600x500, six votes, six PatchMatch iterations, one core."""

SECONDS_IN_PARALLEL = 61
"""The same on six cores, several frames at once."""

DEGREES = 20
"""Rotation from the painted view up to which the style is transferred well (2.4.2)."""
