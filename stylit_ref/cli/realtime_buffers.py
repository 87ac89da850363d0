"""Guides of ``run`` as the packings of ``--method realtime`` know them: by their names."""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.guide_options import guide_weights
from stylit_ref.cli.images_in import ImagesIn
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.notes import note
from stylit_ref.realtime.packing import Packing, PrincipalPacking
from stylit_ref.realtime.packing.principal import ID
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS

_IDS = ID, "IDS", "ID"


class Buffers(NamedTuple):
    """Guides by name.

    Attributes
    ----------
    source, target : dict of str to (H, W, 1) or (H, W, 3) uint8
        The same names. IDMASK is among them; it is black where no guide tells things apart.
    guide_of : dict of str to int
        The number of the guide that a buffer is of.
    files : dict of str to str
        The target's files.
    """

    source: dict[str, NDArray[np.uint8]]
    target: dict[str, NDArray[np.uint8]]
    guide_of: dict[str, int]
    files: dict[str, str]


def named_buffers(files: Sequence[tuple[str, str]], images: ImagesIn) -> Buffers:
    """Name the guides: by layer or file, as ``FULL`` of ``scene.exr:FULL`` or ``scene_full.png``.

    What is read as labels is IDMASK, unless another guide has that name. An alpha channel becomes
    a buffer of its own.

    Parameters
    ----------
    files : sequence of (str, str)
        Source and target of each guide.
    images : ImagesIn

    Raises
    ------
    InputError
        If the IDs are grey on one side and in colour on the other.
    """
    roles = [_role(source) for source, _ in files]
    if ID not in roles:
        for number, encoding in enumerate(images.guide_encodings):
            if encoding.kind == "labels":
                roles[number] = ID
                break
    buffers = Buffers({}, {}, {}, {})
    for number, role in enumerate(roles):
        name = role if role not in buffers.source else f"{role} {number + 1}"
        sides = images.source_guides[number], images.target_guides[number]
        colours = sides[0].shape[2] - (sides[0].shape[2] in (2, 4))
        parts = {name: slice(colours)}
        if colours < sides[0].shape[2]:
            parts[f"alpha of {name}"] = slice(colours, None)
        for part, channels in parts.items():
            for side, image in zip((buffers.source, buffers.target), sides, strict=True):
                side[part] = np.ascontiguousarray(image[:, :, channels])
            buffers.guide_of[part], buffers.files[part] = number, files[number][1]
    for side, image in (
        (buffers.source, images.source_guides[0]), (buffers.target, images.target_guides[0])
    ):  # fmt: skip
        ids = side.get(ID, np.zeros((*image.shape[:2], 1), np.uint8))
        side[ID] = np.ascontiguousarray(np.broadcast_to(ids, (*ids.shape[:2], 3)))
    if ID not in buffers.guide_of:
        note("no guide tells things apart, so paint may spill; add one that is called IDMASK")
    return buffers


def weights_of(
    options: argparse.Namespace, packing: Packing, buffers: Buffers
) -> tuple[int, ...] | None:
    """The weight of each byte of a pixel, None where no ``--weight`` is given.

    Raises
    ------
    InputError
        If one is no whole number, or the packing mixes the guides.
    """
    if not options.guide_weights:
        return None
    if isinstance(packing, PrincipalPacking):
        raise InputError(
            "cannot be given with --packing pca, whose components mix the guides; leave it out",
            parameter="guide_weights",
        )
    weights = guide_weights(options)
    if not all(weight.is_integer() and weight >= 0 for weight in weights):
        raise InputError(
            "must be a whole number from 0 with --method realtime; 0 leaves a guide out",
            parameter="guide_weights",
        )
    of_buffer = {name: int(weights[number]) for name, number in buffers.guide_of.items()}
    return tuple(of_buffer.get(name, 1) for name in packing.channels)  # IDMASK may be of no guide


def _role(path):
    """``FULL`` of ``scene.exr:ViewLayer.FULL``, ``FULL.png`` and ``scene_full.png``."""
    file, layer = split_layer(path)
    own = (layer or Path(file).stem).upper()
    words = own.replace(".", "_").replace("-", "_").split("_")
    last = words[-1]
    if last in _IDS:
        return ID
    return last if last in STAGE_BUFFERS else own
