"""How much memory the command takes for a very large texture, its picture written."""

import sys
import tempfile
from pathlib import Path

import numpy as np
import pandas as pd

from data_gen.textures import make_texture
from eval.runs.process_cost import process_cost
from stylit_ref import write_image

SIDE = 8192

_WANTED = {1024: 2, 4096: 4}
"""GiB that it may take, by the side of the exemplar."""


def peak_memory(plan):
    """Peak memory of ``stylit-ref texture`` for 8192x8192 pixels.

    One iteration is done: all others take the same memory.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    pandas.DataFrame
        A row for each exemplar; none in a preset that leaves this out.
    """
    rows = []
    for side in plan.preset.memory_of:
        with tempfile.TemporaryDirectory() as folder:
            exemplar, output = Path(folder) / "exemplar.png", Path(folder) / "texture.png"
            times = side // 256
            write_image(exemplar, np.tile(make_texture("flowers"), (times, times, 1)))
            cost = process_cost(
                [sys.executable, "-m", "stylit_ref", "texture", "--exemplar", str(exemplar),
                 "--size", f"{SIDE}x{SIDE}", "--iterations", "1", "--output", str(output)]
            )  # fmt: skip
        rows.append(
            {
                "exemplar": f"{side}x{side}", "at most [GiB]": _WANTED[side],
                "peak [GiB]": cost.mebibytes / 1024, "processor seconds": cost.processor_seconds,
            }
        )  # fmt: skip
    return pd.DataFrame(rows)
