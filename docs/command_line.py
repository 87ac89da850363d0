"""Writes ``command_line.md`` from the parser of ``stylit-ref``: ``python docs/command_line.py``."""

import argparse
from pathlib import Path

from stylit_ref.cli import make_parser

PAGE = Path(__file__).with_suffix(".md")
HEAD = """\
# All options

`python docs/command_line.py` writes this page from the parser of `stylit-ref`, so it says what
`--help` says. [Files, masks and options](how_to/files_and_options.md) explains what needs more than
a line.
"""


def page():
    """The whole page."""
    return HEAD + "".join(_chapters(make_parser()))


def _chapters(parser):
    """A chapter for every command that does something, those of ``oracle`` too."""
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for command in action.choices.values():
                yield from _chapters(command)
            return
    yield f"\n## {parser.prog}\n\n{_text(parser.description)}\n"
    for group in parser._action_groups:
        rows = [_row(parser, action) for action in group._group_actions if action.dest != "help"]
        if rows:
            title = group.title.removeprefix("positional ")
            yield f"\n| {title} | |\n|---|---|\n" + "".join(rows)


def _text(description):
    """Paragraphs; those that are indented are commands or what is printed."""
    paragraphs = description.strip().split("\n\n")
    return "\n\n".join(
        f"```text\n{paragraph}\n```" if paragraph.startswith(" ") else paragraph
        for paragraph in paragraphs
    )


def _row(parser, action):
    """An option with its values, and its help."""
    formatter = parser._get_formatter()
    values = formatter._format_args(action, formatter._get_default_metavar_for_optional(action))
    names = [f"{name} {values}".strip() for name in action.option_strings] or [values]
    required = " (required)" if action.required else ""
    cells = ", ".join(f"`{name}`" for name in names) + required, formatter._expand_help(action)
    return "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
