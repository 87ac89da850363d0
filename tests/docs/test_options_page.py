"""The page on all options says what the parser says."""

from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

WRITER = Path(__file__).parents[2] / "docs" / "command_line.py"


def test_the_page_is_what_the_parser_gives():
    spec = spec_from_file_location("command_line", WRITER)
    writer = module_from_spec(spec)
    spec.loader.exec_module(writer)
    text = writer.PAGE.read_text(encoding="utf-8")
    assert text == writer.page(), "write it anew: python docs/command_line.py"
