"""What a command says when it is done."""

import sys
from pathlib import Path

import numpy as np


def tell_finished(path: str | Path, image: np.ndarray, seconds: float, *others: str) -> None:
    """Say on stderr which picture was written, its size, and how long that took.

    Parameters
    ----------
    path : str
    image : (H, W, ...) array
    seconds : float
    *others : str
        What else was written.
    """
    height, width = image.shape[:2]
    beside = "".join(f", {other}" for other in others)
    print(f"wrote {path} ({width}x{height}){beside} in {seconds:.1f} s", file=sys.stderr)


def counted_frames(number: int) -> str:
    """As in ``1 frame``, ``3 frames``."""
    return f"{number} frame" + "s" * (number != 1)
