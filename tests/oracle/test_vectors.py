"""The vectors: their contents, their description, and the library's results for them."""

import re
from fnmatch import fnmatchcase

import numpy as np
import pytest
from kept_cases import assert_made_again

from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import PASSED
from oracle.families import NEWEST, STYLIZATION, spec_of, stages_of
from oracle.make.stylization import stylization_cases
from oracle.stages.passes_port import PassesPort


def test_every_stage_has_cases_and_a_section():
    titles = [case.stage for case in read_cases(NEWEST)]
    assert set(titles) == set(STYLIZATION.sections) == set(stages_of(NEWEST))
    spec = spec_of(NEWEST).read_text(encoding="utf-8")
    assert all(f"\n## {section}. " in spec for section in STYLIZATION.sections.values())
    assert all(f"\n| {stage} |" in spec for stage in titles)


def test_every_name_of_a_case_is_explained():
    table = spec_of(NEWEST).read_text(encoding="utf-8").partition("\n| name | why it is there |")[2]
    rows = re.findall(r"^\| (`.+`) \|", table.partition("\n## ")[0], re.MULTILINE)
    explained = {name.strip("`") for row in rows for name in row.split(", ")}
    used = set()
    for case in read_cases(NEWEST):
        plain = re.sub(r"_\d$", "", case.name)
        found = {name for name in explained if fnmatchcase(case.name, name) or name == plain}
        assert found, case.title
        used |= found
    assert used == explained


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    all_cases = {case.title: case for case in read_cases(NEWEST)}
    levels = [case for title, case in all_cases.items() if title.startswith("iteration/")]
    assert {case.parameters["patch_width"] for case in levels} == {3, 5, 7}
    assert any(case.parameters["occurrence_weight"] == 0 for case in levels)
    assert any((case.arrays["nnf"] < 0).any() for case in levels)
    assert any(np.unique(case.arrays["source"]).size == 1 for case in levels)
    styles = {case.arrays["source"].shape[2] - case.parameters["guide_channels"] for case in levels}
    assert styles == {1, 3, 4}
    assert all(
        (case.expected["nnf"] != case.arrays["nnf"]).any()
        for case in levels
        if "all_ties" not in case.title
    )


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    assert_made_again(stylization_cases(NEWEST), NEWEST, tmp_path)


@pytest.mark.slow
def test_our_passes_give_what_they_must():
    outcomes = list(check(PassesPort(NEWEST), NEWEST))
    assert {outcome.status for outcome in outcomes} == {PASSED}
