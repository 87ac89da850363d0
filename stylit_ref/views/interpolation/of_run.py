"""Open a RUN for views between its own."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.notes import note
from stylit_ref.realtime.formulae.packed_nnf import LARGEST_SIDE, entries_of
from stylit_ref.views.frames import grid_pairs
from stylit_ref.views.interpolation.camera import read_camera
from stylit_ref.views.interpolation.centred import centred
from stylit_ref.views.interpolation.fields_geometry import FieldsGeometry
from stylit_ref.views.interpolation.formulae.mean import WIDEST
from stylit_ref.views.interpolation.formulae.transfer import transfer_of
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry, look_at_mesh
from stylit_ref.views.interpolation.orbit import Orbit, grid_of_steps, orbit_of
from stylit_ref.views.interpolation.positions_geometry import (
    PositionsGeometry,
    positions_of_mesh,
    splatting_error,
)
from stylit_ref.views.interpolation.projection import check_positions
from stylit_ref.views.interpolation.surface import GeometryKind, motion_by_depth
from stylit_ref.views.interpolation.view_interpolator import BAND, Stylized, ViewInterpolator
from stylit_ref.views.mesh import Mesh
from stylit_ref.views.run_folder import Run

MOST_TRIANGLES = 500_000
"""A mesh of more is looked at once from each view of the grid, and its points are splatted."""

MOST_APART = 1.0
"""Mesh and motion of a RUN belong together if their vectors differ by less, in pixels."""


def views_of_run(run: Run | str | Path, *, band: float = BAND) -> ViewInterpolator:
    """Open a RUN for views between its own.

    Parameters
    ----------
    run : Run, str or Path
        A RUN of a grid of views or of views in a row, or its folder. It holds cameras, and a mesh
        or positions; or motion between neighbours.
    band : float, optional
        How wide the fade is where the closest view changes, as a part of the way from view to view:
        0 switches, 1 always fades.

    Returns
    -------
    ViewInterpolator

    Raises
    ------
    InputError
        If the RUN is not whole, or does not hold what views between others need.
    """
    run = run if isinstance(run, Run) else Run(run)
    if not 0 <= band <= 1:
        raise InputError(f"is {band:g}; it must be between 0 and 1", parameter="band")
    if run.has_masks:
        raise InputError(
            f"{run.folder}: was drawn with --mask, and views between others need whole ones; do "
            "the run again without it"
        )
    rows, columns = run.grid or (1, len(run.names))
    if len(run.names) < 2 or rows * columns != len(run.names):
        raise InputError(
            f"{run.folder}: is a grid of {_counted(run.names)}, and nothing lies between views; "
            "do a run with more"
        )
    if geometry_of(run) == "fields":
        geometry = _fields(run, rows, columns)
        return ViewInterpolator(geometry.grid, geometry, _stylized(run), band)
    geometry = _geometry(run, _orbit(run, rows, columns))
    return ViewInterpolator(geometry.orbit.grid, geometry, _stylized(run), band)


def geometry_of(run: Run) -> GeometryKind:
    """What tells the motion between the views of a RUN.

    Parameters
    ----------
    run : Run

    Returns
    -------
    {"mesh", "positions", "fields"}
    """
    if "mesh" in run.facts:
        return "mesh"
    has_positions = all("positions" in frame for frame in run.facts["frames"])
    return "positions" if has_positions else "fields"


def _fields(run: Run, rows: int, columns: int) -> FieldsGeometry:
    """The motion of the RUN itself, where it knows nothing of the scene."""
    known = [bool(camera) for camera in run.cameras]
    grid = _orbit(run, rows, columns).grid if all(known) else grid_of_steps(rows, columns)
    pairs = list(grid_pairs(rows, columns))
    if grid.columns.is_ring:
        ends = [(row * columns, (row + 1) * columns - 1) for row in range(rows)]
        pairs += [pair for first, last in ends for pair in ((first, last), (last, first))]
    missing = [pair for pair in pairs if pair not in run.pairs]
    if missing:
        raise InputError(
            f"{run.folder}: holds neither a mesh, nor positions of all views, nor the motion "
            f"between all neighbours, such as that from {run.names[missing[0][0]]} to "
            f"{run.names[missing[0][1]]}; name one in the manifest of 'stylit-ref views', and do "
            "the run again"
        )
    note(
        f"{run.folder}: holds neither a mesh nor positions, so views between others move by the "
        "motion of their neighbours; a mesh in the manifest is more exact"
    )
    return FieldsGeometry({pair: run.motion(*pair) for pair in pairs}, grid, run.size)


def _orbit(run: Run, rows: int, columns: int) -> Orbit:
    try:
        cameras = [
            read_camera(facts, name) for facts, name in zip(run.cameras, run.names, strict=True)
        ]
    except InputError as error:
        raise InputError(f"{run.folder}: {error}") from None
    return orbit_of(cameras, rows, columns)


def _geometry(run: Run, orbit: Orbit) -> MeshGeometry | PositionsGeometry:
    mesh = run.mesh()
    if mesh is not None:
        mesh, orbit = centred(mesh, orbit)
        _check_mesh(run, orbit, mesh)
        if len(mesh.faces) <= MOST_TRIANGLES:
            return MeshGeometry(mesh, orbit, run.size)
        return _splatted(run, orbit, mesh)
    found = (run.positions(frame) for frame in range(len(run.names)))
    positions = [each for each in found if each is not None]
    for each, camera, name in zip(positions, orbit.cameras, run.names, strict=True):
        try:
            check_positions(each, camera, run.size, name)
        except InputError as error:
            raise InputError(f"{run.folder}: {error}") from None
    return PositionsGeometry(
        np.stack([each.points for each in positions]),
        np.stack([each.labels for each in positions]),
        orbit,
    )


def _splatted(run: Run, orbit: Orbit, mesh: Mesh) -> PositionsGeometry:
    """The points of a mesh, with a sentence that tells the error."""
    found = [positions_of_mesh(mesh, camera, run.size) for camera in orbit.cameras]
    geometry = PositionsGeometry(
        np.stack([each.points for each in found]), np.stack([each.labels for each in found]), orbit
    )
    between = orbit.grid.between((orbit.grid.columns.reach[0], orbit.grid.rows.reach[0]))
    axes = orbit.grid.columns, orbit.grid.rows
    place = tuple(
        (each.low_at + each.high_at) / 2 - axis.middle
        for axis, each in zip(axes, between, strict=True)
    )
    holes, wrong = splatting_error(geometry, mesh, place)
    note(
        f"{run.folder}: the mesh has {len(mesh.faces)} triangles, so its points in the views are "
        f"carried along instead; in the middle of a cell {holes:.2%} of the pixels find none, "
        f"and {wrong:.2%} that of another face; a simpler mesh is exact"
    )
    return geometry


def _check_mesh(run: Run, orbit: Orbit, mesh: Mesh) -> None:
    """Refuse a mesh, or the camera of any view, that tells another motion than the RUN holds."""
    one_of_each = {to: (to, other) for to, other in reversed(run.pairs)}
    for to, other in one_of_each.values():
        motion = run.motion(to, other)
        matrices = [orbit.cameras[frame].matrix(run.size) for frame in (to, other)]
        _, inverse = look_at_mesh(mesh, orbit.cameras[to], run.size)
        [told] = motion_by_depth(inverse, transfer_of(*matrices)[None])
        shown = motion.visible & (inverse > 0)
        apart = np.abs(told - motion.field).max(axis=2)[shown]
        if not apart.size or not np.median(apart) < MOST_APART:
            far = f"by {np.median(apart):.1f} pixels" if apart.size else "everywhere"
            raise InputError(
                f"{run.folder}: its mesh and cameras do not match its motion, which differs {far} "
                f"from {run.names[to]} to {run.names[other]}; export the mesh of the scene that "
                "was rendered, in the units and with the axes of the cameras"
            )


def _stylized(run: Run) -> Stylized:
    style, width = run.style(), run.params.patch_width
    if style.shape[2] > 4:
        raise InputError(
            f"{run.folder}: its style has {style.shape[2]} channels; at most 4 can be shown"
        )
    if max(style.shape[:2]) > LARGEST_SIDE:
        raise InputError(
            f"{run.folder}: its style is {_size(style)}; no side may be longer than {LARGEST_SIDE}"
        )
    if width > WIDEST:
        raise InputError(
            f"{run.folder}: its patches are {width} pixels wide; views between others need "
            f"patches of at most {WIDEST}; do the run again with --patch-size {WIDEST}"
        )
    nnfs, pictures, moved = [], [], 0
    for frame, name in enumerate(run.names):
        nnf, picture = run.field(frame).nnf, np.atleast_3d(run.picture(frame))
        for found, what in ((nnf, "field"), (picture, "picture")):
            if found.shape[:2] != run.size:
                raise InputError(
                    f"{run.folder}: the {what} of {name} is {_size(found)}, and its views are "
                    f"{run.size[1]}x{run.size[0]}; all must have one size"
                )
        inner = _inner(nnf, style.shape[:2], width // 2)
        moved += int((inner != nnf).any(axis=2).sum())
        nnfs.append(entries_of(inner))
        pictures.append(picture)
    if moved:
        note(
            f"{run.folder}: {moved} pixels have patches that reach beyond the style; they are "
            "moved inside"
        )
    return Stylized(style, width, np.stack(nnfs), np.stack(pictures))


def _inner(nnf: NDArray[np.int32], size: tuple[int, int], radius: int) -> NDArray[np.int32]:
    """Centres whose patches lie within the style."""
    last = np.array(size) - 1 - radius
    return np.clip(nnf, radius, last).astype(np.int32)


def _size(image) -> str:
    return f"{image.shape[1]}x{image.shape[0]}"


def _counted(names) -> str:
    return f"{len(names)} view" + "s" * (len(names) != 1)
