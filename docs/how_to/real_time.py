"""The picture of the page on real time: ``python docs/how_to/real_time.py``."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from skimage.io import imread, imsave

from data_gen import guides
from stylit_ref.cli import main
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS

PICTURE = Path(__file__).parents[1] / "pictures" / "real_time.webp"
METHODS = "ref fast", "realtime best", "realtime quick", "realtime simple"
SCENES = Path(guides.__file__).with_name("bundled")


def shown():
    """The middle of the golem, by one method beside the other."""
    pictures = []
    with TemporaryDirectory() as folder:
        for each in METHODS:
            method, preset = each.split()
            output = f"{folder}/{preset}.png"
            main([
                "run", "--method", method, "--preset", preset, "--output", output,
                "--style", f"{SCENES}/source/styles/oil.png",
                "--guide", f"{SCENES}/source", f"{SCENES}/golem",
                "--guide-layers", ",".join(STAGE_BUFFERS),
            ])  # fmt: skip
            pictures.append(imread(output)[:, 60:250])
    return np.hstack(pictures)


if __name__ == "__main__":
    imsave(PICTURE, shown(), check_contrast=False)
