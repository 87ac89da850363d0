"""The list of hostile inputs: what is tested here is what docs/hostile_input.md says."""

import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Listed:
    """A hostile input and what it gets.

    Attributes
    ----------
    title : str
    gets : str
        The one sentence of a refusal, with ``…`` for any text; of what succeeds, what happens.
    code : int
        Exit code.
    """

    title: str
    gets: str
    code: int = 2

    def check(self, code, said, folder):
        """The exit code is the one listed, and so is the sentence of a refusal."""
        assert code == self.code, said
        if self.code == 0:
            return
        assert "Traceback" not in said
        sentence = said.strip().split("\n")[-1].replace(f"{folder}/", "").replace(f"{folder}", "")
        pattern = ".*".join(map(re.escape, self.gets.split("…")))
        assert re.fullmatch(rf"[\w.-]+( run)?: {pattern}", sentence), sentence


def table(cases):
    """The list as a Markdown table."""
    rows = [f"| {case.title} | {case.gets.replace('|', '')} | {case.code} |" for case in cases]
    return "\n".join(["| Input | What it gets | Exit code |", "| --- | --- | --- |", *rows])
