"""The study of --preset architecture: what its runs differ in, and its verdicts."""

from dataclasses import asdict

import numpy as np
import pandas as pd
import pytest

from data_gen.manifest import Manifest
from eval.documents.hauptfleisch.architecture import (
    RUNS,
    architecture_scene,
    claims,
    shown_table,
)
from eval.pages.claims import HELD, NOT_HELD, OPEN
from eval.read_frames import GUIDES
from stylit_ref import InputError, write_image


def test_each_run_lacks_one_choice():
    guides, params = RUNS["architecture"]
    assert guides == GUIDES
    changes = []
    for name in ("the wireframe", "the share of 0.9", "α", "t"):
        other_guides, other = RUNS[f"without {name}"]
        differing = [n for n, value in asdict(params).items() if asdict(other)[n] != value]
        changes.append([*differing, *(set(guides) - set(other_guides))])
    assert changes == [["WIREFRAME"], ["budget"], ["error_limit"], ["vote_outliers"]]
    assert RUNS["with an ID guide"] == ((*GUIDES, "IDMASK"), params)


@pytest.fixture
def numbers():
    """A table in which all choices help the first sketch, and none the two others."""
    rows = []
    for style, good in (("a", True), ("b", False), ("c", False)):
        for run in RUNS:
            helped = (run == "architecture") == good
            rows.append(
                {
                    "style": style,
                    "run": run,
                    "crooked": 1.0 if helped else 2.0,
                    "lost_lines": 0.1 if helped else 0.2,
                    "noise": np.nan if style == "c" else (3.0 if helped else 4.0),
                    "sharpness": 0.9 if helped else 0.8,
                    "cpu": 10.0,
                }
            )
    return pd.DataFrame(rows)


def test_a_choice_must_help_in_more_than_half_of_the_sketches(numbers):
    assert [claim.verdict for claim in claims(numbers)[1:5]] == 4 * [NOT_HELD]
    helped = claims(numbers[numbers["style"] == "a"])[1:5]
    assert [claim.verdict for claim in helped] == 4 * [HELD]
    assert helped[0].evidence == "with it and without it, it is 1.00 and 2.00 for a"


def test_unmodified_stylit_must_be_worse_in_every_sketch_that_shows_it(numbers):
    assert claims(numbers[numbers["style"] != "b"])[0].verdict == HELD
    assert claims(numbers)[0].verdict == NOT_HELD
    assert claims(numbers[numbers["style"] == "c"])[0].verdict == OPEN


def test_lines_are_bent_if_they_lie_farther_off_than_the_paintings(numbers):
    assert claims(numbers[numbers["style"] == "b"])[-1].verdict == HELD
    assert claims(numbers)[-1].verdict == NOT_HELD


def test_sketches_without_blank_paper_have_no_noise(numbers):
    text = shown_table(numbers)
    assert text["noise on white"].tolist()[-1] == ""
    assert text["noise on white"].tolist()[0] == "3.0"
    assert "c" not in claims(numbers)[3].evidence.rpartition(" for ")[2]


def test_a_scene_keeps_the_edges_of_the_model_if_no_guide_has_them(tmp_path):
    manifest = Manifest.open(tmp_path / "set")
    for view in ("sketched_house", "house/1_1"):
        for name in (*GUIDES, "IDMASK", "sketches/inked"):
            file = tmp_path / "set" / view / f"{name}.png"
            file.parent.mkdir(parents=True, exist_ok=True)
            write_image(file, np.full((6, 8, 3), 7, np.uint8))
        manifest.add(view)
    scene = architecture_scene(tmp_path / "set", "inked", RUNS["without the wireframe"][0])
    assert "WIREFRAME" not in scene.guide_names
    assert set(scene.buffers) == {"WIREFRAME"}
    with pytest.raises(InputError, match=r"does not list sketched_house/sketches/oil\.png"):
        architecture_scene(tmp_path / "set", "oil")
