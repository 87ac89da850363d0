"""What a painter sees of the sphere: regions, their light, their form."""

from typing import NamedTuple

import numpy as np
from skimage.filters import gaussian


class Subject(NamedTuple):
    """The sphere's render passes as a painter reads them, all (H, W) float in [0, 1].

    Attributes
    ----------
    object, ground, wall : arrays
        1 inside each region.
    light : array
        Direct diffuse light, of each region's own brightest: 0 in the cast shadow and
        beyond the terminator.
    bounce : array
        Indirect light, of each region's own brightest.
    shine : array
        The highlight.
    form : (H, W) float
        Direction in radians along the surface, around the sphere's outline; across
        the view on ground and wall.
    """

    object: np.ndarray
    ground: np.ndarray
    wall: np.ndarray
    light: np.ndarray
    bounce: np.ndarray
    shine: np.ndarray
    form: np.ndarray

    @property
    def tone(self):
        """How bright a painter takes each place for: mostly direct light."""
        return np.clip(0.85 * self.light + 0.15 * self.bounce, 0, 1)

    @property
    def reflected(self):
        """Where bounce light shows: the less direct light, the more."""
        return self.bounce * (1 - self.light)

    @property
    def unit(self):
        """Pixels of a thin stroke: it shrinks with the picture, but not without end."""
        return max(self.light.shape[0] / 912, 0.45)


def subject(layers):
    """Read render passes of the sphere.

    Parameters
    ----------
    layers : dict of str to (H, W, n) float
        LDE, LSE, LDDE, IDMASK and NORMAL.

    Returns
    -------
    Subject
    """
    regions = np.moveaxis(layers["IDMASK"][..., :3], -1, 0)
    normal = layers["NORMAL"]
    form = np.arctan2(normal[..., 0], normal[..., 1])  # at right angles to (x, -y) on screen
    return Subject(
        *regions,
        light=_relative(layers["LDE"].max(axis=-1), regions),
        bounce=_relative(layers["LDDE"].max(axis=-1), regions),
        shine=np.clip(layers["LSE"].max(axis=-1) / 0.8, 0, 1),
        form=np.where(regions[0] > 0, form, 0.0),
    )


def _relative(light, regions):
    """Light over the brightest of its region, smooth but not across outlines."""
    result = np.zeros_like(light)
    for region in regions:
        inside = region > 0
        if inside.any():
            weight = gaussian(region, 1.0) + 1e-6
            smooth = gaussian(light * region, 1.0) / weight
            result[inside] = smooth[inside] / np.quantile(smooth[inside], 0.995)
    return np.clip(result, 0, 1)
