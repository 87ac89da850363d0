"""Motion between frames: from the vectors of any program to the canonical field of an edge.

The canonical field is :class:`stylit_ref.views.frames.Motion`: of the destination frame's pixels,
in pixels, x to the right and y downwards, added to a pixel it leads into the other frame.
"""
