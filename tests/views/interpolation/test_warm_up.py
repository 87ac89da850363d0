"""Kernels that pictures between views call are known before the first is made."""

import numpy as np
import pytest
from compiled import Compiled
from numba.core import event
from small_run import write_run

from stylit_ref import views_of_run
from stylit_ref.machine.compilation import compile_missing
from stylit_ref.views.interpolation.view_interpolator import MODES
from stylit_ref.views.interpolation.warm_up import kernels_of_views


@pytest.mark.parametrize("holds", ["mesh", "positions", "fields"])
def test_pictures_compile_nothing_that_was_not_warmed_up(tmp_path, holds):
    run = write_run(tmp_path, holds=holds)
    compile_missing(kernels_of_views(3, 5, holds))
    with event.install_listener("numba:compile", Compiled()) as compiled:
        views = views_of_run(run)
        pictures = [views.picture((0.0, 0.0), mode) for mode in MODES]
    assert compiled.names == []
    assert all(picture.any() for picture in pictures)


def test_a_rehearsal_leaves_nothing_behind(tmp_path):
    views = views_of_run(write_run(tmp_path))
    before = views.picture((0.0, 0.0))
    kernels_of_views(3, 5)
    np.testing.assert_array_equal(views.picture((0.0, 0.0)), before)
