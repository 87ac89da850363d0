"""13. A level, and a run."""

import numpy as np

from .spec_01_names import assigned_pixels, occurrence, radius_of
from .spec_02_weights import channel_weights, occurrence_weight_of
from .spec_03_metric import delta
from .spec_05_random_nnf import random_nnf
from .spec_06_pyramid import coarser_part, downsample, level_count, parts_of, pyramid, upsample_nnf
from .spec_10_iteration import patchmatch_iteration
from .spec_11_vote import vote
from .spec_12_guide_maps import guide_map, white_delta
from .spec_15_stylit import stylit_of, stylit_search


def run_level(source, target_guides, weights, nnf, radius, occurrence_weight, votes, iterations,
              seed, level, epsilon=None, stylit=None):  # fmt: skip
    """Synthesize one level; with an epsilon by guide maps, with stylit by the search of 15."""
    n_g = target_guides.shape[-1]
    style = source[..., n_g:]
    source_shape = source.shape[:2]
    maps = None
    if epsilon is not None:
        source_sums, target_sums, _, white = guide_map(
            source[..., :n_g], target_guides, weights[:n_g], radius, epsilon
        )
        maps = (source_sums, target_sums, white)
    _, omega_sums = occurrence(nnf, source_shape, radius)
    for vote_number in range(1, votes + 1):
        target = np.concatenate([target_guides, vote(style, nnf, radius)], axis=-1)

        def measure(centres, target=target):
            if maps is None:
                return delta(source, target, weights, centres, radius)
            return white_delta(source, target, weights, centres, radius, *maps)

        delta_values = measure(nnf)
        if stylit is not None:
            nnf, delta_values, _ = stylit_search(
                source, target, weights, nnf, delta_values, radius, iterations, stylit,
                seed, level, vote_number,
            )  # fmt: skip
            continue
        for iteration in range(1, iterations + 1):
            nnf, delta_values, omega_sums = patchmatch_iteration(
                nnf, delta_values, omega_sums, occurrence_weight, radius, measure,
                seed, level, vote_number, iteration,
            )  # fmt: skip
    omega, _ = occurrence(nnf, source_shape, radius)
    return vote(style, nnf, radius), nnf, omega


def empty_nnf(part):
    """Mark with 0 the pixels that take part; the others with -1."""
    return np.where(part[..., None], np.zeros(2, np.int64), -1)


def run(style, source_guides, target_guides, mask, p, stylit=None):
    """Go from the coarsest level to the finest."""
    patch_width = p["patch_width"]
    radius = patch_width // 2
    seed = int(p["seed"])
    epsilon = p["epsilon"] if p["method"] == "guide_map" else None
    weights = channel_weights(
        p["guide_channels"], p["guide_weights"], style.shape[-1], p["guide_influence"]
    )
    source = np.concatenate([source_guides, style], axis=-1)
    sides = source.shape[:2] + target_guides.shape[:2]
    count = level_count(p["levels"], sides, patch_width)
    sources = pyramid(source, count, downsample)
    targets = pyramid(target_guides, count, downsample)
    parts = pyramid(parts_of(mask, radius), count, coarser_part)
    image = nnf = omega = None
    for level in range(1, count + 1):
        level_source, part = sources[level - 1], parts[level - 1]
        source_shape = level_source.shape[:2]
        blank = empty_nnf(part)
        if level == 1:
            nnf = random_nnf(blank, source_shape, radius, seed, level)
        else:
            nnf = upsample_nnf(nnf, blank, source_shape, radius)
        occurrence_weight = occurrence_weight_of(
            p["uniformity"],
            patch_width,
            source_shape[0] * source_shape[1],
            int(assigned_pixels(nnf).sum()),
        )
        image, nnf, omega = run_level(
            level_source, targets[level - 1], weights, nnf, radius, occurrence_weight,
            p["votes"], p["iterations"], seed, level, epsilon, stylit,
        )  # fmt: skip
    return np.where(mask[..., None], 0, image), nnf, omega


def stage_level(p, a):
    """Do stage level."""
    style, nnf, omega = run_level(
        a["source"], a["target_guides"], a["weights"], a["nnf"], radius_of(p),
        p["occurrence_weight"], p["votes"], p["iterations"], int(p["seed"]), p["level"],
    )  # fmt: skip
    return {"style": style, "nnf": nnf, "omega": omega}


def stage_run(p, a, stylit=None):
    """Do stage run."""
    unmasked = np.zeros(a["target_guides"].shape[:2], bool)
    mask = a["mask"] if p["masked"] else unmasked
    image, nnf, omega = run(a["style"], a["source_guides"], a["target_guides"], mask, p, stylit)
    return {"image": image, "nnf": nnf, "omega": omega}


def stage_stylit_run(p, a):
    """Do stage stylit_run."""
    return stage_run({**p, "uniformity": 0, "method": "ref"}, a, stylit_of(p))


STAGES = {"level": stage_level, "run": stage_run, "stylit_run": stage_stylit_run}
