"""Compare a port's output with the expected one: the first array, element and value that differ."""

import math
from collections.abc import Callable, Collection
from fnmatch import fnmatchcase
from typing import NamedTuple

import numpy as np

from oracle.cases import Case, CaseError
from stylit_ref.errors import InputError

STATUSES = PASSED, FAILED, EXPECTED, UNEXPECTED, NOT_OFFERED = (
    "passed",
    "failed",
    "failed as expected",
    "passed unexpectedly",
    "not offered",
)


class NotOfferedError(Exception):
    """The port does not offer a stage."""


class NoPortError(InputError):
    """The port cannot be used for any case."""


class Difference(NamedTuple):
    """How a port's output differs from the expected one.

    Attributes
    ----------
    message : str
    array : str or None
        Name of the output that differs; None if the port failed before it wrote any.
    index : list of int or None
        The first element that differs.
    found, expected : int, float, bool or None
        None also for infinity and NaN, which JSON cannot hold; the message has them.
    """

    message: str
    array: str | None = None
    index: list[int] | None = None
    found: int | float | bool | None = None
    expected: int | float | bool | None = None


class Outcome(NamedTuple):
    """The result of checking a case.

    Attributes
    ----------
    stage, name, section : str
    status : str
    difference : Difference or None
    """

    stage: str
    name: str
    section: str
    status: str
    difference: Difference | None

    @property
    def title(self):
        """Stage and name."""
        return f"{self.stage}/{self.name}"


def outcome_of(
    port: Callable[[Case], dict], expected_failures: Collection[str], case: Case
) -> Outcome:
    """Run a port on a case and compare.

    Parameters
    ----------
    port : callable
        ``(case) -> dict of str to array``.
    expected_failures : collection of str
        Titles of cases that must fail; ``*`` stands for any text.
    case : Case

    Returns
    -------
    Outcome

    Raises
    ------
    NoPortError
        If the port cannot be used at all. Any other exception counts as a failure of this case.
    """
    expected = any(fnmatchcase(case.title, pattern) for pattern in expected_failures)
    difference = None
    try:
        difference = first_difference(case, port(case))
        status = FAILED if difference else PASSED
    except NotOfferedError:
        status = NOT_OFFERED
    except NoPortError:
        raise
    except CaseError as error:
        difference, status = Difference(str(error)), FAILED
    except (Exception, SystemExit) as error:  # a port's message may hold any characters
        message = f"{type(error).__name__}: {error}".encode(errors="backslashreplace").decode()
        difference, status = Difference(message), FAILED
    if expected:
        status = {FAILED: EXPECTED, PASSED: UNEXPECTED}.get(status, status)
    return Outcome(case.stage, case.name, case.section, status, difference)


def first_difference(case: Case, found: dict) -> Difference | None:
    """The first output, by name, that differs from the expected one."""
    for name, expected in case.expected.items():
        if name not in found:
            return Difference(f"{name} is missing", name)
        difference = _difference(name, np.asarray(found[name]), expected, case.tolerances.get(name))
        if difference:
            return difference
    return None


def _difference(name, found, expected, tolerance):
    if found.shape != expected.shape:
        return Difference(f"{name} has shape {found.shape}; it must be {expected.shape}", name)
    if found.dtype != expected.dtype:
        return Difference(f"{name} is {found.dtype}; it must be {expected.dtype}", name)
    if tolerance is None:
        differs = found != expected
    else:
        differs = ~np.isclose(found, expected, rtol=tolerance, atol=0)
    if not differs.any():
        return None
    index = tuple(int(axis[0]) for axis in np.nonzero(np.atleast_1d(differs)))
    values = [np.atleast_1d(array)[index].item() for array in (found, expected)]
    finite = [value if math.isfinite(value) else None for value in values]
    place = f"[{', '.join(map(str, index))}]" if expected.ndim else ""
    message = "{}{} is {}; it must be {} ({} of {} differ)".format(
        name, place, *values, int(differs.sum()), expected.size
    )
    return Difference(message, name, list(index), *finite)
