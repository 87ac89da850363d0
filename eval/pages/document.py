"""Make the report on a publication: do its runs, then write its page."""

import hashlib
import json
import sys
import time
from collections.abc import Callable
from typing import NamedTuple

from eval.pages.page import Report, is_up_to_date, new_report
from eval.pages.web_page import SCRIPT, STYLE
from eval.provenance import provenance
from eval.runs.complete import Task, complete
from eval.runs.store import numbers_of, run_file, stored


class Document(NamedTuple):
    """A report on a publication.

    Attributes
    ----------
    title : str
    tasks : list of Task
        Its runs, and what to measure of them.
    sections : callable
        Called with the :class:`eval.pages.page.Report` when all runs are stored; gives the page's
        Markdown blocks.
    inputs : list
        What the page is made of besides its runs, as JSON knows it: the digest of its code, and of
        files that it shows. While nothing of it changes, the page is not written again.
    """

    title: str
    tasks: list[Task]
    sections: Callable[[Report], list[str]]
    inputs: list


def make_document(document, folder, scheduler=None):
    """Do the runs that are not stored yet, and write the page.

    Parameters
    ----------
    document : Document
    folder : Path
    scheduler : str, optional
        Address of the Dask scheduler whose cluster does the runs.

    Returns
    -------
    int
        The exit code: 1 if a run failed. Each that failed is named, the others are kept.
    """
    begun = time.perf_counter()
    if _is_up_to_date(document, folder):
        print(f"eval: {folder} is up to date", file=sys.stderr)
    elif failures := complete(document.tasks, scheduler):
        for title, reason in failures.items():
            print(f"eval: failed: {title}: {reason}", file=sys.stderr)
        count = f"{len(failures)} of {len(document.tasks)} runs failed"
        print(f"eval: no report: {count}; the others are kept", file=sys.stderr)
        return 1
    else:
        with new_report(folder, _digest(document), begun) as report:
            report.page(document.title, document.sections(report))
    print(f"Written: {folder / 'report.html'}")
    return 0


def _is_up_to_date(document, folder):
    """Whether the report is there, and its runs; what is in their files is not read again."""
    are_stored = all(run_file(task.job).exists() for task in document.tasks)
    return are_stored and is_up_to_date(folder, _digest(document))


def made_on(tasks):
    """A section on the machines, versions and commits of some runs, and those of the report."""
    made = sorted({stored(task.job).made for task in tasks})
    return [
        "## Made on",
        "The runs were done by:",
        "\n".join(f"- {line}" for line in made),
        f"The report was written by {provenance()}.",
    ]


def _digest(document):
    """Identifies everything that a report is made of."""
    runs = [(task.job.key, sorted(numbers_of(task.job).items())) for task in document.tasks]
    content = json.dumps([document.title, runs, document.inputs, STYLE, SCRIPT])
    return hashlib.sha256(content.encode()).hexdigest()
