"""PatchMatch in scan-line order with Ω live: the simplest reference (thesis 2.4)."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.formulae.candidates import propagation_candidate, random_candidate
from stylit_ref.formulae.improve_assignment import improve_assignment
from stylit_ref.machine.kernel import kernel
from stylit_ref.randomness.philox import FourWords
from stylit_ref.randomness.random_stream import random_words


@kernel(parallel=False)
def scanline(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    weights: NDArray[np.int64],
    omega: NDArray[np.int32],
    occurrence_weight: int,
    patch_width: int,
    nnf: NDArray[np.int32],
    stream: FourWords,
    reverse: bool,
) -> None:
    """One PatchMatch iteration: propagation and random search, one patch after another.

    Parameters
    ----------
    source : (H_A, W_A, C) uint8
    target : (H_B + 2 radius, W_B + 2 radius, C) uint8
    weights : (C,) int64
    omega : (H_A, W_A) int32
        Ω, updated with every change of an assignment.
    occurrence_weight : int
    patch_width : int
    nnf : (H_B, W_B, 2) int32
        Improved in place; negative where a mask leaves the pixel alone.
    stream : tuple of 4 uint32
    reverse : bool
        False: left to right, top to bottom, propagating from the left and from above
        (odd iterations). True: the other way round (even iterations).
    """
    height, width = nnf.shape[:2]
    source_height, source_width = omega.shape
    radius = patch_width // 2
    back = 1 if reverse else -1
    for row in range(height):
        y = height - 1 - row if reverse else row
        for column in range(width):
            x = width - 1 - column if reverse else column
            best_y, best_x = nnf[y, x, 0], nnf[y, x, 1]
            if best_y < 0:
                continue

            for dy, dx in ((0, back), (back, 0)):
                near_y, near_x = y + dy, x + dx
                if near_y < 0 or near_y >= height or near_x < 0 or near_x >= width:
                    continue
                if nnf[near_y, near_x, 0] < 0:
                    continue
                candidate_y, candidate_x = propagation_candidate(
                    nnf[near_y, near_x, 0], nnf[near_y, near_x, 1], dy, dx,
                    radius, source_height, source_width,
                )  # fmt: skip
                best_y, best_x = improve_assignment(
                    (source, target, weights), omega, occurrence_weight, patch_width,
                    y, x, candidate_y, candidate_x, best_y, best_x,
                )  # fmt: skip

            centre_y, centre_x = best_y, best_x
            search_radius = max(height, width)
            draw = 0
            while search_radius > 0:
                words = random_words(stream, y * width + x, draw)
                candidate_y, candidate_x = random_candidate(
                    words[0], words[1], centre_y, centre_x, search_radius,
                    radius, source_height, source_width,
                )  # fmt: skip
                best_y, best_x = improve_assignment(
                    (source, target, weights), omega, occurrence_weight, patch_width,
                    y, x, candidate_y, candidate_x, best_y, best_x,
                )  # fmt: skip
                search_radius //= 2
                draw += 1

            nnf[y, x, 0], nnf[y, x, 1] = best_y, best_x
