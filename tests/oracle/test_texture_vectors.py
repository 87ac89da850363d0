"""The vectors of texture synthesis: the library's results for them, and their description."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest
from described import (
    assert_every_name_of_a_case_is_explained,
    assert_every_stage_has_cases_and_a_section,
    assert_types_of_files_are_those_that_occur,
    text_of,
)
from kept_cases import assert_made_again

from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import PASSED
from oracle.families import TEXTURE
from oracle.make.texture import texture_cases
from oracle.stages.passes_port import PassesPort
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.placement import ACCEPTED, DEFORMED, REJECTED, UNTRIED
from stylit_ref.texture.session import TextureSession

VERSION = TEXTURE.versions[-1]


def cases(stage):
    return {case.name: case for case in read_cases(VERSION, [stage])}


def test_every_stage_has_cases_and_a_section():
    assert_every_stage_has_cases_and_a_section(TEXTURE)
    text = text_of(TEXTURE)
    assert all(f"\n| {stage} |" in text for stage in TEXTURE.sections)


def test_every_name_of_a_case_is_explained():
    def plain(case):
        return re.sub(r"_\d$", "", case.name) if case.stage == "closed_cut" else case.name

    assert_every_name_of_a_case_is_explained(TEXTURE, plain)


def test_types_of_files_are_those_that_occur():
    assert_types_of_files_are_those_that_occur(TEXTURE, 14)


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    outcomes = {o for case in cases("iteration").values() for o in case.expected["outcomes"]}
    assert outcomes == {UNTRIED, REJECTED, ACCEPTED, DEFORMED}
    costs = cases("costs")
    assert (costs["ray_ends"].expected["crossing"] == 2**30 - 1).any()
    assert costs["locked"].expected["saved"].min() < 0
    halved = {name for name, case in costs.items() if case.expected["halved"] > 0}
    assert halved == {"halved", "halved_locked", "halved_guided"}
    assert cases("alignment")["halved"].parameters["halved"] > 0
    assert (cases("seams")["cubed"].expected["seams_x"] == 2**24).any()
    assert 2**29 < cases("cut")["at_the_cap"].expected["costs"][0] < 2**30 - 1
    assert (cases("cut")["blocked"].expected["costs"] >= 2**29).tolist() == [False, True]
    for case in cases("run").values():
        assert (np.diff(case.expected["totals"]) <= 0).all() or case.name == "one_channel"
        assert (np.diff(case.expected["totals"]) < 0).any()
    assert len(np.unique(cases("alignment")["plain"].expected["shifts"])) > 2


@pytest.mark.slow
def test_cases_are_what_this_library_makes_of_them(tmp_path):
    assert_made_again(texture_cases(VERSION), VERSION, tmp_path)


@pytest.mark.slow
def test_our_passes_give_what_they_must():
    outcomes = list(check(PassesPort(VERSION), VERSION))
    assert {outcome.status for outcome in outcomes} == {PASSED}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["plain", "several", "quarters", "whole_pixels"])
def test_a_session_gives_what_a_run_must(name):
    """The session makes the tables of T, the ring and the limits by itself.

    Where pixels are locked it chooses other cells than the grid of the cases.
    """
    case = cases("run")[name]
    numbers, arrays = case.parameters, case.arrays
    images = [arrays[f"image_{k}"] for k in (1, 2) if f"image_{k}" in arrays]
    known = [arrays.get(f"known_{k}") for k in range(1, len(images) + 1)]
    params = TextureParams(
        radius=numbers["radius"],
        max_jump=numbers["max_jump"],
        max_deformation=numbers["max_shift"],
        gamma=0.5 if name == "whole_pixels" else 1.0,
        shift_penalty=numbers["penalty"],
        whole_pixels=not numbers["fractions"],
        candidates=numbers["prescreened"],
        spread=numbers["spread"],
        coherence=numbers["coherence"] / 65536,
    )
    session = TextureSession(
        images, (numbers["height"], numbers["width"]), params,
        seed=numbers["seed"], known=known, lock=arrays.get("lock"),
    )  # fmt: skip
    totals = [session.cost]
    for _ in range(numbers["iterations"]):
        session.step()
        totals.append(session.cost)
    assert totals == case.expected["totals"].tolist()
    np.testing.assert_array_equal(session.texture.addresses, case.expected["addresses"])


@pytest.mark.slow
def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own."""
    command = [sys.executable, "-m", "oracle", "check", "--cases", VERSION]
    done = subprocess.run(
        [*command, "--module", "gpu_cuda.texture", "--jobs", "2"],
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    offered = sum(len(cases(stage)) for stage in ("cut", "closed_cut", "alignment"))
    assert done.stdout.startswith(f"{offered} passed, ")
