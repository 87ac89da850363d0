"""What is worth a note about the guides of a run: one note a kind, however many guides."""

import logging
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.guide_encoding import FAR, GuideEncoding, label_name, labels_of
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
        for path, picture, guide in zip(paths, pictures, encoded, strict=True):
            self._add_side(path, picture, guide, encoding)
        for path, picture, guide in list(zip(paths, pictures, encoded, strict=True))[1:]:
            if encoding.kind == "labels":
                self._add_labels(pictures[0], picture)
                continue
            sides = (paths[0], pictures[0], encoded[0]), (path, picture, guide)
            for (one, one_picture, one_guide), (other, other_picture, other_guide) in (
                sides,
                sides[::-1],
            ):
                if one_picture.alpha_channel is not None and other_picture.alpha_channel is None:
                    said = f"{one} is transparent in parts and {other} nowhere"
                    self._found[_TRANSPARENT][said] = None
                is_light = one_picture.is_light and other_picture.is_light
                if is_light and _colourful(one_guide) > 0.05 and _colourful(other_guide) == 0:
                    self._found[_GREY][f"{one} has colours and {other} is grey"] = None

    def _add_side(self, path, picture, guide, encoding):
        if (guide == guide[:1, :1]).all():
            low, high = float(picture.pixels.min()), float(picture.pixels.max())
            lost = f" ({low:.3g} to {high:.3g} are clipped, or one step of 256)"
            is_lost = picture.pixels.dtype == np.float32 and low < high
            said = f"{path} has one value all over{lost if is_lost else ''}"
            self._found[_CONSTANT][said] = None
        elif picture.pixels.dtype == np.float32 and encoding.kind != "labels":
            clipped = _clipped(picture, encoding)
            if clipped > 0.05:
                self._found[_CLIPPED][f"{clipped:.0%} of {path}"] = None

    def _add_labels(self, source, target):
        labels = [np.unique(labels_of(picture)) for picture in (source, target)]
        alone = []
        for side, picture, mine, others in (
            ("source", source, *labels),
            ("target", target, *labels[::-1]),
        ):
            names = [label_name(picture, label) for label in np.setdiff1d(mine, others)]
            if names:
                more = f" and {len(names) - 8} more" if len(names) > 8 else ""
                alone.append(f"only the {side} has {', '.join(names[:8])}{more}")
        if alone:
            self._found[_LABELS][f"of the labels of {source.name} {' and '.join(alone)}"] = None

    def note(self) -> None:
        """Tell it."""
        if self._encoded:
            note(
                f"shows source and target alike: {_listed(self._encoded)}; with none, values "
                "outside [0, 1] are clipped",
                parameter="guide_encoding",
            )
        for text, found in self._found.items():
            note(text.format(_listed(found)), level=logging.WARNING)


def _listed(sentences):
    return ", ".join(sentences)


def _done_by(encoding):
    if encoding.kind == "labels":
        return f"as {len(encoding.labels)} labels with a colour each"
    if encoding.kind == "light":
        return f"at {1 / encoding.high:.2g} of its light"
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
    return float(np.mean(np.ptp(guide[:, :, :3], axis=2) > _VISIBLE))
