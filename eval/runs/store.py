"""Store results of runs, and their numbers, in files."""

import io
import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
import pandas as pd

from eval.metrics import CODES, METRICS
from eval.outcome import Outcome
from eval.provenance import provenance
from stylit_ref.files.disk.whole_file import whole_file, write_text

RUNS = Path("build/runs")
MEASURES = Path("build/measures")


@dataclass(frozen=True, kw_only=True)
class Run(Outcome):
    """A stored outcome.

    Attributes
    ----------
    key : str
        Key of its job, whatever the name of its file.
    made : str
        The machine, versions and commit that made it.
    """

    key: str
    made: str


def run_file(job):
    """The file of the result of a job."""
    return RUNS / f"{job.file_name}.npz"


def encoded(job, outcome):
    """The result of a job as bytes, for :func:`store`."""
    arrays = {"image": outcome.image}
    for name in ("nnf", "omega", "guide_map", "coordinates"):
        if getattr(outcome, name) is not None:
            arrays[name] = getattr(outcome, name)
    arrays |= {f"level_{number}": image for number, image in enumerate(outcome.levels, 1)}
    facts = {
        "key": job.key,
        "made": provenance(),
        "seconds": outcome.seconds,
        "stages": outcome.stages,
        "history": outcome.history.to_dict("records"),
    }
    file = io.BytesIO()
    np.savez_compressed(file, facts=json.dumps(facts), **arrays)
    return file.getvalue()


def store(job, result):
    """Write a result to its file; a failure leaves no partial file."""
    RUNS.mkdir(parents=True, exist_ok=True)
    with whole_file(run_file(job), len(result)) as partial:
        partial.write_bytes(result)


def stored(job):
    """The :class:`Run` of a job, or None if no readable one is stored."""
    file = run_file(job)
    try:
        run = _read(file, file.stat().st_mtime_ns)
    except OSError:
        return None
    return run if run and run.key == job.key else None


@lru_cache(maxsize=64)
def _read(file, _):
    """Read a result; cached, since a report asks for the same results many times."""
    return read(file)


def read(file):
    """The :class:`Run` in a file, or None if the file cannot be read.

    Parameters
    ----------
    file : Path or file object
    """
    try:
        with np.load(file) as file:
            facts = json.loads(str(file["facts"]))
            count = sum(name.startswith("level_") for name in file.files)
            return Run(
                image=file["image"],
                seconds=facts["seconds"],
                nnf=file.get("nnf"),
                omega=file.get("omega"),
                guide_map=file.get("guide_map"),
                levels=tuple(file[f"level_{number}"] for number in range(1, count + 1)),
                stages=facts["stages"],
                history=pd.DataFrame(facts["history"]),
                coordinates=file.get("coordinates"),
                key=facts["key"],
                made=facts["made"],
            )
    except Exception:  # a broken header can make NumPy's parser raise anything
        return None


def measure(job, outcome, metrics=tuple(METRICS)):
    """Measure an outcome; stored numbers are read instead.

    Parameters
    ----------
    job : Job
    outcome : Outcome
    metrics : sequence of str
        Names of :data:`eval.metrics.METRICS`.

    Returns
    -------
    dict of str to dict of str to float
        The numbers of each metric, for :func:`store_numbers`.
    """
    found = stored_numbers(job)
    return {
        name: found[name] if name in found else METRICS[name].measure(job.scene, outcome)
        for name in metrics
    }


def stored_numbers(job):
    """The stored numbers of a job that today's code would measure again.

    Returns
    -------
    dict of str to dict of str to float
        By metric.
    """
    try:
        record = json.loads(_numbers_file(job).read_text(encoding="utf-8"))
        if record["run"] != job.key:
            return {}
        return {
            name: dict(entry["numbers"])
            for name, entry in record["metrics"].items()
            if entry["code"] == _identity(job, name)
        }
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return {}


def store_numbers(job, numbers):
    """Add the numbers of a run to its stored ones."""
    MEASURES.mkdir(parents=True, exist_ok=True)
    metrics = {
        name: {"code": _identity(job, name), "numbers": values}
        for name, values in (stored_numbers(job) | numbers).items()
    }
    write_text(_numbers_file(job), json.dumps({"run": job.key, "metrics": metrics}, indent=1))


def numbers_of(job):
    """All stored numbers of a job, by name."""
    return {
        name: value for numbers in stored_numbers(job).values() for name, value in numbers.items()
    }


def _identity(job, name):
    """Identifies what the numbers of a metric depend on besides the run."""
    return f"{CODES.get(name)} {job.scene.digest_of_ids[:8]}"


def _numbers_file(job):
    return MEASURES / f"{job.file_name}.json"
