"""The pictures of the page on sequences, after ``make data SIZE=500x500 SCENES=turning``."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image
from skimage.io import imread, imsave

from stylit_ref.cli import main

ROOT = Path(__file__).parents[2]
SCENES = ROOT / "build" / "data" / "500x500"
PICTURE = ROOT / "docs" / "pictures" / "sequence.webp"
MOTION = "--motion", f"{SCENES}/turning/motion/%02d_to_%02d.exr"
SHOWN = 4, 5, 6


def stylized():
    """Three frames: each by itself, and the same as a sequence."""
    rows = []
    with TemporaryDirectory() as folder:
        for motion in ((), MOTION):
            main([
                "sequence", "--preset", "fast", "--style", f"{SCENES}/source/styles/pen.png",
                "--guide", f"{SCENES}/source", f"{SCENES}/turning/%02d",
                "--guide-layers", "FULL,LDE,LSE,LDDE,IDMASK", *motion,
                "--frames", f"0-{SHOWN[-1]}", "--output", f"{folder}/%02d.png",
            ])  # fmt: skip
            rows.append([imread(f"{folder}/{frame:02d}.png") for frame in SHOWN])
    return rows


if __name__ == "__main__":
    rows = stylized()
    parts = [np.hstack([frame[180:330, 130:390] for frame in row]) for row in rows]
    imsave(PICTURE, np.vstack(parts), check_contrast=False)
    small = Image.fromarray(np.hstack([rows[1][0], rows[1][-1]]))
    small.thumbnail((250, 180))
    small.save(PICTURE.with_stem("sequence_small"))
