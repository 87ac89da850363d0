"""Two frames of the film Sintel with their true motion: a style painted over the first of them.

The frames are not part of this project: MPI Sintel's, of ``alley_1``, (c) Blender Foundation.
"""

import numpy as np
from skimage.color import rgb2gray
from skimage.filters import sobel
from skimage.segmentation import mark_boundaries, slic

from eval.frame_sets import FrameSet
from stylit_ref import InputError, read_uint8
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.inversion import inverted
from stylit_ref.views.motion.reading import read_motion

FRAMES = "frame_0002.png", "frame_0003.png"
FLOW, HIDDEN = "gt_frame_0002.flo", "gt_occlusions_frame_0002.png"

_PIECES = 2500
"""Pieces of glass in the painted frame."""

_INK = (0.12, 0.1, 0.14)


def read_sintel(folder):
    """Read the frames, and paint over the first.

    Guides are luma and edges alone, as of footage that nobody has rendered. The flow leads from the
    first frame to the second; the way back is inverted by splatting.

    Parameters
    ----------
    folder : Path or None

    Returns
    -------
    FrameSet

    Raises
    ------
    InputError
        If the folder does not hold the frames.
    """
    if folder is None:
        raise InputError("--sintel names no folder with its frames")
    for name in (*FRAMES, FLOW, HIDDEN):
        if not (folder / name).is_file():
            raise InputError(f"{folder}: holds no {name}")
    images = [read_uint8(folder / name) for name in FRAMES]
    hidden = read_uint8(folder / HIDDEN)[..., 0] > 127
    forward = read_motion(folder / FLOW).forward
    forward = Motion(forward.field, forward.visible & ~hidden)
    guides = tuple(_guides(image) for image in images)
    return FrameSet(
        name="sintel_glass",
        style=_glass(images[0]),
        source_guides=guides[0],
        guides=guides,
        edges={(0, 1): forward, (1, 0): inverted(forward)},
        renderings=np.stack(images),
    )


def _guides(image):
    """Luma and the strength of its edges, (H, W, 1) uint8 each."""
    grey = rgb2gray(image)
    edges = np.clip(4 * sobel(grey), 0, 1)
    return tuple(np.uint8(255 * each + 0.5)[..., None] for each in (grey, edges))


def _glass(image):
    """Stained glass: pieces of the mean colour of what lies behind them, between lines of lead."""
    pieces = slic(image, _PIECES, compactness=12, start_label=0)
    counts = np.bincount(pieces.ravel())
    means = np.stack(
        [np.bincount(pieces.ravel(), image[..., c].ravel()) / counts for c in range(3)], axis=1
    )
    painted = mark_boundaries(means[pieces] / 255, pieces, color=_INK, mode="inner")
    return np.uint8(255 * painted + 0.5)
