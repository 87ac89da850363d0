"""Figures on the front page and beside other programs are those of the committed reports."""

import csv
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
BENCH = "bench_stylit_golem_1200x912/bench.csv"
ENERGY = "image energy"
FAST = {"configuration": "preset fast", "program": "stylit-ref"}
DEFAULTS = {"configuration": "ebsynth's defaults"}
THESIS = {"configuration": "thesis configuration"}
OURS, EBSYNTH = {"program": "stylit-ref"}, {"program": "ebsynth"}
LIVE = "heidrich_quick/requirements.csv"
TABLE_1 = "heidrich_quick/table_1.csv"
SMALL = {"resolution": "500x500", "with rendering": "no"}
COMPARISON = "docs/comparison.md"
ALIKE = {"scene": "golem/oil", "guides": "alike", "size": "1200x912"}
FIGURES = (
    ("README.md", "2.6 s, image energy", BENCH, FAST, "process [s]"),
    ("README.md", "energy 2688", BENCH, FAST, ENERGY),
    ("README.md", "10.6 s, 2581", BENCH, DEFAULTS | OURS, "process [s]"),
    ("README.md", "2581 |", BENCH, DEFAULTS | OURS, ENERGY),
    ("README.md", "44.4 s, 2809", BENCH, DEFAULTS | EBSYNTH, "process [s]"),
    ("README.md", "2809 (", BENCH, DEFAULTS | EBSYNTH, ENERGY),
    ("README.md", "17.0 s, 2763", BENCH, THESIS | OURS, "process [s]"),
    ("README.md", "2763 |", BENCH, THESIS | OURS, ENERGY),
    ("README.md", "77.2 s, 3000", BENCH, THESIS | EBSYNTH, "process [s]"),
    ("README.md", "3000 |", BENCH, THESIS | EBSYNTH, ENERGY),
    ("README.md", "6 to 9 ms", TABLE_1, SMALL | {"method": "quick"}, "ours, all threads [ms]"),
    ("README.md", "9 ms", TABLE_1, SMALL | {"method": "best"}, "ours, all threads [ms]"),
    ("README.md", "18 to 46 ms", TABLE_1, SMALL | {"method": "optimized"}, "thesis [ms]"),
    ("README.md", "46 ms", TABLE_1, SMALL | {"method": "simple"}, "thesis [ms]"),
    ("README.md", "1.06 times", "hauptfleisch_quick/costs.csv", {"study": "house"}, "ratio"),
    (COMPARISON, "1.06 times", "hauptfleisch_quick/costs.csv", {"study": "house"}, "ratio"),
    (COMPARISON, "takes 138 MiB", BENCH, DEFAULTS | EBSYNTH, "peak [MiB]"),
    (COMPARISON, "we take 485", BENCH, DEFAULTS | OURS, "peak [MiB]"),
    (COMPARISON, "preview takes 2.6 s", BENCH, FAST, "process [s]"),
    (COMPARISON, "final picture 17 s", BENCH, THESIS | OURS, "process [s]"),
    (COMPARISON, "in 10.6 s", BENCH, DEFAULTS | OURS, "process [s]"),
    (COMPARISON, "takes 44.4 s", BENCH, DEFAULTS | EBSYNTH, "process [s]"),
    (COMPARISON, "energy of 2688", BENCH, FAST, ENERGY),
    (COMPARISON, "energy 2581", BENCH, DEFAULTS | OURS, ENERGY),
    (COMPARISON, "its 2809", BENCH, DEFAULTS | EBSYNTH, ENERGY),
    (COMPARISON, "19.63 dB", "levels/levels.csv", ALIKE | {"effort": "ebsynth"}, "colours"),
    (
        COMPARISON,
        "28.45 dB",
        "levels/levels.csv",
        ALIKE | {"effort": "thesis", "levels": "8"},
        "colours",
    ),
    (COMPARISON, "117 frames", LIVE, {"method": "StyleBlit"}, "fps"),
    (COMPARISON, "has 104", LIVE, {"method": "quick"}, "fps"),
    (COMPARISON, "is 1.24", LIVE, {"method": "best"}, "quality"),
    (COMPARISON, "1.31 with", LIVE, {"method": "quick"}, "quality"),
    (COMPARISON, "9.79 with", LIVE, {"method": "StyleBlit"}, "quality"),
)
"""The page, words on it, a report's table, its row, and the column that the first number is of."""


def rows_of(table, wanted):
    """The rows of a table that have these values."""
    with (ROOT / "reports" / table).open(encoding="utf-8", newline="") as file:
        return [row for row in csv.DictReader(file) if wanted.items() <= row.items()]


SITE = tuple(("docs/index.md", *figure[1:]) for figure in FIGURES if figure[0] == "README.md")


@pytest.mark.parametrize(("page", "words", "table", "wanted", "column"), FIGURES + SITE)
def test_a_figure_is_that_of_its_report(page, words, table, wanted, column):
    text = " ".join((ROOT / page).read_text(encoding="utf-8").split())
    assert words in text
    (row,) = rows_of(table, wanted)
    number = re.search(r"\d+(?:\.(\d+))?", words)
    assert float(number[0]) == round(float(row[column]), len(number[1] or ""))


MATERIALS = "lasram_full/quality.csv"
RANGES = (
    ("0.56 to 2.28", "G'MIC", "novelty"),
    ("0.78 to 3.43", "default", "novelty"),
    ("0.95 to 1.31", "default", "border"),
    ("2.2 to 6.9", "G'MIC", "border"),
    ("0.56 to 1.06", "G'MIC", "seconds"),
    ("0.43 to 0.46", "default", "seconds"),
)


@pytest.mark.parametrize(("words", "method", "column"), RANGES)
def test_a_range_is_that_of_its_report(words, method, column):
    assert words in (ROOT / COMPARISON).read_text(encoding="utf-8")
    numbers = re.findall(r"\d+\.(\d+)", words)
    values = [float(row[column]) for row in rows_of(MATERIALS, {"method": method})]
    ends = min(values), max(values)
    assert {f"{end:.{len(numbers[0])}f}" for end in ends} == set(re.findall(r"[\d.]+", words))


@pytest.mark.parametrize(
    ("words", "column", "ours_is_less"),
    [
        ("in all nine exemplars", "novelty", 0),
        ("in seven of nine", "omission", 2),
        ("in five of nine exemplars", "sw", 5),
    ],
)
def test_so_many_exemplars_are_better(words, column, ours_is_less):
    assert words in (ROOT / COMPARISON).read_text(encoding="utf-8")
    ours, theirs = (
        {row["exemplar"]: float(row[column]) for row in rows_of(MATERIALS, {"method": method})}
        for method in ("default", "G'MIC")
    )
    assert sum(ours[name] < theirs[name] for name in ours) == ours_is_less
