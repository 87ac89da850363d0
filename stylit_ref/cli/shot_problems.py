"""What is wrong with the files of a shot: all of it in one message, and nothing twice."""

from collections.abc import Iterable
from pathlib import Path

from stylit_ref.cli.motion_files import MotionFiles
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import is_there, split_layer

_SHOWN = 8
"""As many problems are named, and as many files of one."""


class ShotProblems:
    """Collects what is wrong. What is said of many files of a pattern is said once, of the pattern.

    Attributes
    ----------
    patterns : dict of str to str
        The name with a placeholder that each file was found by; files of no pattern are not in it.
    """

    patterns: dict[str, str]

    def __init__(self) -> None:
        self.patterns = {}
        self._found: dict[str, dict[str, str]] = {}

    def know(self, motion: Iterable[MotionFiles], *patterns: str | None) -> None:
        """Learn the patterns of vectors, depth and IDs; None for what there is not."""
        for files_of_pair in motion:
            for files, pattern in zip(files_of_pair.kinds, patterns, strict=True):
                self.patterns |= {path: pattern for path in files if pattern}

    def add(self, sentence: str, path: str = "") -> None:
        """Add a sentence, and the file that it is about."""
        self._found.setdefault(self._of_pattern(sentence, path), {})[path] = sentence

    def add_missing(self, paths: Iterable[str], remedy: str = "") -> None:
        """Add a sentence that names those that do not exist, if there are any, and the remedy."""
        missing = [
            path for path in dict.fromkeys(paths) if not (is_there(path) or Path(path).is_dir())
        ]
        if len(missing) == 1:
            self.add(f"{missing[0]}: no such file{remedy}")
        elif missing:
            self.add(f"no such files: {_listed(missing)}{remedy}")

    def refuse(self) -> None:
        """Refuse in one sentence what has been added.

        Raises
        ------
        InputError
            If anything has.
        """
        sentences = [self._sentence(told, found) for told, found in self._found.items()]
        if sentences:
            more = len(sentences) - _SHOWN
            others = f"; and {more} more" if more > 0 else ""
            raise InputError("; ".join(sentences[:_SHOWN]) + others)

    def _of_pattern(self, sentence, path):
        """The sentence, about the pattern in place of the file."""
        if path not in self.patterns:
            return sentence
        file, layer = split_layer(path)
        behind = "" if layer is None else f":{layer}"
        pattern = self.patterns[path].removesuffix(behind)
        return sentence.replace(path.removesuffix(behind), pattern).replace(str(file), pattern)

    def _sentence(self, told, found):
        patterns = {self.patterns.get(path) for path in found} - {None}
        files = _files(found) if patterns else []
        if len(files) < 2:
            return next(iter(found.values()))
        of_patterns = _files(path for path in self.patterns if self.patterns[path] in patterns)
        return told if len(files) == len(of_patterns) else f"{told} (in {_listed(files)})"


def _files(paths):
    """The files of paths, without their layers and each once."""
    return list(dict.fromkeys(str(split_layer(path)[0]) for path in paths))


def _listed(files):
    more = f" and {len(files) - _SHOWN} more" if len(files) > _SHOWN else ""
    return ", ".join(files[:_SHOWN]) + more
