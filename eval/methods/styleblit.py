"""StyleBlit (Sýkora et al. 2019): verbatim pieces of the style where the guide stays close.

A pixel looks for the nearest seed, from a coarse to a fine raster of jittered seeds. The seed's
guide, here its normal, names a place of the painted sphere, and the pixel lies as far from that
place as from the seed. If the guide there differs little enough from the pixel's own, the pixel is
taken from there; else it asks the next finer raster. At the end each pixel is the mean of what its
neighbours' pieces have in its place, which softens the borders of the pieces.

The authors' levels and threshold are the defaults. Only the object is stylized: ground and wall
have one normal each, which guides nothing. Everything is in integers, on one core.
"""

import time
from dataclasses import dataclass

import numpy as np

from eval.device import processor
from eval.methods.normal_table import normal_table, objects
from eval.outcome import Outcome
from stylit_ref.formulae.rounding import rounded_mean
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.machine.kernel import kernel

_CODE = code_digest(__file__, without=("gpu_cuda",))
_JITTER_SIDE = 256


@dataclass(frozen=True)
class StyleBlit:
    """StyleBlit with its parameters.

    Attributes
    ----------
    levels : int
        Rasters; the seeds of the coarsest are ``2 ** (levels - 1)`` pixels apart.
    threshold : int
        Largest sum of absolute differences of two 8-bit normals, exclusive.
    blend : int
        Radius in pixels of the final mean; 0 leaves it out.
    """

    levels: int = 7
    threshold: int = 24
    blend: int = 1

    name = "StyleBlit"
    cost = 0.1

    @property
    def code(self):
        """Digest of this file and what it imports."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Stylize an object.

        Parameters
        ----------
        scene : Scene
            With the buffers NORMAL and IDMASK.
        seed : int
            Of the jitter.
        progress : callable, optional
            Not called: there are no steps.

        Returns
        -------
        Outcome
            Its time is that of a frame, on the processor; ``stages`` has that of the source's table
            too.

        Raises
        ------
        InputError
            If the scene lacks the buffers.
        """
        source, target = objects(scene)
        start = time.process_time()
        table = normal_table(source)
        made = time.process_time()
        jitter = make_jitter(seed)
        self._frame(scene.style, source, target, table, jitter)  # compile
        begin = time.process_time()
        image = self._frame(scene.style, source, target, table, jitter)
        seconds = time.process_time() - begin
        return Outcome(image, seconds, stages={"table": made - start, "cpu": seconds})

    def _frame(self, style, source, target, table, jitter):
        shape = target.mask.shape
        places = np.empty((*shape, 2), np.int32)
        assign(*source, *target, table, jitter, self.levels, self.threshold, places)
        image = np.full((*shape, style.shape[2]), 255, np.uint8)
        blend(style, places, target.mask, self.blend, image)
        return image


def make_jitter(seed):
    """Where a raster's seeds lie in their cells, in 256ths; repeated every 256 cells.

    Parameters
    ----------
    seed : int

    Returns
    -------
    (256, 256, 2) uint8
    """
    return np.random.default_rng(seed).integers(0, 256, (_JITTER_SIDE,) * 2 + (2,), dtype=np.uint8)


@kernel(parallel=False)
def assign(
    source_normals, source_mask, normals, mask, table, jitter, levels, threshold, places
):  # fmt: skip
    """Write the place in the style that each pixel of the object is taken from.

    Parameters
    ----------
    source_normals, normals : (H, W, 3) uint8
    source_mask, mask : (H, W) bool
    table : (2, 256, 256) int32
        From :func:`eval.methods.normal_table.normal_table`.
    jitter : (256, 256, 2) uint8
    levels, threshold : int
    places : (H_B, W_B, 2) int32
        Written; (y, x).
    """
    height, width = mask.shape
    source_height, source_width = source_mask.shape
    for y in range(height):
        for x in range(width):
            if not mask[y, x]:
                continue
            n = normals[y, x]
            own = table[n[2] >> 7, n[0], n[1]]
            places[y, x, 0], places[y, x, 1] = own // source_width, own % source_width
            for level in range(levels - 1, -1, -1):
                nearest, seed_y, seed_x = 1 << 30, 0, 0
                cell_y, cell_x = y >> level, x >> level
                for row in range(cell_y - 1, cell_y + 2):
                    for column in range(cell_x - 1, cell_x + 2):
                        shift = jitter[row & 255, column & 255]
                        s_y = ((row << 8) + shift[0]) << level >> 8
                        s_x = ((column << 8) + shift[1]) << level >> 8
                        distance = (s_y - y) ** 2 + (s_x - x) ** 2
                        if distance < nearest:
                            nearest, seed_y, seed_x = distance, s_y, s_x
                if not (0 <= seed_y < height and 0 <= seed_x < width and mask[seed_y, seed_x]):
                    continue
                m = normals[seed_y, seed_x]
                place = table[m[2] >> 7, m[0], m[1]]
                to_y = place // source_width + y - seed_y
                to_x = place % source_width + x - seed_x
                if not (0 <= to_y < source_height and 0 <= to_x < source_width):
                    continue
                if not source_mask[to_y, to_x]:
                    continue
                there = source_normals[to_y, to_x]
                error = 0
                for c in range(3):
                    error += abs(np.int64(there[c]) - np.int64(n[c]))
                if error < threshold:
                    places[y, x, 0], places[y, x, 1] = to_y, to_x
                    break


@kernel(parallel=False)
def blend(style, places, mask, radius, image):
    """Write the mean of what the neighbours' pieces have in each pixel's place, rounded half up.

    Parameters
    ----------
    style : (H_A, W_A, n) uint8
    places : (H_B, W_B, 2) int32
    mask : (H_B, W_B) bool
        Other pixels are not written.
    radius : int
    image : (H_B, W_B, n) uint8
        Written.
    """
    height, width = mask.shape
    sums = np.empty(style.shape[2], np.int64)
    for y in range(height):
        for x in range(width):
            if not mask[y, x]:
                continue
            sums[:] = 0
            count = 0
            for j in range(max(y - radius, 0), min(y + radius + 1, height)):
                for i in range(max(x - radius, 0), min(x + radius + 1, width)):
                    to_y = places[j, i, 0] + y - j if mask[j, i] else -1
                    to_x = places[j, i, 1] + x - i if mask[j, i] else -1
                    if 0 <= to_y < style.shape[0] and 0 <= to_x < style.shape[1]:
                        count += 1
                        for c in range(style.shape[2]):
                            sums[c] += style[to_y, to_x, c]
            for c in range(style.shape[2]):
                image[y, x, c] = rounded_mean(sums[c], count)
