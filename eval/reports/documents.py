"""Make the reports on all four publications, and a page that leads to them."""

import argparse
import csv
import sys
import time
from importlib import import_module
from typing import NamedTuple

import pandas as pd

from eval.pages.claims import HELD, NOT_HELD, OPEN
from eval.pages.document import make_documents
from eval.pages.page import BUILT, new_report
from eval.pages.tables import table
from eval.provenance import provenance
from stylit_ref import InputError

FRONT = BUILT / "documents"


class Part(NamedTuple):
    """A report, and how it is made here.

    Attributes
    ----------
    title, subject : str
    folder : str
        Its name in :data:`eval.pages.page.BUILT`.
    options : tuple of str
        What is told to it; its presets are small by default.
    """

    title: str
    subject: str
    folder: str
    options: tuple[str, ...] = ()


TARGETS = "golem,teapot"
"""Two of the seven, which give the verdicts of all: the others would take five minutes more."""

PARTS = {
    "dzurenko": Part(
        "Dzurenko 2017",
        "stylization on the GPU",
        f"quick_{TARGETS.replace(',', '_')}",
        ("--targets", TARGETS, "--seeds", "0"),
    ),
    "lasram": Part("Lasram and Lefebvre 2012", "texture synthesis", "lasram_quick"),
    "heidrich": Part("Heidrich 2017", "stylization in real time", "heidrich_quick"),
    "hauptfleisch": Part("Hauptfleisch 2020", "views and animations", "hauptfleisch_quick"),
}
"""By the name of the command."""


def add_options(parser):
    """Declare nothing: whoever wants something else makes one of the reports alone."""


def main(options):
    """Make the reports; returns the exit code: 1 if a run of one failed.

    A report that cannot be made, since something is not there, is named, and the others are made.
    """
    begun = time.perf_counter()
    documents, missing = {}, {}
    for name, part in PARTS.items():
        module = import_module(f"eval.documents.{name}.report")
        parser = argparse.ArgumentParser()
        module.add_options(parser)
        try:
            documents |= module.prepared(parser.parse_args(part.options))
        except (InputError, OSError) as error:
            print(f"eval: {name} is left out: {error}", file=sys.stderr)
            missing[name] = str(error)
    code = make_documents(documents)
    with new_report(FRONT) as report:
        page = _sections(missing, time.perf_counter() - begun)
        report.page("Four publications, and what we found", page)
    print(f"Written: {FRONT / 'report.html'}")
    return code


def _sections(missing, seconds):
    rows = [_row(name, part, missing) for name, part in PARTS.items()]
    yield (
        "Every table and figure of four publications is made again by this implementation, and "
        "every claim gets a verdict, with the rule by which it was judged."
    )
    yield table(pd.DataFrame(rows))
    for name, reason in missing.items():
        yield f"{PARTS[name].title} is left out: {reason}."
    time_taken = f"{seconds / 60:.0f} minutes" if seconds >= 60 else f"{seconds:.0f} seconds"
    yield (
        f"The command took {time_taken}; runs that were kept from an earlier one took none of it. "
        f"This page was written by {provenance()}."
    )


def _row(name, part, missing):
    """A report's line of the table."""
    folder = BUILT / part.folder
    try:
        with open(folder / "claims.csv", encoding="utf-8", newline="") as file:
            verdicts = [claim["verdict"] for claim in csv.DictReader(file)]
    except OSError:
        verdicts = None
    if name in missing or verdicts is None:
        cells = dict.fromkeys((HELD, NOT_HELD, OPEN), "")
        return {"publication": part.title, "subject": part.subject} | cells
    return {
        "publication": f"[{part.title}](../{part.folder}/report.html)",
        "subject": part.subject,
        **{each: str(verdicts.count(each)) for each in (HELD, NOT_HELD, OPEN)},
    }
