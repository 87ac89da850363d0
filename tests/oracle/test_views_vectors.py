"""The vectors of coherent frames: the library's results for them, and their description."""

import os
import subprocess
import sys

import numpy as np
import pytest
from described import (
    assert_every_name_of_a_case_is_explained,
    assert_every_stage_has_cases_and_a_section,
    assert_types_of_files_are_those_that_occur,
    stages_in_table,
)
from kept_cases import assert_made_again
from listening import Listening

from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import PASSED
from oracle.families import VIEWS, folder_of
from oracle.make.views import views_cases
from oracle.stages import SYSTEMS, run_case
from oracle.stages.passes_port import PassesPort
from stylit_ref.views import passes

VERSION = VIEWS.versions[-1]
STAGES = SYSTEMS[VIEWS.name].stages


def cases(stage):
    return {case.name: case for case in read_cases(VERSION, [stage])}


def test_every_stage_has_cases_and_a_section():
    assert_every_stage_has_cases_and_a_section(VIEWS)
    assert stages_in_table(VIEWS) == set(VIEWS.sections)


def test_every_name_of_a_case_is_explained():
    assert_every_name_of_a_case_is_explained(VIEWS)


def test_types_of_files_are_those_that_occur():
    assert_types_of_files_are_those_that_occur(VIEWS, 10)


def test_cases_are_light():
    files = [file for file in folder_of(VERSION).glob("*/**/*") if file.is_file()]
    assert sum(file.stat().st_size for file in files) < 300_000


def share(stage, output):
    """For each case of a stage how many of its pixels are True, or not nowhere."""
    expected = {name: case.expected[output] for name, case in cases(stage).items()}
    return {
        name: np.mean(found if found.ndim == 2 else found[..., 0] >= 0)
        for name, found in expected.items()
    }


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    assert cases("fold")["contrast"].expected["spreads"].max() == 221
    nowhere = {"hidden"}
    for stage, output in (
        ("shift_map", "places"), ("cancel", "cancels"), ("compose", "visible"),
        ("splat", "winners"), ("invert", "visible"), ("unhidden", "visible"),
        ("along", "visible"), ("motion", "visible"),
    ):  # fmt: skip
        shares = share(stage, output)
        assert {name for name, found in shares.items() if found == 0} <= nowhere, stage
        assert any(0 < found < 1 for found in shares.values())
    assert {name for name, found in share("rims", "rims").items() if found == 0} == {"one_pixel"}
    inverted = cases("invert")
    assert inverted["cracks"].expected["visible"].all()
    assert not inverted["uncovered"].expected["visible"][2:5, 2].any()
    for case in cases("iteration").values():
        assert (case.arrays["nnf"] != case.expected["nnf"]).any()
    orders = {case.parameters["order"] for case in cases("run").values()}
    assert orders == {"parallel", "sweeps", "sequential"}


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    assert_made_again(views_cases(VERSION), VERSION, tmp_path)


@pytest.mark.slow
def test_our_passes_give_what_they_must():
    outcomes = list(check(PassesPort(VERSION), VERSION))
    assert {outcome.status for outcome in outcomes} == {PASSED}


@pytest.mark.parametrize("stage", [name for name, stage in STAGES.items() if stage.passes])
def test_a_stage_names_the_passes_that_it_uses(stage):
    ours = Listening(passes)
    for case in read_cases(VERSION, [stage]):
        run_case(VIEWS, stage, case.parameters, dict(case.arrays), ours)
    assert ours.heard == set(STAGES[stage].passes)


@pytest.mark.slow
def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own."""
    command = [sys.executable, "-m", "oracle", "check", "--cases", VERSION]
    done = subprocess.run(
        [*command, "--module", "gpu_cuda.views", "--jobs", "2"],
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    offered = sum(len(cases(name)) for name, stage in STAGES.items() if stage.passes)
    assert done.stdout.startswith(f"{offered} passed, ")
