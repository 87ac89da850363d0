"""Motion by projecting points: what the vectors of a renderer are compared with."""

import json
from itertools import product
from pathlib import Path

import numpy as np
from scipy.ndimage import maximum_filter, minimum_filter

from stylit_ref.files.picture import read_picture
from stylit_ref.views.motion.reading import read_motion


def vectors_off(folder):
    """How far vectors of Blender are from the motion of projected points.

    Parameters
    ----------
    folder : str or Path
        What ``data_gen/blender_shot.py`` wrote.

    Returns
    -------
    inside : (n,) float
        Distances in pixels along an axis, of pixels whose neighbours show the same object.
    beside : (m,) float
        Those of the others, where samples of a pixel may hit two objects.
    """
    folder = Path(folder)
    facts = json.loads((folder / "scene.json").read_text())
    frames = sorted(map(int, facts["frames"]))
    inside, beside = [], []
    for frame, step in product(frames, (1, -1)):
        if frame + step in frames:
            file = folder / "perspective" / f"shot.{frame:04}.exr"
            depth, ids = (
                read_picture(f"{file}:ViewLayer.{name}", is_guide=True).pixels[:, :, 0]
                for name in ("Depth", "Object Index")
            )
            true = projected_motion(facts, frame, frame + step, depth, ids)
            off = np.abs(read_motion(file).towards(step).field - true).max(axis=2)
            is_inside = maximum_filter(ids, 3) == minimum_filter(ids, 3)
            inside.append(off[is_inside])
            beside.append(off[~is_inside])
    return np.concatenate(inside), np.concatenate(beside)


def projected_motion(facts, frame, other, depth, ids):
    """Where the points of a frame appear in another one.

    Parameters
    ----------
    facts : dict
        Of ``scene.json``: the lens, and matrices of camera and objects in every frame.
    frame, other : int
    depth : (H, W) float
        Distance from the plane of the camera.
    ids : (H, W) array
        The index of the object that each pixel shows.

    Returns
    -------
    (H, W, 2) float
        (x, y) in pixels, y downwards.
    """
    height, width = depth.shape
    focal = facts["lens"] / facts["sensor"] * width
    here, there = (
        {name: np.array(rows) for name, rows in facts["frames"][str(number)].items()}
        for number in (frame, other)
    )
    y, x = np.mgrid[:height, :width].astype(float)
    right, up = (x + 0.5 - width / 2) / focal, (height / 2 - y - 0.5) / focal
    seen = np.stack([right * depth, up * depth, -depth, np.ones_like(depth)], axis=-1)
    points = seen @ here["camera"].T
    for name, index in facts["indices"].items():
        moved = there[name] @ np.linalg.inv(here[name])
        points[ids == index] = points[ids == index] @ moved.T
    points = points @ np.linalg.inv(there["camera"]).T
    across = focal * points[:, :, 0] / -points[:, :, 2] + width / 2 - 0.5
    down = height / 2 - 0.5 - focal * points[:, :, 1] / -points[:, :, 2]
    return np.stack([across - x, down - y], axis=-1)
