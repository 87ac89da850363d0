"""Image quilting (Efros & Freeman 2001): blocks in scan order, cut where they overlap."""

import time
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.fft import irfft2, rfft2

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref import InputError
from stylit_ref.machine.code_digest import code_digest

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class ImageQuilting:
    """Image quilting with its parameters.

    Attributes
    ----------
    block : int
        Side of the blocks in pixels.
    overlap : int
        By how much they overlap; theirs is a sixth of the block, here it is a quarter.
    tolerance : float
        A block is drawn from those whose error is at most so much larger than the least.
    """

    block: int = 48
    overlap: int = 12
    tolerance: float = 0.1

    name = "image quilting"
    cost = 4.0

    @property
    def code(self):
        """Digest of this file and what it imports."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Quilt a texture.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called: the method reports no steps.

        Returns
        -------
        Outcome
            The result does not tile. Its time is that of the processor.
        """
        start = time.process_time()
        coordinates = quilt(texture.exemplar, texture.shape, self, seed)
        image = texture.exemplar[coordinates[..., 1] // 4, coordinates[..., 2] // 4]
        seconds = time.process_time() - start
        return Outcome(image, seconds, stages={"cpu": seconds}, coordinates=coordinates)


def quilt(exemplar, shape, params, seed):
    """Quilt a texture.

    Parameters
    ----------
    exemplar : (H, W, c) uint8
    shape : tuple of int
    params : ImageQuilting
    seed : int

    Returns
    -------
    (h, w, 3) int32
        For every pixel exemplar 0, and y and x in quarters of a pixel.

    Raises
    ------
    InputError
        If the exemplar is smaller than a block.
    """
    block, overlap = params.block, params.overlap
    if min(exemplar.shape[:2]) < block:
        raise InputError(f"image quilting needs an exemplar of at least {block} x {block} pixels")
    rng = np.random.default_rng(seed)
    step = block - overlap
    down, along = (max(1, -(-(side - overlap) // step)) for side in shape)
    source = np.zeros((down * step + overlap, along * step + overlap, 2), np.int32)
    within = np.moveaxis(np.mgrid[:block, :block], 0, -1)
    search = _Search(exemplar, block)
    for row in range(down):
        for column in range(along):
            place = np.s_[row * step : row * step + block, column * step : column * step + block]
            covered = np.zeros((block, block), np.bool_)
            covered[:, :overlap] |= column > 0
            covered[:overlap] |= row > 0
            old = exemplar[source[place][..., 0], source[place][..., 1]]
            errors = search.errors(old, covered)
            good = np.argwhere(errors <= errors.min() * (1 + params.tolerance))
            corner = good[rng.integers(len(good))]
            new = exemplar[tuple(np.moveaxis(within + corner, -1, 0))]
            difference = ((new.astype(np.int64) - old) ** 2).sum(axis=2)
            keeps = np.zeros((block, block), np.bool_)
            if column:
                keeps[:, :overlap] |= _before(cheapest_cut(difference[:, :overlap]), overlap)
            if row:
                keeps[:overlap] |= _before(cheapest_cut(difference[:overlap].T), overlap).T
            source[place] = np.where(keeps[..., None], source[place], within + corner)
    coordinates = np.zeros((*shape, 3), np.int32)
    coordinates[..., 1:] = 4 * source[: shape[0], : shape[1]]
    return coordinates


class _Search:
    """The squared difference of a block to every place of the exemplar, by Fourier transform."""

    def __init__(self, exemplar, block):
        self._image = exemplar.astype(float)
        self._places = tuple(side - block + 1 for side in exemplar.shape[:2])
        self._transform = rfft2(self._image, axes=(0, 1))
        self._squares = rfft2((self._image**2).sum(axis=2))
        self._energies = {}

    def errors(self, block, covered):
        """(H, W) int64, over the covered pixels alone."""
        key = covered.tobytes()
        if key not in self._energies:
            self._energies[key] = self._correlated(self._squares, covered.astype(float))
        wanted = block * covered[..., None].astype(float)
        likeness = sum(
            self._correlated(self._transform[..., c], wanted[..., c]) for c in range(block.shape[2])
        )
        errors = self._energies[key] - 2 * likeness + (wanted**2).sum()
        return np.rint(errors).astype(np.int64)  # they are integers but for rounding

    def _correlated(self, transform, kernel):
        size = self._image.shape[:2]
        correlation = irfft2(transform * np.conj(rfft2(kernel, size)), size)
        return correlation[: self._places[0], : self._places[1]]


def cheapest_cut(costs):
    """The path from the first to the last row that costs least; its column moves by at most one.

    Parameters
    ----------
    costs : (H, W) int64

    Returns
    -------
    (H,) int
        Of several such paths, that farthest to the left at the end and then at each step.
    """
    totals = costs.copy()
    for above, row in pairwise(totals):
        padded = np.pad(above, 1, constant_values=np.iinfo(np.int64).max)
        row += np.minimum(np.minimum(padded[:-2], padded[1:-1]), padded[2:])
    path = [int(totals[-1].argmin())]
    for row in totals[-2::-1]:
        first = max(0, path[-1] - 1)
        path.append(first + int(row[first : path[-1] + 2].argmin()))
    return np.array(path[::-1])


def _before(path, width):
    return np.arange(width) < path[:, None]
