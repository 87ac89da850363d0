"""The guide of time between painted frames."""

import numpy as np
import pytest

from stylit_ref.metric.packing import ONE, make_packing
from stylit_ref.views.keyframes import STEPS, values_of_time, weights_with_time


def costs(frame, keyframes, channels=7, influence=2.0):
    """What each painting costs more in a frame, a pixel."""
    weights = weights_with_time([1.0], channels, len(keyframes))
    packing = make_packing([channels, 1], 3, influence, weights)
    weight = packing.weights[packing.guide_channels[1]] / ONE
    (value,) = values_of_time([frame], keyframes)
    return weight * np.square(np.subtract(value, values_of_time(keyframes, keyframes)))


def test_a_painted_frame_has_the_value_of_its_painting():
    assert values_of_time((10, 20, 50), (10, 20, 50)) == [0, 128, 255]


def test_frames_outside_have_that_of_the_nearest():
    assert values_of_time((1, 90), (10, 50)) == [0, 255]


def test_in_a_painted_frame_the_next_painting_costs_as_much_as_guides_that_are_steps_off():
    assert costs(10, (10, 50)) == pytest.approx([0, 2 * STEPS**2], rel=0.01)


@pytest.mark.parametrize("frame", [10, 20, 30, 40, 50])
def test_the_preference_falls_with_the_frames_along_a_line(frame):
    near, far = costs(frame, (10, 50))
    expected = 2 * STEPS**2 * (1 - 2 * (frame - 10) / 40)
    assert far - near == pytest.approx(expected, abs=0.01 * 2 * STEPS**2)


def test_of_three_the_farthest_costs_most():
    near, middle, far = costs(12, (10, 20, 90))
    assert near < middle < far


def test_other_guides_count_what_they_count_without_time():
    weights = (1.0, 2.0)
    alone = make_packing([3, 4], 3, 2.0, weights).weights
    beside = make_packing([3, 4, 1], 3, 2.0, weights_with_time(weights, 7, 2)).weights
    for number in (0, 4):
        assert beside[number] == pytest.approx(alone[number], abs=1)
