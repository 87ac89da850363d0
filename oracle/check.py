"""Run a port on the cases and report the outcome of each."""

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import partial

from oracle.cases import Case, read_cases
from oracle.compare import Outcome, outcome_of
from oracle.workers import shared


def check(
    port: Callable[[Case], dict],
    version: str,
    stages: Sequence[str] | None = None,
    expected_failures: Collection[str] = (),
    jobs: int = 1,
) -> Iterator[Outcome]:
    """Run a port on the cases of some stages.

    Parameters
    ----------
    port : callable
        ``(case) -> dict of str to array``; :class:`oracle.ports.CommandPort`,
        :class:`oracle.ports.ModulePort` or :class:`oracle.stages.passes_port.PassesPort`.
    version : str
    stages : sequence of str, optional
        All of the version by default.
    expected_failures : collection of str
        Titles of cases that must fail, ``*`` standing for anything.
    jobs : int
        Processes that share the cases. With more than one, the port must be picklable and the
        call must come from the main thread.

    Yields
    ------
    Outcome
        In the order of the cases.

    Raises
    ------
    NoPortError
        If the port cannot be started, or ends the checker's process that it runs in.
    """
    one = partial(outcome_of, port, expected_failures)
    cases = read_cases(version, stages)
    yield from map(one, cases) if jobs == 1 else shared(one, cases, jobs)
