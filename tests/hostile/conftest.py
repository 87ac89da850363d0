"""Says how many cases were generated."""

from hostile.generated import CASES


def pytest_terminal_summary(terminalreporter):
    if CASES:
        terminalreporter.write_line(f"{sum(CASES.values())} hostile cases were generated")
