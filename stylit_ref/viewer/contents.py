"""What a page holds: a table of contents, and pieces. ``src/page_data.ts`` reads it."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.viewer.cameras import axis_facts, camera_facts
from stylit_ref.viewer.fields import of_field
from stylit_ref.viewer.grid_views import GridViews
from stylit_ref.viewer.pieces import Piece, of_bytes, of_colours
from stylit_ref.viewer.points import of_points
from stylit_ref.views.formulae.silhouette import reach_of
from stylit_ref.views.mesh import Mesh

FORMAT = 1


@dataclass(frozen=True)
class Contents:
    """A page's data.

    Attributes
    ----------
    facts : dict
        The table of contents, as JSON holds it.
    pieces : tuple of Piece
        In the order in which a page needs them.
    """

    facts: dict[str, Any]
    pieces: tuple[Piece, ...]


def make_contents(
    views: GridViews, *, title: str, band: float, still: NDArray[np.uint8] | None = None
) -> Contents:
    """Pack a grid of views. Nothing else goes into a page: no name and no path of a file.

    Parameters
    ----------
    views : GridViews
    title : str
        What the page is called, and its alternative text.
    band : float
        How wide a fade is, as a part of the way from view to view.
    still : (k H_A, k W_A, 3) uint8, optional
        The style at a whole multiple of its size, for stills.

    Returns
    -------
    Contents

    Raises
    ------
    InputError
        If the style for stills has another size.
    """
    pieces: list[Piece] = []

    def add(piece: Piece) -> dict[str, Any]:
        pieces.append(piece)
        return piece.facts()

    height, width = views.size
    facts = {
        "format": FORMAT,
        "title": title,
        "width": width,
        "height": height,
        "rows": axis_facts(views.grid.rows),
        "columns": axis_facts(views.grid.columns),
        "patchRadius": views.patch_width // 2,
        "reach": reach_of(height, width),
        "fadeBand": band,
        "style": None,
        "mesh": None,
        "still": None,
        "folder": None,
    }
    if views.style is not None:
        rows, columns = views.style.shape[:2]
        piece = add(of_colours("style", views.style))
        facts["style"] = {"width": columns, "height": rows, "piece": piece}
    if views.mesh is not None:
        piece = add(of_bytes("mesh", mesh_bytes(views.mesh)))
        facts["mesh"] = {"triangles": len(views.mesh.faces), "piece": piece}
    facts["views"] = [
        {"camera": camera, "nnf": None, "picture": None, "points": None}
        | {kind: add(piece) for kind, piece in packed.items()}
        for camera, packed in _views(views)
    ]
    if still is not None:
        scale = _scale(still, views)
        facts["still"] = {"scale": scale, "piece": add(of_colours("still", still))}
    return Contents(facts, tuple(pieces))


def mesh_bytes(mesh: Mesh) -> bytes:
    """Nine float32 a triangle, then a uint32 for its face."""
    corners = mesh.vertices[mesh.faces].astype("<f4")
    return corners.tobytes() + mesh.groups.astype("<u4").tobytes()


def _views(views: GridViews) -> Iterator[tuple[dict[str, Any] | None, dict[str, Piece]]]:
    """Of every view, from below and from the left: its camera, and its pieces by their kinds."""
    for row, frames in enumerate(views.grid.frames):
        for column, frame in enumerate(frames):
            camera = camera_facts(views.orbit, row, column) if views.orbit else None
            name, view = f"view-{row}-{column}", views.view(frame)
            packed = {}
            if views.style is None:
                packed["picture"] = of_colours(name, view.astype(np.uint8))
            else:
                packed["nnf"] = of_field(name, view.astype(np.int32))
            if views.points and views.orbit:
                matrix = views.orbit.cameras[frame].matrix(views.size)
                packed["points"] = of_points(f"points-{row}-{column}", views.points(frame), matrix)
            yield camera, packed


def _scale(still, views):
    if views.style is None:
        raise InputError(
            "is for views that tell where their pixels come from; name nnfs and style in place of "
            "pictures, or leave it out",
            parameter="still",
        )
    size = views.style.shape[:2]
    scale = still.shape[0] // size[0]
    if not scale or still.shape[:2] != (scale * size[0], scale * size[1]):
        raise InputError(
            f"is {still.shape[1]}x{still.shape[0]}, but the style of the views is "
            f"{size[1]}x{size[0]}; it must be that size or a whole number of times as large",
            parameter="still",
        )
    return scale
