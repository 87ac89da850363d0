"""Image Analogies (Hertzmann et al. 2001), for the background comparison (thesis, figure 1.1).

From coarse to fine, in scan order, each pixel takes the source pixel whose neighbourhood matches
best, or one that continues the source next to an already synthesized neighbour if that is hardly
worse (BestMatch of their section 3.1). As in the thesis' figure only the first guide is used.

One thing differs. Their approximate search compares the whole neighbourhood of one pixel after
another. Here it finds the eight nearest source pixels for all pixels of a level at once, by what
is known before the scan: both levels of the guide, and the coarser level of the output. The scan
then chooses among the eight by the whole neighbourhood.
"""

import time
from dataclasses import dataclass

import numba
import numpy as np
from numba import njit
from scipy.spatial import cKDTree
from skimage.transform import downscale_local_mean
from skimage.util import view_as_windows

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest

FINE, COARSE = 5, 3
"""Widths of the neighbourhoods on a level and on the next coarser one (their section 3.1)."""
DIMENSIONS = 24
"""Number of principal components that the approximate search uses."""
NEAREST = 8
APPROXIMATION = 1.0
"""ε of the approximate search, as in their paper."""

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class ImageAnalogies:
    """Image Analogies with its parameters.

    Attributes
    ----------
    coherence : float
        κ: how much worse a match that continues its neighbour may be (theirs: 0.5 to 5 for
        texture-like filters).
    levels : int
    """

    coherence: float = 1.0
    levels: int = 4

    name = "image analogies"
    cost = 1.0

    @property
    def code(self):
        """Digest of this file and what it imports."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Stylize a scene; the seed changes nothing.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called: the method reports no steps.

        Returns
        -------
        Outcome
        """
        start = time.perf_counter()
        image, nnf, omega, levels = image_analogies(
            scene.style, scene.source_guides[0], scene.target_guides[0], self
        )
        seconds = time.perf_counter() - start
        return Outcome(image, seconds, nnf, omega, levels=levels)


def image_analogies(style, source_guide, target_guide, params):
    """Stylize by image analogies.

    Parameters
    ----------
    style : (H_A, W_A, n) uint8
    source_guide, target_guide : (H, W, c) uint8
    params : ImageAnalogies

    Returns
    -------
    image : (H_B, W_B, n) uint8
    nnf : (H_B, W_B, 2) int32
    omega : (H_A, W_A) int32
        How many target pixels were taken from each source pixel.
    levels : tuple of (H, W, n) uint8
        The coarsest first.
    """
    pyramids = [_pyramid(image, params.levels) for image in (source_guide, style, target_guide)]
    made, nnf, levels = None, None, []
    for level in range(params.levels):
        source_guide, source_style, target_guide = (pyramid[level] for pyramid in pyramids)
        coarser = ([], [])
        if level:
            coarse_guide, coarse_style, coarse_target = (pyramid[level - 1] for pyramid in pyramids)
            coarser = (coarse_guide, coarse_style), (coarse_target, made)
        source, target = _known(source_guide, coarser[0]), _known(target_guide, coarser[1])
        candidates = _candidates(source, target)
        made, nnf = _scan(
            source, target, source_style, target_guide.shape[:2], candidates,
            1 + 2.0 ** (level + 1 - params.levels) * params.coherence,
        )  # fmt: skip
        levels.append(np.rint(made).astype(np.uint8))
    omega = np.zeros(style.shape[:2], np.int32)
    np.add.at(omega, (nnf[:, :, 0], nnf[:, :, 1]), 1)
    return style[nnf[:, :, 0], nnf[:, :, 1]], nnf, omega, tuple(levels)


def _pyramid(image, levels):
    """The levels of an image, the coarsest first."""
    pyramid = [image.astype(np.float32)]
    for _ in range(levels - 1):
        height, width = (side // 2 * 2 for side in pyramid[-1].shape[:2])
        pyramid.append(downscale_local_mean(pyramid[-1][:height, :width], (2, 2, 1)))
    return pyramid[::-1]


def _neighbourhoods(image, width):
    """Every pixel's neighbourhood, times weights whose squares are Gaussian and sum to 1."""
    radius = width // 2
    padded = np.pad(image, ((radius, radius), (radius, radius), (0, 0)), mode="edge")
    windows = view_as_windows(padded, (width, width, image.shape[2]))[:, :, 0]
    offsets = np.arange(-radius, radius + 1) / (radius / 2 + 0.5)
    weights = np.exp(-(offsets[:, None] ** 2 + offsets**2) / 2)
    weights = np.sqrt(weights / weights.sum())[:, :, None].astype(np.float32)
    return (windows * weights).reshape(*image.shape[:2], -1)


def _known(guide, coarser):
    """The features that are known of every pixel before the scan, (H, W, n) float32."""
    features = [_neighbourhoods(guide, FINE)]
    for image in coarser:
        parents = (
            np.minimum(np.arange(side) // 2, coarse - 1)
            for side, coarse in zip(guide.shape[:2], image.shape[:2], strict=True)
        )
        features.append(_neighbourhoods(image, COARSE)[np.ix_(*parents)])
    return np.concatenate(features, axis=2)


def _candidates(source, target):
    """The nearest source pixels of every target pixel, (pixels, NEAREST) int."""
    count = source.shape[2]
    mean = source.reshape(-1, count).mean(axis=0)
    centred = source.reshape(-1, count) - mean
    _, axes = np.linalg.eigh(centred.T @ centred)
    axes = axes[:, -DIMENSIONS:]
    tree = cKDTree(centred @ axes)
    wanted = (target.reshape(-1, count) - mean) @ axes
    nearest = min(NEAREST, len(centred))
    _, indices = tree.query(wanted, k=nearest, eps=APPROXIMATION, workers=numba.get_num_threads())
    return indices.reshape(-1, nearest)


@njit
def _scan(source, target, style, size, candidates, tolerance):
    """Scan a level: returns B' and the source pixel of every pixel."""
    height, width = size
    channels = style.shape[2]
    made = np.zeros((height, width, channels), np.float32)
    nnf = np.zeros((height, width, 2), np.int32)
    radius = FINE // 2
    for y in range(height):
        for x in range(width):
            best_y, best_x, best = 0, 0, np.inf
            for candidate in candidates[y * width + x]:
                source_y, source_x = candidate // style.shape[1], candidate % style.shape[1]
                distance = _distance(source, target, style, made, y, x, source_y, source_x, best)
                if distance < best:
                    best_y, best_x, best = source_y, source_x, distance
            coherent_y, coherent_x, coherent = 0, 0, np.inf
            for dy in range(-radius, 1):
                for dx in range(-radius, radius + 1 if dy < 0 else 0):
                    if y + dy < 0 or not 0 <= x + dx < width:
                        continue
                    source_y, source_x = nnf[y + dy, x + dx, 0] - dy, nnf[y + dy, x + dx, 1] - dx
                    if not (0 <= source_y < style.shape[0] and 0 <= source_x < style.shape[1]):
                        continue
                    distance = _distance(
                        source, target, style, made, y, x, source_y, source_x, coherent
                    )
                    if distance < coherent:
                        coherent_y, coherent_x, coherent = source_y, source_x, distance
            if coherent <= best * tolerance:
                best_y, best_x = coherent_y, coherent_x
            nnf[y, x, 0], nnf[y, x, 1] = best_y, best_x
            made[y, x] = style[best_y, best_x]
    return made, nnf


@njit
def _distance(source, target, style, made, y, x, source_y, source_x, limit):
    """Squared distance of known and synthesized features; it may stop once it reaches ``limit``."""
    total = 0.0
    for c in range(source.shape[2]):
        total += (target[y, x, c] - source[source_y, source_x, c]) ** 2
    radius = FINE // 2
    height, width = style.shape[:2]
    weight = 1 / (2 * radius * (radius + 1))
    for dy in range(-radius, 1):
        if total >= limit:
            break
        for dx in range(-radius, radius + 1 if dy < 0 else 0):
            if y + dy < 0 or not 0 <= x + dx < made.shape[1]:
                continue
            near_y = min(max(source_y + dy, 0), height - 1)
            near_x = min(max(source_x + dx, 0), width - 1)
            for c in range(style.shape[2]):
                total += weight * (made[y + dy, x + dx, c] - style[near_y, near_x, c]) ** 2
    return total
