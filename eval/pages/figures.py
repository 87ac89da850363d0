"""Pictures side by side: contact sheets, and comparisons with zoom-ins."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from skimage.color import lab2rgb


def contact_sheet(rows, file, tile=300):
    """Save rows of titled images.

    Parameters
    ----------
    rows : list of list of (str, (H, W, n) array)
        Titles and images.
    file : Path
    tile : int
        Width of an image in pixels.
    """
    columns = max(len(row) for row in rows)
    height, width = rows[0][0][1].shape[:2]
    high = tile * height / width + 22
    figure = Figure(figsize=(columns * (tile + 8) / 100, len(rows) * high / 100), dpi=100)
    axes = figure.subplots(len(rows), columns, squeeze=False)
    figure.subplots_adjust(0, 0, 1, 1 - 20 / (high * len(rows)), wspace=0.03, hspace=22 / high)
    for place in axes.flat:
        place.axis("off")
    for places, row in zip(axes, rows, strict=True):
        for place, (title, image) in zip(places, row, strict=False):
            place.imshow(_in_colour(image))
            place.set_title(title, fontsize=9, pad=3)
    figure.savefig(file)


def comparison(rows, zoom, file):
    """Save rows of images, each row followed by its zoom-ins.

    Parameters
    ----------
    rows : list of list of (str, (H, W, n) array)
        Titles and images.
    zoom : tuple of 4 float
        Top, left, height and width of the zoom-in, as shares of the image.
    file : Path
    """
    columns = max(len(row) for row in rows)
    height, width = rows[0][-1][1].shape[:2]
    dpi = 100 if width <= 320 else 200  # large images keep their detail
    figure = Figure(
        figsize=(3.2 * columns, 2 * len(rows) * (3.2 * height / width) + 0.5),
        layout="constrained",
    )
    axes = figure.subplots(2 * len(rows), columns, squeeze=False)
    for place in axes.flat:
        place.axis("off")
    for k, row in enumerate(rows):
        for column, (title, image) in enumerate(row):
            top, left = int(zoom[0] * image.shape[0]), int(zoom[1] * image.shape[1])
            bottom, right = (
                top + int(zoom[2] * image.shape[0]),
                left + int(zoom[3] * image.shape[1]),
            )
            image = _in_colour(image)
            axes[2 * k, column].imshow(image, interpolation="antialiased")
            axes[2 * k, column].set_title(title, fontsize=11)
            axes[2 * k, column].add_patch(
                Rectangle((left, top), right - left, bottom - top, fill=False, color="lime")
            )
            axes[2 * k + 1, column].imshow(image[top:bottom, left:right], interpolation="nearest")
    figure.savefig(file, dpi=dpi)


def _in_colour(image):
    """An image with three channels: matplotlib would stretch the tones of a single one."""
    return np.repeat(image[:, :, :1], 3, axis=2) if image.shape[2] < 3 else image


def detailed_window(weights, share=0.25):
    """Find the most detailed square of an image.

    Parameters
    ----------
    weights : (H, W) array
    share : float
        Side of the square over that of the image.

    Returns
    -------
    tuple of 4 float
        Top, left, height, width, as shares of the image.
    """
    best = max(
        ((top / 20, left / 20) for top in range(1, 14) for left in range(1, 14)),
        key=lambda corner: weights[_window(weights.shape, *corner, share)].mean(),
    )
    return (*best, share, share)


def _window(shape, top, left, share):
    y, x = int(top * shape[0]), int(left * shape[1])
    return slice(y, y + int(share * shape[0])), slice(x, x + int(share * shape[1]))


def nnf_colours(nnf, source_size):
    """Show an NNF as colours: green to red from left to right, blue to yellow from top to bottom.

    Lightness is equal everywhere, so that colour shows the position in the source and nothing else.
    Coherent areas appear as smooth shades, jumps as edges.

    Parameters
    ----------
    nnf : (H, W, 2) int
        Source centres ``(y, x)``.
    source_size : (int, int)
        Rows and columns of the source.

    Returns
    -------
    (H, W, 3) float64
        sRGB in [0, 1].
    """
    down, along = np.moveaxis(nnf / np.array(source_size), 2, 0)
    return lab2rgb(np.stack([np.full_like(down, 70), 90 * along - 45, 90 * down - 45], axis=2))
