"""The scenes of a data set, each a few pieces."""

from functools import cache, partial

from data_gen.camera import (
    CHAPEL,
    GRID,
    HOUSE,
    HOUSE_SOURCE,
    SOURCE_AZIMUTH,
    SOURCE_ELEVATION,
    STAGE,
    STAGE_ELEVATION,
    STAGE_VIEW,
)
from data_gen.guides import CHAPEL_LIMITS, HOUSE_LIMITS, LIGHT_PASSES, STAGE_LIMITS
from data_gen.models import TARGETS, sphere
from data_gen.models.mesh import turned
from data_gen.pieces import (
    Motion,
    MotionOfTurn,
    Paintings,
    SceneMesh,
    Sketches,
    View,
    ViewsManifest,
)
from data_gen.stage import chapel_scene, house_scene, on_stage

SIX_GUIDES = ("FULL", "LDE", "LDDE", "LSE", "LIGHTMASK", "WIREFRAME")
"""Beauty, direct, indirect and reflected light, shadows, wireframe (Hauptfleisch 2020, 2.4.1)."""

_golem = cache(TARGETS["golem"])  # a sculpture takes longer to build than to turn


def turning(name, model, cameras, degrees=1.0):
    """The pieces of a model that turns on the stage: a view for each frame, and the motion.

    Parameters
    ----------
    name : str
        Of the scene.
    model : callable
        Builds the mesh of the first frame.
    cameras : sequence of Camera
        Of each frame.
    degrees : float
        From a frame to the next; the front turns towards the right.

    Returns
    -------
    tuple of View and MotionOfTurn
    """
    scenes = tuple(partial(_turned_on_stage, model, degrees * k) for k in range(len(cameras)))
    views = (
        View(f"{name}/{frame:02}", scene, camera, STAGE_LIMITS)
        for frame, (scene, camera) in enumerate(zip(scenes, cameras, strict=True))
    )
    return *views, MotionOfTurn(f"{name}/motion", scenes, tuple(cameras), degrees)


def turntable(name, model, step):
    """The pieces of a model that turns once around: a view for every ``step`` degrees.

    Parameters
    ----------
    name : str
        Of the scene; a view's is ``NAME/090``, with its degrees.
    model : callable
        Builds the mesh at 0 degrees.
    step : int
        Degrees; the front turns towards the right.

    Returns
    -------
    tuple of View
    """
    return tuple(
        View(
            f"{name}/{degrees:03}",
            partial(_turned_on_stage, model, degrees),
            STAGE_VIEW,
            STAGE_LIMITS,
        )
        for degrees in range(0, 360, step)
    )


def _turned_on_stage(model, degrees):
    return on_stage(turned(model(), degrees))


def grid_of_views(name, view, cameras):
    """The pieces of a grid: its views, and the motion between neighbours both ways.

    Parameters
    ----------
    name : str
        Of the scene.
    view : callable
        Makes a :class:`View` of a name and a camera.
    cameras : dict of (int, int) to Camera
        By row and column.

    Returns
    -------
    tuple of View and Motion
    """
    views = [
        view(f"{name}/{row}_{column}", camera=camera) for (row, column), camera in cameras.items()
    ]
    pairs = tuple(
        (_place(row, column), _place(row + down, column + right))
        for row, column in cameras
        for down, right in ((0, -1), (0, 1), (-1, 0), (1, 0))
        if (row + down, column + right) in cameras
    )
    by_name = {_place(*place): camera for place, camera in cameras.items()}
    return *views, Motion(f"{name}/motion", views[0].scene, by_name, pairs)


def _place(row, column):
    return f"{row}_{column}"


def _cells():
    """Views in the middle of each cell of the house's grid, and the motion to its four corners."""
    middles = HOUSE.grid((22.5, 27.5), (10.5, 15.5))
    views = [_house_view(f"house_cells/{_place(*at)}", camera=c) for at, c in middles.items()]
    cameras = {f"cell_{_place(*at)}": camera for at, camera in middles.items()}
    cameras |= {_place(*at): camera for at, camera in GRID.items()}
    to_corners = [
        (f"cell_{_place(row, column)}", _place(row + down, column + right))
        for row, column in middles
        for down in (0, 1)
        for right in (0, 1)
    ]
    both = [pair for there in to_corners for pair in (there, there[::-1])]
    return *views, Motion("house_cells/motion", house_scene, cameras, tuple(both))


def _around():
    """The house from its source's height: 0 is the source view itself, then to both sides."""
    turns = {"0": 0, "behind": 180} | {
        f"{side}_{turn}": sign * turn
        for side, sign in (("minus", -1), ("plus", 1))
        for turn in (10, 20, 30)
    }
    cameras = {
        name: HOUSE.at(SOURCE_AZIMUTH + turn, SOURCE_ELEVATION) for name, turn in turns.items()
    }
    views = [_house_view(f"house_around/{name}", camera=c) for name, c in cameras.items()]
    return *views, _manifest("house_around", _HOUSE, cameras, [tuple(cameras)], has_motion=False)


def _painted_grid(name, sketches, view, cameras):
    """A grid of views of a building, what was drawn over it, its mesh, and the manifest."""
    rows = [
        tuple(_place(*at) for at in cameras if at[0] == row)
        for row in dict.fromkeys(row for row, _ in cameras)
    ]
    by_name = {_place(*at): camera for at, camera in cameras.items()}
    grid = grid_of_views(name, view, cameras)
    mesh = SceneMesh(f"{name}/mesh", grid[0].scene)
    return sketches, *grid, mesh, _manifest(name, sketches, by_name, rows, mesh=mesh.name)


def _manifest(name, sketches, cameras, rows, has_motion=True, mesh=None):
    style = f"{sketches.name}/sketches/inked.png"
    return ViewsManifest(name, style, SIX_GUIDES, cameras, tuple(rows), has_motion, mesh)


def _animation(frames=16):
    """The golem turns to the right while the camera moves to the left and rises."""
    cameras = [STAGE.at(-frame, STAGE_ELEVATION + 0.4 * frame) for frame in range(frames)]
    pieces = turning("animation", _golem, cameras, degrees=2.0)
    by_name = {f"{frame:02}": camera for frame, camera in enumerate(cameras)}
    style = f"{SOURCE.name}/styles/oil.png"
    manifest = ViewsManifest("animation", style, LIGHT_PASSES, by_name, (tuple(by_name),))
    return *pieces, manifest


def _on_stage(name, model):
    return View(name, lambda: on_stage(model()), STAGE_VIEW, STAGE_LIMITS)


_house_view = partial(View, scene=house_scene, limits=HOUSE_LIMITS)
_chapel_view = partial(View, scene=chapel_scene, limits=CHAPEL_LIMITS)

SOURCE = Paintings(_on_stage("source", sphere))
"""Belongs to every data set."""

_HOUSE = Sketches(_house_view("sketched_house", camera=HOUSE_SOURCE))
_CHAPEL = Sketches(
    _chapel_view("sketched_chapel", camera=CHAPEL.at(SOURCE_AZIMUTH, SOURCE_ELEVATION))
)

_ALWAYS = {name: (_on_stage(name, model),) for name, model in TARGETS.items()} | {
    "house": (
        _house_view("house/source", camera=HOUSE_SOURCE),
        *grid_of_views("house", _house_view, GRID),
    )
}

_ON_DEMAND = {
    "turning": turning("turning", _golem, 60 * (STAGE_VIEW,)),
    "turntable": turntable("turntable", _golem, 30),
    "animation": _animation(),
    "sketched_house": (_HOUSE,),
    "sketched_chapel": (_CHAPEL,),
    "house_around": (_HOUSE, *_around()),
    "house_cells": (_HOUSE, *_cells()),
    "house_2.5": _painted_grid(
        "house_2.5", _HOUSE, _house_view, HOUSE.grid((22.5, 25, 27.5), (10.5, 13, 15.5))
    ),
    "house_5": _painted_grid("house", _HOUSE, _house_view, GRID),
    "house_10": _painted_grid(
        "house_10", _HOUSE, _house_view, HOUSE.grid((15, 25, 35), (3, 13, 23))
    ),
    "house_9x9": _painted_grid(
        "house_9x9",
        _HOUSE,
        _house_view,
        HOUSE.grid(
            [SOURCE_AZIMUTH + 2.5 * step for step in range(-4, 5)],
            [SOURCE_ELEVATION + 2.5 * step for step in range(-2, 7)],
        ),
    ),
    "chapel": _painted_grid(
        "chapel", _CHAPEL, _chapel_view, CHAPEL.grid((10, 15, 20), (8, 13, 18))
    ),
}

SCENES = _ALWAYS | _ON_DEMAND
"""The pieces of every scene, by its name."""

USUAL = tuple(_ALWAYS)
"""The scenes that are rendered if none are named."""
