"""The numbers of a run that most reports show."""

from eval.runs.local import numbers, run

METRICS = ("energy", "image_energy", "usage", "sharpness")

COLUMNS = (
    "delta", "penalization", "phi", "image_energy", "distinct", "distinct_in_image", "coverage",
    "peak", "sharpness", "richness",
)  # fmt: skip


def row(job):
    """Do a run and measure it.

    Parameters
    ----------
    job : Job

    Returns
    -------
    dict of str to float
        ``seconds`` of the processor, and the :data:`COLUMNS` that apply.
    """
    found = numbers(job, METRICS)
    seconds = run(job).processor_seconds
    return {"seconds": seconds} | {name: found[name] for name in COLUMNS if name in found}
