"""Pictures as PNG, for the page's ``img``."""

import io

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from starlette.responses import Response

THUMBNAIL = 96
"""Most pixels along a side of a thumbnail."""


def png_response(image: NDArray[np.uint8], *, most: int | None = None) -> Response:
    """An answer that is a picture.

    Parameters
    ----------
    image : (H, W) or (H, W, n) uint8
        Of more than three channels the first three are shown, of two the first.
    most : int, optional
        Pixels along a side that it is shrunk to.
    """
    if image.ndim == 3:
        image = image[:, :, 0] if image.shape[2] < 3 else image[:, :, :3]
    picture = Image.fromarray(np.ascontiguousarray(image))
    if most:
        picture.thumbnail((most, most))
    content = io.BytesIO()
    picture.save(content, format="PNG", compress_level=1)
    return Response(content.getvalue(), media_type="image/png")
