"""docs/hostile_input.md lists what these tests see."""

from pathlib import Path

from hostile import test_files, test_interruptions
from hostile.listed import table

PAGE = Path(__file__).parents[2] / "docs" / "hostile_input.md"


def test_the_page_lists_what_is_tested():
    text = PAGE.read_text(encoding="utf-8")
    assert table([*test_files.CASES.values(), *test_files.OTHERS]) in text
    assert table(test_interruptions.CASES) in text
