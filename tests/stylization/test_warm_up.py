"""Kernels that are compiled before a run."""

from dataclasses import replace

import numba
import numpy as np
import pytest
from numba.core import event

from stylit_ref import InputError, Params, stylize, warm_up
from stylit_ref.stylization.warm_up import kernels_of_run


class Compiled(event.Listener):
    """Names of what is compiled while it listens, in order."""

    def __init__(self):
        self.names = []

    def on_start(self, event):
        self.names.append(event.data["dispatcher"].__name__)

    def on_end(self, event):
        pass


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


def test_each_kernel_is_told_before_it_is_compiled(tmp_path, monkeypatch):
    """The kernels that no other test or run can have compiled, in a folder of their own."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    steps = []
    params = Params(schedule="scanline", patch_width=59)
    needed = kernels_of_run(params, 1, (1,))
    missing = [each for each in needed if not each.is_compiled]
    count = warm_up(
        params, style_channels=1, guide_channels=(1,), progress=lambda *step: steps.append(step)
    )
    assert count == len(missing) > 0
    assert steps == [(number, count) for number in range(1, count + 1)]


def test_a_rehearsal_leaves_kernels_as_they_are():
    kernels_of_run(Params(), 3, (3,))
    style, guide = random_images([(20, 20, 3), (20, 20, 3)])
    result = stylize(style, [guide], [guide], Params(levels=1, votes=1))
    assert (result.nnf > 0).all()


def test_channels_that_do_not_fit_are_refused():
    with pytest.raises(InputError, match="5 channels"):
        warm_up(style_channels=5)
