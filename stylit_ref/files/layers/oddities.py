"""What a header says that a picture does not show: a note for each."""

import logging
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

from stylit_ref.files.layers.contents import Layer
from stylit_ref.notes import note

_SRGB = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
"""Chromaticities x, y of red, green, blue and white."""


def note_oddities(path: str | Path, file: Path, spec: oiio.ImageSpec, layer: Layer) -> None:
    """Tell what is left out of a layer, or taken otherwise than the file means it.

    Parameters
    ----------
    path : str or Path
        The file and layer as the user wrote them.
    file : Path
    spec : OpenImageIO.ImageSpec
        Header of the layer's part.
    layer : Layer
    """
    _note_windows(path, file, spec)
    if spec.get_int_attribute("Orientation", 1) > 1:
        note(f"{path}: is turned upright, as its header says that it was taken")
    chromaticities = spec.getattribute("chromaticities")
    if layer.is_light and chromaticities and not np.allclose(chromaticities, _SRGB, atol=2e-3):
        note(
            f"{path}: its colours have other primaries than sRGB and are taken for sRGB; convert "
            "it to the primaries of sRGB (Rec. 709) to be exact",
            level=logging.WARNING,
        )


def _note_windows(path, file, spec):
    data, display = spec.roi, spec.roi_full
    shared = oiio.intersection(data, display)
    if shared.width <= 0 or shared.height <= 0:
        note(
            f"{path}: its data window lies outside its display window, so nothing of it is seen; "
            f"make its display window the data window: oiiotool {file} --fullpixels -o whole.exr",
            level=logging.WARNING,
        )
    elif (shared.width, shared.height) != (data.width, data.height):
        note(f"{path}: what lies outside its display window is left out")
