"""The vectors of the real-time method: the library's results for them, and their description."""

import os
import subprocess
import sys

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
from oracle.families import REALTIME, folder_of
from oracle.make.realtime import realtime_cases
from oracle.stages import SYSTEMS, run_case
from oracle.stages.passes_port import PassesPort
from stylit_ref.realtime import passes

VERSION = REALTIME.versions[-1]
STAGES = SYSTEMS[REALTIME.name].stages


def cases(stage):
    return {case.name: case for case in read_cases(VERSION, [stage])}


def test_every_stage_has_cases_and_a_section():
    assert_every_stage_has_cases_and_a_section(REALTIME)
    assert stages_in_table(REALTIME) == set(REALTIME.sections)


def test_every_name_of_a_case_is_explained():
    assert_every_name_of_a_case_is_explained(REALTIME)


def test_types_of_files_are_those_that_occur():
    assert_types_of_files_are_those_that_occur(REALTIME, 11)


def test_cases_are_light():
    files = [file for file in folder_of(VERSION).rglob("*") if file.is_file()]
    assert sum(file.stat().st_size for file in files) < 600_000


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    assert cases("energy")["contrast"].expected["energy"].max() > 1 << 30
    assert (cases("entry_labels")["lost"].expected["labels"] == -1).any()
    assert (cases("entry_labels")["at_the_edge"].expected["labels"] == -1).any()
    principal = cases("pack_principal")
    assert {0, 255} <= set(principal["clipped"].expected["features"].flat)
    assert 0 in principal["unknown_colours"].expected["labels"]
    moved = {
        name: (case.arrays["nnf"] != case.expected["nnf"]).any()
        for name, case in cases("search").items()
    }
    assert {name for name, is_moved in moved.items() if not is_moved} == {"ties", "one_pixel"}
    for case in cases("stroke").values():
        assert (case.expected["replayed"] != case.expected["picture"]).any() or (
            case.name == "guides_only"
        )


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    assert_made_again(realtime_cases(VERSION), VERSION, tmp_path)


@pytest.mark.slow
def test_our_passes_give_what_they_must():
    outcomes = list(check(PassesPort(VERSION), VERSION))
    assert {outcome.status for outcome in outcomes} == {PASSED}


@pytest.mark.slow
@pytest.mark.parametrize("stage", [name for name, stage in STAGES.items() if stage.passes])
def test_a_stage_names_the_passes_that_it_uses(stage):
    ours = Listening(passes)
    for case in read_cases(VERSION, [stage]):
        run_case(REALTIME, stage, case.parameters, dict(case.arrays), ours)
    assert ours.heard <= set(STAGES[stage].passes)


@pytest.mark.slow
def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own.

    Whole frames take longer than all else. ``tests/gpu_cuda`` compares them with those of the CPU.
    """
    whole = "frame", "warm_frame"
    stages = [name for name, stage in STAGES.items() if stage.passes and name not in whole]
    command = [sys.executable, "-m", "oracle", "check", "--cases", VERSION]
    command += ["--jobs", "2", "--stages", ",".join(stages)]
    done = subprocess.run(
        [*command, "--module", "gpu_cuda.realtime"],
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    assert done.stdout == f"{sum(len(cases(name)) for name in stages)} passed\n"
