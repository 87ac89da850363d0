"""The vectors of views between others: the library's results for them, and their description."""

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
from oracle.families import INTERPOLATION, folder_of
from oracle.make.interpolation import interpolation_cases
from oracle.stages import SYSTEMS, run_case
from oracle.stages.passes_port import PassesPort
from stylit_ref.views.interpolation import passes

VERSION = INTERPOLATION.versions[-1]
STAGES = SYSTEMS[INTERPOLATION.name].stages


def cases(stage):
    return {case.name: case for case in read_cases(VERSION, [stage])}


def test_every_stage_has_cases_and_a_section():
    assert_every_stage_has_cases_and_a_section(INTERPOLATION)
    assert stages_in_table(INTERPOLATION) == set(INTERPOLATION.sections)


def test_every_name_of_a_case_is_explained():
    assert_every_name_of_a_case_is_explained(INTERPOLATION)


def test_types_of_files_are_those_that_occur():
    assert_types_of_files_are_those_that_occur(INTERPOLATION, 9)


def test_cases_are_light():
    files = [file for file in folder_of(VERSION).glob("*/**/*") if file.is_file()]
    assert sum(file.stat().st_size for file in files) < 700_000


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    for case in cases("shift").values():
        assert 0 < case.expected["masked"].mean() < 1
        assert not np.isfinite(case.arrays["motion"]).all()
    assert cases("fetch")["none"].arrays["masked"].all()
    for name, case in cases("search").items():
        assert (case.expected["nnf"] == case.arrays["nnf"]).all() == (name == "equal")
    for name, case in cases("rasterize").items():
        share = (case.expected["triangles"] >= 0).mean()
        assert (share == 0) == (name in ("nothing", "edge_on"))
        assert share < 1
    assert np.isinf(cases("transfer")["behind"].expected["seen"]).any()


def test_our_passes_give_what_they_must():
    outcomes = list(check(PassesPort(VERSION), VERSION))
    assert {outcome.status for outcome in outcomes} == {PASSED}


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    assert_made_again(interpolation_cases(VERSION), VERSION, tmp_path)


@pytest.mark.parametrize("stage", [name for name, stage in STAGES.items() if stage.passes])
def test_a_stage_names_the_passes_that_it_uses(stage):
    ours = Listening(passes)
    for case in read_cases(VERSION, [stage]):
        run_case(INTERPOLATION, stage, case.parameters, dict(case.arrays), ours)
    assert ours.heard == set(STAGES[stage].passes)
