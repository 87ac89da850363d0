"""A progress bar if tqdm is installed; the checker works without it."""

from collections.abc import Iterable

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None


def progress(cases: Iterable, total: int | None = None) -> Iterable:
    """Pass the cases through; on a terminal a bar shows how many are done."""
    return cases if tqdm is None else tqdm(cases, total=total, unit="case", disable=None)


def say(line: str) -> None:
    """Print a line, above the bar."""
    if tqdm is None:
        print(line)
    else:
        tqdm.write(line)
