"""Drag a patch over a texture, and drop it (section 8, "Patch drag-and-drop")."""

from dataclasses import dataclass
from numbers import Integral

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError, shown
from stylit_ref.texture.checks import check_exemplar
from stylit_ref.texture.exemplars import Exemplars
from stylit_ref.texture.formulae.deformation import power_table
from stylit_ref.texture.formulae.polar import MARGIN
from stylit_ref.texture.passes.dragged_patch import fit_dragged, write_dragged
from stylit_ref.texture.session import TextureSession


@dataclass(frozen=True, eq=False)
class DraggedPatch:
    """A patch where it is held now.

    Attributes
    ----------
    y, x : int
        The pixel of the texture that its centre lies on.
    covers : (n, n) bool
        The pixels around the centre that it covers; it wraps around the texture.
    colours : (n, n, c) uint8
        What they show.
    change : int
        What the texture costs with it, less what it costs now, in units of 1/256 of M.
    addresses : (n * n,) int32
    radius : int
    exemplars : Exemplars
        Those that the addresses belong to.
    """

    y: int
    x: int
    covers: NDArray[np.bool_]
    colours: NDArray[np.uint8]
    change: int
    addresses: NDArray[np.int32]
    radius: int
    exemplars: Exemplars


def drag(
    session: TextureSession,
    source: tuple[int, int, int],
    place: tuple[int, int],
    *,
    least_radius: int = 1,
) -> DraggedPatch:
    """Cut and stitch a patch where it is held; the session stays as it is.

    Parameters
    ----------
    session : TextureSession
        Patches are of the radius of its next iteration. They are not deformed, and none is
        rejected.
    source : tuple of int
        The number of an exemplar, from 1, and y and x of the pixel at the patch's centre.
    place : tuple of int
        y and x of the pixel of the texture that it is held over.
    least_radius : int
        The patch has at least this radius; seams that are nearer count for nothing.

    Returns
    -------
    DraggedPatch

    Raises
    ------
    InputError
        If a position is none, or too close to the exemplar's border for a patch of the least
        radius.
    """
    exemplar, from_y, from_x = source
    number = check_exemplar(exemplar, session.exemplars.images) - 1
    height, width = session.exemplars.images[number].shape[:2]
    radius = session.radius
    if not isinstance(least_radius, Integral) or not 0 <= least_radius <= radius:
        raise InputError(
            f"is {shown(least_radius)}; it must be an integer from 0 to the radius {radius}",
            parameter="least_radius",
        )
    _check_position((from_y, from_x), (height, width), "source")
    _check_position(place, session.size, "place")
    polar, sources, settings = session.fitted(radius)
    at = np.array([number, 4 * from_y, 4 * from_x], np.int32)
    address = int(session.exemplars.addresses(at))
    if 2 * int(sources.clearance[address]) <= radius:
        raise InputError(
            f"is y = {from_y}, x = {from_x} of exemplar {exemplar}, too close to its border: the "
            f"centre of a patch lies more than half of its radius {radius} inside",
            parameter="source",
        )
    y, x = map(int, place)
    patch, change = np.full(polar.radius_at.size, -1, np.int32), np.empty(1, np.int64)
    fit_dragged(
        session.texture, sources, polar, settings, session.workspace(polar, settings), address, y,
        x, int(least_radius), power_table(session.params.gamma), patch, change,
    )  # fmt: skip
    clear = int(sources.clearance[address])
    if not (patch >= 0).any() and clear <= least_radius + MARGIN:
        raise InputError(
            f"is {least_radius}, but no such patch fits around {source}: the exemplar ends {clear} "
            "pixels from there",
            parameter="least_radius",
        )
    side = polar.half_width.size
    covers = patch.reshape(side, side) >= 0
    colours = session.exemplars.show(np.where(patch >= 0, patch, 0)).reshape(side, side, -1)
    return DraggedPatch(y, x, covers, colours, int(change[0]), patch, radius, session.exemplars)


def drop(session: TextureSession, patch: DraggedPatch) -> None:
    """Write a patch where it is held; the cost may rise.

    Parameters
    ----------
    session : TextureSession
    patch : DraggedPatch
    """
    polar, sources, settings = session.fitted(patch.radius)
    addresses, change = patch.addresses, np.empty(1, np.int64)
    if patch.exemplars is not session.exemplars:
        # The session has laid its exemplars out anew, for a larger radius or for fractions.
        covered = addresses >= 0
        coordinates = patch.exemplars.coordinates(addresses[covered])
        addresses = addresses.copy()
        addresses[covered] = session.exemplars.addresses(coordinates)
    write_dragged(
        session.texture, sources, settings, patch.y, patch.x, polar.half_width, addresses, change
    )
    session.cost += int(change[0])


def _check_position(position, size, name):
    y, x = position
    inside = isinstance(y, Integral) and isinstance(x, Integral)
    if not inside or not (0 <= y < size[0] and 0 <= x < size[1]):
        raise InputError(
            f"is y = {shown(y)}, x = {shown(x)}; these must be integers of a pixel within "
            f"{size[1]} x {size[0]}",
            parameter=name,
        )
