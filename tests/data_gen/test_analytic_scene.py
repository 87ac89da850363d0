import numpy as np

from data_gen.analytic_scene import FIGURE, PASSES, SPHERE, render
from data_gen.painted_style import paint_crayon

SMALL = {"height": 38, "width": 50, "antialias": 1, "light_side": 2, "bounces": 4}


def test_passes_and_style_are_deterministic():
    first, again = render(SPHERE, **SMALL), render(SPHERE, **SMALL)
    assert tuple(first) == PASSES
    for name in PASSES:
        np.testing.assert_array_equal(first[name], again[name])
        assert first[name].shape == (38, 50, 3)
    np.testing.assert_array_equal(paint_crayon(first), paint_crayon(again))


def test_full_light_is_no_darker_than_its_parts():
    passes = render(FIGURE, **SMALL)
    assert (passes["fullgi"] >= passes["dirdif"]).all()
    assert (passes["fullgi"] >= passes["dirspc"]).all()


def test_the_object_is_red_and_has_a_highlight():
    passes = render(SPHERE, **SMALL)
    centre = passes["dirdif"][17, 25].astype(int)
    assert centre[0] > centre[1] + 50
    assert passes["dirspc"].max() > 200
