"""Motion fields between two views, with what the other one does not see."""

import numpy as np

from data_gen.models.mesh import rotation
from data_gen.visibility import sees


def motion_field(rendered, surface, other):
    """Where each pixel's point appears to another camera (forward motion).

    Parameters
    ----------
    rendered : mitsuba.Scene
        What the other camera looks at.
    surface : Surface
        What the first camera sees, moved to where it is for the other one.
    other : Camera

    Returns
    -------
    motion : (H, W, 2) float32
        (x, y) in pixels, to be added to the pixel's own; 0 where there is no surface.
    visible : (H, W, 1) float32
        1 where the other camera sees the same point, inside its image.
    """
    height, width = surface.part.shape
    seen = surface.part >= 0
    own = np.stack(np.mgrid[:height, :width], axis=-1)
    motion = other.project(surface.position, height, width) - own
    motion[~seen] = 0
    there = own + motion
    inside = ((there >= -0.5) & (there <= (height - 0.5, width - 0.5))).all(axis=-1)
    eye = np.asarray(other.origin)
    unhidden = sees(rendered, surface.position, surface.normal, eye)
    visible = seen & inside & unhidden
    return motion[..., ::-1].astype(np.float32), visible[..., None].astype(np.float32)


def turned_with(surface, part, degrees):
    """A surface after a part of the scene has turned about the y axis.

    Parameters
    ----------
    surface : Surface
    part : int
        Number of the part.
    degrees : float

    Returns
    -------
    Surface
        Each point where the same pixel's point has gone.
    """
    turns, turn = (surface.part == part)[..., None], rotation(degrees).T
    return surface._replace(
        position=np.where(turns, surface.position @ turn, surface.position),
        normal=np.where(turns, surface.normal @ turn, surface.normal),
    )
