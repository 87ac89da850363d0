"""The fast tests catch mistakes: each of these, made in a copy of the checkout, makes them fail."""

import re
from typing import NamedTuple

import pytest
from code_copy import CHECKOUT, PACKAGES, CodeCopy


class Mutation(NamedTuple):
    """A change that makes one line of a file wrong, and the tests that should notice it."""

    file: str
    right: str
    wrong: str
    tests: str


MUTATIONS = {
    "an equal candidate replaces": Mutation(
        "stylit_ref/formulae/improve_assignment.py",
        "if penalty + delta >= best_phi:",
        "if penalty + delta > best_phi:",
        "tests/passes/test_proposals.py::test_equal_candidates_do_not_move",
    ),
    "clamped a pixel too far": Mutation(
        "stylit_ref/formulae/candidates.py",
        "x = clamp(neighbour_x - dx, radius, source_width - 1 - radius)",
        "x = clamp(neighbour_x - dx, radius, source_width - radius)",
        "tests/formulae/test_candidates.py",
    ),
    "a neighbour's assignment shifted on instead of back": Mutation(
        "stylit_ref/formulae/candidates.py",
        "y = clamp(neighbour_y - dy, radius,",
        "y = clamp(neighbour_y + dy, radius,",
        "tests/formulae/test_candidates.py",
    ),
    "half rounded down": Mutation(
        "stylit_ref/formulae/rounding.py",
        "return (total + 2) // 4",
        "return (total + 1) // 4",
        "tests/passes/test_pyramid.py",
    ),
    "a wrong word of Philox": Mutation(
        "stylit_ref/randomness/philox.py",
        "c3 = np.uint32(product_0 &",
        "c3 = np.uint32(product_1 &",
        "tests/randomness/test_philox.py",
    ),
    "W follows the last class of a commit alone": Mutation(
        "stylit_ref/passes/commit.py",
        "if not occurrence_weight:",
        "if not occurrence_weight or n < order.shape[0] - 1:",
        "tests/passes/test_commit.py::test_commit_takes_what_lowers_phi_class_by_class"
        "[{'uniformity': 100000}]",
    ),
    "patches on the first row do not vote": Mutation(
        "stylit_ref/passes/vote.py",
        "not (0 <= near_y < height and",
        "not (0 < near_y < height and",
        "tests/passes/test_vote.py::test_vote_is_the_mean_rounded_half_up[{}]",
    ),
    "a random search over twice the distance": Mutation(
        "stylit_ref/formulae/search_radii.py",
        "return (int(side) // 2).bit_length()",
        "return int(side).bit_length()",
        "tests/passes/test_proposals.py::test_random_search[{}]",
    ),
    "the means' part of δ rounded to the nearest": Mutation(
        "stylit_ref/formulae/guide_map.py",
        "return total // (patch_width * patch_width)",
        "return (total + patch_width * patch_width // 2) // (patch_width * patch_width)",
        "tests/passes/test_guide_map.py::test_delta_of_white_patches_compares_means"
        "[{'smooth': True}]",
    ),
    "a later claim wins a tie": Mutation(
        "stylit_ref/passes/claims.py",
        "or error < delta[target_y, target_x]:",
        "or error <= delta[target_y, target_x]:",
        "tests/passes/test_claims.py",
    ),
}


@pytest.fixture(scope="module")
def code(tmp_path_factory):
    """A copy of the code that the tests need."""
    copy = CodeCopy(tmp_path_factory.mktemp("checkout"), (*PACKAGES, "tests"))
    copy.add("pyproject.toml", (CHECKOUT / "pyproject.toml").read_text(encoding="utf-8"))
    return copy


def fast_tests(code, tests):
    """Exit code and output of the fast tests, up to the first failure."""
    options = "-x", "-m", "not slow", "-p", "no:cacheprovider"
    done = code.try_python("-m", "pytest", *options, *tests)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.slow
def test_the_copy_passes(code):
    result, said = fast_tests(code, {mutation.tests for mutation in MUTATIONS.values()})
    assert result == pytest.ExitCode.OK, said


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MUTATIONS)
def test_a_mistake_is_caught(code, mistake):
    file, right, wrong, tests = MUTATIONS[mistake]
    code.edit(file, right, wrong)
    try:
        result, said = fast_tests(code, [tests])
    finally:
        code.edit(file, wrong, right)
    assert result == pytest.ExitCode.TESTS_FAILED, said
    assert re.search(r"^1 failed", said, re.MULTILINE), said
