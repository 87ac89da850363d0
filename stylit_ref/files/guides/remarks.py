"""What is worth a note about the guides of a run: one note a kind, however many guides."""

import logging
from collections import defaultdict
from collections.abc import Sequence
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.guides.encoding import FAR, GuideEncoding, label_name, labels_of
from stylit_ref.files.picture import Picture
from stylit_ref.notes import note

_CLIPPED = "{}: these values are too dark or too bright for 8 bits and are clipped"
_CONSTANT = "{}: such a guide guides nothing"
_GREY = "{}: values that are grey on one side alone can hardly correspond"
_LABELS = "{}: give what corresponds the same index or name in both scenes"
_TRANSPARENT = (
    "{}: they can hardly correspond; render both with a transparent background or both without"
)

_VISIBLE = 16
"""A difference of channels that is colour, not noise."""


_SHOWN = 8
"""As many of a kind are named."""


class _Side(NamedTuple):
    """A guide of the source or of a target: its file, what was read, and that in 8 bits."""

    path: str | Path
    picture: Picture
    guide: NDArray[np.uint8]


class GuideRemarks:
    """Collects what is remarkable about guides, and tells it once."""

    def __init__(self) -> None:
        self._encoded: dict[str, None] = {}
        self._found: defaultdict[str, dict[str, None]] = defaultdict(dict)

    def add(
        self,
        paths: Sequence[str | Path],
        pictures: Sequence[Picture],
        encoded: Sequence[NDArray[np.uint8]],
        encoding: GuideEncoding,
    ) -> None:
        """Look at a guide.

        Parameters
        ----------
        paths : sequence of str or Path
            Of the source and the targets, as the user wrote them.
        pictures : sequence of Picture
        encoded : sequence of (H, W, n) uint8
            The pictures in 8 bits.
        encoding : GuideEncoding
        """
        if not encoding.is_plain:
            self._encoded[f"{pictures[0].name} {_done_by(encoding)}"] = None
        source, *targets = map(_Side._make, zip(paths, pictures, encoded, strict=True))
        for side in (source, *targets):
            self._add_side(side, encoding)
        for target in targets:
            if encoding.kind == "labels":
                self._add_labels(source.picture, target.picture)
            else:
                self._add_transparency(source, target)
                self._add_transparency(target, source)
                self._add_colours(source, target)

    def _add_side(self, side, encoding):
        pixels, is_float = side.picture.pixels, side.picture.pixels.dtype == np.float32
        if (side.guide == side.guide[:1, :1]).all():
            low, high = pixels.min(), pixels.max()
            lost = f" ({low:.3g} to {high:.3g} are clipped, or one step of 256)"
            said = f"{side.path} has one value all over{lost if is_float and low < high else ''}"
            self._found[_CONSTANT][said] = None
        elif is_float and encoding.kind != "labels":
            clipped = _clipped(side.picture, encoding)
            if clipped > 0.05:
                self._found[_CLIPPED][f"{clipped:.0%} of {side.path}"] = None

    def _add_transparency(self, one, other):
        """That one side has it and the other has not."""
        if one.picture.alpha_channel is not None and other.picture.alpha_channel is None:
            said = f"{one.path} is transparent in parts and {other.path} nowhere"
            self._found[_TRANSPARENT][said] = None

    def _add_colours(self, source, target):
        """That one side has them and the other has not."""
        if not (source.picture.is_light and target.picture.is_light):
            return
        shares = [(_colourful(side.guide), side.path) for side in (source, target)]
        (grey, without), (colourful, path) = sorted(shares, key=itemgetter(0))
        if colourful > 0.05 and grey == 0:
            self._found[_GREY][f"{path} has colours and {without} is grey"] = None

    def _add_labels(self, source, target):
        labels = [np.unique(labels_of(picture)) for picture in (source, target)]
        alone = []
        for side, picture, mine, others in (
            ("source", source, *labels),
            ("target", target, *labels[::-1]),
        ):
            names = [label_name(picture, label) for label in np.setdiff1d(mine, others)]
            if names:
                alone.append(f"only the {side} has {_listed(names)}")
        if alone:
            self._found[_LABELS][f"of the labels of {source.name} {' and '.join(alone)}"] = None

    def note(self) -> None:
        """Tell it."""
        if self._encoded:
            note(
                f"makes 8 bits of floating point, in source and target alike: "
                f"{_listed(self._encoded)}; with none, values outside [0, 1] would be clipped",
                parameter="guide_encoding",
            )
        for text, found in self._found.items():
            note(text.format(_listed(found)), level=logging.WARNING)


def _listed(sentences):
    named = list(sentences)
    more = f" and {len(named) - _SHOWN} more" if len(named) > _SHOWN else ""
    return f"{', '.join(named[:_SHOWN])}{more}"


def _done_by(encoding):
    if encoding.kind == "labels":
        return f"as {len(encoding.labels)} labels with a colour each"
    if encoding.kind == "light":
        return f"at {1 / encoding.high:.2g} of its brightness"
    return f"from {encoding.low:.4g} to {encoding.high:.4g}"


def _clipped(picture, encoding):
    """Share of the values that the encoding clips, but for pixels where nothing is."""
    colours, low, high = picture.colours, encoding.low, encoding.high
    is_below = colours < low - 0.01 * (high - low)
    return float(np.mean(is_below | ((colours > high) & (colours < FAR))))


def _colourful(guide):
    """Share of the pixels whose colour is no grey."""
    if guide.shape[2] < 3:
        return 0.0
    # Channel by channel: along the last axis NumPy takes ten times as long.
    red, green, blue = (np.ascontiguousarray(guide[:, :, channel]) for channel in range(3))
    most = np.maximum(np.maximum(red, green), blue)
    least = np.minimum(np.minimum(red, green), blue)
    return float(np.mean(most - least > _VISIBLE))
