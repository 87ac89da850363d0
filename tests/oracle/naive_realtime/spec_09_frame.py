"""9. A frame."""

import numpy as np

from .spec_01_names import grid_of, into_range, ranges
from .spec_03_levels import FREE, picked, pyramid
from .spec_04_random_numbers import random_nnf
from .spec_05_energy import Energy
from .spec_06_search import Half, labels_of
from .spec_07_blend import blend
from .spec_08_upsampling import upsampled_nnf, upsampled_picture


def at(values, level):
    """Give a level's value of a list."""
    return values[min(level, len(values) - 1)]


class Frame:
    """Source and target on all levels."""

    def __init__(self, p, a):
        self.p, levels = p, p["levels"]
        self.guides = pyramid(a["source_guides"], levels)
        self.style = pyramid(a["source_style"], levels)
        self.target = pyramid(a["target_guides"], levels)
        self.labels = [a.get(side) for side in ("source_labels", "target_labels")]

    def source_size(self, level):
        """Give height and width of the source."""
        return self.guides[level].shape[:2]

    def size(self, level):
        """Give height and width of the target."""
        return self.target[level].shape[:2]

    def blended(self, nnf, level):
        """Blend B' of a level."""
        p = self.p
        return blend(self.style[level], nnf, p["patch_width"], p["spacing"], self.size(level))

    def begin(self, nnf, level):
        """Give the NNF of a level from that of the coarser one, or at random."""
        p, grid = self.p, grid_of(self.size(level), self.p["spacing"])
        if level == p["levels"] - 1:
            return random_nnf(grid, self.source_size(level), p["patch_width"], p["seed"], level)
        return upsampled_nnf(nnf, grid, self.source_size(level), p["patch_width"], p["spacing"])

    def first_picture(self, nnf, coarse, level):
        """Give B' with which a level begins; ``coarse`` is the NNF of the coarser level."""
        if self.p["start"] == "vote" or coarse is None:
            return self.blended(nnf, level)
        return upsampled_picture(self.blended(coarse, level + 1), self.size(level))

    def search(self, nnf, picture, level, iteration, moving):
        """Do an iteration."""
        p = self.p
        height, width = self.source_size(level)
        here = p | {
            "mu": at(p["mu"], level),
            "level": level,
            "iteration": iteration,
            "radius": min(max(height, width) // 2, at(p["radii"], level)),
        }
        images = {
            "source_guides": self.guides[level],
            "source_style": self.style[level],
            "target_guides": self.target[level],
            "target_style": picture,
        }
        labels = [None if side is None else picked(side, level) for side in self.labels]
        energy = Energy(here, images)
        for half in (0, 1):
            now = here | {"half": half}
            Half(now, nnf, energy, (height, width), labels_of(p, *labels), moving).run()

    def refine(self, nnf, coarse, level, settles=False):
        """Do the iterations of a level; where it settles, later ones search what moves alone."""
        picture, moving = self.first_picture(nnf, coarse, level), None
        reads_style = at(self.p["mu"], level) > 0
        for iteration in range(at(self.p["iterations"], level)):
            if iteration > 0 and reads_style:
                picture = self.blended(nnf, level)
            before = nnf.copy()
            self.search(nnf, picture, level, iteration, moving)
            if settles:
                moving = moving_entries(before, nnf)

    def cold(self, last=0):
        """Give the NNF of a level, begun from nothing."""
        nnf = None
        for level in range(self.p["levels"] - 1, last - 1, -1):
            coarse, nnf = nnf, self.begin(nnf, level)
            self.refine(nnf, coarse, level)
        return nnf


def moving_entries(before, nnf):
    """Tell which entries have another match than before, or stand beside one that has."""
    moving = np.zeros(nnf.shape[:2], bool)
    for a, b in np.argwhere((nnf != before).any(axis=2)).tolist():
        moving[max(a - 1, 0) : a + 2, max(b - 1, 0) : b + 2] = True
    return moving


def others(labels):
    """Give a question: has a match another label than its entry, which is not free."""

    def asked(entry, match):
        if labels is None:
            return False
        wanted = int(labels[0][entry])
        return wanted != FREE and int(labels[1][match]) != wanted

    return asked


def renew(p, a, nnf, fresh):
    """Renew the matches of level 0 that have grown old."""
    k, spacing = p["renewal_level"], p["spacing"]
    guides = [pyramid(a[side], k + 1) for side in ("source_guides", "target_guides")]
    energy = Energy(
        p | {"mu": 0},
        {
            "source_guides": guides[0][k],
            "target_guides": guides[1][k],
            "source_style": np.zeros((*guides[0][k].shape[:2], 3), int),
            "target_style": np.zeros((*guides[1][k].shape[:2], 3), int),
        },
    )
    sides = [a.get("source_labels"), a.get("target_labels")]
    barred, barred_here = (
        others(labels_of(p, *(None if side is None else picked(side, level) for side in sides)))
        for level in (0, k)
    )
    bounds, bounds_here = (ranges(guides[0][level].shape[:2], p["patch_width"]) for level in (0, k))
    before = nnf.copy()
    for entry in np.ndindex(nnf.shape[:2]):
        parent = tuple(place >> k for place in entry)
        first = tuple(place << k for place in parent)
        own = into_range([place >> k for place in before[first].tolist()], bounds_here)
        new = tuple(fresh[parent].tolist())
        old = energy.of(parent, own) > 4 * energy.of(parent, new) or barred_here(parent, own)
        if not old and not barred(entry, tuple(before[entry])):
            continue
        match = [
            (at << k) + spacing * (place - start)
            for at, place, start in zip(new, entry, first, strict=True)
        ]
        match = into_range(match, bounds)
        if not barred(entry, match):
            nnf[entry] = match


def warm(p):
    """Give the lists by level of a warm frame."""
    levels = range(p["levels"])
    mu, iterations, radii = (
        [at(p[name], level) for level in levels] for name in ("mu", "iterations", "radii")
    )
    return {
        "mu": mu if p["scale_space"] else [p["warm_mu"], *mu[1:]],
        "iterations": [p["warm_iterations"], *((count + 1) // 2 for count in iterations[1:])],
        "radii": [p["warm_radius"], *radii[1:]],
    }


def stage_frame(p, a):
    """Do stage frame."""
    frame = Frame(p, a)
    nnf = frame.cold()
    return {"picture": frame.blended(nnf, 0), "nnf": nnf}


def stage_warm_frame(p, a):
    """Do stage warm_frame."""
    frame = Frame(p | warm(p), a)
    level = min(p["renewal_level"], p["levels"] - 1)
    if level > 0 and at(p["mu"], level) < 16:
        renew(p | {"renewal_level": level}, a, a["nnf"], frame.cold(level))
    frame.refine(a["nnf"], None, 0, settles=True)
    return {"picture": frame.blended(a["nnf"], 0), "nnf": a["nnf"]}


def stage_renew(p, a):
    """Do stage renew."""
    renew(p, a, a["nnf"], a["fresh"])
    return {"nnf": a["nnf"]}


def stage_stroke(p, a):
    """Do stage stroke."""
    after = Frame(p, a | {"source_style": a["new_style"]})
    nnf, new_nnf = Frame(p, a).cold(), after.cold()
    pictures = {"replayed": after.blended(nnf, 0), "picture": after.blended(new_nnf, 0)}
    return pictures | {"nnf": nnf, "new_nnf": new_nnf}


STAGES = {
    "frame": stage_frame,
    "renew": stage_renew,
    "warm_frame": stage_warm_frame,
    "stroke": stage_stroke,
}
