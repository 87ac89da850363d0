"""How a draughtsman draws: paper, washes, ruled lines, hatching."""

import numpy as np
from scipy.ndimage import map_coordinates
from skimage.filters import gaussian

from data_gen.styles.painting import at, noise

PAPER = np.array((0.985, 0.975, 0.95))
INK = np.array((0.10, 0.09, 0.14))


def paper(rng, shape):
    """A blank sheet, (H, W, 3): nearly white, as the ground of a drawing has to stay."""
    fibre = gaussian(rng.standard_normal(shape), 0.6)
    return np.clip(PAPER * (1 + 0.006 * fibre / fibre.std())[..., None], 0, 1)


def washed(rng, picture, colour, amount, unit, spill=5.0):
    """Thin colour laid over a picture; its border wanders by about ``spill`` thin strokes.

    Parameters
    ----------
    rng : numpy.random.Generator
    picture, colour : (H, W, 3) float
    amount : (H, W) float
        0 leaves the picture, 1 covers it.
    unit : float
    spill : float

    Returns
    -------
    (H, W, 3) float
    """
    shape = amount.shape
    rows, columns = np.mgrid[: shape[0], : shape[1]].astype(float)
    rows += spill * unit * noise(rng, shape, 60 * unit)
    columns += spill * unit * noise(rng, shape, 60 * unit)
    smooth = [gaussian(channel, 2.5 * unit) for channel in (*np.moveaxis(colour, -1, 0), amount)]
    moved = [map_coordinates(s, [rows, columns], order=1, mode="nearest") for s in smooth]
    pooled = np.clip(moved[3] * (1 + 0.13 * noise(rng, shape, 35 * unit)), 0, 1)[..., None]
    return picture + pooled * (np.stack(moved[:3], axis=-1) - picture)


def ruled(rng, lines, unit, overshoot, drift):
    """Straight lines as a hand draws them: a little past their ends, a little beside.

    Parameters
    ----------
    rng : numpy.random.Generator
    lines : (N, 2, 2) float
        Ends, (x, y) in pixels.
    unit : float
    overshoot : float
        Thin strokes by which a long line passes its end; a short one passes less.
    drift : float
        Thin strokes by which a line lies beside its edge.

    Returns
    -------
    (N, 9, 2) float
    """
    count = len(lines)
    along = lines[:, 1] - lines[:, 0]
    length = np.linalg.norm(along, axis=1, keepdims=True) + 1e-9
    along = along / length
    across = along[:, ::-1] * (-1, 1)
    past = np.minimum(overshoot * unit * rng.uniform(0.2, 1.4, (count, 2)), 0.35 * length)
    start = lines[:, 0] - past[:, :1] * along
    end = lines[:, 1] + past[:, 1:] * along
    share = np.linspace(0, 1, 9)[:, None]
    # A line starts and ends beside its edge, and bends a little between: by less if it is short.
    calm = np.minimum(1, length[:, 0] / (40 * unit))
    beside = drift * unit * calm * rng.normal(0, 1, (3, count))
    sideways = beside[0] * (1 - share) + beside[1] * share + 0.5 * beside[2] * share * (1 - share)
    points = start[:, None] * (1 - share) + end[:, None] * share
    return points + sideways.T[..., None] * across[:, None]


def hatching(rng, inside, angle, spacing, unit, waver=0.35):
    """Parallel lines at even distances, as far as they lie inside.

    Parameters
    ----------
    rng : numpy.random.Generator
    inside : (H, W) bool
    angle : float
        Radians, 0 along x, a quarter turn along y.
    spacing : float
        Thin strokes from a line to the next.
    unit : float
    waver : float
        Thin strokes by which lines are off.

    Returns
    -------
    (N, 2, 2) float
        Short pieces, to be drawn one after another.
    """
    height, width = inside.shape
    along, across = (
        np.array([np.cos(angle), np.sin(angle)]),
        np.array([-np.sin(angle), np.cos(angle)]),
    )
    reach, middle = np.hypot(height, width) / 2, np.array([width, height]) / 2
    offsets = np.arange(-reach, reach, spacing * unit)
    steps = np.arange(-reach, reach, 2.0)
    offsets = offsets + waver * unit * rng.normal(0, 1, len(offsets))
    tilt = 0.006 * rng.normal(0, 1, len(offsets))
    sideways = offsets[:, None] + tilt[:, None] * steps
    points = middle + steps[None, :, None] * along + sideways[..., None] * across
    in_picture = ((points >= 0) & (points <= (width - 1, height - 1))).all(axis=-1)
    drawn = at(inside, points) & in_picture
    both = drawn[:, :-1] & drawn[:, 1:]
    return np.stack([points[:, :-1][both], points[:, 1:][both]], axis=1)


def layer(rng, lines, width, unit, opacity, colour=INK):
    """A layer for :func:`data_gen.lines.draw_lines`: strokes that differ a little in weight."""
    count = len(lines)
    colours = np.broadcast_to(colour, (count, 3)) + rng.normal(0, 0.03, (count, 1))
    return lines, colours, width * unit * rng.uniform(0.75, 1.3, count), opacity
