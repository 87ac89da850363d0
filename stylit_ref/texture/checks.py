"""Whether what a session is given fits together."""

from collections.abc import Sequence
from numbers import Integral

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError, shown
from stylit_ref.machine.memory import physical_memory
from stylit_ref.texture.cells import largest_radius
from stylit_ref.texture.exemplars import packed_planes, with_channels
from stylit_ref.texture.formulae.deformation import PHASES
from stylit_ref.texture.formulae.polar import MARGIN
from stylit_ref.texture.params import TextureParams

LARGEST_SIDE = 1 << 16

_BYTES_A_PIXEL = 20
"""Of a texture without patches: its address, two seams, its colours."""


def check_size(size: tuple[int, int]) -> tuple[int, int]:
    """The height and width of a texture, or InputError."""
    try:
        height, width = size
    except (TypeError, ValueError):
        raise InputError(
            f"is {shown(size)}; it must be a height and a width", parameter="size"
        ) from None
    for side in (height, width):
        if not isinstance(side, Integral) or not 1 <= side <= LARGEST_SIDE:
            raise InputError(
                f"is {width} x {height} pixels; each side must be an integer from 1 to "
                f"{LARGEST_SIDE}",
                parameter="size",
            )
    return int(height), int(width)


def check_memory(size: tuple[int, int], params: TextureParams) -> None:
    """Refuse a texture that the machine has no memory for, before any is taken.

    The windows of patches overlap, so that small patches take more than large ones.
    """
    height, width = size
    radius = min(params.radius_at(params.iterations), largest_radius(size))
    cells = max(1, height // (2 * radius)) * max(1, width // (2 * radius))
    patches = cells * (2 * (radius + MARGIN) + 1) ** 2 * 4
    needed, there = height * width * _BYTES_A_PIXEL + patches, physical_memory()
    if there is not None and needed > there:
        smaller = "make it smaller"
        if 2 * patches > needed:
            smaller = f"make it smaller, or its patches larger than a radius of {radius}"
        raise InputError(
            f"is {width} x {height} pixels, which take about {needed / 2**30:.1f} GiB; the machine "
            f"has {there / 2**30:.1f} GiB of memory; {smaller}",
            parameter="size",
        )


def check_exemplar(exemplar: int, images: Sequence[NDArray[np.uint8]]) -> int:
    """The number of an exemplar, from 1."""
    if not isinstance(exemplar, Integral) or not 1 <= exemplar <= len(images):
        raise InputError(
            f"is {shown(exemplar)}; it must be an integer from 1 to {len(images)}, the number of "
            "exemplars",
            parameter="exemplar",
        )
    return int(exemplar)


def check_lock(
    lock: NDArray[np.bool_] | None, size: tuple[int, int], name: str = "lock"
) -> NDArray[np.uint8]:
    """A lock, or another mask, of the texture's size; all zeros where none is given."""
    if lock is None:
        return np.zeros(size, np.uint8)
    locked = as_array(lock, name)
    if locked.shape != size or locked.dtype != np.bool_:
        raise InputError(
            f"is {locked.dtype} of the shape {locked.shape}; it must be bool of the texture's "
            f"shape {size}",
            parameter=name,
        )
    return np.ascontiguousarray(locked, np.uint8)


def check_labels(
    labels: NDArray[np.uint8] | None, images: Sequence[NDArray[np.uint8]], size: tuple[int, int]
) -> NDArray[np.uint8]:
    """Labels of the texture's size, each 0 or the number of an exemplar; (1, 1) zeros for None."""
    if labels is None:
        return np.zeros((1, 1), np.uint8)
    given = as_array(labels, "labels")
    if given.shape != size or given.dtype != np.uint8:
        raise InputError(
            f"is {given.dtype} of the shape {given.shape}; it must be uint8 of the texture's shape "
            f"{size}",
            parameter="labels",
        )
    if given.max() > len(images):
        raise InputError(
            f"has the label {given.max()}, but there are {len(images)} exemplars; give one for "
            "every label",
            parameter="labels",
        )
    return np.ascontiguousarray(given)


def check_exemplar_sizes(
    sizes: Sequence[tuple[int, int]], images: Sequence[NDArray[np.uint8]]
) -> None:
    """Refuse a field of other exemplars; there may be more than it knows."""
    if len(images) < len(sizes):
        raise InputError(
            f"was made from {len(sizes)} exemplars, but got {len(images)}; give all, in the same "
            "order",
            parameter="start",
        )
    for number, ((height, width), image) in enumerate(zip(sizes, images, strict=False), 1):
        if image.shape[:2] != (height, width):
            raise InputError(
                f"was made from an exemplar {number} of {width} x {height} pixels, and the one "
                f"that was given has {image.shape[1]} x {image.shape[0]}; give the same",
                parameter="start",
            )


def check_coordinates(
    coordinates: NDArray[np.int32], images: Sequence[NDArray[np.uint8]], size: tuple[int, int]
) -> NDArray[np.int32]:
    """Coordinates that all lie in an exemplar, for a texture of ``size``."""
    given = as_array(coordinates, "start")
    if given.shape != (*size, 3) or not np.issubdtype(given.dtype, np.integer):
        raise InputError(
            f"is {given.dtype} of the shape {given.shape}; it must be integers of the shape "
            f"{(*size, 3)}: exemplar, y and x in quarters of a pixel",
            parameter="start",
        )
    index, y, x = np.moveaxis(given, -1, 0)
    inside = (index >= 0) & (index < len(images))
    limits = np.array([image.shape[:2] for image in images]) * PHASES
    height, width = np.moveaxis(limits[np.where(inside, index, 0)], -1, 0)
    inside &= (y >= 0) & (y < height) & (x >= 0) & (x < width)
    if not inside.all():
        row, column = np.argwhere(~inside)[0]
        raise InputError(
            f"holds {given[row, column].tolist()} at y = {row}, x = {column}, which lies outside "
            "the exemplars",
            parameter="start",
        )
    return given


def check_guides(
    source_guides: Sequence[NDArray[np.uint8]] | None,
    target_guide: NDArray[np.uint8] | None,
    images: Sequence[NDArray[np.uint8]],
    size: tuple[int, int],
) -> tuple[list[NDArray[np.uint8]] | None, NDArray[np.int32]]:
    """Guides of the exemplars' and the texture's sizes; the texture's packed, or (1, 1) zeros."""
    if source_guides is None and target_guide is None:
        return None, np.zeros((1, 1), np.int32)
    if source_guides is None or target_guide is None:
        raise InputError("a guide is needed for the exemplars and for the texture; one was given")
    if len(source_guides) != len(images):
        raise InputError(
            f"exemplars: {len(images)}, guides of exemplars: {len(source_guides)}; give a list "
            "with a guide of each exemplar"
        )
    target = with_channels(target_guide, "the texture's guide")
    if target.shape[:2] != size:
        raise InputError(
            f"the texture's guide has {target.shape[1]} x {target.shape[0]} pixels, the texture "
            f"{size[1]} x {size[0]}; make it as large"
        )
    guides = []
    for k, (guide, image) in enumerate(zip(source_guides, images, strict=True), 1):
        guide = with_channels(guide, f"the guide of exemplar {k}")
        if guide.shape[:2] != image.shape[:2]:
            raise InputError(
                f"the guide of exemplar {k} has {guide.shape[1]} x {guide.shape[0]} pixels, the "
                f"exemplar {image.shape[1]} x {image.shape[0]}; make it as large"
            )
        if guide.shape[2] != target.shape[2]:
            raise InputError(
                f"the guide of exemplar {k} and that of the texture have {guide.shape[2]} and "
                f"{target.shape[2]} channels; give both the same"
            )
        guides.append(guide)
    return guides, packed_planes([target], 0, fractions=False).reshape(size)
