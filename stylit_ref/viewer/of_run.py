"""The views of a RUN for a page."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.notes import note
from stylit_ref.viewer.grid_views import GridViews, opaque
from stylit_ref.views.interpolation.camera import read_camera
from stylit_ref.views.interpolation.of_run import MOST_TRIANGLES, views_of_run
from stylit_ref.views.interpolation.orbit import grid_of_steps, orbit_of
from stylit_ref.views.interpolation.positions_geometry import positions_of_mesh
from stylit_ref.views.positions import Positions
from stylit_ref.views.run_folder import Run


def views_of_page(run: Run) -> GridViews:
    """The views of a RUN, with all that its page needs.

    Parameters
    ----------
    run : Run
        Of a grid of views, or of views in a row.

    Returns
    -------
    GridViews

    Raises
    ------
    InputError
        If the RUN is not whole, or of one view.
    """
    rows, columns = run.grid or (1, len(run.names))
    style, width = opaque(run.style(), str(run.folder)), run.params.patch_width
    if run.params.vote_outliers:
        note(
            f"{run.folder}: its votes left {run.params.vote_outliers} outliers out, and those of "
            "the page do not; its views look a little softer than their pictures"
        )
    shared = {"size": run.size, "style": style, "patch_width": width}

    def field(frame: int) -> NDArray[np.int32]:
        nnf = run.field(frame).nnf
        if nnf.shape[:2] != run.size:
            raise InputError(
                f"{run.folder}: the field of {run.names[frame]} is {nnf.shape[1]}x{nnf.shape[0]}, "
                f"and its views are {run.size[1]}x{run.size[0]}; all must have one size"
            )
        last = np.array(style.shape[:2]) - 1 - width // 2
        return np.clip(nnf, width // 2, last).astype(np.int32)

    mesh = run.mesh()
    has_positions = all("positions" in frame for frame in run.facts["frames"])
    if (mesh is None and not has_positions) or not all(run.cameras):
        note(
            f"{run.folder}: holds neither a mesh nor positions, or not all cameras, so its page "
            "can only blend views into each other; name them in the manifest of 'stylit-ref views'"
        )
        if len(run.names) < 2 or rows * columns != len(run.names):
            raise InputError(
                f"{run.folder}: is of {len(run.names)} view, and nothing lies between views; do a "
                "run with more"
            )
        return GridViews(grid_of_steps(rows, columns), **shared, view=field)
    views_of_run(run)  # it refuses what the page could not show
    cameras = [read_camera(*each) for each in zip(run.cameras, run.names, strict=True)]
    orbit = orbit_of(cameras, rows, columns)
    if mesh is not None and len(mesh.faces) <= MOST_TRIANGLES:
        return GridViews(orbit.grid, **shared, view=field, orbit=orbit, mesh=mesh)

    def points(frame: int) -> Positions:
        if mesh is not None:
            return positions_of_mesh(mesh, cameras[frame], run.size)
        positions = run.positions(frame)
        assert positions is not None
        return positions

    return GridViews(orbit.grid, **shared, view=field, orbit=orbit, points=points)
