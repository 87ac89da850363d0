"""What pages link to is committed."""

import re
import subprocess
from pathlib import Path

import pytest
from markdown_it import MarkdownIt

ROOT = Path(__file__).parents[2]
PAGES = "*.md", ":!oracle/v1", ":!build"


def committed(*places):
    """The files that git holds in some places."""
    command = ["git", "-C", ROOT, "ls-files", "-z", "--", *places]
    names = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return [ROOT / name for name in names.split("\0") if name]


def places_of(text):
    """Where the links and pictures of a page lead, those in HTML too."""
    for block in MarkdownIt().enable("table").parse(text):
        for token in block.children or ():
            if token.type in ("link_open", "image"):
                yield str(token.attrs.get("href") or token.attrs.get("src"))
        if block.type in ("html_block", "inline"):
            yield from re.findall(r'src="([^"]*)"', block.content)


@pytest.mark.parametrize(
    "page", committed(*PAGES), ids=lambda page: page.relative_to(ROOT).as_posix()
)
def test_links_of_a_page_are_committed(page):
    held = set(committed("."))
    for place in places_of(page.read_text(encoding="utf-8")):
        file = place.partition("#")[0]
        if file and ":" not in file:
            target = (page.parent / file).resolve()
            assert target in held or target.is_dir(), f"{page}: {place}"
