"""Guides as packings know them: by their names."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.notes import note
from stylit_ref.realtime.packing.packed import Packing
from stylit_ref.realtime.packing.principal import ID, PrincipalPacking
from stylit_ref.realtime.packing.stage import CAST_SHADOW, STAGE_BUFFERS

_IDS = ID, "IDS", "ID"


class NamedBuffers(NamedTuple):
    """Guides by name.

    Attributes
    ----------
    source, target : dict of str to (H, W, 1) or (H, W, 3) uint8
        The same names. IDMASK is among them; it is black where no guide tells things apart.
    guide_of : dict of str to int
        The number of the guide that a buffer is of.
    """

    source: dict[str, NDArray[np.uint8]]
    target: dict[str, NDArray[np.uint8]]
    guide_of: dict[str, int]


class UnknownThing(NamedTuple):
    """A pixel of the target that belongs to a thing which the source does not show.

    Attributes
    ----------
    buffer : str
        The buffer that says so.
    x, y : int
    colour : tuple of int
    """

    buffer: str
    x: int
    y: int
    colour: tuple[int, ...]


def name_of_file(path: str) -> str:
    """What a guide is called: ``FULL`` of ``FULL.png``, ``ViewLayer.FULL`` of its layer in an EXR.

    Raises
    ------
    InputError
        If there is no such file.
    """
    file, layer = split_layer(path)
    return layer or Path(file).stem


def roles_of(names: Sequence[str], encodings: Sequence[GuideEncoding]) -> list[str]:
    """The buffer that each guide is: ``FULL`` of ``ViewLayer.FULL``, ``FULL`` and ``scene_full``.

    What is read as labels is IDMASK, unless another guide has that name. A role that another guide
    has already is followed by the number of the guide.

    Parameters
    ----------
    names : sequence of str
        From :func:`name_of_file`.
    encodings : sequence of GuideEncoding
        None where all values were 8 bits.
    """
    roles = [_role(name) for name in names]
    if ID not in roles:
        for number, encoding in enumerate(encodings):
            if encoding.kind == "labels":
                roles[number] = ID
                break
    for number, role in enumerate(roles):
        if role in roles[:number]:
            roles[number] = f"{role} {number + 1}"
    return roles


def named_buffers(
    roles: Sequence[str],
    source: Sequence[NDArray[np.uint8]],
    target: Sequence[NDArray[np.uint8]],
) -> NamedBuffers:
    """Make buffers of guides. An alpha channel becomes a buffer of its own.

    Parameters
    ----------
    roles : sequence of str
        From :func:`roles_of`.
    source, target : sequence of (H, W, n) uint8
    """
    buffers = NamedBuffers({}, {}, {})
    for number, (name, *sides) in enumerate(zip(roles, source, target, strict=True)):
        colours = sides[0].shape[2] - (sides[0].shape[2] in (2, 4))
        parts = {name: slice(colours)}
        if colours < sides[0].shape[2]:
            parts[f"alpha of {name}"] = slice(colours, None)
        for part, channels in parts.items():
            for side, image in zip((buffers.source, buffers.target), sides, strict=True):
                side[part] = np.ascontiguousarray(image[:, :, channels])
            buffers.guide_of[part] = number
    for side, image in ((buffers.source, source[0]), (buffers.target, target[0])):
        ids = side.get(ID, np.zeros((*image.shape[:2], 1), np.uint8))
        side[ID] = np.ascontiguousarray(np.broadcast_to(ids, (*ids.shape[:2], 3)))
    if ID not in buffers.guide_of:
        note("no guide tells things apart, so paint may spill; add one that is called IDMASK")
    return buffers


def read_by(
    packing: Packing, buffers: Mapping[str, NDArray[np.uint8]]
) -> dict[str, NDArray[np.uint8]]:
    """Those of the buffers that a packing reads."""
    return {name: buffers[name] for name in packing.names}


def weights_of_channels(
    weights: Sequence[int], packing: Packing, guide_of: Mapping[str, int]
) -> tuple[int, ...]:
    """The weight of each byte of a pixel.

    Parameters
    ----------
    weights : sequence of int
        Of the guides.
    packing : Packing
        Other than :class:`PrincipalPacking`, which mixes the guides.
    guide_of : mapping of str to int
        Of :class:`NamedBuffers`.
    """
    of_buffer = {name: weights[number] for name, number in guide_of.items()}
    return tuple(of_buffer.get(name, 1) for name in packing.channels)  # IDMASK may be of no guide


def find_unknown_thing(
    labels: NDArray[np.uint8],
    target_labels: NDArray[np.uint8],
    packing: Packing,
    target: Mapping[str, NDArray[np.uint8]],
) -> UnknownThing | None:
    """The first pixel of the target whose label the source does not have.

    Parameters
    ----------
    labels, target_labels : (H, W) uint8
        From :func:`stylit_ref.realtime.packing.pack`.
    packing : Packing
    target : mapping of str to (H, W, n) uint8
        The target's buffers.
    """
    unknown = ~np.isin(target_labels, np.unique(labels))
    if not unknown.any():
        return None
    y, x = map(int, np.argwhere(unknown)[0])
    of_stage = not isinstance(packing, PrincipalPacking)
    buffer = "LIGHTMASK" if of_stage and target_labels[y, x] == CAST_SHADOW else ID
    return UnknownThing(buffer, x, y, tuple(target[buffer][y, x].tolist()))


def _role(name: str) -> str:
    own = name.upper()
    last = own.replace(".", "_").replace("-", "_").split("_")[-1]
    if last in _IDS:
        return ID
    return last if last in STAGE_BUFFERS else own
