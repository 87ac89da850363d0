"""The parser of every command."""

import argparse
import sys
from collections.abc import Iterable
from difflib import get_close_matches
from itertools import pairwise
from typing import Any, NoReturn

from stylit_ref.errors import one_line

EBSYNTH = (
    "style", "guide", "weight", "output", "uniformity", "patchsize", "pyramidlevels",
    "searchvoteiters", "patchmatchiters", "stopthreshold", "extrapass3x3", "backend",
)  # fmt: skip
"""Options of ebsynth, which have one dash there."""

EBSYNTH_PAGE = "docs/how_to/from_ebsynth.md has every option of ebsynth"


class Parser(argparse.ArgumentParser):
    """Refuses in one sentence, and names an unknown option before it misses another."""

    def __init__(self, **settings: Any) -> None:
        own = {"allow_abbrev": False, "formatter_class": argparse.RawDescriptionHelpFormatter}
        super().__init__(**own | settings)

    def error(self, message: str) -> NoReturn:
        """End with exit code 2."""
        self.exit(2, f"{self.prog}: {one_line(message)} (--help shows the options)\n")

    def parse_known_args(
        self, args: Iterable[str] | None = None, namespace: Any = None
    ) -> tuple[Any, list[str]]:
        """Parse, and refuse what is unknown or left over here rather than at the end."""
        words = sys.argv[1:] if args is None else list(args)
        self._refuse_unknown(words)
        options, left_over = super().parse_known_args(words, namespace)
        if left_over:
            self.error(self._why_left_over(words, left_over[0]))
        return options, left_over

    @property
    def commands(self) -> dict[str, "Parser"]:
        """Parsers of the commands that this one has, by name."""
        for action in self._actions:
            if isinstance(action, argparse._SubParsersAction):
                return action.choices
        return {}

    def flag_of(self, parameter: str) -> str:
        """What a parameter of the Python interface is called here.

        Parameters
        ----------
        parameter : str

        Returns
        -------
        str
            The flag that sets it, or ``parameter`` itself where no flag does.
        """
        for action in self._actions:
            if action.dest == parameter and action.option_strings:
                return action.option_strings[0]
        return parameter

    def _refuse_unknown(self, words):
        takes_rest = any(
            action.nargs in (argparse.PARSER, argparse.REMAINDER) for action in self._actions
        )
        for before, word in pairwise(["", *words]):
            if word == "--":
                return
            if not self._is_flag(word):
                if takes_rest:  # from here on the words are the command's
                    if self.commands and word not in self.commands:
                        self.error(f"there is no command {word!r}{_nearest(word, self.commands)}")
                    return
                continue
            flag = word.partition("=")[0]
            if flag not in self._option_string_actions:
                self.error(self._why_unknown(before, flag))

    def _is_flag(self, word):
        """As argparse sees it: a negative number is a value, and so is what has a space in it."""
        return (
            word.startswith("-")
            and word != "-"
            and " " not in word.partition("=")[0]
            and not self._negative_number_matcher.match(word)
        )

    def _why_unknown(self, before, flag):
        for name, command in self.commands.items():
            found = command._same_flag(flag)
            if found:
                return f"{flag}: name the command first: {self.prog} {name} {found}{_page(flag)}"
        found = self._same_flag(flag)
        if found and not flag.startswith("--"):
            return f"{flag}: two dashes here: {found}{_page(flag)}"
        if found:
            return f"{flag}: did you mean {found}?"
        if before in self._option_string_actions and "." in flag:
            return f"{before} {flag}: a value cannot begin with a dash; write ./{flag}"
        nearest = _nearest(flag, self._option_string_actions)
        return f"there is no option {flag}{nearest}{_page(flag)}"

    def _same_flag(self, flag):
        """The option that is spelled with the same letters, whatever the dashes, or None."""
        for known in self._option_string_actions:
            if known.replace("-", "") == flag.replace("-", ""):
                return known
        return None

    def _why_left_over(self, words, word):
        before = [flag for flag in words[: words.index(word)] if self._is_flag(flag)]
        if not before:
            return f"{word}: is neither an option nor the value of one"
        action = self._option_string_actions[before[-1].partition("=")[0]]
        if action.nargs == 2:
            first, second = action.metavar
            takes = f"{before[-1]} takes {first} and {second}"
            return f"{word}: {takes}; repeat {before[-1]} for each pair"
        return f"{word}: {before[-1]} has its value already; put a name with spaces in quotes"


def _nearest(word, known):
    found = get_close_matches(word, known, n=1)
    return f"; did you mean {found[0]}?" if found else ""


def _page(flag):
    is_of_ebsynth = not flag.startswith("--") and flag[1:] in EBSYNTH
    return f"; {EBSYNTH_PAGE}" if is_of_ebsynth else ""
