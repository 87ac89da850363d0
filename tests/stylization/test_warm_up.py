"""Kernels that are compiled before a run."""

from dataclasses import replace

import numpy as np
import pytest
from compiled import Compiled
from numba.core import event

from stylit_ref import InputError, Params, stylize, warm_up
from stylit_ref.stylization.warm_up import kernels_of_run


def random_images(sizes_and_channels):
    random = np.random.default_rng(3)
    return [random.integers(0, 256, shape, np.uint8) for shape in sizes_and_channels]


@pytest.mark.parametrize(
    ("values", "style_channels", "guide_channels"),
    [
        ({}, 3, (3, 3, 3, 3, 3)),
        ({"schedule": "scanline"}, 3, (3,)),
        ({"vote_outliers": 3, "uniformity": 0}, 1, (1, 4)),
        ({"method": "guide_map", "epsilon": 0}, 3, (3, 1)),
        ({"method": "guide_map", "patch_width": 7}, 4, (3, 3)),
        ({"method": "stylit"}, 3, (3, 3)),
        ({"method": "stylit", "budget": 0.9, "error_limit": 5}, 2, (3,) * 6),
    ],
    ids=str,
)
@pytest.mark.slow
def test_a_run_compiles_nothing_that_was_not_warmed_up(values, style_channels, guide_channels):
    params = Params(**values)
    warm_up(params, style_channels=style_channels, guide_channels=guide_channels)
    assert warm_up(params, style_channels=style_channels, guide_channels=guide_channels) == 0
    style, *sources = random_images((61, 70, n) for n in (style_channels, *guide_channels))
    targets = random_images((80, 51, n) for n in guide_channels)
    mask = np.zeros((80, 51), bool)
    mask[:30, :20] = True
    short = replace(params, levels=3, votes=2, patchmatch_iterations=2)
    with event.install_listener("numba:compile", Compiled()) as compiled:
        stylize(style, sources, targets, short, mask=mask)
    assert compiled.names == []


def test_a_rehearsal_leaves_kernels_as_they_are():
    kernels_of_run(Params(), 3, (3,))
    style, guide = random_images([(20, 20, 3), (20, 20, 3)])
    result = stylize(style, [guide], [guide], Params(levels=1, votes=1))
    assert (result.nnf > 0).all()


def test_a_rehearsal_notes_nothing(caplog):
    with caplog.at_level("INFO", "stylit_ref"):
        kernels_of_run(Params(patch_width=63, uniformity=100), 3, (3,))
    assert caplog.records == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"style_channels": 5}, "style_channels is 5; it must be an integer from 1 to 4"),
        ({"guide_channels": 3}, "guide_channels is 3; it must be a list of numbers"),
        ({"guide_channels": [0]}, "guide_channels 1 is 0; it must be an integer from 1 to 1000"),
        ({"params": "fast"}, "params is 'fast'; write Params.preset('fast')"),
    ],
)
def test_arguments_that_do_not_fit_are_refused(arguments, said):
    with pytest.raises(InputError) as refused:
        warm_up(**arguments)
    assert str(refused.value) == said
