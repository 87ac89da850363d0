"""What a port gives beside what it must give: the first array, element and value that differ."""

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
    """A port does not do a stage."""


class NoPortError(InputError):
    """A port cannot be used, whatever the case."""


class Difference(NamedTuple):
    """What is wrong with a port's output.

    Attributes
    ----------
    message : str
    array : str or None
        The output concerned; None where the port failed before there was any.
    index : list of int or None
        The first element that differs.
    found, expected : int, float, bool or None
        None also for what is no finite number: JSON has none, the message says it.
    """

    message: str
    array: str | None = None
    index: list[int] | None = None
    found: int | float | bool | None = None
    expected: int | float | bool | None = None


class Outcome(NamedTuple):
    """What became of a case.

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
        Titles of cases that must fail, ``*`` standing for anything.
    case : Case

    Returns
    -------
    Outcome

    Raises
    ------
    NoPortError
        If the port cannot be used at all. Whatever else it raises is a failure of this case.
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
    except (Exception, SystemExit) as error:  # a module's own may say anything
        message = f"{type(error).__name__}: {error}".encode(errors="backslashreplace").decode()
        difference, status = Difference(message), FAILED
    if expected:
        status = {FAILED: EXPECTED, PASSED: UNEXPECTED}.get(status, status)
    return Outcome(case.stage, case.name, case.section, status, difference)


def first_difference(case: Case, found: dict) -> Difference | None:
    """The first output that is not what it must be, in the order of their names."""
    for name, expected in case.expected.items():
        if name not in found:
            return Difference(f"{name} is not there", name)
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
