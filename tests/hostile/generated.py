"""Generated cases: how many of each property, always the same ones."""

import functools

from hostile.count import CASES
from hypothesis import HealthCheck, given, settings


def generated(cases, **strategies):
    """Run a test on so many generated cases, the same in every run."""

    def decorate(test):
        CASES[test.__name__] = 0

        @functools.wraps(test)
        def counted(*fixtures, **case):
            CASES[test.__name__] += 1
            test(*fixtures, **case)

        fixed = settings(
            max_examples=cases,
            derandomize=True,
            database=None,
            deadline=None,
            suppress_health_check=list(HealthCheck),
        )
        return fixed(given(**strategies)(counted))

    return decorate
