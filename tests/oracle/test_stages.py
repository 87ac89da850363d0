"""Every stage: the library and the naive port pass it, and it is checked if a port offers it."""

import os
import re
import subprocess
import sys
from collections import Counter
from types import ModuleType

import pytest
from listening import Listening

from oracle.cases import read_cases
from oracle.check import check
from oracle.compare import FAILED, NOT_OFFERED, PASSED, outcome_of
from oracle.families import NEWEST, STYLIZATION, stages_of
from oracle.ports import ModulePort
from oracle.stages import SYSTEMS, is_offered, run_case
from oracle.stages.passes_port import PassesPort
from stylit_ref import passes

STAGES = SYSTEMS[STYLIZATION.name].stages


def smallest_case(stage):
    """The case of a stage with the fewest elements."""

    def elements(case):
        return sum(array.size for array in (case.arrays | case.expected).values())

    return min(read_cases(NEWEST, [stage]), key=elements)


@pytest.mark.parametrize("stage", stages_of(NEWEST))
@pytest.mark.parametrize(
    "port", [PassesPort(NEWEST), ModulePort("naive_port")], ids=["passes", "naive"]
)
def test_the_smallest_case_of_a_stage_is_what_it_was(port, stage):
    outcome = outcome_of(port, (), smallest_case(stage))
    assert (outcome.status, outcome.difference) == (PASSED, None)


@pytest.mark.slow
def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own.

    Whole levels and runs take as long as all else. ``tests/gpu_cuda`` compares them with those of
    the CPU.
    """
    stages = [stage for stage in stages_of(NEWEST) if stage not in ("level", "run")]
    command = [sys.executable, "-m", "oracle", "check", "--module", "gpu_cuda"]
    command += ["--jobs", "2", "--stages", ",".join(stages)]
    done = subprocess.run(
        command,
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    counts = Counter(case.stage for case in read_cases(NEWEST, stages))
    formulae_alone = "philox", "weights", "phi", "commit_order"
    beyond = *formulae_alone, *stages[stages.index("lower_bound") :]
    not_offered = sum(counts[stage] for stage in beyond)
    assert {status: int(n) for n, status in re.findall(r"(\d+) (.+?)[,\n]", done.stdout)} == {
        "not offered": not_offered,
        "passed": counts.total() - not_offered,
    }


@pytest.mark.slow
@pytest.mark.parametrize("stage", [name for name, stage in STAGES.items() if stage.passes])
def test_a_stage_is_offered_where_a_module_has_all_that_it_uses(stage):
    ours, needed = Listening(passes), STAGES[stage].passes
    for case in read_cases(NEWEST, [stage]):
        run_case(STYLIZATION, stage, case.parameters, dict(case.arrays), ours)
    assert ours.heard == set(needed)
    few = ModuleType("few_passes")
    vars(few).update({name: getattr(passes, name) for name in needed})
    assert is_offered(STYLIZATION, stage, few)
    for name in needed:
        fewer = ModuleType("fewer_passes")
        vars(fewer).update({key: value for key, value in vars(few).items() if key != name})
        assert not is_offered(STYLIZATION, stage, fewer)


@pytest.mark.slow
def test_only_what_a_module_does_is_checked(monkeypatch):
    mistaken = ModuleType("mistaken_passes")
    vars(mistaken).update({name: getattr(passes, name) for name in passes.__all__})
    mistaken.vote = lambda source, target, *rest: target.fill(7)
    monkeypatch.setitem(sys.modules, "mistaken_passes", mistaken)
    stages = ["philox", "downsample", "vote", "run"]
    outcomes = list(check(PassesPort(NEWEST, "mistaken_passes"), NEWEST, stages))
    found = {outcome.stage: outcome.status for outcome in outcomes}
    assert found == {"philox": NOT_OFFERED, "downsample": PASSED, "vote": FAILED, "run": FAILED}
