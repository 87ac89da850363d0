"""Writes the lists of docs/hostile_input.md: ``PYTHONPATH=tests:. python -m hostile.page``."""

import re
from pathlib import Path

from hostile import test_files, test_interruptions
from hostile.listed import table

PAGE = Path(__file__).parents[2] / "docs" / "hostile_input.md"
LISTS = {
    "## Files and paths": [*test_files.CASES.values(), *test_files.OTHERS],
    "## Full disks and signals": test_interruptions.CASES,
}


def listed(text):
    """The page with the lists under their headings as the tests have them."""
    for heading, cases in LISTS.items():
        before, _, after = re.split(rf"(?<={heading}\n\n)((?:\|.*\n)*)", text)
        text = f"{before}{table(cases)}\n\n{after.lstrip()}"
    return text


if __name__ == "__main__":
    PAGE.write_text(listed(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
