"""Names of numbered files: ``shot/LDE.%04d.exr`` stands for a file of every frame."""

import os
import re
from glob import escape, glob
from pathlib import PurePath

_KINDS = r"%0?\d*d", r"\$F\d*", r"#+"
"""Placeholders of a number. A name is read by the first kind that it has, so that a folder may be
called ``shot#2``."""


class FramePattern:
    """A name with one placeholder or more: ``%04d``, ``####`` or ``$F4``.

    Parameters
    ----------
    text : str
        A path, with a layer behind it or without.

    Attributes
    ----------
    text : str
    """

    def __init__(self, text: str) -> None:
        self.text: str = text
        kind = next(kind for kind in _KINDS if re.search(kind, text))
        self._between, self._widths, self._numbers_of_file = _taken_apart(text, kind)

    @property
    def names_pairs(self) -> bool:
        """Whether the file's name has two numbers: a frame's, and that of another frame."""
        return self._numbers_of_file == 2

    def path(self, frame: int) -> str:
        """The file of a frame: every placeholder is its number."""
        return self._filled([frame] * len(self._widths))

    def path_of_pair(self, frame: int, other: int) -> str:
        """The file of a frame and another; folders are the frame's."""
        return self._filled([*[frame] * (len(self._widths) - 1), other])

    def frames(self) -> list[int]:
        """The frames whose files, or folders, there are; in ascending order.

        The name of a layer behind the file's is left out.
        """
        found = ((pattern, path, int(first)) for pattern, path, (first, *_) in self._on_disk())
        return sorted({number for pattern, path, number in found if path == pattern.path(number)})

    def count_files(self) -> int:
        """How many files, or folders, there are: of frames, or of pairs of frames."""
        return sum(pattern._makes(path, numbers) for pattern, path, numbers in self._on_disk())

    def respelled(self) -> str | None:
        """The name with numbers as wide as on the disk; None if no file has such a name either."""
        widths = {len(each) for *_, numbers in self._on_disk() for each in numbers}
        texts = [f"%0{width}d".join(self._between) for width in sorted(widths - {1}, reverse=True)]
        texts.insert(0, "%d".join(self._between))
        found = {text: FramePattern(text).count_files() for text in texts}
        most = max(found, key=found.__getitem__)
        return most if found[most] else None

    def _on_disk(self):
        """Of each file with numbers of any width: a pattern, its name, and the digits of each."""
        text = self.text
        while not (found := _numbered_on_disk(text)) and is_pattern(text.rpartition(":")[0]):
            text = text.rpartition(":")[0]
        return found

    def _makes(self, path, numbers):
        """Whether this name is what the pattern is with these digits."""
        first, last = int(numbers[0]), int(numbers[-1])
        return path == (self.path_of_pair(first, last) if self.names_pairs else self.path(first))

    def _filled(self, numbers):
        first, *names = self._between
        from fileseq.utils import pad  # imported late, as below

        padded = map(pad, numbers, self._widths)
        return first + "".join(number + name for number, name in zip(padded, names, strict=True))


def is_pattern(text: str) -> bool:
    """Whether a name has a placeholder."""
    return any(re.search(kind, text) for kind in _KINDS)


def _taken_apart(text, kind):
    """What stands between the placeholders; their widths; how many are in the file's own name."""
    from fileseq import FileSequence  # imported late: most names have no placeholder
    from fileseq.constants import PAD_STYLE_HASH1

    widths = [
        FileSequence.getPaddingNum(found, pad_style=PAD_STYLE_HASH1)
        for found in re.findall(kind, text)
    ]
    return re.split(kind, text), widths, len(re.findall(kind, PurePath(text).name))


def _numbered_on_disk(text):
    pattern = FramePattern(text.replace("/", os.sep))  # as glob answers
    number = re.compile(r"(-?\d+)".join(map(re.escape, pattern._between)))
    paths = glob("*".join(map(escape, pattern._between)))
    return [(pattern, path, found.groups()) for path in paths if (found := number.fullmatch(path))]
