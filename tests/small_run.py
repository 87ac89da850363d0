"""A RUN of a grid of views of a box on a ground, made without stylizing anything."""

import numpy as np

from stylit_ref import ArrayShot, FrameResult, Motion, Params
from stylit_ref.realtime.formulae.packed_nnf import entries_of
from stylit_ref.views.frames import grid_pairs
from stylit_ref.views.interpolation.camera import Camera
from stylit_ref.views.interpolation.formulae.transfer import transfer_of
from stylit_ref.views.interpolation.mesh_geometry import look_at_mesh
from stylit_ref.views.interpolation.painting import make_style, pixels_of, vote
from stylit_ref.views.interpolation.positions_geometry import positions_of_mesh
from stylit_ref.views.interpolation.surface import motion_by_depth
from stylit_ref.views.mesh import make_mesh
from stylit_ref.views.problem import make_problem
from stylit_ref.views.run_writer import RunWriter

SIZE = 27, 34
AZIMUTHS, ELEVATIONS = (-10, 0, 12), (10, 20)

_CORNERS = [(x, y, z) for x in (-1, 1) for y in (0, 1.6) for z in (-1, 1)]
_BOX = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
_GROUND = [(-9, 0, -9), (9, 0, -9), (9, 0, 9), (-9, 0, 9)]


def box_on_ground():
    """The mesh; each side of the box is a face of its own."""
    vertices = np.array([*_CORNERS, *_GROUND], np.float32)
    corners = [*_BOX, (8, 9, 10, 11)]
    faces = [(a, *pair) for a, b, c, d in corners for pair in ((b, c), (c, d))]
    return make_mesh(vertices, np.array(faces))


def camera_at(azimuth, elevation):
    """Around the box, from 8 units away."""
    a, e = np.radians((azimuth, elevation))
    away = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
    origin = (0.0, 0.8, 0.0) + 8 * away
    return Camera(tuple(map(float, origin)), (0.0, 0.8, 0.0), 25.0)


def cameras_of_grid(azimuths=AZIMUTHS, elevations=ELEVATIONS):
    """Row by row, from below."""
    return [camera_at(azimuth, elevation) for elevation in elevations for azimuth in azimuths]


def facts_of(camera):
    """A camera as ``run.json`` holds it."""
    return {
        "origin": list(camera.origin),
        "target": list(camera.target),
        "field_of_view": camera.field_of_view,
    }


def true_motion(mesh, camera, other, size=SIZE):
    """The motion from a view into another one, by the mesh."""
    _, inverse = look_at_mesh(mesh, camera, size)
    transfer = transfer_of(camera.matrix(size), other.matrix(size))
    [field] = motion_by_depth(inverse, transfer[None])
    own, there = (positions_of_mesh(mesh, each, size).labels for each in (camera, other))
    place = np.stack(np.mgrid[: size[0], : size[1]], axis=-1) + field[:, :, ::-1]
    row, column = np.moveaxis(np.floor(place + 0.5).astype(int), -1, 0)
    is_inside = (row >= 0) & (row < size[0]) & (column >= 0) & (column < size[1])
    row, column = row.clip(0, size[0] - 1), column.clip(0, size[1] - 1)
    return Motion(field, is_inside & (there[row, column] == own))


def write_run(
    folder,
    cameras=None,
    grid=(2, 3),
    holds="mesh",
    facts=None,
    motion_scale=1.0,
    has_motion=True,
    **params,
):
    """Write a RUN whose patches come from a smooth random style; ``holds`` mesh or positions."""
    cameras = cameras_of_grid() if cameras is None else cameras
    rng, mesh = np.random.default_rng(3), box_on_ground()
    style = (rng.random((20, 25, 3)) * 60 + np.linspace(0, 190, 25)[:, None]).astype(np.uint8)
    guide = np.zeros((*style.shape[:2], 1), np.uint8)
    frames = [[np.zeros((*SIZE, 1), np.uint8)] for _ in cameras]
    edges = {}
    for to, other in grid_pairs(*grid) if has_motion else ():
        motion = true_motion(mesh, cameras[to], cameras[other])
        edges[to, other] = motion._replace(field=motion.field * np.float32(motion_scale))
    shot = ArrayShot(frames, edges)
    problem = make_problem(style, [guide], shot, Params(**{"levels": 2} | params))
    writer = RunWriter(
        folder,
        problem,
        grid=grid,
        cameras=[facts_of(camera) for camera in cameras] if facts is None else facts,
        mesh=mesh if holds == "mesh" else None,
        positions=(
            (lambda frame: positions_of_mesh(mesh, cameras[frame], SIZE))
            if holds == "positions"
            else None
        ),
    )
    made = make_style(style, 5)
    for frame, camera in enumerate(cameras):
        labels = positions_of_mesh(mesh, camera, SIZE).labels
        y, x = np.mgrid[: SIZE[0], : SIZE[1]]
        nnf = np.stack([2 + (y + labels) % 16, 2 + (x + 3 * labels) % 21], axis=-1).astype(np.int32)
        picture = pixels_of(vote(made, entries_of(nnf)), 3)
        writer.add(FrameResult(frame, shot.names[frame], picture, nnf))
    return writer.finish()
