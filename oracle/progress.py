"""A bar of progress where tqdm is installed; the cases are checked without it too."""

from collections.abc import Iterable

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None


def progress(cases: Iterable, total: int | None = None) -> Iterable:
    """The same cases, with a bar on a terminal that says how many are done."""
    return cases if tqdm is None else tqdm(cases, total=total, unit="case", disable=None)


def say(line: str) -> None:
    """Print a line, above the bar."""
    if tqdm is None:
        print(line)
    else:
        tqdm.write(line)
