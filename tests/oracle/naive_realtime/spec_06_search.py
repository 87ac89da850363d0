"""6. Search."""

import numpy as np

from .spec_01_names import into_range, ranges
from .spec_03_levels import FREE, entry_labels
from .spec_04_random_numbers import SEARCH, draw, place
from .spec_05_energy import Energy

WORST = 2**31 - 1
NEIGHBOURS = (-1, 0), (1, 0), (0, -1), (0, 1)


class Half:
    """A half iteration.

    ``labels`` are those of the entries and of the source, or None; ``moving`` says which entries
    are searched, or is None.
    """

    def __init__(self, p, nnf, energy, size, labels, moving=None):
        self.p, self.nnf, self.energy, self.labels = p, nnf, energy, labels
        self.moving = moving
        self.bounds = ranges(size, p["patch_width"])

    def is_barred(self, entry, centre):
        """Tell whether a label forbids a match."""
        if self.labels is None:
            return False
        wanted = int(self.labels[0][entry])
        return wanted != FREE and int(self.labels[1][centre]) != wanted

    def improve(self, entry, candidate):
        """Take a candidate if it is better."""
        if candidate == self.match or self.is_barred(entry, candidate):
            return
        found = self.energy.of(entry, candidate)
        if found < self.best:
            self.best, self.match = found, candidate

    def propagate(self, entry):
        """Look at the neighbours' matches."""
        spacing = self.p["spacing"]
        for v, u in NEIGHBOURS:
            a, b = entry[0] + v, entry[1] + u
            if 0 <= a < self.nnf.shape[0] and 0 <= b < self.nnf.shape[1]:
                y, x = self.nnf[a, b].tolist()
                moved = y - v * spacing, x - u * spacing
                self.improve(entry, into_range(moved, self.bounds))

    def search_around(self, entry):
        """Look around the match."""
        p, middle, trial = self.p, self.match, 0
        position = entry[0] * self.nnf.shape[1] + entry[1]
        while p["radius"] >> trial > 0:
            radius = p["radius"] >> trial
            words = draw(
                p["seed"], SEARCH, p["level"], p["iteration"], p["half"], position, trial // 4
            )
            window = [
                (max(at - radius, first), min(at + radius, last))
                for at, (first, last) in zip(middle, self.bounds, strict=True)
            ]
            self.improve(entry, place(words[trial % 4], window))
            trial += 1

    def run(self):
        """Search the entries of the half."""
        for entry in np.ndindex(self.nnf.shape[:2]):
            if (entry[0] + entry[1] + self.p["half"]) % 2:
                continue
            if self.moving is not None and not self.moving[entry]:
                continue
            self.match = tuple(self.nnf[entry].tolist())
            barred = self.is_barred(entry, self.match)
            self.best = WORST if barred else self.energy.of(entry, self.match)
            self.propagate(entry)
            self.search_around(entry)
            self.nnf[entry] = self.match


def labels_of(p, source, target):
    """Give labels of the entries and of the source, from those of a level."""
    if source is None or target is None:
        return None
    return entry_labels(source, target, p["patch_width"], p["spacing"]), source


def stage_search(p, a):
    """Do stage search."""
    labels = labels_of(p, a.get("source_labels"), a.get("target_labels"))
    Half(p, a["nnf"], Energy(p, a), a["source_guides"].shape[:2], labels).run()
    return {"nnf": a["nnf"]}


STAGES = {"search": stage_search}
