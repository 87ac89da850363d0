"""Small sources and targets with awkward contents, from which the cases are cut."""

import numpy as np

SEED = 0x1234567890ABCDEF

PLACE = {"seed": SEED, "level": 2, "iteration": 1, "half": 0}
"""The point of a frame whose random numbers the cases of a half iteration use."""


def noise(rng, size, channels):
    """A smooth ramp with noise."""
    ramp = np.add.outer(np.arange(size[0]) * 11, np.arange(size[1]) * 7)[:, :, None]
    return (ramp + rng.integers(0, 90, (*size, channels))).astype(np.uint8)


def things(rng, size, number=3):
    """Labels: noise in blocks of 3x3, one of which is alone in its thing of ``number``."""
    blocks = rng.integers(0, number, (size[0] // 3 + 1, size[1] // 3 + 1))
    return blocks.repeat(3, 0).repeat(3, 1)[: size[0], : size[1]].astype(np.uint8)


def centres(size, patch_width):
    """First and last centre along both sides."""
    radius = patch_width // 2
    first = [min(radius, (side - 1) // 2) for side in size]
    last = [max(side - 1 - radius, (side - 1) // 2) for side in size]
    return np.array(first), np.array(last)


class Scene:
    """A level: its images, its NNF, and how its energy is weighed."""

    def __init__(
        self, number, source=(9, 11), target=(10, 13), channels=3, patch_width=5, spacing=None,
        mu=4, terms="sums", guide_weights=None, scale_space=False, depth=2, means="mip",
        constant=False, blemish=False, contrast=False, labels=False,
    ):  # fmt: skip
        rng = np.random.default_rng(number)
        spacing = patch_width // 2 + 1 if spacing is None else spacing
        self.parameters = {
            "patch_width": patch_width,
            "spacing": spacing,
            "mu": mu,
            "terms": terms,
            "guide_weights": [1] * channels if guide_weights is None else guide_weights,
            "scale_space": scale_space,
            "depth": depth,
            "means": means,
        }
        self.arrays = {
            "source_guides": noise(rng, source, channels),
            "source_style": noise(rng, source, 3),
            "target_guides": noise(rng, target, channels),
            "target_style": noise(rng, target, 3),
        }
        if contrast:
            for name, image in self.arrays.items():
                share = 0.1 if name.startswith("source") else 0.9
                image[:] = np.where(rng.random(image.shape) < share, 0, 255)
        if constant:
            for image in self.arrays.values():
                image[:] = 100
        if blemish:  # half of the source does not fit; the other half fits equally well everywhere
            self.arrays["source_guides"][:, : source[1] // 2] = 0
        self.grid = tuple(-(-side // spacing) for side in target)
        first, last = centres(source, patch_width)
        nnf = rng.integers(first, last + 1, (*self.grid, 2)).astype(np.int32)
        if blemish:  # every other match does not fit
            nnf[np.indices(self.grid).sum(axis=0) % 2 == 0, 1] = first[1]
        self.arrays["nnf"] = nnf
        if labels:
            self.arrays["source_labels"] = things(rng, source)
            self.arrays["target_labels"] = things(rng, target)
