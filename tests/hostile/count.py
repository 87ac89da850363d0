"""Counts the generated cases of all test processes; too few of them fail the session."""

from collections import Counter

import pytest

ENOUGH = 2000
CASES = Counter()
"""Cases that ran, by property; 0 for one that did not run."""


def pytest_sessionfinish(session):
    """A worker hands its counts over; where there are no workers left, they are judged."""
    if hasattr(session.config, "workeroutput"):
        session.config.workeroutput["hostile_cases"] = dict(CASES)
    elif too_few():
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node):
    """Take over the counts of a worker, unless it crashed."""
    CASES.update(getattr(node, "workeroutput", {}).get("hostile_cases", {}))


def pytest_terminal_summary(terminalreporter):
    """Say how many there were."""
    if CASES.total():
        terminalreporter.write_line(f"{CASES.total()} hostile cases were generated")
    if too_few():
        terminalreporter.write_line(f"FAILED: at least {ENOUGH} must be", red=True)


def too_few():
    """Whether all properties ran, but on too few cases."""
    return bool(CASES) and all(CASES.values()) and CASES.total() < ENOUGH
