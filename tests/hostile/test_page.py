"""docs/hostile_input.md lists what these tests see."""

from hostile.page import PAGE, listed


def test_the_page_lists_what_is_tested():
    text = PAGE.read_text(encoding="utf-8")
    assert listed(text) == text, "write it anew: PYTHONPATH=tests:. python -m hostile.page"
