"""The line that shows how far a run is."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NamedTuple, NoReturn

from tqdm import tqdm

from stylit_ref.stylization.progress import Step

_COMPILATION = "{desc} |{bar}| {elapsed}"
_WHOLE = 1.0
_RUN = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


class ProgressLine(NamedTuple):
    """One line on stderr: the kernels that are compiled, if any are, then the run.

    Attributes
    ----------
    bar : tqdm.tqdm
    verbose : bool
        Tell the energy too.
    """

    bar: "tqdm[NoReturn]"
    verbose: bool

    def compiling(self, number: int, count: int) -> None:
        """Tell which kernel is going to be compiled."""
        self.bar.set_description_str(f"compiling kernels {number} of {count}, once", refresh=False)
        if number == 1:
            self.bar.bar_format = _COMPILATION
            self.bar.reset(total=count)
        self.bar.n = number - 1
        self.bar.refresh()

    def step(self, step: Step) -> None:
        """Tell a :class:`stylit_ref.Step`."""
        told = _place(step)
        if self.verbose:
            told += f"  {_energy(step)}"
        self.bar.set_description_str(told, refresh=False)
        if self.bar.total != _WHOLE:  # kernels were compiled: no part of the estimate
            self.bar.bar_format = _RUN
            self.bar.reset(total=_WHOLE)
        self.bar.update(step.done - self.bar.n)


@contextmanager
def progress_line(quiet: bool, verbose: bool) -> Iterator[ProgressLine]:
    """Show the line while the block runs.

    Parameters
    ----------
    quiet : bool
        Never show it; otherwise a terminal does.
    verbose : bool
        Tell the energy too.

    Yields
    ------
    ProgressLine
    """
    with tqdm(total=_WHOLE, disable=quiet or None, bar_format=_RUN, file=sys.stderr) as bar:
        yield ProgressLine(bar, verbose)


def _place(step):
    place = f"level {step.level} of {step.levels} ({step.width}x{step.height}), round {step.vote}"
    return place if step.fixed is None else f"{place}, {step.fixed:.0%} placed"


def _energy(step):
    delta = f"δ {step.delta:.0f}"
    if step.fixed is not None:
        return f"{delta}  retrieval {step.retrieval}"
    phi = step.delta + step.penalization
    return f"φ {phi:.0f} = {delta} + λρ {step.penalization:.0f}"
