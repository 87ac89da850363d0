"""Pixel-based synthesis in the manner of Lefebvre and Hoppe (2005), the paper's rival (figure 16).

From coarse to fine, each level takes the coordinates of the last one, moves them at random (the
jitter), and corrects every pixel twice: it takes that coordinate whose neighbourhood matches best,
among those that continue its neighbours and one that looks like each of these (k-coherence).

Two things differ from theirs. Neighbourhoods are compared as a whole, not by principal components.
And coordinates whose neighbourhood crosses the border of the exemplar are not taken, so that
exemplars need not tile; those that are there at first see its mirror image.
"""

import time
from dataclasses import dataclass

import numpy as np
from numba import njit
from scipy.ndimage import gaussian_filter
from scipy.spatial import cKDTree
from skimage.util import view_as_windows

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest

REACH = 2
"""Neighbourhoods are of 5x5 pixels, as theirs."""

LEVELS = 6
PASSES = 2

_ROUNDS = 2
SAMPLES, COMPONENTS, NEAREST = 4096, 12, 8

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class PixelSynthesis:
    """Pixel-based synthesis with its parameters.

    Attributes
    ----------
    name : str
        What reports call it.
    jitter : float
        r: how far coordinates move at random on each level, over the distance of its pixels.
    """

    name: str
    jitter: float

    cost = 8.0

    @property
    def code(self):
        """Digest of this file and what it imports."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Synthesize a texture; the kernel is compiled first, and the exemplar analysed.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called: the method reports no steps.

        Returns
        -------
        Outcome
            The result tiles. Its time is that of the synthesis alone, as theirs: the least of
            several runs, by the clock, and as the stage ``cpu`` of the processor.
        """
        exemplar = texture.exemplar
        analysed = [_analysed(exemplar, level) for level in range(LEVELS)]
        _synthesized(analysed, (8, 8), self.jitter, seed)
        spent = []
        for _ in range(_ROUNDS):
            wall, cpu = time.perf_counter(), time.process_time()
            source = _synthesized(analysed, texture.shape, self.jitter, seed)
            spent.append((time.perf_counter() - wall, time.process_time() - cpu))
        seconds, cpu = map(min, zip(*spent, strict=True))
        coordinates = np.concatenate([np.zeros((*texture.shape, 1), np.int32), 4 * source], axis=2)
        image = exemplar[source[..., 0], source[..., 1]]
        return Outcome(image, seconds, stages={"cpu": cpu}, coordinates=coordinates)


def _analysed(exemplar, level):
    """A level of the exemplar, padded with its mirror image, and which pixel is like each."""
    spacing = 1 << level
    blurred = np.stack(
        [gaussian_filter(c.astype(np.float32), spacing / 2 if level else 0)
         for c in np.moveaxis(exemplar, 2, 0)], axis=2,
    )  # fmt: skip
    pad = REACH * spacing
    padded = np.pad(blurred, [(pad, pad), (pad, pad), (0, 0)], "reflect")
    return padded, _alike(padded, exemplar.shape[:2], spacing)


def _alike(padded, size, spacing):
    """(H, W, 2) int32: for every pixel one of a similar neighbourhood, not close to it."""
    width = 2 * REACH * spacing + 1
    windows = view_as_windows(padded, (width, width, padded.shape[2]))[
        :, :, 0, ::spacing, ::spacing
    ]
    patches = windows.reshape(size[0] * size[1], -1)
    rng = np.random.default_rng(1)
    sample = rng.choice(len(patches), min(SAMPLES, len(patches)), replace=False)
    mean = patches[sample].mean(axis=0)
    axes = np.linalg.eigh(np.cov(patches[sample], rowvar=False))[1][:, -COMPONENTS:]
    reduced = (patches - mean) @ axes
    _, nearest = cKDTree(reduced[sample]).query(reduced, k=NEAREST)
    places = np.stack(np.divmod(sample[nearest], size[1]), axis=-1)
    own = np.stack(np.divmod(np.arange(len(patches)), size[1]), axis=-1)
    far = np.abs(places - own[:, None]).max(axis=2) >= max(size) / 20
    chosen = np.where(far.any(axis=1), far.argmax(axis=1), NEAREST - 1)
    found = places[np.arange(len(patches)), chosen]
    return found.reshape(*size, 2).astype(np.int32)


def _synthesized(analysed, shape, jitter, seed):
    """(h, w, 2) int32: y and x of the pixel of the exemplar that each shows."""
    rng = np.random.default_rng(seed)
    size = np.array(analysed[0][1].shape[:2])
    coarsest = [-(-side // (1 << len(analysed))) for side in shape]
    source = np.stack(np.indices(coarsest), axis=-1) * (1 << len(analysed)) % size
    for level in range(len(analysed) - 1, -1, -1):
        padded, alike = analysed[level]
        spacing = 1 << level
        height, width = (-(-side // spacing) for side in shape)
        y, x = np.indices((height, width))
        within = np.stack([y % 2, x % 2], axis=-1)
        moved = np.rint(spacing * jitter * rng.uniform(-1, 1, (height, width, 2))).astype(np.int64)
        source = (source[y // 2, x // 2] + spacing * within + moved) % size
        source = np.ascontiguousarray(source, np.int32)
        _correct(source, padded, alike, spacing)
    return source


@njit
def _correct(source, padded, alike, spacing):
    height, width = source.shape[:2]
    rows, columns = alike.shape[:2]
    margin = REACH * spacing
    if 2 * margin >= min(rows, columns):
        margin = 0
    side = 2 * REACH + 1
    wanted = np.empty((side, side, padded.shape[2]), np.float32)
    for step in range(4 * PASSES):
        for y in range((step >> 1) % 2, height, 2):
            for x in range(step % 2, width, 2):
                for j in range(side):
                    for i in range(side):
                        at = source[(y + j - REACH) % height, (x + i - REACH) % width]
                        wanted[j, i] = padded[at[0] + REACH * spacing, at[1] + REACH * spacing]
                least, best_y, best_x = np.inf, source[y, x, 0], source[y, x, 1]
                for j in range(-1, 2):
                    for i in range(-1, 2):
                        at = source[(y + j) % height, (x + i) % width]
                        at_y, at_x = at[0] - spacing * j, at[1] - spacing * i
                        for like in range(2):
                            if like:
                                if not (0 <= at_y < rows and 0 <= at_x < columns):
                                    continue
                                at_y, at_x = alike[at_y, at_x]
                            if not (
                                margin <= at_y < rows - margin and margin <= at_x < columns - margin
                            ):
                                continue
                            error = _error(wanted, padded, at_y, at_x, spacing, least)
                            if error < least:
                                least, best_y, best_x = error, at_y, at_x
                source[y, x, 0], source[y, x, 1] = best_y, best_x


@njit
def _error(wanted, padded, top, left, spacing, least):
    """The squared difference of a neighbourhood; given up once it is above the least."""
    error = np.float32(0)
    for j in range(wanted.shape[0]):
        for i in range(wanted.shape[1]):
            for c in range(wanted.shape[2]):
                difference = wanted[j, i, c] - padded[top + j * spacing, left + i * spacing, c]
                error += difference * difference
        if error >= least:
            break
    return error
