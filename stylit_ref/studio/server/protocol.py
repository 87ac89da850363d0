"""What page and server say to each other through the socket, version 2.

Paint and pictures travel as bytes, little-endian: a header and rows of RGB; a look has what was
asked for between them. All else is JSON.
"""

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.studio.engine.events import Picture
from stylit_ref.studio.painting.folder import LARGEST_SERIAL

VERSION = 2

LARGEST_MESSAGE = 64 * 2**20
"""Bytes: a whole painting of the largest size fits."""

LARGEST_TEXT = 64 * 2**10
"""Characters of a message that is no paint."""

PICTURES = "replay", "coherent", "warm", "fast", "full", "step", "look"
"""Kinds of pictures, by the number that stands for each."""

_PAINT = struct.Struct("<BBHHHHI")
_IMAGE = struct.Struct("<BBHHHIf")
_PAINT_KIND = 1
_PICTURE_KIND, _PAINTING_KIND, _CHANGES_KIND = 1, 2, 3


class ProtocolError(Exception):
    """A message that this page cannot have sent.

    Parameters
    ----------
    sentence : str
    code : int
        That the socket is closed with (RFC 6455, 7.4.1).
    """

    def __init__(self, sentence: str, code: int = 1007) -> None:
        super().__init__(sentence)
        self.code: int = code


@dataclass(frozen=True, eq=False)
class Paint:
    """A rectangle of the painting.

    Attributes
    ----------
    x, y : int
        Its upper left corner.
    pixels : (h, w, 3) uint8
    serial : int
        What the page has counted up to; it comes back with the picture that shows the paint.
    """

    x: int
    y: int
    pixels: NDArray[np.uint8]
    serial: int


@dataclass(frozen=True)
class Hello:
    """The page's first words."""

    version: int


@dataclass(frozen=True)
class Rest:
    """The brush pauses."""

    serial: int


@dataclass(frozen=True)
class Finish:
    """Stylize by the full method."""


@dataclass(frozen=True)
class ChooseScene:
    """Another target."""

    name: str


@dataclass(frozen=True)
class Turn:
    """Another step of a turntable; without ``restylize`` the last matches are moved only."""

    step: int
    restylize: bool


@dataclass(frozen=True)
class SetParameters:
    """Other parameters, by name."""

    values: Mapping[str, Any]


@dataclass(frozen=True)
class SetWeights:
    """Other weights, by buffer."""

    values: Mapping[str, Any]


@dataclass(frozen=True)
class SetSeed:
    """Another seed."""

    value: int


@dataclass(frozen=True)
class Step:
    """A single operation."""

    operation: str


@dataclass(frozen=True)
class Look:
    """Show a buffer, a level, matches or their use."""

    what: str


@dataclass(frozen=True)
class Export:
    """Write what is shown."""


@dataclass(frozen=True)
class TakeOver:
    """Paint on the page that asks."""


@dataclass(frozen=True)
class Layers:
    """Which layers of a file are guides."""

    names: list[str]


Wish = (
    Hello | Rest | Finish | ChooseScene | Turn | SetParameters | SetWeights | SetSeed | Step | Look
    | Export | TakeOver | Layers
)  # fmt: skip

WISHES: Mapping[str, type[Wish]] = {
    "hello": Hello, "rest": Rest, "finish": Finish, "scene": ChooseScene, "turn": Turn,
    "parameters": SetParameters, "weights": SetWeights, "seed": SetSeed, "step": Step,
    "look": Look, "export": Export, "take_over": TakeOver, "layers": Layers,
}  # fmt: skip
"""What a page can ask for, by the word for it; fields are those of the message."""


def parse_paint(message: bytes, size: tuple[int, int], left_behind: int = -1) -> Paint:
    """Read a binary message.

    Parameters
    ----------
    message : bytes
    size : tuple of int
        Height and width of the painting.
    left_behind : int
        Up to this serial it was painted on another painting, perhaps of another size.

    Raises
    ------
    ProtocolError
        If it is no rectangle within the painting.
    """
    if len(message) > LARGEST_MESSAGE:
        raise ProtocolError("A message has more than 64 MB.", 1009)
    if len(message) < _PAINT.size:
        raise ProtocolError("A binary message is shorter than its header.")
    kind, zero, x, y, w, h, serial = _PAINT.unpack_from(message)
    if kind != _PAINT_KIND or zero:
        raise ProtocolError("A binary message is not of the one kind that there is.")
    if len(message) != _PAINT.size + 3 * w * h:
        raise ProtocolError("A rectangle of paint has other than its number of pixels.")
    height, width = size
    is_inside = 0 < w <= width - x and 0 < h <= height - y
    if not (is_inside or serial <= left_behind):
        raise ProtocolError("A rectangle of paint lies outside the painting.")
    pixels = np.frombuffer(message, np.uint8, offset=_PAINT.size).reshape(h, w, 3)
    return Paint(x, y, pixels, serial)


def parse_wish(message: str) -> Wish:
    """Read a text message.

    Raises
    ------
    ProtocolError
        If it is no JSON, or not what a page can ask for.
    """
    if len(message) > LARGEST_TEXT:
        raise ProtocolError("A text message has more than 64 KB.", 1009)
    try:
        said = json.loads(message, parse_constant=_refuse_constant)
    except (ValueError, RecursionError):
        raise ProtocolError("A text message is not JSON.") from None
    word = said.pop("do", None) if isinstance(said, dict) else None
    if not isinstance(word, str):
        raise ProtocolError('A text message does not say what to "do".')
    if word not in WISHES:
        raise ProtocolError(f"There is no {word[:40]!r} to do.")
    wanted = fields(WISHES[word])
    if said.keys() != {field.name for field in wanted}:
        names = ", ".join(field.name for field in wanted) or "no fields"
        raise ProtocolError(f"A message {word!r} has other fields than it must: {names}.")
    for field in wanted:
        if not _fits(said[field.name], field.type):
            raise ProtocolError(f"The field {field.name} of {word!r} has a wrong value.")
    return WISHES[word](**said)


def _fits(value: object, kind: object) -> bool:
    if kind is int:
        is_number = isinstance(value, int) and not isinstance(value, bool)
        return is_number and 0 <= value <= LARGEST_SERIAL
    if kind in (str, bool):
        return isinstance(value, kind)
    if kind == list[str]:
        return isinstance(value, list) and all(isinstance(each, str) for each in value)
    return isinstance(value, dict)


def _refuse_constant(name):
    raise ValueError(f"{name} is not JSON")


def sentence(error: Exception | str) -> str:
    """What went wrong, with a full stop."""
    text = str(error)
    return text if text.endswith((".", "!", "?")) else f"{text}."


def said(word: str, values: Mapping[str, Any] | None = None) -> str:
    """A text message of the server: a word, and what belongs to it.

    It is ASCII, so that whatever a page or a file has put into a text can be sent.
    """
    return json.dumps({"say": word, **(values or {})}, separators=(",", ":"), allow_nan=False)


def picture_bytes(picture: Picture) -> bytes:
    """A picture for the page."""
    return _head_of(_PICTURE_KIND, picture) + _rows(picture.image)


def changes_bytes(picture: Picture, changed: NDArray[np.bool_], tiles: NDArray[np.uint8]) -> bytes:
    """What differs in a picture from the one that the page was sent before, of the same size.

    Parameters
    ----------
    picture : Picture
    changed : (rows, columns) bool
        Tiles that differ; they follow the header as bits, row by row, the lowest first.
    tiles : (n, 16, 48) uint8
        Those tiles, in this order, whole also where they reach beyond the picture.
    """
    bits = np.packbits(changed, bitorder="little").tobytes()
    return _head_of(_CHANGES_KIND, picture) + bits + tiles.tobytes()


def painting_bytes(painting: NDArray[np.uint8], serial: int) -> bytes:
    """The painting, (h, w, 3) uint8, for the page."""
    height, width = painting.shape[:2]
    return _IMAGE.pack(_PAINTING_KIND, 0, width, height, 0, serial, 0.0) + _rows(painting)


def _head_of(kind, picture):
    height, width = picture.image.shape[:2]
    which, name = PICTURES.index(picture.which), picture.of.encode("utf-8", "replace")
    told = picture.serial, picture.milliseconds
    return _IMAGE.pack(kind, which, width, height, len(name), *told) + name


def _rows(image):
    return np.ascontiguousarray(image).tobytes()
