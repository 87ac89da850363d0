"""Measure the time of a run by stage."""

from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter
from types import SimpleNamespace

from numba.core import event

from stylit_ref.machine.replaced import Passes

COMPILATION = "compilation"


class Profile:
    """Wall time by stage.

    Attributes
    ----------
    seconds : dict of str to float
        By stage, each measured until it has finished; the compilation of CPU kernels is a stage of
        its own.
    calls : dict of str to int
    """

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {COMPILATION: 0.0}
        self.calls: dict[str, int] = {COMPILATION: 0}
        self._start = perf_counter()

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Add the time of the block to stage ``name``."""
        compiled = 0.0

        def on_compiled(seconds):
            nonlocal compiled
            compiled += seconds

        start = perf_counter()
        with event.install_timer("numba:compile", on_compiled):
            yield
        elapsed = perf_counter() - start
        self._add(name, elapsed - compiled)
        if compiled:
            self._add(COMPILATION, compiled)

    def passes(self, passes: Passes) -> SimpleNamespace:
        """The functions of a module of passes, each a stage of its own."""

        def timed(name):
            def call(*arguments, **options):
                with self.stage(name):
                    result = getattr(passes, name)(*arguments, **options)
                    passes.wait()
                    return result

            return call

        return SimpleNamespace(**{name: timed(name) for name in passes.__all__})

    def table(self) -> list[str]:
        """Lines of text: seconds, share and calls of each stage, largest first, then the rest."""
        total = perf_counter() - self._start
        stages = sorted(self.seconds, key=self.seconds.get, reverse=True)
        rows = [(name, self.seconds[name], self.calls[name]) for name in stages if self.calls[name]]
        rows.append(("elsewhere", total - sum(self.seconds.values()), ""))
        width = max(len(name) for name, _, _ in rows)
        return [f"{'stage':{width}}  seconds  share  calls"] + [
            f"{name:{width}}  {seconds:7.2f}  {seconds / total:5.1%}  {calls:5}".rstrip()
            for name, seconds, calls in rows
        ]

    def _add(self, name, seconds):
        self.seconds[name] = self.seconds.get(name, 0.0) + seconds
        self.calls[name] = self.calls.get(name, 0) + 1
