"""Small textures and exemplars with awkward contents, from which the cases are cut."""

import numpy as np

from stylit_ref.texture.exemplars import make_exemplars, packed_planes
from stylit_ref.texture.formulae.guide_cost import fixed_guide_weight
from stylit_ref.texture.formulae.polar import cost_limits, make_polar

PLACE = {"seed": 0x1234567890ABCDEF, "iteration": 3}
"""The point of a run whose random numbers the cases use."""


COSTS = "cut_x", "cut_y", "cut_cosine", "cut_sine", "cut_weight"
STEPS = "step_x", "step_y", "step_cosine", "step_sine", "step_weight"
BENDING = "cosine", "sine"
RASTER = "border", "radius_at", "angle_at"
POLAR = *COSTS, *STEPS, "inside", "area", *BENDING, *RASTER
"""The tables of T that stages read; all but the half widths, which are integers anyway."""


def pictures(rng, sizes, channels, holes, contrast=False):
    """Images ``image_1`` and so on; with ``holes`` all have some pixels that are not known."""
    arrays = {}
    for k, size in enumerate(sizes, 1):
        ramp = np.add.outer(np.arange(size[0]) * 9, np.arange(size[1]) * 6)[:, :, None]
        image = (ramp + rng.integers(0, 60, (*size, channels))).astype(np.uint8)
        if contrast:
            image = np.where(rng.random(image.shape) < 0.5, 0, 255).astype(np.uint8)
        arrays[f"image_{k}"] = image
        if holes:
            known = np.ones(size, np.bool_)
            known[size[0] // 2, : size[1] // 3] = False
            arrays[f"known_{k}"] = known
    return arrays


class Patch:
    """A place in a texture, a place in an exemplar, and all that a patch is made with there.

    S is made of pieces of the exemplars, so that there are seams of all sorts, and none.
    """

    def __init__(
        self, number, images=((14, 15),), channels=3, size=(18, 21), radius=4, radial_samples=2.0,
        angular_samples=1.5, weighting="arc_length", max_jump=4, exponent=2, eta=1000,
        fractions=False, locked=False, guide_weight=0.0, holes=False, at_edge=False,
        contrast=False, flat=False, split=False,
    ):  # fmt: skip
        rng = np.random.default_rng(number)
        self.pictures = pictures(rng, images, channels, holes, contrast)
        if flat:
            self.pictures["image_1"][:] = 90
        if split:
            self.pictures["image_1"][:] = np.where(np.arange(images[0][1]) < 7, 0, 255)[:, None]
        shown = [self.pictures[f"image_{k}"] for k in range(1, len(images) + 1)]
        known = [self.pictures[f"known_{k}"] for k in range(1, len(images) + 1)] if holes else None
        made = make_exemplars(shown, radius, known=known, fractions=fractions)
        polar = make_polar(radius, radial_samples, angular_samples, weighting)
        valid = made.clearance > 0
        self.arrays = {name: getattr(polar, name) for name in POLAR} | {
            "addresses": _pieces(rng, size, valid, fractions),
            "colours": made.colours,
            "valid": valid,
        }
        self.parameters = {
            "radius": radius,
            "max_jump": max_jump,
            "eta": eta,
            "exponent": exponent,
            "fractions": fractions,
            "guide_weight": fixed_guide_weight(guide_weight),
        } | {f"{name}_limit": limit for name, limit in cost_limits(polar)._asdict().items()}
        if locked:
            self.arrays["lock"] = rng.random(size) < 0.4
        if guide_weight:
            guides = pictures(rng, images, 3, holes=False)
            self.arrays["guide_colours"] = packed_planes(list(guides.values()), made.border, False)
            wanted = rng.integers(0, 256, (*size, 3), dtype=np.uint8)
            self.arrays["guide"] = packed_planes([wanted], 0, False).reshape(size)
        centres = made.centres(radius)
        source = centres[0] if at_edge else centres[centres.size // 2]
        self.cells = rng.integers(0, size, (6, 2))
        y, x = self.cells[0]
        self.place = {"y": int(y), "x": int(x), "source": int(source)}

    def only(self, *names):
        """Some of the arrays, where there are such."""
        return {name: self.arrays[name] for name in names if name in self.arrays}


def _pieces(rng, size, valid, fractions):
    """Addresses: a few runs of neighbours, and noise between."""
    pixels = np.flatnonzero(valid)
    addresses = rng.choice(pixels, size)
    plane, stride = valid.size, valid.shape[1]
    for _ in range(5):
        y, x = rng.integers(0, size)
        first = rng.choice(pixels)
        for dy in range(min(6, size[0] - y)):
            for dx in range(min(7, size[1] - x)):
                there = first + dy * stride + dx
                if there < plane and valid.ravel()[there]:
                    addresses[y + dy, x + dx] = there
    if fractions:
        addresses = addresses + plane * rng.integers(0, 16, size)
    return addresses.astype(np.int32)
