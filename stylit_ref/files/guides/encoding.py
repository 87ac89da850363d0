"""How the values of a guide become 8 bits: the same way in the source and in every target.

An encoding is chosen once from all pictures of a guide
(:mod:`stylit_ref.files.guides.choose_encoding`) and then fixed, so that frames and views are
encoded alike.
"""

from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.colour.bit_depth import to_uint8_by_rows
from stylit_ref.files.picture import Picture

_WITH_RANGE = "light", "data"
_LARGEST = float(np.finfo(np.float32).max)

FAR = 1e10
"""Depth of a pixel where nothing is, as Blender writes it; in half floats it is infinity."""


@dataclass(frozen=True)
class GuideEncoding:
    """How a guide is encoded. Integers of 8 and 16 bits are display values already and stay so.

    Attributes
    ----------
    kind : {"light", "data", "labels"}
        Light goes through the sRGB curve, data through none. A label becomes a colour.
    low, high : float
        Values that become 0 and 255; others between them, and beyond are clipped. Of light, which
        begins at 0, 1 / ``high`` is the exposure.
    labels : tuple of (int, (r, g, b))
        Labels in ascending order, and the colour of each.
    """

    kind: Literal["light", "data", "labels"]
    low: float = 0.0
    high: float = 1.0
    labels: tuple[tuple[int, tuple[int, int, int]], ...] = ()

    def __post_init__(self) -> None:
        numbers = [label for label, _ in self.labels]
        levels = [level for _, colour in self.labels for level in colour]
        has_range = -_LARGEST <= self.low < self.high <= _LARGEST and not numbers
        has_labels = numbers and numbers == sorted(set(numbers)) and numbers[0] >= -(2**31)
        has_labels = has_labels and numbers[-1] < 2**32 and 0 <= min(levels) <= max(levels) <= 255
        if not (has_labels if self.kind == "labels" else has_range and self.kind in _WITH_RANGE):
            raise InputError(
                f"is {self!r}; it must be light or data with low less than high, or labels of "
                "at most 32 bits in ascending order",
                parameter="guide_encoding",
            )

    @property
    def is_plain(self) -> bool:
        """Whether values between 0 and 1 are taken as they are."""
        return self.kind != "labels" and (self.low, self.high) == (0, 1)

    def encode(self, picture: Picture) -> NDArray[np.uint8]:
        """Encode a picture.

        Parameters
        ----------
        picture : Picture

        Returns
        -------
        (H, W, n) uint8
            Colours of labels have three channels.

        Raises
        ------
        InputError
            If the picture has a label that the encoding does not know, or has labels and the
            encoding none, or the other way round.
        """
        if self.kind == "labels":
            return self._coloured(picture)
        pixels = picture.pixels
        if pixels.dtype == np.uint32:
            raise InputError(
                f"gives no colours to {picture.name}, which holds labels; leave it out, or show "
                "them on both sides with auto",
                parameter="guide_encoding",
            )
        if pixels.dtype == np.float32 and not self.is_plain:
            pixels = pixels.copy()
            colours = pixels[:, :, : picture.alpha_channel]
            with np.errstate(over="ignore"):  # infinity is clipped as other large values are
                colours -= np.float32(self.low)
                colours /= np.float32(self.high - self.low)
        curve = "srgb" if self.kind == "light" else "none"
        return to_uint8_by_rows(pixels, picture.alpha_channel, curve)

    def _coloured(self, picture):
        if picture.pixels.shape[2] > 1:
            raise InputError(
                f"is for labels, and {picture.name} has {picture.pixels.shape[2]} channels",
                parameter="guide_encoding",
            )
        found = labels_of(picture)
        known = np.array([label for label, _ in self.labels], np.int64)
        place = np.minimum(np.searchsorted(known, found), len(known) - 1)
        unknown = np.unique(found[known[place] != found])
        if unknown.size:
            raise InputError(
                f"has no colour for label {label_name(picture, unknown[0])} of {picture.name}; "
                "choose it from all targets",
                parameter="guide_encoding",
            )
        return np.array([colour for _, colour in self.labels], np.uint8)[place]

    def to_dict(self) -> dict[str, Any]:
        """What JSON can hold of it."""
        return asdict(self)

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> "GuideEncoding":
        """The encoding that :meth:`to_dict` gave, also by way of JSON.

        Raises
        ------
        InputError
            If there is none in it.
        """
        try:
            labels = tuple(
                (int(label), (int(r), int(g), int(b))) for label, (r, g, b) in values["labels"]
            )
            return cls(values["kind"], float(values["low"]), float(values["high"]), labels)
        except (KeyError, TypeError, ValueError):
            raise InputError(f"cannot be {values!r}", parameter="guide_encoding") from None


def labels_of(picture: Picture) -> NDArray[np.int64]:
    """The label of every pixel.

    Parameters
    ----------
    picture : Picture
        Of one channel.

    Returns
    -------
    (H, W) int64
    """
    return picture.pixels[:, :, 0].astype(np.int64)


def label_name(picture: Picture, label: int) -> str:
    """What a label is called: by its name, its hash where the file lists none, or its number."""
    if picture.labels is None:
        return str(label)
    return picture.labels.get(int(label), f"{label:08x}" if label else "nothing")
