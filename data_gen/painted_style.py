"""A style exemplar painted over the sphere: wax crayon on grained paper.

Strokes take their colour from the light at their middle (highlight, lit side,
terminator, bounce light and cast shadow each have a colour of their own), run
diagonally across the background and around the object, and leave the paper's grain
white, so that the exemplar has the high frequencies that wash-out would lose.
"""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from skimage.filters import gaussian

# Colours from dark to light, sRGB in [0, 1].
_OBJECT = np.array(
    [[0.10, 0.06, 0.28], [0.16, 0.16, 0.52], [0.10, 0.38, 0.64], [0.24, 0.66, 0.66],
     [0.66, 0.88, 0.74], [1.00, 0.98, 0.90]]
)  # fmt: skip
_GROUND = np.array(
    [[0.24, 0.05, 0.20], [0.45, 0.08, 0.22], [0.78, 0.20, 0.14], [0.92, 0.42, 0.12],
     [0.97, 0.66, 0.28], [1.00, 0.87, 0.60]]
)  # fmt: skip
_PAPER = np.array([0.985, 0.97, 0.94])


def _palette(colours, tones):
    steps = np.linspace(0, 1, len(colours))
    return np.stack([np.interp(tones, steps, colours[:, c]) for c in range(3)], axis=-1)


def _grain(rng, height, width):
    """Paper tooth in [0, 1]: noise at two scales along the weave."""
    fine = gaussian(rng.standard_normal((height, width)), 0.5)
    coarse = gaussian(rng.standard_normal((height, width)), 1.8)
    tooth = fine / fine.std() + 0.6 * coarse / coarse.std()
    return np.argsort(np.argsort(tooth.ravel())).reshape(height, width) / tooth.size


def paint_crayon(passes, seed=7):
    """Paint a crayon picture over rendered passes of the sphere.

    Parameters
    ----------
    passes : dict of str to (H, W, 3) uint8
        From :func:`data_gen.analytic_scene.render`.
    seed : int

    Returns
    -------
    (H, W, 3) uint8
    """
    rng = np.random.default_rng(seed)
    full = passes["fullgi"] / 255
    height, width = full.shape[:2]
    on_object = full[..., 0] - full[..., 2] > 0.12
    shine = passes["dirspc"][..., 0] > 60
    on_object |= shine
    tone = gaussian(full.max(axis=-1) * 0.75 + 0.25 * passes["dirdif"].max(axis=-1) / 255, 1.5)
    for region in (on_object, ~on_object):
        low, high = np.quantile(tone[region], (0.01, 0.99))
        tone[region] = np.clip((tone[region] - low) / (high - low), 0, 1) * 0.86
    tone[shine] = 1.0
    rows, columns = np.nonzero(on_object)
    centre = np.array([rows.mean(), columns.mean()])

    figure = Figure(figsize=(width / 100, height / 100), dpi=100, facecolor=_PAPER)
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(0, width), ylim=(height, 0))
    axes.axis("off")
    for strokes, reach, thickness, opacity in (
        (height * width // 25, 16, 3.2, 0.5),
        (height * width // 14, 11, 1.5, 0.6),
        (height * width // 18, 8, 0.8, 0.75),
    ):
        y, x = rng.uniform(0, height, strokes), rng.uniform(0, width, strokes)
        pixel = y.astype(int), x.astype(int)
        painted = on_object[pixel]
        around = np.arctan2(y - centre[0], x - centre[1]) + np.pi / 2
        angle = np.where(painted, 0.75 * around, -0.9) + rng.normal(0, 0.16, strokes)
        length = reach * rng.uniform(0.5, 1.4, strokes) * np.where(painted, 0.55, 1.3)
        bend = rng.normal(0, 0.08, strokes) * length
        along = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        across = along[:, ::-1] * [-1, 1]
        middle = np.stack([x, y], axis=-1)
        half = along * length[:, None] / 2
        lines = np.stack([middle - half, middle + across * bend[:, None], middle + half], axis=1)
        shade = np.clip(tone[pixel] + rng.normal(0, 0.05, strokes), 0, 1)
        colour = np.where(painted[:, None], _palette(_OBJECT, shade), _palette(_GROUND, shade))
        colour = np.clip(colour + rng.normal(0, 0.05, (strokes, 3)), 0, 1)
        # An artist stays roughly inside the outline: strokes that cross it are lifted.
        ends = np.clip(lines[:, ::2].astype(int), 0, [width - 1, height - 1])
        inside = (on_object[ends[..., 1], ends[..., 0]] == painted[:, None]).all(axis=1)
        keep = inside | (rng.uniform(size=strokes) < 0.06)
        axes.add_collection(
            LineCollection(
                lines[keep],
                colors=colour[keep],
                alpha=opacity,
                linewidths=thickness * 0.72 * rng.uniform(0.6, 1.3, keep.sum()),
                capstyle="round",
            )
        )
    canvas.draw()
    picture = np.asarray(canvas.buffer_rgba())[..., :3] / 255

    # Wax skips the valleys of the paper, more so where little of it was laid on.
    skipped = _grain(rng, height, width) < 0.04 + 0.09 * tone * (~shine)
    skipped = gaussian(skipped.astype(float), 0.35)[..., None] * 0.7
    picture = picture * (1 - skipped) + _PAPER * skipped
    return np.floor(255 * np.clip(picture, 0, 1) + 0.5).astype(np.uint8)
