"""Colours that tell labels apart."""

import numpy as np

from stylit_ref.files.guides.label_colours import MOST_LABELS, distinct_colours


def test_each_colour_is_the_farthest_from_those_before():
    palette = [
        (r, g, b) for r in range(0, 256, 17) for g in range(0, 256, 17) for b in range(0, 256, 17)
    ]

    def nearest(colour, others):
        return min(
            sum((x - y) ** 2 for x, y in zip(colour, other, strict=True)) for other in others
        )

    chosen = distinct_colours(12)
    assert chosen[0] == (0, 0, 0)
    for number in range(1, 12):
        before = chosen[:number]
        farthest = max(nearest(colour, before) for colour in palette)
        assert nearest(chosen[number], before) == farthest


def test_fewer_colours_are_the_first_of_more():
    assert distinct_colours(5) == distinct_colours(9)[:5]


def test_as_many_as_there_can_be_are_all_different():
    assert len(set(distinct_colours(MOST_LABELS))) == MOST_LABELS


def test_a_few_are_far_apart():
    colours = np.array(distinct_colours(8))
    distances = np.linalg.norm(colours[:, None] - colours, axis=2)
    assert distances[~np.eye(8, dtype=bool)].min() > 150
