"""5. Energy."""

from math import gcd

import numpy as np

from .spec_01_names import clamped, grid_of
from .spec_03_levels import pyramid


def weights(n16, terms, omega):
    """Give the weights of the channels and that of the colours."""
    guides, style = [(16 - n16) * weight for weight in omega], n16
    if terms == "means":
        guides, style = [3 * weight for weight in guides], style * max(sum(omega), 1)
    divisor = gcd(*guides, style) or 1
    return [weight // divisor for weight in guides], style // divisor


def box(image, y, x, scale):
    """Give the mean of a box."""
    reach = (3**scale - 1) // 2
    span = range(-reach, reach + 1)
    number = (2 * reach + 1) ** 2
    total = sum(clamped(image, y + v, x + u) for v in span for u in span)
    return (total + number // 2) // number


class Samples:
    """What is compared of an image: its patches, or its scales."""

    def __init__(self, p, image):
        self.p, self.image, self.known = p, image, {}
        self.levels = pyramid(image, p["depth"]) if p["scale_space"] else [image]

    def scales(self, y, x):
        """List the scales of a pixel."""
        numbers = range(self.p["depth"])
        if self.p["means"] == "mip":
            return [self.levels[k][y >> k, x >> k] for k in numbers]
        return [box(self.image, y, x, k) for k in numbers]

    def at(self, y, x):
        """Give (samples, channels) of a pixel."""
        if (y, x) not in self.known:
            if self.p["scale_space"]:
                found = self.scales(y, x)
            else:
                radius = self.p["patch_width"] // 2
                span = range(-radius, radius + 1)
                found = [clamped(self.image, y + v, x + u) for v in span for u in span]
            self.known[y, x] = np.array(found)
        return self.known[y, x]


class Energy:
    """The energy of matches of one level.

    ``a`` has source_guides, source_style, target_guides and target_style of the level.
    """

    def __init__(self, p, a):
        names = "source_guides", "source_style", "target_guides", "target_style"
        self.p, self.samples = p, [Samples(p, a[name]) for name in names]
        self.guides, self.style = weights(p["mu"], p["terms"], p["guide_weights"])

    def of(self, entry, centre):
        """Give the energy of an entry and a centre."""
        there, painted, here, picture = self.samples
        pixel = entry[0] * self.p["spacing"], entry[1] * self.p["spacing"]
        guides = (there.at(*centre) - here.at(*pixel)) ** 2
        colours = (painted.at(*centre) - picture.at(*pixel)) ** 2
        return int((guides * self.guides).sum() + self.style * colours.sum())


def stage_weights(p, a):
    """Do stage weights."""
    guides, style = weights(p["mu"], p["terms"], p["guide_weights"])
    return {"guides": guides, "style": style}


def stage_records(p, a):
    """Do stage records."""
    image, spacing = a["image"], p["spacing"]
    samples = Samples(p | {"scale_space": True}, image)
    grid = grid_of(image.shape[:2], spacing)
    records = np.zeros((*grid, p["depth"], image.shape[2]), int)
    for y, x in np.ndindex(grid):
        records[y, x] = samples.at(y * spacing, x * spacing)
    return {"records": records}


def stage_energy(p, a):
    """Do stage energy."""
    energy, nnf = Energy(p, a), a["nnf"]
    found = np.zeros(nnf.shape[:2], int)
    for entry in np.ndindex(found.shape):
        found[entry] = energy.of(entry, tuple(nnf[entry]))
    return {"energy": found}


STAGES = {"weights": stage_weights, "records": stage_records, "energy": stage_energy}
