"""Make the bundled turntable of a data set that was rendered: ``make turntable`` calls it."""

import argparse
import shutil
import sys
from pathlib import Path

from PIL import Image

from data_gen.manifest import DataError, Manifest
from data_gen.turntable import BUFFERS, BUNDLED, SOURCE, STYLES, TARGET

PAINTING_QUALITY = 90
"""Of the paintings to begin with: what is painted over may be lossy."""


def main(arguments=None):
    """Pack the rendered set; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m data_gen.turntable", description=__doc__)
    parser.add_argument("rendered", type=Path, help="folder of the data set")
    parser.add_argument("--folder", type=Path, default=BUNDLED, help=f"default {BUNDLED}")
    options = parser.parse_args(arguments)
    try:
        pack(options.rendered, options.folder)
    except (DataError, OSError) as error:
        print(f"data_gen.turntable: {error}", file=sys.stderr)
        return 2
    return 0


def pack(rendered, folder):
    """Write the buffers of the source and the steps, the paintings, and a manifest.

    Parameters
    ----------
    rendered : Path
        A data set with the scene.
    folder : Path
        Emptied first, but for files that its manifest does not list.

    Raises
    ------
    DataError
        If the data set lacks a file, or the folder holds other files.
    """
    of_set = Manifest.read(rendered)
    packed = Manifest.open(folder)
    packed.restart(of_set.recipe | {"painting_quality": PAINTING_QUALITY})
    steps = [piece for piece in of_set.pieces if piece.startswith(f"{TARGET}/")]
    for piece in (SOURCE, *steps):
        shutil.rmtree(folder / piece, ignore_errors=True)
        (folder / piece).mkdir(parents=True)
        for name in BUFFERS:
            _save_lossless(of_set.path(f"{piece}/{name}.png"), folder / piece / name)
        packed.add(piece)
    (folder / STYLES).mkdir()
    for style in of_set.styles:
        with Image.open(of_set.path(f"{STYLES}/{style}.png")) as image:
            image.save(folder / STYLES / f"{style}.webp", quality=PAINTING_QUALITY, method=6)
    packed.add(STYLES)


def _save_lossless(file, place):
    with Image.open(file) as image:
        if image.mode == "L":
            image.save(place.with_suffix(".png"), optimize=True)
        else:
            image.save(place.with_suffix(".webp"), lossless=True, quality=100, method=6, exact=True)


if __name__ == "__main__":
    sys.exit(main())
