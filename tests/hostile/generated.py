"""Generated cases: how many of each property, always the same ones, and how many there were."""

import functools
from collections import Counter

from hypothesis import HealthCheck, given, settings

CASES = Counter()
"""Cases that ran, by property."""


def generated(cases, **strategies):
    """Run a test on so many generated cases, the same in every run."""

    def decorate(test):
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
