"""Runs done here."""

import numpy as np
import pytest

import eval.methods.stylit_ref
import eval.runs.store
from eval.methods.stylit_ref import StylitRef
from eval.runs.job import Job
from eval.runs.local import run
from eval.scenes import load_scene
from stylit_ref import Params


def test_a_run_is_computed_once(folder, monkeypatch):
    scene = load_scene(folder)
    method = StylitRef(Params(levels=1, votes=1, patchmatch_iterations=1))
    first = run(Job(scene, method))

    def refuse(*arguments, **options):
        raise AssertionError("computed again")

    monkeypatch.setattr(eval.methods.stylit_ref, "stylize", refuse)
    again = run(Job(scene, method))
    np.testing.assert_array_equal(first.image, again.image)
    assert first.seconds == again.seconds
    with pytest.raises(AssertionError, match="computed again"):
        run(Job(scene, method, 1))
    with pytest.raises(AssertionError, match="computed again"):
        run(Job(load_scene(folder, step=2), method))
