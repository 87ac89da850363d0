"""Lines rasterized over a picture by matplotlib's Agg."""

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure


def draw_lines(picture, layers):
    """Draw lines over a picture, one layer after another.

    Parameters
    ----------
    picture : (H, W, 3) float
        sRGB in [0, 1].
    layers : list of (lines, colours, widths, opacity)
        ``lines`` (N, K, 2) float, K points (x, y) each, whole at pixel centres;
        ``colours`` (N, 3) float; ``widths`` (N,) float, pixels; ``opacity`` float.

    Returns
    -------
    (H, W, 3) float
    """
    height, width = picture.shape[:2]
    figure = Figure(figsize=(width / 100, height / 100), dpi=100)
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.imshow(picture, extent=(-0.5, width - 0.5, height - 0.5, -0.5), interpolation="none")
    axes.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5))
    axes.axis("off")
    points_a_pixel = 72 / figure.dpi
    for lines, colours, widths, opacity in layers:
        collection = LineCollection(
            lines,
            colors=np.clip(colours, 0, 1),
            linewidths=points_a_pixel * widths,
            alpha=opacity,
            capstyle="round",
            snap=False,  # or short pieces jump to whole pixels
        )
        axes.add_collection(collection, autolim=False)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3] / 255
