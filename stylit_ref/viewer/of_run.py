"""The views of a RUN for a page."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.notes import note
from stylit_ref.realtime.formulae.packed_nnf import places_of
from stylit_ref.viewer.grid_views import GridViews, opaque
from stylit_ref.views.interpolation.mesh_geometry import MeshGeometry
from stylit_ref.views.interpolation.of_run import views_of_run
from stylit_ref.views.interpolation.positions_geometry import PositionsGeometry
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
        As :func:`stylit_ref.views_of_run`.
    """
    views = views_of_run(run)
    geometry, stylized = views.geometry, views.stylized
    style = opaque(stylized.style, str(run.folder))
    if run.params.vote_outliers:
        note(
            f"{run.folder}: its votes left {run.params.vote_outliers} outliers out, and those of "
            "the page do not; its views look a little softer than their pictures"
        )

    def field(frame: int) -> NDArray[np.int32]:
        return places_of(stylized.nnfs[frame])

    shared = views.grid, run.size, style, stylized.patch_width, field
    if isinstance(geometry, MeshGeometry):
        return GridViews(*shared, geometry.orbit, geometry.mesh)
    if isinstance(geometry, PositionsGeometry):
        points, labels = geometry.points, geometry.labels
        return GridViews(
            *shared,
            geometry.orbit,
            points=lambda frame: Positions(points[frame], labels[frame]),
        )
    note(
        f"{run.folder}: so its page can only blend views into each other; name a mesh and cameras "
        "in the manifest of 'stylit-ref views'"
    )
    return GridViews(*shared)
