"""The printed numbers of the thesis, and the ratios that do not follow from its times."""

from pathlib import Path

import pandas as pd

FOLDER = Path(__file__).with_name("published")

LAMBDA = pd.read_csv(FOLDER / "lambda.csv")
SHARED_MEMORY = pd.read_csv(FOLDER / "shared_memory.csv")
EPSILON = pd.read_csv(FOLDER / "epsilon.csv")

TARGETS = tuple(LAMBDA["target"].unique())
UNIFORMITIES = tuple(LAMBDA["lambda"].dropna().astype(int).unique().tolist())
EPSILONS = tuple(EPSILON["epsilon"].dropna().astype(int).unique().tolist())

ROUNDING = {"stylit": 0.5, "ref": 0.0005}
"""Largest rounding error of a printed time, in seconds."""


def figure(table, target):
    """Number of the figure that shows a target, which is also that of its table."""
    return str(table.loc[table["target"] == target, "figure"].iloc[0])


def errata():
    """Rows whose printed ratio does not follow from the printed times, even allowing for rounding.

    Returns
    -------
    pandas.DataFrame
        Columns table, target, row, ratio, printed, follows.
    """
    found = []
    for table in (LAMBDA, EPSILON):
        for target, rows in table.groupby("target", sort=False):
            times = {
                name: rows.loc[rows["method"] == name, "time_s"].iloc[0]
                for name in ("stylit", "ref")
            }
            for _, row in rows[rows["method"] != "stylit"].iterrows():
                parameter = "lambda" if "lambda" in row else "epsilon"
                value = "" if pd.isna(row[parameter]) else f", {parameter} {row[parameter]:g}"
                place = row["figure"], target, f"{row['method']}{value}"
                found += [(*place, *entry) for entry in _entries(row, row["time_s"], times)]
    for _, row in SHARED_MEMORY.iterrows():
        times = {name: row[f"{name}_s"] for name in ("stylit", "ref")}
        entries = _entries(row, row["shared_memory_s"], times)
        found += [("5.1.3", row["target"], "shared memory", *entry) for entry in entries]
    columns = ["table", "target", "row", "ratio", "printed", "follows"]
    return pd.DataFrame(found, columns=columns)


def _entries(row, seconds, times):
    """The ratios of a row that do not follow: name, as printed, as it follows."""
    for name, numerator in times.items():
        printed = next((row[key] for key in row.index if key.startswith(f"{name}_over_")), None)
        if pd.isna(printed):
            continue
        low = (numerator - ROUNDING[name]) / (seconds + ROUNDING["ref"]) - 0.001
        high = (numerator + ROUNDING[name]) / (seconds - ROUNDING["ref"]) + 0.001
        if not low <= printed <= high:
            yield f"{name}/time", printed, numerator / seconds
