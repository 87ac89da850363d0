"""Chapters 4 and 5 again: do the runs, then write the report."""

import sys

from eval.report import BUILT
from eval.scheduling import complete
from eval.thesis.page import write_page


def evaluate(plan, folder=None):
    """Run what is not stored yet and write the report.

    Parameters
    ----------
    plan : Plan
    folder : Path, optional
        ``build/reports/<name of the plan>`` by default.

    Returns
    -------
    Path or None
        Folder of the report; None if a run failed, which is said on stderr.
    """
    folder = folder or BUILT / plan.name
    failures = complete(plan.jobs, plan.scheduler)
    for title, reason in failures.items():
        print(f"eval: failed: {title}: {reason}", file=sys.stderr)
    if failures:
        count = len(plan.jobs) - len(failures)
        print(f"eval: {count} runs are kept; no report without the others", file=sys.stderr)
        return None
    if not write_page(plan, folder):
        print(f"eval: {folder} is up to date", file=sys.stderr)
    return folder
