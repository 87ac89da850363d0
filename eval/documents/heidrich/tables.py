"""The tables: the printed numbers beside ours, quality, and what each choice costs and changes."""

import numpy as np
import pandas as pd

from eval.documents.heidrich.plan import (
    BUFFERS,
    DENSE,
    ITERATIONS,
    LEFT_OUT,
    METHODS,
    PRODUCTS,
    SCHEDULES,
    STYLES,
    THESIS,
)
from eval.documents.heidrich.printed import OTHERS, TABLE_1
from eval.metrics import NUMBERS
from eval.runs.store import numbers_of, stored

SHOWN = (
    "image_energy", "median_energy", "distinct_in_image", "richness", "wrong_id", "spilled",
    "hatching", "foreground_outside", "style_border", "silhouette_lines", "stretched", "bent",
    "lost_highlights",
)  # fmt: skip
"""The numbers of every picture; from ``spilled`` on, artefacts of figures 24 and 25."""


def frame_times(job):
    """Milliseconds of a frame, ``cpu`` on one thread and ``wall`` on all, by method."""
    return stored(job).history.set_index("method")


def energy(jobs):
    """Mean image energy of some pictures."""
    return float(np.mean([numbers_of(job)["image_energy"] for job in jobs]))


def table_1(plan):
    """Table 1, the printed row and ours.

    Returns
    -------
    pandas.DataFrame
        Milliseconds and frames per second; the rows with rendering are cited alone.
    """
    rows = []
    for side in plan.sides:
        ours = frame_times(plan.times(side))
        for rendering in ("no", "yes"):
            for method in THESIS + (PRODUCTS if rendering == "no" else ()):
                row = {"resolution": f"{side}x{side}", "method": method}
                row["with rendering"] = rendering
                printed = TABLE_1[
                    (TABLE_1["resolution"] == row["resolution"])
                    & (TABLE_1["method"] == method)
                    & (TABLE_1["with_rendering"] == rendering)
                ]
                if len(printed):
                    row["thesis [ms]"] = printed["ms_per_frame"].iloc[0]
                    row["thesis [fps]"] = printed["fps"].iloc[0]
                if rendering == "no":
                    row["ours, one thread [ms]"] = ours.loc[method, "cpu"]
                    row["ours, all threads [ms]"] = ours.loc[method, "wall"]
                    row["ours [fps]"] = 1000 / ours.loc[method, "wall"]
                rows.append(row)
    return pd.DataFrame(rows).round(2)


def hand_times(plan):
    """What a hand waits for, with our presets on all threads.

    Returns
    -------
    pandas.DataFrame
        ``preset``, ``waited for``, and the median and the least milliseconds by side.
    """
    columns = {}
    for side in plan.sides:
        history = stored(plan.hand_times(side)).history
        columns["preset"], columns["waited for"] = history["preset"], history["waited_for"]
        columns[f"{side}², median [ms]"] = history["median"].round(1)
        columns[f"{side}², least [ms]"] = history["least"].round(1)
    return pd.DataFrame(columns)


def turning(plan):
    """How calm the turning target is, by preset and by how its frames are made.

    Returns
    -------
    pandas.DataFrame
        ``preset``, ``frames``, ``flicker`` in 8-bit steps, and the last frame's energy over that of
        a cold one.
    """
    history = stored(plan.turning).history.drop(columns="holds")
    history = history.rename(columns={"rise": "energy, over cold"})
    return history.round({"flicker": 2, "energy, over cold": 3})


def others(plan):
    """The times that section 4.2 quotes of others, and ours for a megapixel.

    Returns
    -------
    pandas.DataFrame
        Seconds.
    """
    rows = [
        {"system": row.system, "size": row.size_, "hardware": row.hardware, "seconds": _range(row)}
        for row in OTHERS.rename(columns={"size": "size_"}).itertuples()
    ]
    for name in DENSE:
        jobs = [plan.picture(style, name) for style in STYLES]
        spent = np.mean([stored(job).stages["cpu"] / job.scene.pixels for job in jobs])
        rows.append(_of_ours(name, f"{1e6 * spent:.0f}"))
    ours = frame_times(plan.times(plan.sides[-1]))
    rows += [
        _of_ours(name, f"{1000 * ours.loc[name, 'cpu'] / plan.sides[-1] ** 2:.3f}")
        for name in THESIS + PRODUCTS
    ]
    return pd.DataFrame(rows)


def _range(row):
    if pd.isna(row.seconds_least):
        return f"up to {row.seconds_most:g}"
    low, high = row.seconds_least, row.seconds_most
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def _of_ours(name, seconds):
    return {"system": f"ours: {name}", "size": "1 Mpx", "hardware": "one core", "seconds": seconds}


def quality(plan):
    """The numbers of every method in every style.

    Returns
    -------
    pandas.DataFrame
        ``style``, ``method``, the :data:`SHOWN` and ``background``.
    """
    rows = []
    for style in STYLES:
        for method in METHODS:
            found = numbers_of(plan.picture(style, method))
            numbers = {name: found.get(name) for name in (*SHOWN, "background")}
            rows.append({"style": style, "method": method, **numbers})
    return pd.DataFrame(rows)


def large(plan):
    """The numbers of the methods in real time at the thesis' size, without energy."""
    rows = []
    for style in STYLES:
        for method in THESIS + PRODUCTS:
            found = numbers_of(plan.large_picture(style, method))
            numbers = {name: found[name] for name in SHOWN if name in found}
            rows.append({"style": style, "method": method, **numbers})
    return pd.DataFrame(rows)


def formatted(table):
    """A table of words and metrics as text, with the metrics' titles."""
    text = pd.DataFrame()
    for name in table:
        if pd.api.types.is_numeric_dtype(table[name]):
            title, form = NUMBERS[name]
            text[title] = ["" if pd.isna(value) else form.format(value) for value in table[name]]
        else:
            text[name] = table[name]
    return text


def ablation(plan):
    """The optimized method without one, two or all of its savings (4.2): time and energy.

    Returns
    -------
    pandas.DataFrame
    """
    rows = []
    times = {side: frame_times(plan.times_of_savings(side)) for side in plan.sides}
    for savings in LEFT_OUT:
        row = {"left out": ", ".join(savings) or "nothing"}
        for side in plan.sides:
            row[f"{side}² [ms]"] = times[side]["cpu"].iloc[LEFT_OUT.index(savings)]
        row["energy"] = energy([plan.left_out(style, savings) for style in plan.preset.studied])
        rows.append(row)
    table = pd.DataFrame(rows)
    for side in plan.sides:
        table[f"{side}², over all three"] = table[f"{side}² [ms]"] / table[f"{side}² [ms]"].iloc[0]
    table["energy"] = table["energy"].round().astype(int)
    return table.round(2)


def widths(plan):
    """The simple method as w grows."""
    return _sweep(plan, "w", plan.preset.widths, plan.times_of_widths, plan.width)


def depths(plan):
    """The optimized method as D grows."""
    return _sweep(plan, "D", plan.preset.depths, plan.times_of_depths, plan.depth)


def _sweep(plan, name, values, times_at, job_of):
    columns = {name: values}
    for side in plan.sides:
        columns[f"{side}² [ms]"] = frame_times(times_at(side))["cpu"].round(2).tolist()
    columns["energy"] = [
        round(energy([job_of(style, value) for style in plan.preset.studied])) for value in values
    ]
    return pd.DataFrame(columns)


def choices(plan):
    """What else the thesis chose: μ by level, iterations, what a scale is."""
    tried = {"the thesis' simple method": lambda style: plan.picture(style, "simple")}
    tried |= {name: lambda style, name=name: plan.scheduled(style, name) for name in SCHEDULES}
    for count in ITERATIONS:
        tried[f"{count} iterations a level"] = lambda style, count=count: plan.iterated(
            style, count
        )
    tried["the thesis' optimized method"] = lambda style: plan.picture(style, "optimized")
    tried["optimized, means of boxes around the pixel"] = plan.boxes
    tried["patches at the finest level, scales elsewhere"] = plan.hybrid
    rows = []
    for name, job_of in tried.items():
        jobs = [job_of(style) for style in plan.preset.studied]
        numbers = pd.DataFrame([numbers_of(job) for job in jobs]).mean()
        rows.append({"choice": name} | {each: numbers[each] for each in SHOWN})
    return pd.DataFrame(rows)


def buffers(plan):
    """The thesis' methods with buffers left out (figure 27).

    Returns
    -------
    pandas.DataFrame
        ``changed`` is the mean absolute difference to the picture of all buffers, in 8-bit steps;
        for another seed, it is that of chance.
    """
    rows = []
    for method in THESIS:
        for weights in ("all", "all, another seed", *BUFFERS):
            jobs = [_weighted(plan, style, method, weights) for style in plan.preset.studied]
            whole = [plan.picture(style, method) for style in plan.preset.studied]
            row = {"method": method, "buffers": weights}
            row["changed"] = np.mean(
                [difference(job, other) for job, other in zip(jobs, whole, strict=True)]
            )
            for name in ("image_energy", "wrong_id", "lost_highlights"):
                row[name] = np.mean([numbers_of(job)[name] for job in jobs])
            rows.append(row)
    return pd.DataFrame(rows)


def _weighted(plan, style, method, weights):
    if weights in BUFFERS:
        return plan.weighted(style, method, weights)
    return plan.picture(style, method, seed=int(weights != "all"))


def difference(job, other):
    """Mean absolute difference of two pictures, in 8-bit steps."""
    one, two = (stored(each).image.astype(int) for each in (job, other))
    return float(np.abs(one - two).mean())


def fewest(plan):
    """Which buffers the simple method can do without (chapter 7).

    Returns
    -------
    pandas.DataFrame
        Every trial: ``style``, ``left out``, ``energy``, and ``over all``, its ratio to that of all
        buffers.
    """
    tables = []
    for style in plan.preset.studied:
        table = stored(plan.fewest(style, "simple")).history
        table = table.rename(columns={"left_out": "left out"})
        table.insert(0, "style", style)
        table["over all"] = table["energy"] / table["energy"].iloc[0]
        tables.append(table)
    table = pd.concat(tables).round({"over all": 3})
    table["energy"] = table["energy"].round().astype(int)
    return table
