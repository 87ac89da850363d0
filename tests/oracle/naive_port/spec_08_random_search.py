"""8. Random search."""

import numpy as np

from .spec_01_names import assigned_pixels
from .spec_03_metric import usable_centres
from .spec_04_random_numbers import RANDOM_SEARCH, below, case_stream, draw_grid
from .spec_07_propagation import Proposal, pass_arguments


def draw_between(words, middle, reach, radius, side):
    """Draw a coordinate within reach of the middle and among the centres."""
    low = np.maximum(middle - reach, radius)
    high = np.minimum(middle + reach, side - 1 - radius)
    return low + below(words, high - low + 1)


def random_search(nnf, delta_values, omega_sums, occurrence_weight, radius, measure, stream):
    """Propose random centres around the assignment, at growing distances."""
    height, width = nnf.shape[:2]
    assigned = assigned_pixels(nnf)
    middle = usable_centres(nnf, radius)
    best = Proposal(nnf, delta_values, omega_sums, occurrence_weight, measure)
    k = 0
    while 2**k <= max(height, width) // 2:
        words = draw_grid(stream, height, width, k // 2)
        first = 0 if k % 2 == 0 else 2
        sides = omega_sums.shape
        y = draw_between(words[..., first], middle[..., 0], 2**k, radius, sides[0])
        x = draw_between(words[..., first + 1], middle[..., 1], 2**k, radius, sides[1])
        best.offer(np.stack([y, x], axis=-1), assigned)
        k += 1
    return best.nnf, best.delta


def stage_random_search(p, a):
    """Do stage random_search."""
    stream = case_stream(RANDOM_SEARCH, p)
    proposed_nnf, proposed_delta = random_search(*pass_arguments(p, a), stream)
    return {"proposed_nnf": proposed_nnf, "proposed_delta": proposed_delta}


STAGES = {"random_search": stage_random_search}
