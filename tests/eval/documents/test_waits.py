"""What a hand waits for, and how much memory a large texture takes."""

from types import SimpleNamespace

import numpy as np
import pytest
from small_textures import spots

from eval.documents.lasram import interaction as interaction_module
from eval.documents.lasram import peak_memory as memory_module
from eval.documents.lasram.interaction import Interaction, interaction
from eval.documents.lasram.peak_memory import peak_memory
from eval.runs.job import Job
from eval.runs.local import run
from eval.textures import Texture


@pytest.mark.slow
def test_times_of_a_patch_and_of_a_stroke(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(interaction_module, "REPEATS", 2)
    job = Job(Texture("spots", spots(1, 256), (320, 320)), Interaction())
    assert len(run(job).history) == 3 * 2
    table = interaction(job)
    assert table["at most [ms]"].tolist() == [10, 40, 50]
    assert (table[["least [ms]", "least of processors [ms]"]] > 0).all(axis=None)
    assert (table["least [ms]"] <= table["median [ms]"]).all()


@pytest.mark.slow
def test_memory_is_that_of_the_whole_program(monkeypatch):
    monkeypatch.setattr(memory_module, "SIDE", 160)
    monkeypatch.setattr(memory_module, "_WANTED", {256: 1})
    table = peak_memory(SimpleNamespace(preset=SimpleNamespace(memory_of=(256,))))
    assert table["exemplar"].tolist() == ["256x256"]
    assert 0.05 < table["peak [GiB]"][0] < 2


def test_a_preset_may_leave_memory_out():
    assert peak_memory(SimpleNamespace(preset=SimpleNamespace(memory_of=()))).empty


def test_a_stroke_wraps_and_is_as_long_as_the_brush_is_wide(monkeypatch):
    painted = []
    monkeypatch.setattr(interaction_module, "paint", lambda _, mask, exemplar: painted.append(mask))
    for place in ((150, 160), (0, 3)):
        interaction_module._stroke(SimpleNamespace(size=(300, 320)), place)
    inside, wrapped = painted
    assert np.ptp(np.nonzero(inside.any(axis=0))[0]) == pytest.approx(128, abs=2)
    assert np.ptp(np.nonzero(inside.any(axis=1))[0]) == pytest.approx(64, abs=2)
    assert inside.sum() == wrapped.sum()
