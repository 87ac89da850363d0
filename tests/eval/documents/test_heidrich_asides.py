"""The sections of the report on the thesis that need more than the bundled scene."""

import os
from functools import cache

import numpy as np
import pandas as pd
import pytest

from data_gen.manifest import Manifest
from eval.__main__ import main
from eval.documents.heidrich import stage
from eval.documents.heidrich.beside import SEEDS, Beside
from eval.documents.heidrich.busy import BesideOthers
from eval.documents.heidrich.faults import DENSE, FAULTS, VARIANTS, Faults
from eval.documents.heidrich.frame_times import FrameTimes
from eval.documents.heidrich.house import BUFFERS, SKETCH, SOURCE, TARGET, Components, house
from eval.documents.heidrich.outlook import Hybrid
from eval.documents.heidrich.prototype import InTurns, Prototype, prototype_of
from eval.methods.realtime import Frames, Realtime
from eval.metrics import METRICS, NUMBERS
from eval.pages.page import new_report
from eval.runs.busy_programs import spinning_processes
from eval.runs.complete import complete
from eval.scenes import BUNDLED
from stylit_ref import InputError, read_uint8, write_image
from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.refinement import refine

PROTOTYPE = """
import numpy as np

PRESETS = {name: {} for name in ("quick", "best", "thesis-ev", "thesis-ov-mip")}


def labels(buffers):
    return buffers["IDMASK"][..., 0]


def pack(buffers):
    return buffers["FULL"]


class Engine:
    def __init__(self, guides, style, size, ids=None):
        self.size, self.style = size, style

    def frame(self, guides, seed):
        return np.full((*self.size, 3), self.style.mean(), np.uint8)
"""


@cache
def small(side=80):
    return stage.enlarged(stage.bundled("oil"), side)


@pytest.fixture
def prototype(tmp_path):
    file = tmp_path / "prototype.py"
    file.write_text(PROTOTYPE, encoding="utf-8")
    return str(file)


def test_a_hybrid_is_the_optimized_method_with_the_finest_level_of_the_simple_one():
    scene = small()
    optimized = Frames(scene, RealtimeParams.preset("optimized", iterations=(0, 2)))
    optimized.frame()
    simple = Frames(scene, RealtimeParams.preset("simple", levels=1, start="vote"))
    simple.take()
    exemplar, target, refinement, _ = inputs = simple.session.inputs
    assert refinement.layout.params.iterations_at(0) == 2
    nnf = entries_of(optimized.session.nnf)
    refine(exemplar, target, refinement, [nnf], 0, 0, np.zeros(1, np.uint8))
    hybrid = Hybrid().frames(scene, 0)
    np.testing.assert_array_equal(hybrid.frame(), inputs.blended(nnf))
    np.testing.assert_array_equal(hybrid.session.nnf, places_of(nnf))


def test_frames_and_a_prototypes_take_turns(prototype):
    history = InTurns(prototype, rounds=2).run(small(), 0).history.set_index("preset")
    assert list(history.index) == ["quick", "best", "simple", "optimized"]
    assert (history["theirs"] > history["packed"]).all()
    assert (history["ratio"] < history["ratio_packed"]).all()


def test_a_prototype_is_another_run_when_its_file_changes(prototype):
    before = Prototype(prototype, "best").code
    with open(prototype, "a", encoding="utf-8") as file:
        file.write("\nMORE = 1\n")
    assert Prototype(prototype, "best").code != before


def test_energies_of_ours_and_of_a_prototype_are_asked_at_every_size_in_every_style(prototype):
    beside = Beside(prototype, lambda style, side: small(side), (40, 48))
    pictures = [task for task in beside.tasks if task.metrics == ("image_energy",)]
    assert len(pictures) == 2 * len(stage.STYLES) * 2 * 2 * SEEDS


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (None, "is not a file; give the path"),
        ("1 / 0", "cannot be loaded: division by zero"),
        ("PRESETS = {}", "has no Engine, pack, labels"),
        (PROTOTYPE.replace("thesis-ev", "ev"), "has no thesis-ev among its PRESETS"),
    ],
)
def test_a_prototype_that_does_not_fit_is_one_sentence(tmp_path, text, sentence):
    file = tmp_path / "other.py"
    if text:
        file.write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=sentence):
        prototype_of(str(file))


def test_a_prototype_without_rendered_scenes_is_one_sentence(prototype, monkeypatch, capsys):
    monkeypatch.chdir(os.path.dirname(prototype))
    assert main(["heidrich", "--prototype", prototype]) == 2
    assert "render them with 'make data SIZE=500x500" in capsys.readouterr().err


@pytest.fixture
def house_data(tmp_path):
    """The bundled house, every fourth pixel, with a drawing."""
    bundled = Manifest.read(BUNDLED)
    manifest = Manifest(tmp_path, {}, {})
    for piece, view in ((SOURCE, "house/source"), (TARGET, TARGET)):
        (tmp_path / piece).mkdir(parents=True)
        for name in (*BUFFERS, "IDMASK"):
            image = read_uint8(bundled.path(f"{view}/{name}.png"))[::4, ::4]
            write_image(tmp_path / piece / f"{name}.png", np.ascontiguousarray(image))
    (tmp_path / SOURCE / "sketches").mkdir()
    write_image(
        tmp_path / SOURCE / "sketches" / f"{SKETCH}.png", np.ascontiguousarray(image[..., :3])
    )
    for piece in (SOURCE, TARGET):
        manifest.add(piece)
    return tmp_path


@pytest.mark.slow
def test_the_house_is_packed_in_both_ways(house_data):
    history = Components(rounds=1, seeds=1).run(house(house_data), 0).history
    every, components = history.to_dict("records")
    assert (every["bytes"], components["bytes"]) == (19, 8)
    assert every["all"] == every["nearest"] == pytest.approx(1)
    assert components["nearest"] > 0.9
    assert 0 < components["energy"] < 1.5 * every["energy"]


def test_a_data_set_without_the_house(house_data):
    assert house(house_data / "elsewhere") is None
    manifest = Manifest.read(house_data)
    del manifest.pieces[SOURCE]
    manifest.save()
    assert house(house_data) is None


def test_frames_beside_programs_that_spin():
    (row,) = BesideOthers(seconds=0.2, trials=1).run(small(), 0).history.to_dict("records")
    assert row["slower"] > 0
    assert row["back"] >= 0
    assert min(row["quiet"], row["one"], row["choice"]) > 0


def test_programs_that_spin_end_with_the_block():
    with spinning_processes(1) as (process,):
        assert process.poll() is None
    assert process.poll() is not None


def test_every_fault_has_a_number_and_a_finding():
    for fault in FAULTS:
        assert fault.number in METRICS[fault.number].NUMBERS.keys() & NUMBERS.keys()
        assert fault.finding


@pytest.mark.slow
def test_faults_are_measured_and_shown(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    few = {name: VARIANTS[name] for name in ("quick", "best", "best, dense finish")}
    monkeypatch.setattr("eval.documents.heidrich.faults.VARIANTS", few)
    scenes = {
        (style, side): stage.enlarged(stage.bundled(style), side)
        for style in ("oil", "pen", "watercolour")
        for side in (88, 96)
    }
    section = Faults(lambda style, side: scenes[style, side], (88, 96), 1)
    assert not complete(section.tasks)
    with new_report(tmp_path / "report") as report:
        text = "\n".join(section.sections(report))
    assert (tmp_path / "report/faults.webp").exists()
    assert all(fault.title in text for fault in FAULTS)
    table = pd.read_csv(tmp_path / "report/faults.csv")
    assert table["method"].tolist() == 2 * [*few, DENSE]
    assert not table.drop(columns="ms").isna().any(axis=None)
    assert (table["ms"] > 0).sum() == 2 * len(few)


def test_times_depend_on_the_code_of_the_methods_that_are_timed():
    class Other(Realtime):
        code = "edited"

    def code_with(method):
        return FrameTimes("times", (method,), 1).code

    assert code_with(Realtime("a")) == code_with(Realtime("b"))
    assert code_with(Realtime("a")) != code_with(Other("a"))
