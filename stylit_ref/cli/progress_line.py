"""The line that shows how far a run is."""

import sys
from collections.abc import Callable, Iterable
from contextlib import ExitStack
from types import TracebackType

from tqdm import tqdm

from stylit_ref.machine.compilation import Specialization, compiling_together
from stylit_ref.stylization.progress import Step

_PREPARATION = "{desc} {n_fmt} of {total_fmt} |{bar}| {elapsed}"
_COMPILATION = "{desc} |{bar}| {elapsed}"
_RUN = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


class _Bar(tqdm):
    """A bar without a thread of its own, beside which kernels are not compiled in forks."""

    monitor_interval = 0


class ProgressLine:
    """One line on stderr: frames that are looked at, kernels that are compiled, then the run.

    Each begins a bar of its own when it has something to tell, so that notes and refusals before it
    find an empty line, and the estimate of the run knows of nothing but the run.

    Parameters
    ----------
    quiet : bool
        Never show it; otherwise a terminal does.
    verbose : bool
        Tell the energy too.

    Attributes
    ----------
    is_shown : bool
    """

    def __init__(self, quiet: bool, verbose: bool = False) -> None:
        self.is_shown: bool = not quiet and sys.stderr.isatty()
        self._quiet = quiet
        self._verbose = verbose
        self._bar: _Bar | None = None
        self._runs = False
        self._together = ExitStack()

    def __enter__(self) -> "ProgressLine":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._together.close()
        self._close()

    def compile(self, kernels: Callable[[], Iterable[Specialization]]) -> None:
        """Tell it when one of these kernels is missing, and compile all; until the line ends."""
        self._together.enter_context(compiling_together(kernels, self.compiling))

    def compiling(self, number: int, count: int) -> None:
        """Tell which kernel is going to be compiled; where no line is shown, how many there are."""
        if not self.is_shown:
            if number == 1 and not self._quiet:
                what = "a kernel" if count == 1 else f"{count} kernels"
                print(f"compiling {what}, once", file=sys.stderr)
            return
        told = f"compiling kernels {number} of {count}, once"
        if number == 1:
            self._runs = False  # if a run has begun, it goes on in a line of its own
            self._open(_COMPILATION, desc=told, total=count, leave=False)
        self._bar.n = number - 1
        self._bar.set_description_str(told)

    def look(self, number: int, count: int) -> None:
        """Tell that so many of the frames have been looked at, before any is stylized."""
        if number == 0:
            self._open(_PREPARATION, desc="looking at frames", total=count, leave=False)
        self._bar.update(number - self._bar.n)

    def step(self, step: Step) -> None:
        """Tell a step of the run."""
        told = _place(step)
        if self._verbose:
            told += f"  {_energy(step)}"
        self.tell(step.done, told)

    def tell(self, done: float, told: str) -> None:
        """Tell in words how far a run is; ``done`` is the share of its work."""
        if not self._runs:
            self._runs = True
            self._open(_RUN, desc=told, total=1.0, initial=done)
        self._bar.set_description_str(told, refresh=False)
        self._bar.update(done - self._bar.n)

    def wrote(self, path: str, number: int, count: int) -> None:
        """Tell that a file of several is written, where no line shows how far the work is."""
        if not self.is_shown and not self._quiet:
            print(f"wrote {path}, {number} of {count}", file=sys.stderr, flush=True)

    def _open(self, layout, **settings):
        self._close()
        # miniters=0: every step is shown that comes a tenth of a second after the one shown last.
        self._bar = _Bar(
            file=sys.stderr, disable=not self.is_shown, bar_format=layout, miniters=0, **settings
        )

    def _close(self):
        if self._bar is not None:
            self._bar.close()


def _place(step):
    place = f"level {step.level} of {step.levels} ({step.width}x{step.height}), round {step.vote}"
    return place if step.fixed is None else f"{place}, {step.fixed:.0%} placed"


def _energy(step):
    delta = f"δ {step.delta:.0f}"
    if step.fixed is not None:
        return f"{delta}  retrieval {step.retrieval}"
    phi = step.delta + step.penalization
    return f"φ {phi:.0f} = {delta} + λρ {step.penalization:.0f}"
