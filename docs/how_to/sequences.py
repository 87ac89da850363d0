"""The picture of the page on sequences, after ``make data SIZE=500x500 SCENES=turning``."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from skimage.io import imread, imsave

from stylit_ref.cli import main

ROOT = Path(__file__).parents[2]
SCENES = ROOT / "build" / "data" / "500x500"
PICTURE = ROOT / "docs" / "pictures" / "sequence.webp"
MOTION = "--motion", f"{SCENES}/turning/motion/%02d_to_%02d.exr"
SHOWN = 4, 5, 6


def shown():
    """Three frames: each by itself in the first row, as a sequence in the second."""
    rows = []
    with TemporaryDirectory() as folder:
        for motion in ((), MOTION):
            code = main([
                "sequence", "--preset", "fast", "--style", f"{SCENES}/source/styles/pen.png",
                "--guide", f"{SCENES}/source", f"{SCENES}/turning/%02d",
                "--guide-layers", "FULL,LDE,LSE,LDDE,IDMASK", *motion,
                "--frames", f"0-{SHOWN[-1]}", "--output", f"{folder}/%02d.png",
            ])  # fmt: skip
            assert code == 0, "there are no such frames, or no motion"
            frames = [imread(f"{folder}/{frame:02d}.png") for frame in SHOWN]
            rows.append(np.hstack([frame[180:330, 130:390] for frame in frames]))
    return np.vstack(rows)


if __name__ == "__main__":
    imsave(PICTURE, shown(), check_contrast=False)
