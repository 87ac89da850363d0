"""The page to print: the picture pale, to be painted over, with a mark at each corner."""

from io import BytesIO
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont
from scipy.ndimage import gaussian_filter, maximum_filter, minimum_filter

from stylit_ref.parameters import Choice
from stylit_ref.studio.sheet.layout import CELL, CODES, DOTS_PER_INCH, MARK, layout_of

Paper = Literal["A4", "Letter"]

_SIZES = {"A4": (2480, 3508), "Letter": (2550, 3300)}
"""Width and height in dots."""

_USE = (
    "Paint over the picture. Keep the four marks free. Then scan the sheet, or photograph all of "
    "it from above in even light."
)

_INK = 0.3
"""How much of the rendering's darkness is printed: enough to see its light, and paint covers it."""

_OUTLINE, _FRAME, _TEXT = 150, 190, 90
"""Grey values."""

_STEPS = 1.2
"""Pixels over which the steps of an outline are smoothed."""

_MOST_PARTS = 16


def print_sheet(
    rendering: NDArray[np.uint8], ids: NDArray[np.uint8], *, paper: Paper = "A4"
) -> bytes:
    """The sheet as a PDF of one page, at 300 dpi.

    Parameters
    ----------
    rendering : (H, W, 3) uint8
        What is to be painted over.
    ids : (H, W, 3) uint8
        A colour for each thing; where two meet, an outline is printed.
    paper : {"A4", "Letter"}

    Returns
    -------
    bytes

    Raises
    ------
    InputError
        If the paper is another one.
    """
    pdf = BytesIO()
    page = draw_sheet(rendering, ids, paper=paper)
    page.save(pdf, "PDF", resolution=DOTS_PER_INCH, quality=92, title="A sheet to paint on")
    return pdf.getvalue()


def draw_sheet(
    rendering: NDArray[np.uint8], ids: NDArray[np.uint8], *, paper: Paper = "A4"
) -> Image.Image:
    """The page as a grey image; parameters and errors are those of :func:`print_sheet`."""
    size = _SIZES[Choice(tuple(_SIZES)).check("paper", paper)]
    height, width = rendering.shape[:2]
    layout = layout_of(width, height)
    x, y = (size[0] - layout.width) // 2, (size[1] - layout.height) // 2
    page = Image.new("L", size, 255)
    page.paste(_picture(rendering, ids, layout), (x, y))
    draw = ImageDraw.Draw(page)
    draw.rectangle((x - 9, y - 9, x + layout.width + 8, y + layout.height + 8), None, _FRAME, 3)
    for code, corners in zip(CODES, layout.marks.astype(int).tolist(), strict=True):
        _draw_mark(draw, code, corners[0][0] + x, corners[0][1] + y)
    below = y + layout.height + 2 * MARK
    font = ImageFont.load_default(34)
    draw.text((size[0] // 2, below), _USE, fill=_TEXT, font=font, anchor="ms")
    return page


def _picture(rendering, ids, layout):
    grey = Image.fromarray(rendering).convert("L").resize(layout, Image.Resampling.BICUBIC)
    pale = 255 - _INK * (255 - np.asarray(grey, np.float32))
    return Image.fromarray(np.where(_outline(ids, layout), _OUTLINE, pale).astype(np.uint8))


def _outline(ids, layout):
    """Where two things meet, as a line of a few dots, without the steps of pixels."""
    colours, counts = np.unique(ids.reshape(-1, ids.shape[2]), axis=0, return_counts=True)
    owner = np.zeros(layout[::-1], np.uint8)
    share = np.zeros(layout[::-1], np.uint8)
    for number, colour in enumerate(colours[np.argsort(-counts)][:_MOST_PARTS]):
        own = 255 * (ids == colour).all(axis=2).astype(np.float32)
        own = Image.fromarray(gaussian_filter(own, _STEPS).astype(np.uint8))
        own = np.asarray(own.resize(layout, Image.Resampling.BICUBIC))
        owner[own > share] = number
        share = np.maximum(share, own)
    return maximum_filter(owner, 4) != minimum_filter(owner, 4)


def _draw_mark(draw, code, x, y):
    draw.rectangle((x, y, x + MARK - 1, y + MARK - 1), 0)
    for row, cells in enumerate(code, 1):
        for column, cell in enumerate(cells, 1):
            if cell == "1":
                corner = x + CELL * column, y + CELL * row
                draw.rectangle((*corner, corner[0] + CELL - 1, corner[1] + CELL - 1), 255)
