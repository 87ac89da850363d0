"""Tables of numbers as text."""

import numpy as np
import pandas as pd

from eval.metrics import NUMBERS
from eval.number import Number

COLUMNS = NUMBERS | {"seconds": Number("processor time [s]", "{:.1f}")}


def table(frame):
    """A data frame as a Markdown table."""
    return frame.to_markdown(index=False, disable_numparse=True)


def formatted(frame, numbers=COLUMNS):
    """A data frame whose columns get the titles and formats of ``numbers``."""
    formatted = frame.copy()
    for name, number in numbers.items():
        if name in formatted:
            formatted[name] = formatted[name].map(number.form.format)
            formatted = formatted.rename(columns={name: number.title})
    return formatted


def formatted_with_spread(frame, numbers):
    """Text of means and spreads: ``mean ± spread``.

    Parameters
    ----------
    frame : pandas.DataFrame
        A column ``method``, and for each number one of its name and optionally one with ``±``.
    numbers : dict of str to Number

    Returns
    -------
    pandas.DataFrame
    """
    text = frame[["method"]].copy()
    for name, (title, form) in numbers.items():
        if name not in frame:
            continue
        text[title] = [
            "" if pd.isna(mean) else form.format(mean) + _plus_minus(spread, form)
            for mean, spread in zip(
                frame[name], frame.get(f"{name} ±", np.nan * frame[name]), strict=True
            )
        ]
    return text


def with_spread(rows):
    """Mean of each number and, if there are several rows, sample standard deviation (``±``).

    Parameters
    ----------
    rows : iterable of dict of str to float

    Returns
    -------
    dict of str to float
    """
    frame = pd.DataFrame(list(rows))
    spread = {}
    for name in frame:
        spread[name] = frame[name].mean()
        if len(frame) > 1:
            spread[f"{name} ±"] = 0.0 if frame[name].nunique() == 1 else frame[name].std()
    return spread


def _plus_minus(spread, form):
    return "" if pd.isna(spread) or np.isinf(spread) else f" ± {form.format(spread)}"
