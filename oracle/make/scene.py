"""Small inputs with awkward contents, from which the cases are cut."""

import numpy as np

from oracle.make.answer import answer

PLACE = {"seed": 0x1234567890ABCDEF, "level": 3, "vote": 2, "iteration": 5}
"""The point of a run whose random numbers the cases use."""

RUN = {
    "masked": False, "guide_channels": [3, 1], "guide_weights": [1.0, 1.0],
    "guide_influence": 2.0, "patch_width": 3, "levels": 6, "votes": 1, "iterations": 1, "seed": 7,
}  # fmt: skip
"""Parameters of whole runs."""


class Scene:
    """Input of the stages of a level, and the arrays computed from it."""

    def __init__(
        self, number, source=(13, 17), target=(14, 12), guide_channels=(3, 3),
        guide_weights=(1.0, 1.0), style_channels=3, patch_width=5, uniformity=5000.0,
        guide_influence=2.0, constant=False, blemish=False, masked=False, smooth=False,
        crowded=False, contrast=False,
    ):  # fmt: skip
        rng = np.random.default_rng(number)
        channels = sum(guide_channels) + style_channels
        self.guide_channels = sum(guide_channels)
        self.arrays = {
            name: random_image(rng, size, channels, smooth, constant)
            for name, size in (("source", source), ("target", target))
        }
        if contrast:  # the largest possible differences
            self.arrays |= {
                name: np.where(image < 128, 0, 255).astype(np.uint8)
                for name, image in self.arrays.items()
            }
        if blemish:  # half of the source does not fit; the other half fits equally well everywhere
            self.arrays["source"][:, : source[1] // 2] = 0
        self.weighing = {
            "guide_channels": list(guide_channels),
            "guide_weights": list(guide_weights),
            "style_channels": style_channels,
            "guide_influence": guide_influence,
            "uniformity": uniformity,
            "patch_width": patch_width,
            "source_pixels": source[0] * source[1],
            "target_patches": target[0] * target[1],
        }
        weighed = answer("weights", self.weighing, {})
        self.arrays["weights"] = weighed["weights"]
        self.occurrence_weight = int(weighed["occurrence_weight"])
        self.sizes = {
            "patch_width": patch_width, "source_height": source[0], "source_width": source[1],
        }  # fmt: skip
        self.start = np.zeros((*target, 2), np.int32)
        if masked:
            self.start[np.eye(*target, dtype=bool)] = -1
        place = {"seed": PLACE["seed"], "level": PLACE["level"]}
        self.random = self.sizes | place
        nnf = answer("random_nnf", self.random, {"nnf": self.start})["nnf"]
        if crowded:
            nnf[::2] = nnf[0, 0]
        self.arrays["nnf"] = nnf
        self.metric = {"patch_width": patch_width, "guide_channels": self.guide_channels}
        delta = answer("delta", self.metric, self.arrays)
        self.arrays["delta"] = delta["delta_guides"] + delta["delta_style"]
        occurrence = answer("occurrence", self.sizes, {"nnf": nnf})
        self.arrays["omega_sums"] = occurrence["omega_sums"]
        self.search = self.metric | {"occurrence_weight": self.occurrence_weight}

    def only(self, *names):
        """Some of the arrays."""
        return {name: self.arrays[name] for name in names}


def random_image(rng, size, channels, smooth=False, constant=False):
    """Noise, or a ramp with a little noise, or a constant image."""
    image = rng.integers(0, 256, (*size, channels), dtype=np.uint8)
    if smooth:
        ramp = np.add.outer(np.arange(size[0]), np.arange(size[1]))[:, :, None]
        image = (ramp * 4 + image // 16).astype(np.uint8)
    return np.full_like(image, 100) if constant else image


def run_arrays(number, sizes, parameters, style_channels=3):
    """Input of a whole run.

    Parameters
    ----------
    number : int
        Number of the scene: the seed of its noise.
    sizes : pair of (int, int)
        Sizes of source and target.
    parameters : dict
        If ``masked`` is true, the mask leaves only a few pixels to synthesize, some of them in the
        last row and column.
    style_channels : int

    Returns
    -------
    dict of str to array
    """
    rng = np.random.default_rng(number)
    source, target = sizes
    guides = sum(parameters["guide_channels"])
    arrays = {
        "style": random_image(rng, source, style_channels),
        "source_guides": random_image(rng, source, guides, smooth=True),
        "target_guides": random_image(rng, target, guides, smooth=True),
    }
    if parameters["masked"]:
        arrays["mask"] = np.ones(target, bool)
        alone = (3, 4), (target[0] // 2, target[1] - 7), (target[0] - 1, 1), (6, target[1] - 1)
        for pixel in alone:
            arrays["mask"][pixel] = False
    return arrays
