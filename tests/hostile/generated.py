"""Generate test cases: a fixed number for each property, the same in every run."""

from hypothesis import HealthCheck, given, settings


def generated(cases, **strategies):
    """Run a test on this number of generated cases, the same in every run."""
    fixed = settings(
        max_examples=cases,
        derandomize=True,
        database=None,
        deadline=None,
        suppress_health_check=list(HealthCheck),
    )
    return lambda test: fixed(given(**strategies)(test))
