"""A port of views between others from their text alone passes; mistakes are found in stages."""

from pathlib import Path

import naive_interpolation
import pytest
from mistakes import assert_found, first_failure

from oracle.families import INTERPOLATION
from oracle.ports import ModulePort

NAIVE = Path(naive_interpolation.__file__).parent
VERSION = INTERPOLATION.versions[-1]


def test_a_port_written_from_the_text_alone_gives_the_same():
    assert not any("stylit_ref" in file.read_text(encoding="utf-8") for file in NAIVE.glob("*.py"))
    assert first_failure(ModulePort("naive_interpolation"), VERSION) is None


MISTAKES = {
    "a place on a position ends the part before it": (
        "if at >= after[k]",
        "if at > after[k]",
        "around",
    ),
    "ties by column": ("(across + above, row, column,", "(across + above, column, row,", "around"),
    "weights that are cut off": (
        "(at - low) / (high - low) + 1 / 2)",
        "(at - low) / (high - low))",
        "around",
    ),
    "a ring that is none": ("if is_ring:\n        at", "if False:\n        at", "around"),
    "a sky that moves": ('if a["inverse"][y, x] == 0:', "if False:", "transfer"),
    "what lies behind is mirrored": ("elif depth > 0:", "elif depth != 0:", "transfer"),
    "no near plane": ("if one[2] > near:", "if one[2] > 0:", "rasterize"),
    "the last of equals": ("if v > inverse[y, x] and", "if v >= inverse[y, x] and", "rasterize"),
    "the farthest point": (
        "and 1 / depth > far[row, column]",
        "and not 0 < far[row, column] < 1 / depth",
        "splat",
    ),
    "gaps filled one after the other": ("if sparse[y, x] >= 0:", "if found[y, x] >= 9:", "splat"),
    "gaps filled from the nearer side": ("far[other] < far[one]", "far[other] > far[one]", "splat"),
    "motion of the pixel itself": (
        'right, down = a["motion"][k][taken]',
        'right, down = a["motion"][k][y, x]',
        "shift",
    ),
    "round half to even": (
        "return floor(coordinate + Fraction(float(component)) + Fraction(1, 2))",
        "return round(coordinate + Fraction(float(component)))",
        "shift",
    ),
    "masks by the pixel itself": ('== a["labels"][taken]', '== a["labels"][y, x]', "shift"),
    "the last view that shows a point": (
        "first = shown[0] if shown else 0\n        nnf",
        "first = shown[-1] if shown else 0\n        nnf",
        "fetch",
    ),
    "votes in each other's place": (
        "nnf[q] + pixel - np.array(q)",
        "nnf[q] - pixel + np.array(q)",
        "vote",
    ),
    "means that are cut off": (
        "(2 * total + len(covering)) // (2 * len(covering))",
        "total // len(covering)",
        "vote",
    ),
    "the last of equal patches": ("error < best", "error <= best", "search"),
    "black beyond the edge": (
        "- picture[row, column]) ** 2",
        "- picture[row, column] * (row == y + down)) ** 2",
        "search",
    ),
    "weights that are a mean": ("(2 * total + sum(weights)) //", "(2 * total) //", "mix"),
    "masked pictures mixed in": (
        "if not masked[k, y, x]]\n        weights",
        "if True]\n        weights",
        "mix_shifted",
    ),
    "one order for all frames": (
        "order = [first, *(k for k in range(len(places)) if k != first)]",
        "order = list(range(len(places)))",
        "frame",
    ),
}
"""What stands in the naive port, what to write there, and the stage that finds it."""


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_found_where_it_is(name, tmp_path, monkeypatch):
    port = f"mistaken_interpolation_{list(MISTAKES).index(name)}"
    assert_found(NAIVE, port, MISTAKES[name], VERSION, tmp_path, monkeypatch)
