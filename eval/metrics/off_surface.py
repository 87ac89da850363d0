"""Whether strokes turn with the surface that they lie on: Hauptfleisch 2020, future work."""

import numpy as np
from scipy.ndimage import gaussian_filter, maximum_filter, minimum_filter

from eval.number import Number
from eval.scenes import Scene

DIRECTION = "DIRECTION"
"""Buffer of the projected direction of the surface: cosine and sine of twice its angle."""

FACE = "FACE"
"""Buffer of a value for each face in the light or in shadow, the same in source and target."""

WIDTH = 2.0
"""Pixels over which the direction of strokes is told."""

MARGIN = 4
"""Pixels beside the border of a face that do not count: there are outlines."""

_CLEAREST, _FEWEST = 0.5, 100
"""How much the strokes of a face have to agree in direction, from 0 to 1, and its fewest pixels."""

NUMBERS = {"off_surface": Number("strokes off the surface", "{:.1f}°")}

DEFINITION = """\
- **strokes off the surface**: mean angle between the output's strokes and those that the painting
  has on the same face, in the light or in shadow, turned as the face's line of steepest descent
  turns from the source's view to the target's. Clear strokes weigh more; outlines, and faces whose
  strokes have no common direction in the painting, do not count; 45° is chance."""


def measure(scene, outcome):
    """The number of a picture whose surfaces are known."""
    if not isinstance(scene, Scene) or not {DIRECTION, FACE} <= scene.buffers.keys():
        return {}
    angle = off_surface(
        outcome.image, scene.style, scene.buffers[DIRECTION][::-1], scene.buffers[FACE][::-1]
    )
    return {} if angle is None else {"off_surface": angle}


def off_surface(image, style, directions, faces):
    """Mean angle in degrees between strokes and the direction that their surface gives them.

    Parameters
    ----------
    image : (H_B, W_B, n) uint8
    style : (H_A, W_A, n) uint8
    directions : 2 arrays (H, W, 2) uint8
        Of the target and of the source.
    faces : 2 arrays (H, W, n) uint8
        A value for each face; of the target and of the source.

    Returns
    -------
    float or None
        0 to 90; None if no face has strokes of a common direction, or the output has none there.
    """
    numbers = _numbered(faces)
    (ours, our_numbers), (theirs, their_numbers) = (
        (_strokes(picture) * np.conj(_unit(direction)), _without_borders(number))
        for picture, direction, number in zip((image, style), directions, numbers, strict=True)
    )
    angles = weights = 0.0
    for face in np.unique(their_numbers[their_numbers >= 0]):
        painted, drawn = theirs[their_numbers == face], ours[our_numbers == face]
        common, all_of_it = painted.sum(), np.abs(painted).sum()
        if len(painted) >= _FEWEST and abs(common) > _CLEAREST * all_of_it:
            off = np.abs(np.angle(drawn * np.conj(common))) / 2
            angles += (off * np.abs(drawn)).sum()
            weights += np.abs(drawn).sum()
    return float(np.degrees(angles / weights)) if weights else None


def _strokes(image):
    """(H, W) complex: twice the angle of strokes, y down, as long as they are strong and clear."""
    grey = np.atleast_3d(image).astype(float).mean(axis=2)
    down, right = (gaussian_filter(grey, 1, order) for order in ((1, 0), (0, 1)))
    square = (down + 1j * right) ** 2  # strokes run across their gradient
    return gaussian_filter(square.real, WIDTH) - 1j * gaussian_filter(square.imag, WIDTH)


def _unit(direction):
    """(H, W) complex of length 1; 0 where there is no surface."""
    double = (direction.astype(float) / 127.5 - 1) @ (1, 1j)
    length = np.abs(double)
    return np.where(length > 0.5, double / np.maximum(length, 0.5), 0)


def _numbered(faces):
    """The same faces as numbers from 0 on, (H, W) int each."""
    rows = np.concatenate([face.reshape(-1, face.shape[2]) for face in faces])
    numbers = np.unique(rows, axis=0, return_inverse=True)[1].ravel()
    parts = np.split(numbers, [faces[0].shape[0] * faces[0].shape[1]])
    return [part.reshape(face.shape[:2]) for part, face in zip(parts, faces, strict=True)]


def _without_borders(numbers):
    """Numbers of faces, -1 near where two of them meet."""
    side = 2 * MARGIN + 1
    is_inside = maximum_filter(numbers, side) == minimum_filter(numbers, side)
    return np.where(is_inside, numbers, -1)
