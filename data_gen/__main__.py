"""Render the bundled scene: ``python -m data_gen [FOLDER]``."""

import argparse
from pathlib import Path

from skimage.io import imsave

from data_gen.analytic_scene import FIGURE, SPHERE, render
from data_gen.painted_style import paint_crayon

BUNDLED = Path(__file__).parent / "bundled" / "figure"
HEIGHT, WIDTH = 304, 400


def main():
    """Write ``source_*.png``, ``target_*.png`` and ``source_style.png``."""
    parser = argparse.ArgumentParser(prog="python -m data_gen", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=BUNDLED)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for side, shape in (("source", SPHERE), ("target", FIGURE)):
        passes = render(shape, HEIGHT, WIDTH, antialias=3, light_side=6, bounces=96)
        for name, image in passes.items():
            imsave(folder / f"{side}_{name}.png", image, check_contrast=False)
        if shape == SPHERE:
            imsave(folder / "source_style.png", paint_crayon(passes), check_contrast=False)
        print(f"{folder}: {side} rendered")


if __name__ == "__main__":
    main()
