"""What a header says that a picture does not show: a note for each."""

import logging
from pathlib import Path

import numpy as np
import OpenImageIO as oiio

from stylit_ref.files.colour.profile import SRGB_PRIMARIES
from stylit_ref.files.layers.layer import Layer
from stylit_ref.notes import note


def note_oddities(file: Path, spec: oiio.ImageSpec, layer: Layer) -> None:
    """Tell what is left out of a layer, or taken otherwise than the file means it.

    What holds for all layers of a file names the file, so that it is told once.

    Parameters
    ----------
    file : Path
    spec : OpenImageIO.ImageSpec
        Header of the layer's part.
    layer : Layer
    """
    _note_windows(file, spec)
    if spec.get_int_attribute("Orientation", 1) > 1:
        note(f"{file}: is turned upright, as its header says that it was taken")
    chromaticities = spec.getattribute("chromaticities")
    if (
        layer.is_light
        and chromaticities
        and not np.allclose(chromaticities, SRGB_PRIMARIES, atol=2e-3)
    ):
        note(
            f"{file}: its colours have other primaries than sRGB and keep their values; convert it "
            "to the primaries of sRGB (Rec. 709) where other images have those",
            level=logging.WARNING,
        )


def _note_windows(file, spec):
    data, display = spec.roi, spec.roi_full
    shared = oiio.intersection(data, display)
    if shared.width <= 0 or shared.height <= 0:
        note(
            f"{file}: its data window lies outside its display window, so nothing of it is seen; "
            f"make its display window the data window: oiiotool {file} --fullpixels -o whole.exr",
            level=logging.WARNING,
        )
    elif (shared.width, shared.height) != (data.width, data.height):
        note(f"{file}: what lies outside its display window is left out")
