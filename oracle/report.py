"""Report the outcomes: as text for people, as JSON for programs."""

import json
from collections import Counter
from collections.abc import Iterable
from itertools import groupby
from operator import attrgetter

from oracle.compare import FAILED, NOT_OFFERED, STATUSES, UNEXPECTED, Outcome
from oracle.families import spec_of
from oracle.ports import EXIT_NOT_OFFERED
from oracle.progress import say
from stylit_ref import __version__
from stylit_ref.files.disk.whole_file import write_text

HOW_TO_DECLINE = (
    f"If the port does not do these stages yet, let it end with exit code {EXIT_NOT_OFFERED}, or "
    "let run_case raise NotImplementedError."
)


def tell_failures(outcomes: Iterable[Outcome]) -> list[Outcome]:
    """Print which cases fail and how, stage by stage.

    If all cases of some stages fail without any output and with the same message, one line serves
    them all: the port probably does not know these stages yet.

    Parameters
    ----------
    outcomes : iterable of Outcome

    Returns
    -------
    list of Outcome
        The same.
    """
    told, alike = [], {}
    for _, group in groupby(outcomes, key=attrgetter("stage")):
        stage = list(group)
        told += stage
        words = {_words_without_output(outcome) for outcome in stage}
        if len(words) == 1 and None not in words:
            alike.setdefault(words.pop(), []).extend(stage)
            continue
        for outcome in stage:
            if outcome.status in (FAILED, UNEXPECTED):
                say(_line(outcome))
    for failures in alike.values():
        say(_line(failures[0]) + _others(failures))
    if any(len(_stages(failures)) > 1 for failures in alike.values()):
        say(HOW_TO_DECLINE)
    return told


def _words_without_output(outcome):
    """The message of a case that failed without any output, otherwise None."""
    if outcome.status != FAILED or outcome.difference.array is not None:
        return None
    return outcome.difference.message.replace(outcome.stage, "STAGE")


def _line(outcome):
    message = f": {outcome.difference.message}" if outcome.difference else ""
    return f"{outcome.title}: {outcome.status}{message}"


def _others(failures):
    if len(failures) == 1:
        return ""
    return f" (so do all {len(failures)} cases of {', '.join(_stages(failures))})"


def _stages(outcomes):
    return list(dict.fromkeys(outcome.stage for outcome in outcomes))


def summary(version: str, outcomes: list[Outcome]) -> str:
    """How many cases passed, which stages the port does not offer, and which one to mend first."""
    counts = Counter(outcome.status for outcome in outcomes)
    lines = [", ".join(f"{counts[status]} {status}" for status in STATUSES if counts[status])]
    left_out = _stages(outcome for outcome in outcomes if outcome.status == NOT_OFFERED)
    if left_out:
        lines.append(f"Not offered: {', '.join(left_out)}.")
    failed = next((outcome for outcome in outcomes if outcome.status == FAILED), None)
    if failed:
        spec = spec_of(version)
        lines.append(f"Begin with stage {failed.stage}: section {failed.section} of {spec}.")
    return "\n".join(lines)


def write_report(file: str, version: str, code: int, outcomes: list[Outcome]) -> None:
    """Write the outcome of every case as JSON.

    Raises
    ------
    InputError
        If the file cannot be written.
    """
    report = {
        "stylit-ref": __version__,
        "cases": version,
        "exit_code": code,
        "counts": Counter(outcome.status for outcome in outcomes),
        "outcomes": [
            outcome._asdict()
            | {"difference": outcome.difference._asdict() if outcome.difference else None}
            for outcome in outcomes
        ],
    }
    write_text(file, json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False) + "\n")
