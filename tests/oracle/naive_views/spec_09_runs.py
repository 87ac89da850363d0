"""9. An iteration, and a run."""

import numpy as np
from naive_port.spec_01_names import occurrence
from naive_port.spec_02_weights import occurrence_weight_of
from naive_port.spec_03_metric import delta
from naive_port.spec_05_random_nnf import random_nnf
from naive_port.spec_06_pyramid import downsample, level_count, pyramid, upsample_nnf
from naive_port.spec_10_iteration import patchmatch_iteration
from naive_port.spec_11_vote import vote
from naive_port.spec_12_guide_maps import guide_map, white_delta
from naive_port.spec_15_stylit import stylit_of, stylit_search

from .spec_01_names import Motion, in_units, places_of
from .spec_02_shift import shifted
from .spec_07_folding import coherent_weights, folded
from .spec_08_order import frame_votes_of, neighbours_of, pulls_of, tasks_of


class Source:
    """Style and source guides on all levels, and the parameters."""

    def __init__(self, p, a, size):
        self.p, self.radius = p, p["patch_width"] // 2
        sides = a["style"].shape[:2] + size
        self.levels = level_count(p["levels"], sides, p["patch_width"])
        self.styles = pyramid(a["style"], self.levels, downsample)
        self.guides = pyramid(a["source_guides"], self.levels, downsample)

    def pyramid(self, image):
        """Halve an image to all levels, the coarsest first."""
        return pyramid(image, self.levels, downsample)

    def begin(self, size, before, level):
        """Give the first NNF of a level; before is that of the level before."""
        blank, source_size = np.zeros((*size, 2), np.int64), self.styles[level - 1].shape[:2]
        if level == 1:
            return random_nnf(blank, source_size, self.radius, int(self.p["seed"]), level)
        return upsample_nnf(before, blank, source_size, self.radius)

    def vote(self, nnf, level):
        """Give the picture of an NNF."""
        return vote(self.styles[level - 1], nnf, self.radius, self.p["outliers"])

    def advance(self, guides, nnf, picture, neighbours, level, k):
        """Do an iteration; guides are the target's at the level, neighbours (picture, motion)."""
        p, style, source_guides = self.p, self.styles[level - 1], self.guides[level - 1]
        weight = in_units(p["coherence"])
        shifts = [
            shifted(theirs, places_of(motion, self.levels - level), picture)
            for theirs, motion in neighbours
        ]
        mixed, spread = folded(picture, shifts, [weight] * len(shifts))
        with_spread = p["method"] == "stylit" and len(shifts) > 0
        weights = coherent_weights(p, style.shape[-1], len(shifts), with_spread)
        if with_spread:
            guides = np.concatenate([guides, spread], axis=-1)
            nothing = np.zeros((*style.shape[:2], 1), np.int64)
            source_guides = np.concatenate([source_guides, nothing], axis=-1)
        source = np.concatenate([source_guides, style], axis=-1)
        target = np.concatenate([guides, mixed], axis=-1)
        nnf = self.search(source, target, weights, nnf, level, k)
        return nnf, self.vote(nnf, level)

    def search(self, source, target, weights, nnf, level, k):
        """Search as the method does."""
        p, radius, seed = self.p, self.radius, int(self.p["seed"])
        maps, n_g = None, source.shape[-1] - self.styles[0].shape[-1]
        if p["method"] == "guide_map":
            source_sums, target_sums, _, white = guide_map(
                source[..., :n_g], target[..., :n_g], weights[:n_g], radius, p["epsilon"]
            )
            maps = source_sums, target_sums, white

        def measure(centres):
            if maps is None:
                return delta(source, target, weights, centres, radius)
            return white_delta(source, target, weights, centres, radius, *maps)

        delta_values = measure(nnf)
        if p["method"] == "stylit":
            return stylit_search(
                source, target, weights, nnf, delta_values, radius, p["iterations"],
                stylit_of(p), seed, level, k,
            )[0]  # fmt: skip
        _, omega_sums = occurrence(nnf, source.shape[:2], radius)
        occurrence_weight = occurrence_weight_of(
            p["uniformity"], p["patch_width"], source[..., 0].size, nnf[..., 0].size
        )
        for iteration in range(1, p["iterations"] + 1):
            nnf, delta_values, omega_sums = patchmatch_iteration(
                nnf, delta_values, omega_sums, occurrence_weight, radius, measure,
                seed, level, k, iteration,
            )  # fmt: skip
        return nnf


def halved(picture, size):
    """Halve a finished picture to the size of a level."""
    while picture.shape[:2] != size:
        picture = downsample(picture)
    return picture


def edges_of(a):
    """Give the motion of each edge."""
    names = [name.split("_")[1:] for name in a if name.startswith("field_")]
    return {
        (int(to), int(other)): Motion(a[f"field_{to}_{other}"], a[f"visible_{to}_{other}"])
        for to, other in names
    }


def run(p, a):
    """Do all tasks; give the last state of each frame."""
    frames = sum(name.startswith("target_guides_") for name in a)
    source = Source(p, a, a["target_guides_0"].shape[:2])
    guides = [source.pyramid(a[f"target_guides_{frame}"]) for frame in range(frames)]
    edges = edges_of(a)
    neighbours = neighbours_of(edges, frames, p)
    votes = [p["votes"]] * source.levels
    following = [p.get("following_votes", p["votes"])] * source.levels
    frame_votes = frame_votes_of(neighbours, p, votes, following)
    states = {}
    for task in tasks_of(frame_votes, p["order"]):
        frame, level, k = task
        here = guides[frame][level - 1]
        size = here.shape[:2]
        if k == 0:
            last = frame_votes[frame][level - 2]
            before = states[frame, level - 1, last][0] if level > 1 else None
            nnf = source.begin(size, before, level)
            states[task] = nnf, source.vote(nnf, level)
            continue
        pulling = [
            (halved(states[other][1], size), edges[frame, other[0]])
            for other in pulls_of(task, neighbours[frame], frame_votes, p["order"])
        ]
        states[task] = source.advance(here, *states[frame, level, k - 1], pulling, level, k)
    return [states[frame, source.levels, frame_votes[frame][-1]] for frame in range(frames)]


def stage_iteration(p, a):
    """Do stage iteration."""
    source, size = Source(p, a, a["target_guides"].shape[:2]), a["picture"].shape[:2]
    frames = sorted(int(name.split("_")[1]) for name in a if name.startswith("picture_"))
    pulling = [
        (halved(a[f"picture_{f}"], size), Motion(a[f"field_{f}"], a[f"visible_{f}"]))
        for f in frames
    ]
    guides = source.pyramid(a["target_guides"])[p["level"] - 1]
    nnf, picture = source.advance(guides, a["nnf"], a["picture"], pulling, p["level"], p["vote"])
    return {"nnf": nnf, "picture": picture}


def stage_run(p, a):
    """Do stage run."""
    outputs = {}
    for frame, (nnf, picture) in enumerate(run(p, a)):
        outputs |= {f"nnf_{frame}": nnf, f"picture_{frame}": picture}
    return outputs


STAGES = {"iteration": stage_iteration, "run": stage_run}
