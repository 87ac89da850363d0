"""The parser of every command."""

import argparse
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from stylit_ref.errors import did_you_mean, one_line

FRAMES = "FRAMES"
"""What help calls a name that stands for a file of each frame."""

EBSYNTH = (
    "style", "guide", "weight", "output", "uniformity", "patchsize", "pyramidlevels",
    "searchvoteiters", "patchmatchiters", "stopthreshold", "extrapass3x3", "backend",
)  # fmt: skip
"""Options of ebsynth, which have one dash there."""

SYMBOLS = {"lambda": "uniformity"}
"""What the theses call a parameter whose name here is another."""

EBSYNTH_PAGE = (
    "https://github.com/stylit-ref/stylit-ref/blob/main/docs/how_to/from_ebsynth.md "
    "has every option of ebsynth"
)


class Parser(argparse.ArgumentParser):
    """Refuses in one sentence, and names an unknown option before it misses another."""

    def __init__(self, **settings: Any) -> None:
        own = {"allow_abbrev": False, "formatter_class": argparse.RawDescriptionHelpFormatter}
        super().__init__(**own | settings)

    def error(self, message: str) -> NoReturn:
        """End with exit code 2."""
        said = one_line(message.removeprefix("argument "))
        self.exit(2, f"{self.prog}: {said} (--help shows the options)\n")

    def parse_known_args(
        self, args: Sequence[str] | None = None, namespace: argparse.Namespace | None = None
    ) -> tuple[argparse.Namespace, list[str]]:
        """Parse, but refuse first what is unknown or too much."""
        words = sys.argv[1:] if args is None else list(args)
        self._check(words)
        return super().parse_known_args(words, namespace)

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            known = list(map(str, action.choices))
            refusal = (
                f"is {value!r}; it must be {', '.join(known)}{did_you_mean(str(value), known)}"
            )
            raise argparse.ArgumentError(action, refusal)

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

    def _check(self, words):
        """Refuse words in which an option is unknown, or that no option takes."""
        arguments = [action for action in self._actions if not action.option_strings]
        takes_rest = any(
            action.nargs in (argparse.PARSER, argparse.REMAINDER) for action in arguments
        )
        takes_any = any(action.nargs == "*" for action in arguments)
        flag, owed, free = None, 0, len(words) if takes_any else len(arguments)
        for word in words:
            if word == "--":
                return
            if self._is_flag(word):
                name = word.partition("=")[0]
                if name not in self._option_string_actions:
                    self.error(self._why_unknown(name, flag if owed else None, owed or free))
                flag, owed = name, 0 if "=" in word else self._values_of(name)
            elif owed:
                owed -= 1
            elif takes_rest:  # from here on the words are the command's
                if self.commands and word not in self.commands:
                    self.error(f"there is no command {word!r}{did_you_mean(word, self.commands)}")
                return
            elif free:
                free -= 1
            else:
                self.error(self._why_left_over(word, flag))

    def _is_flag(self, word):
        """As argparse sees it: numbers are values, and so is what has a space in it."""
        return (
            word.startswith("-")
            and word != "-"
            and " " not in word.partition("=")[0]
            and not _is_number(word)
        )

    def _values_of(self, flag):
        action = self._option_string_actions[flag]
        return 1 if action.nargs is None else int(action.nargs)

    def _why_unknown(self, flag, before, owed):
        for name, command in self.commands.items():
            found = command._meant(flag)
            if found:
                return f"{flag}: name the command first: {self.prog} {name} {found}{_page(flag)}"
        found = self._meant(flag)
        if found and not flag.startswith("--"):
            return f"{flag}: two dashes here: {found}{_page(flag)}"
        if found:
            return f"{flag}: did you mean {found}?"
        if owed and not self.commands and not flag.startswith("--"):
            if before and self._option_string_actions[before].type:
                return f"{before}: {self._why_no_value(before, flag)}"
            named = f"{before} {flag}" if before else flag
            return f"{named}: a name cannot begin with a dash; write ./{flag}"
        nearest = did_you_mean(flag, self._option_string_actions)
        return f"there is no option {flag}{nearest}{_page(flag)}"

    def _why_no_value(self, flag, word):
        """What the type of an option says of a word that begins with a dash."""
        try:
            self._option_string_actions[flag].type(word)
        except argparse.ArgumentTypeError as error:
            return str(error)
        return f"write {flag}={word}, since what begins with a dash looks like an option"

    def _meant(self, flag):
        """The option of these letters, whatever the dashes, of that name in Python or symbol."""
        meant = _letters(flag)
        meant = SYMBOLS.get(meant, meant)
        for action in self._actions:
            for known in action.option_strings:
                if meant in (_letters(known), _letters(action.dest)):
                    return known
        return None

    def _why_left_over(self, word, flag):
        values = self._values_of(flag) if flag else 0
        metavar = self._option_string_actions[flag].metavar if values else None
        names = metavar if isinstance(metavar, tuple) else (metavar,)
        if FRAMES in names:
            return (
                f"{word}: {flag} takes one name for all frames; write %04d or #### where the "
                "number of the frame stands, put the name in quotes, and use no star"
            )
        if values == 2:
            first, second = names
            return f"{word}: {flag} takes {first} and {second}; repeat {flag} for each pair"
        if values == 1:
            return f"{word}: {flag} has its value already; put a name with spaces in quotes"
        return f"{word}: is neither an option nor the value of one"


def _letters(flag):
    return flag.replace("-", "").replace("_", "")


def _is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def _page(flag):
    is_of_ebsynth = not flag.startswith("--") and flag[1:] in EBSYNTH
    return f"; {EBSYNTH_PAGE}" if is_of_ebsynth else ""
