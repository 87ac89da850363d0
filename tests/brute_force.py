"""Oracles: the definitions of the thesis in plain, slow Python."""

from fractions import Fraction
from math import floor

import numpy as np


def weights_of(packing):
    """Weight of each channel as Python integers."""
    return [int(weight) for weight in packing.weights]


def padded(target, radius):
    """Target with its edge repeated."""
    return np.pad(target, ((radius, radius), (radius, radius), (0, 0)), mode="edge")


def delta(source, padded_target, weights, patch_width, y, x, source_y, source_x):
    """δ by its definition in Python integers (thesis 2.1, weighted as in 3.2)."""
    radius = patch_width // 2
    p = padded_target[y : y + patch_width, x : x + patch_width].astype(object)
    q = source[
        source_y - radius : source_y + radius + 1, source_x - radius : source_x + radius + 1
    ].astype(object)
    return int((((p - q) ** 2).sum(axis=(0, 1)) * np.array(weights, object)).sum())


def mean(patch):
    """Mean of each channel of a patch, exact (thesis 5.2.1)."""
    return [Fraction(int(channel.sum()), channel.size) for channel in np.moveaxis(patch, 2, 0)]


def variance(patch):
    """Sum of the variances of a patch's channels, exact (thesis 5.2.1)."""
    return sum(
        Fraction(sum((m - int(f)) ** 2 for f in channel.flat), channel.size)
        for m, channel in zip(mean(patch), np.moveaxis(patch, 2, 0), strict=True)
    )


def guide_map_delta(source, padded_target, weights, patch_width, style_channel, *place):
    """δ where the guide map is white (SSD, thesis 5.2.2); its guides' part rounded down."""
    y, x, source_y, source_x = place
    radius = patch_width // 2
    p = padded_target[y : y + patch_width, x : x + patch_width, :style_channel]
    q = source[
        source_y - radius : source_y + radius + 1,
        source_x - radius : source_x + radius + 1,
        :style_channel,
    ]
    guides = patch_width**2 * sum(
        weight * (a - b) ** 2
        for weight, a, b in zip(weights[:style_channel], mean(p), mean(q), strict=True)
    )
    of_style = [0] * style_channel + weights[style_channel:]
    return floor(guides) + delta(source, padded_target, of_style, patch_width, *place)


def omega(nnf, source_size, patch_width):
    """Ω by counting: one for each assigned patch over each pixel it covers (thesis 2.1)."""
    radius = patch_width // 2
    counts = np.zeros(source_size, np.int64)
    for source_y, source_x in nnf.reshape(-1, 2):
        if source_y >= 0:
            counts[
                source_y - radius : source_y + radius + 1, source_x - radius : source_x + radius + 1
            ] += 1
    return counts


def omega_sum(omega_map, patch_width, source_y, source_x):
    """W: Ω summed over one patch."""
    radius = patch_width // 2
    return int(
        omega_map[
            source_y - radius : source_y + radius + 1, source_x - radius : source_x + radius + 1
        ].sum()
    )


def delta_bound(level, y, x, source_y, source_x):
    """Lower bound of δ (Bessel): sums for guides, degrees up to two for the style."""
    reach = min(level.patch_width, 5) // 2
    radius = level.patch_width // 2
    p = level.textures.target[
        y + radius - reach : y + radius + reach + 1, x + radius - reach : x + radius + reach + 1
    ]
    q = level.textures.source[
        source_y - reach : source_y + reach + 1, source_x - reach : source_x + reach + 1
    ]
    differences = p.astype(int) - q
    t = np.arange(-reach, reach + 1)
    basis = [np.ones_like(t), t, t**2 - (t**2).mean()]
    packing = level.packing
    total = 0.0
    for channel, weight in enumerate(packing.weights):
        is_style = 0 <= channel - packing.style_channel < packing.style_channels
        for v, h in [(0, 0), (0, 1), (1, 0), (0, 2), (2, 0), (1, 1)][: 6 if is_style else 1]:
            product = np.outer(basis[v], basis[h])
            moment = (differences[:, :, channel] * product).sum()
            total += weight * moment**2 / (product**2).sum()
    return total


def phi(level, omega_map, y, x, source_y, source_x):
    """φ of a target and a source patch of a level, in full."""
    return level.occurrence_weight * omega_sum(
        omega_map, level.patch_width, source_y, source_x
    ) + level_delta(level, y, x, source_y, source_x)


def level_delta(level, *place):
    """δ of a target and a source patch of a level, by means where its guide map is white."""
    textures, packing = level.textures, level.packing
    metric = textures.source, textures.target, weights_of(packing), level.patch_width
    if textures.guide_map is not None and textures.guide_map[place[:2]]:
        return guide_map_delta(*metric, packing.style_channel, *place)
    return delta(*metric, *place)


def best_of(level, omega_map, y, x, candidates):
    """The first candidate with the lowest φ; the current assignment counts as the first of all."""
    best = tuple(int(v) for v in level.nnf[y, x])
    best_phi = phi(level, omega_map, y, x, *best)
    for candidate in candidates:
        candidate_phi = phi(level, omega_map, y, x, *candidate)
        if candidate_phi < best_phi:
            best, best_phi = candidate, candidate_phi
    return best


def vote(style, nnf, patch_width, outliers=0):
    """Mean of the votes of all assigned patches over each pixel, rounded half up (2.3).

    The ``outliers`` farthest from it are left out (Hauptfleisch 2.4.1), but one vote always counts.
    """
    radius = patch_width // 2
    height, width = nnf.shape[:2]
    image = np.zeros((height, width, style.shape[2]), np.int64)
    for y in range(height):
        for x in range(width):
            votes = [
                style[nnf[py, px, 0] + y - py, nnf[py, px, 1] + x - px].astype(int)
                for py in range(max(0, y - radius), min(height, y + radius + 1))
                for px in range(max(0, x - radius), min(width, x + radius + 1))
                if nnf[py, px, 0] >= 0
            ]
            if outliers and votes:
                mean_vote = [Fraction(int(total), len(votes)) for total in np.sum(votes, axis=0)]
                distances = [
                    sum((int(v) - m) ** 2 for v, m in zip(value, mean_vote, strict=True))
                    for value in votes
                ]
                farthest = sorted(range(len(votes)), key=lambda n: -distances[n])
                kept = sorted(farthest[min(outliers, len(votes) - 1) :])
                votes = [votes[n] for n in kept]
            if votes:
                image[y, x] = np.floor(np.mean(votes, axis=0) + 0.5)
    return image
