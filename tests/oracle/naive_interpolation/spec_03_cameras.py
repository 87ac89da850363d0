"""3. Cameras and motion."""

import numpy as np


def rays_of(camera):
    """Give R and e."""
    rays = np.linalg.inv(camera[:, :3])
    return rays, -rays @ camera[:, 3]


def stage_transfer(p, a):
    """Do stage transfer."""
    rays, eye = rays_of(a["camera"])
    other = a["other"]
    transfer = np.column_stack([other[:, :3] @ rays, other[:, :3] @ eye + other[:, 3]])
    seen = np.empty((*a["inverse"].shape, 2))
    for y, x in np.ndindex(a["inverse"].shape):
        across, down, depth = transfer @ (x, y, 1, a["inverse"][y, x])
        if a["inverse"][y, x] == 0:
            seen[y, x] = x, y
        elif depth > 0:
            seen[y, x] = across / depth, down / depth
        else:
            seen[y, x] = np.inf, np.inf
    return {"seen": seen}


STAGES = {"transfer": stage_transfer}
