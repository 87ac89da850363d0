"""The oracle: cases that are what they were, ports that pass, mistakes that are found."""

import hashlib
import inspect
import json
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path
from types import ModuleType

import jsonschema
import naive_port
import numpy as np
import pytest

from oracle.cases import (
    SECTIONS,
    STAGES,
    VERSIONS,
    damaged_files,
    folder_of,
    read_arrays,
    read_cases,
)
from oracle.check import FAILED, PASSED, check, module_port
from oracle.make import cases
from stylit_ref import passes
from stylit_ref.cli import main

NAIVE = Path(naive_port.__file__)


def failed_stages(port, stages=STAGES):
    """Stages with a case that failed, in order, and the first message."""
    bad = [outcome for outcome in check(port, "v1", stages) if outcome.status == FAILED]
    found = list(dict.fromkeys(outcome.title.partition("/")[0] for outcome in bad))
    return found, bad[0].message if bad else ""


DIGESTS = {
    "v1": "606196c9b3ec25a03ed20e8a0e6e2b0fa76306a2a61b8ae477bf6df8279ba7de",
}
"""SHA-256 of the SHA256SUMS of every version: what is published never changes."""


def test_published_versions_are_what_they_were():
    assert DIGESTS.keys() == set(VERSIONS)
    for version, digest in DIGESTS.items():
        assert damaged_files(version) == []
        assert (
            hashlib.sha256((folder_of(version) / "SHA256SUMS").read_bytes()).hexdigest() == digest
        )


def test_descriptions_follow_the_schema():
    text = (folder_of("v1") / "case.schema.json").read_text(encoding="utf-8")
    schema = jsonschema.Draft202012Validator(json.loads(text))
    schema.check_schema(schema.schema)
    files = sorted(folder_of("v1").glob("*/*/case.json"))
    assert len(files) > 200
    for file in files:
        schema.validate(json.loads(file.read_text(encoding="utf-8")))


def test_every_stage_has_cases_and_a_section():
    titles = [case.stage for case in read_cases("v1")]
    assert set(titles) == set(STAGES) == set(SECTIONS)
    spec = (folder_of("v1").parent / "SPEC.md").read_text(encoding="utf-8")
    assert all(f"\n## {section}. " in spec for section in SECTIONS.values())
    assert all(f"\n| {stage} |" in spec for stage in STAGES)


def test_cases_are_what_this_library_makes_of_them():
    made = {case.title: case for case in cases()}
    kept = {case.title: case for case in read_cases("v1")}
    assert made.keys() == kept.keys()
    for title, case in made.items():
        assert case.parameters == kept[title].parameters
        for ours, theirs in (
            (case.arrays, kept[title].arrays),
            (case.expected, kept[title].expected),
        ):
            assert ours.keys() == theirs.keys()
            for name, array in ours.items():
                np.testing.assert_array_equal(array, theirs[name], err_msg=f"{title} {name}")


def test_cases_are_awkward():
    """Each thing that a port may get wrong is there."""
    all_cases = {case.title: case for case in read_cases("v1")}
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


def test_our_passes_give_what_they_must():
    outcomes = list(check(module_port(passes), "v1"))
    assert {outcome.status for outcome in outcomes} == {PASSED}


def test_a_port_written_from_the_text_alone_gives_the_same():
    assert "stylit_ref" not in NAIVE.read_text(encoding="utf-8")
    assert failed_stages(module_port(naive_port)) == ([], "")


MISTAKES = {
    "an off-by-one radius": (
        "while 2**k <= max(height, width) // 2:",
        "while 2**k < max(height, width) // 2:",
        "random_search",
    ),
    "a float metric": (
        "total += (weights * difference * difference).sum(axis=-1)",
        "total += (weights * difference * difference).astype(np.float32).sum(axis=-1).astype(int)",
        "delta",
    ),
    "Ω live instead of committed": (
        """for class_y, class_x in order:
        in_class = (ys % 4 == class_y) & (xs % 4 == class_x) & assigned_pixels(nnf)""",
        """pixels = [(y, x) for c, d in order for y in range(c, len(ys), 4)
              for x in range(d, len(ys[0]), 4)]
    for pixel_y, pixel_x in pixels:
        in_class = (ys == pixel_y) & (xs == pixel_x) & assigned_pixels(nnf)""",
        "commit",
    ),
    "commit classes in another order": (
        "order = [(k // 4, k % 4) for k in range(16)]",
        "order = [(k % 4, k // 4) for k in range(16)]",
        "commit_order",
    ),
    "a swapped candidate order": (
        "((0, distance), (distance, 0), (0, -distance), (-distance, 0))",
        "((distance, 0), (0, distance), (0, -distance), (-distance, 0))",
        "propagation",
    ),
    "round half to even": (
        "(2 * total + n) // np.maximum(2 * n, 1)",
        "np.rint(total / np.maximum(n, 1)).astype(int)",
        "vote",
    ),
    "mirrored instead of clamped": (
        "y = np.clip(pixels[..., 0] + dy, 0, height - 1)",
        "y = np.pad(np.arange(height), 9, mode='symmetric')[pixels[..., 0] + dy + 9]",
        "delta",
    ),
    "an equal candidate replaces": (
        "better = valid & (candidate_phi < self.phi)",
        "better = valid & (candidate_phi <= self.phi)",
        "propagation",
    ),
    "the seed's words swapped": (
        "seed & WORD, (seed >> 32) & WORD",
        "(seed >> 32) & WORD, seed & WORD",
        "random_nnf",
    ),
    "an iteration counted from 0": (
        "for iteration in range(1, iterations + 1):",
        "for iteration in range(iterations):",
        "level",
    ),
    "a later claim wins a tie": (
        "error < delta_values[pixel]:",
        "error <= delta_values[pixel]:",
        "settle",
    ),
    "all claims made anew in a retrieval": (
        "for iteration in range(iterations * k + 1,",
        "claims[:] = 0\n        for iteration in range(iterations * k + 1,",
        "stylit_search",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake):
    right, wrong, stage = MISTAKES[mistake]
    source = inspect.getsource(naive_port)
    assert right in source
    code = compile(source.replace(right, wrong, 1), f"<{mistake}>", "exec")
    mistaken = ModuleType("mistaken_port")
    exec(code, vars(mistaken))
    found, message = failed_stages(module_port(mistaken))
    assert found[0] == stage
    assert "it must be" in message
    assert "differ)" in message or "shape" in message


def test_cuda_kernels_give_what_they_must():
    """In Numba's simulator, which needs a process of its own."""
    command = [sys.executable, "-m", "stylit_ref.cli", "oracle", "check", "--module", "gpu_cuda"]
    done = subprocess.run(
        [*command, "--xfail", folder_of("v1").with_name("gpu_cuda.xfail")],
        check=False, capture_output=True, text=True,
        env=os.environ | {"NUMBA_ENABLE_CUDASIM": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout
    counts = Counter(case.stage for case in read_cases("v1"))
    beyond = sum(counts[stage] for stage in STAGES[STAGES.index("lower_bound") :])
    beyond -= counts["budget"] + counts["knee"]
    passed = counts.total() - beyond
    assert done.stdout == f"{passed} passed, {beyond} failed as expected\n"


def test_a_command_is_a_port(tmp_path, capsys):
    command = f"{sys.executable} {NAIVE} {{input}} {{output}}"
    report = tmp_path / "report.json"
    arguments = ["oracle", "check", "--port", command, "--stages", "philox,vote", "--json"]
    assert main([*arguments, str(report)]) == 0
    assert "passed" in capsys.readouterr().out
    outcomes = json.loads(report.read_text(encoding="utf-8"))["outcomes"]
    assert {outcome["status"] for outcome in outcomes} == {PASSED}


def test_a_port_that_fails_is_told_where(tmp_path, capsys):
    port = tmp_path / "port.py"
    port.write_text("import sys\nsys.exit('no such stage')\n", encoding="utf-8")
    command = f"{sys.executable} {port} {{input}} {{output}}"
    assert main(["oracle", "check", "--port", command, "--stages", "commit_order,knee"]) == 1
    said = capsys.readouterr().out
    assert "commit_order/first: failed: RuntimeError: exit code 1: no such stage" in said
    assert "Begin with stage commit_order: section 9 of" in said


def test_expected_failures_do_not_count_but_unexpected_passes_do(tmp_path, capsys):
    wrong = "knee/ends  # not yet\n"
    (tmp_path / "xfail.txt").write_text(wrong, encoding="utf-8")
    (tmp_path / "port.py").write_text("", encoding="utf-8")
    command = f"{sys.executable} {tmp_path / 'port.py'} {{input}} {{output}}"
    options = ["--stages", "knee", "--xfail", str(tmp_path / "xfail.txt")]
    assert main(["oracle", "check", "--port", command, *options]) == 0
    assert "1 failed as expected" in capsys.readouterr().out
    assert main(["oracle", "check", *options]) == 1
    assert "knee/ends: passed unexpectedly" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("found", "said"),
    [
        ({}, "order is not there"),
        ({"order": np.zeros((16, 2), np.int64)}, "order is int64; it must be int32"),
        ({"order": np.zeros((2, 16), np.int32)}, "order has shape (2, 16); it must be (16, 2)"),
    ],
)
def test_what_differs_is_named(found, said):
    (outcome, _) = check(lambda case: found, "v1", ["commit_order"])
    assert outcome.status == FAILED
    assert said in outcome.message


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--stages", "philo"], "'philo' is no stage"),
        (["--cases", "v2"], "there are no cases 'v2'; there are v1"),
        (["--port", "run it"], "must name {input} and {output}"),
        (["--module", "no.such.module"], "no.such.module: cannot be imported"),
        (["--xfail", "nowhere.txt"], "nowhere.txt: cannot be read"),
    ],
)
def test_bad_arguments_are_one_sentence(arguments, said, capsys):
    assert main(["oracle", "check", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_a_pickled_answer_is_refused(tmp_path):
    np.save(tmp_path / "order.npy", np.array([object()]), allow_pickle=True)
    with pytest.raises(ValueError, match="allow_pickle"):
        read_arrays(tmp_path)
