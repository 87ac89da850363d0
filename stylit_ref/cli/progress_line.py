"""The line that shows how far a run is, and its energy."""

import sys
from contextlib import contextmanager

from tqdm import tqdm

_BAR = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


@contextmanager
def progress_line(quiet):
    """Show the line on stderr while the block runs.

    Parameters
    ----------
    quiet : bool
        Never show it; otherwise a terminal does.

    Yields
    ------
    callable
        To be called with every :class:`stylit_ref.Step`.
    """
    with tqdm(total=1.0, disable=quiet or None, bar_format=_BAR, file=sys.stderr) as bar:

        def show(step):
            bar.set_description_str(
                f"level {step.level}/{step.levels}  {_energy(step)}", refresh=False
            )
            bar.update(step.done - bar.n)

        yield show


def _energy(step):
    delta = f"δ {step.delta:.0f}"
    if step.fixed is not None:
        return f"{delta}  retrieval {step.retrieval}: {step.fixed:.0%} fixed"
    phi = step.delta + step.penalization
    return f"φ {phi:.0f} = {delta} + λρ {step.penalization:.0f}"
