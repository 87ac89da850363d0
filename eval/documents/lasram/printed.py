"""The printed numbers of the paper (sections 4 and 8)."""

import pandas as pd

SIZES = (256, 512, 1024, 2048)

TIMES = pd.DataFrame(
    {
        "size of S": SIZES,
        "paper [MB]": ("<4", "14", "56", "226"),
        "paper, an iteration [ms]": (6, 6, 25, 59),
    }
)
"""One iteration at R = 64 on a GTX 580."""

STAGES = pd.DataFrame(
    {
        "size of S": SIZES,
        "paper, C: DP initialization": (0.09, 0.19, 0.29, 0.51),
        "paper, C: DP": (0.27, 0.22, 0.11, 0.12),
        "paper, D: DP initialization": (0.03, 0.05, 0.08, 0.14),
        "paper, D: DP": (0.28, 0.22, 0.10, 0.08),
    }
)
"""The shares of its four stages."""

CUTS = {
    "weighting": "paper",
    "laid over": "not said",
    "passes": "one",
    "trials": 3000,
    "optimal cut, mean": 50.855,
    "approximate cut, mean": 53.633,
    "ratio of means": 53.633 / 50.855,
    "rank of 256": 8.59,
    "ranked first": 0.1776,
    "all cuts, mean": 81.962,
}
"""How good approximate cuts are."""

RADIUS_128_MS = 112
"""16 iterations at 512² with R = 128 (figure 16)."""

COMPLETED = 1200, 1600
"""Height and width of S in figure 12."""

PIXELS_MS = 15
"""4 iterations of pixel-based synthesis at 512² (figure 16)."""
