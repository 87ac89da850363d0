"""Make reports on publications: do their runs, then write their pages."""

import hashlib
import json
import sys
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from eval.pages.page import Report, is_up_to_date, new_report
from eval.pages.web_page import SCRIPT, STYLE
from eval.provenance import provenance
from eval.runs.complete import Task, complete
from eval.runs.side_by_side import do_all
from eval.runs.store import numbers_of, run_file, stored
from stylit_ref import InputError


class Document(NamedTuple):
    """A report on a publication.

    Attributes
    ----------
    title : str
    tasks : list of Task
        Its runs, and what to measure of them.
    sections : callable
        Called with the :class:`eval.pages.page.Report` when all runs are stored; gives the page's
        Markdown blocks. It may be called in another process, while other pages are written, and
        so it measures no times.
    inputs : list
        What the page is made of besides its runs, as JSON knows it: the digest of its code, and of
        files that it shows. While nothing of it changes, the page is not written again.
    """

    title: str
    tasks: list[Task]
    sections: Callable[[Report], list[str]]
    inputs: list


def make_documents(documents, scheduler=None):
    """Do the runs that are not stored yet, those of all reports together, and write the pages.

    Parameters
    ----------
    documents : dict of Path to Document
        By the folder of the report.
    scheduler : str, optional
        Address of the Dask scheduler whose cluster does the runs.

    Returns
    -------
    int
        The exit code: 2 if a page could not be written, or 1 if a run failed. Each is named, and
        all the others are kept.

    Raises
    ------
    Exception
        That which a page ended with by a fault of ours.
    """
    old = [folder for folder, document in documents.items() if not _is_up_to_date(document, folder)]
    failures = complete([task for folder in old for task in documents[folder].tasks], scheduler)
    reasons, pages = {}, {}
    for folder in old:
        document = documents[folder]
        if failed := sum(task.job.key in failures for task in document.tasks):
            reasons[folder] = f"{failed} of {len(document.tasks)} runs failed; the others are kept"
        else:
            pages[folder] = partial(_write, document, folder)
    errors = do_all(pages)
    reasons |= errors
    for failure in failures.values():
        print(f"eval: failed: {failure}", file=sys.stderr)
    for folder in documents:
        page = folder / "report.html"
        if folder in reasons:
            print(f"eval: {page} is not written: {reasons[folder]}", file=sys.stderr)
        elif folder not in old:
            print(f"eval: {page} is up to date", file=sys.stderr)
    for error in errors.values():
        if not isinstance(error, InputError | OSError):
            raise error
    return 2 if errors else int(bool(failures))


def _write(document, folder):
    """Write the page; all runs are stored."""
    with new_report(folder, _digest(document)) as report:
        report.page(document.title, document.sections(report))
    print(f"Written: {folder / 'report.html'}", flush=True)


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
