"""The printed numbers of the thesis (1.1, 4.2 and table 1)."""

from pathlib import Path

import pandas as pd

FOLDER = Path(__file__).with_name("published")

TABLE_1 = pd.read_csv(FOLDER / "table_1.csv")
"""Milliseconds a frame on a GTX 1080."""

OTHERS = pd.read_csv(FOLDER / "others.csv")
"""Seconds a picture that section 4.2 quotes of others."""

REAL_TIME, INTERACTIVE = 15.0, 1.0
"""Frames per second: above the first it is real time, from the second on interactive (1.1)."""


def milliseconds(method, side):
    """Table 1 without rendering: a frame of ``side`` x ``side`` pixels.

    Parameters
    ----------
    method : {"simple", "optimized"}
    side : {500, 1000}

    Returns
    -------
    float
    """
    row = TABLE_1[
        (TABLE_1["method"] == method)
        & (TABLE_1["resolution"] == f"{side}x{side}")
        & (TABLE_1["with_rendering"] == "no")
    ]
    return float(row["ms_per_frame"].iloc[0])
