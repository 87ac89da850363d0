"""Pictures: views side by side, what changes between them, and frames that move."""

import numpy as np
from PIL import Image

from eval.documents.hauptfleisch.goals import GOALS
from eval.metrics.warping import change
from eval.motion_paths import cells, landing
from eval.pages.figures import contact_sheet, detailed_window
from eval.runs.store import stored

STRENGTH = 4
"""Differences are shown so many times larger."""

MILLISECONDS = 160
"""Of a frame of a preview."""

_QUALITY = 70


def views_figure(study, method, file):
    """The first row of views: renderings, frames alone, and those that pull at each other."""
    shown = range(min(3, study.frames.frames))
    rows = [[(f"{frame}: {name}", images[frame]) for frame in shown]
            for name, images in _pictures(study, method).items()]  # fmt: skip
    contact_sheet(rows, file, tile=_tile(study))


def styles_figure(plan, file):
    """The middle view in every style: what was painted, alone, and pulled by its neighbours."""
    coherence = GOALS["house"][0].coherence
    rows = []
    for style, study in plan.styles.items():
        middle = study.frames.frames // 2
        runs = {"alone": study.alone("ref"), "coherent": study.job("ref", coherence)}
        rows.append(
            [(style, study.frames.style)]
            + [(name, stored(job).image[middle]) for name, job in runs.items()]
        )
    contact_sheet(rows, file, tile=300)


def long_shot_figure(plan, file):
    """Four frames of the long shot."""
    images = stored(plan.long_shot).image
    rows = [[(str(k), image) for k, image in enumerate(images)]]
    contact_sheet([rows[0][:2], rows[0][2:]], file, tile=480)


def crops_figure(study, method, file):
    """The most detailed place of the middle view, and the same points in its neighbour."""
    to, other = _pair(study)
    motion = study.frames.edges[to, other]
    gradient = np.abs(np.diff(study.frames.renderings[to].astype(float).mean(axis=2), axis=1))
    top, left, height, width = detailed_window(gradient, 0.3)
    rows, columns = motion.visible.shape
    here = np.s_[int(top * rows) : int((top + height) * rows),
                 int(left * columns) : int((left + width) * columns)]  # fmt: skip
    moved = np.median(motion.field[here][motion.visible[here]], axis=0).round().astype(int)
    there = tuple(
        slice(max(0, part.start + move), max(0, part.stop + move))
        for part, move in zip(here, moved[::-1], strict=True)
    )
    sheet = [
        [
            (f"{frame}: {name}", images[frame][place])
            for frame, place in ((to, here), (other, there))
        ]
        for name, images in _pictures(study, method).items()
    ]
    contact_sheet(list(map(list, zip(*sheet, strict=True))), file, tile=260)


def changes_figure(study, method, file):
    """How much each point of the middle view differs in a neighbour."""
    to, other = _pair(study)
    motion = study.frames.edges[to, other]
    y, x, seen = landing(motion)
    row = []
    for name, images in _pictures(study, method).items():
        apart = np.abs(images[other][y, x].astype(int) - images[to])
        shown = np.where(seen[..., None], np.minimum(STRENGTH * apart, 255), 128)
        error = change(images[to], images[other], motion)
        row.append((f"{name}: {error:.1f}", shown.astype(np.uint8)))
    contact_sheet([row], file, tile=_tile(study))


def preview(study, method, file):
    """Frames alone beside those that pull at each other, forth and back, as an animation."""
    alone, coherent = list(_pictures(study, method).values())[1:3]
    steps = steps_of(study.frames.frames, is_grid=bool(cells(study.frames.edges)))
    frames = [Image.fromarray(np.hstack([alone[step], coherent[step]])) for step in steps]
    frames[0].save(
        file, save_all=True, append_images=frames[1:], duration=MILLISECONDS, loop=0,
        quality=_QUALITY, method=4,
    )  # fmt: skip


def steps_of(frames, is_grid):
    """Frames, each a neighbour of the one before: a sequence forth and back, or through a grid.

    Parameters
    ----------
    frames : int
        A square number if they are a grid.
    is_grid : bool

    Returns
    -------
    list of int
        Without the last step, to the first frame.
    """
    order = list(range(frames))
    if is_grid:
        side = round(frames**0.5)
        rows = [order[side * k : side * (k + 1)] for k in range(side)]
        order = [view for k, row in enumerate(rows) for view in (row if k % 2 == 0 else row[::-1])]
    return [*order, *order[-2:0:-1]]


def neighbours(study, method):
    """A frame, and its neighbour moved back along its motion: alone, then as it is judged.

    Parameters
    ----------
    study : Study
        Its runs must be stored.
    method : str

    Returns
    -------
    list of ((str, (H, W, n) uint8), (str, (H, W, n) uint8))
    """
    to, other = _pair(study)
    y, x, seen = landing(study.frames.edges[to, other])
    found = []
    for name, images in list(_pictures(study, method).items())[1:3]:
        back = np.where(seen[..., None], images[other][y, x], images[to])
        found.append(((f"{name}: frame {to}", images[to]), (f"frame {other}, moved back", back)))
    return found


def _pictures(study, method):
    """Images by what they are called: the renderings, alone, and the settings that are judged."""
    return {
        "rendered": study.frames.renderings,
        f"{method}, alone": stored(study.alone(method)).image,
        **{
            f"{method}, {way.order}, λ = {way.weight:g}": stored(study.job(method, way)).image
            for way in study.shown(method)
        },
    }


def _pair(study):
    """The middle frame, and one of its neighbours."""
    middle = study.frames.frames // 2
    return middle, max(other for to, other in study.frames.edges if to == middle)


def _tile(study):
    return min(400, study.frames.guides[0][0].shape[1])
