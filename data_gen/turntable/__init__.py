"""The scene that the studio opens with: a sphere to paint on, and the golem on a turntable.

It lies in ``bundled``, at 500x500: what a packing of the stage reads (Heidrich 2017, 4.1.3), and no
more. Colours are lossless WebP, and FRESNEL, which has none, is PNG. ``make turntable`` makes it.
"""

from pathlib import Path
from typing import NamedTuple

from data_gen.manifest import Manifest

BUNDLED = Path(__file__).with_name("bundled")

BUFFERS = "FULL", "LDE", "LDDE", "LSE", "IDMASK", "FRESNEL", "LIGHTMASK"
"""Those of each view, a file for each."""

SOURCE, TARGET, STYLES = "source", "turntable", "source/styles"


class Turntable(NamedTuple):
    """Files of the scene, all at one size.

    Attributes
    ----------
    source : dict of str to Path
        The buffers of the sphere, by their names.
    steps : dict of str to dict of str to Path
        The buffers of each step, by its degrees: ``"090"``.
    styles : dict of str to Path
        Paintings of the sphere to begin with.
    """

    source: dict[str, Path]
    steps: dict[str, dict[str, Path]]
    styles: dict[str, Path]


def turntable():
    """The bundled scene.

    Returns
    -------
    Turntable

    Raises
    ------
    DataError
        If a file is missing or was changed.
    """
    manifest = Manifest.read(BUNDLED)
    found = {
        piece: {Path(file).stem: manifest.path(file) for file in files}
        for piece, files in manifest.pieces.items()
    }
    steps = {
        piece.removeprefix(f"{TARGET}/"): files
        for piece, files in sorted(found.items())
        if piece.startswith(f"{TARGET}/")
    }
    return Turntable(found[SOURCE], steps, found[STYLES])
