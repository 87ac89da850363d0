"""The tables of chapters 4 and 5: the published numbers beside ours."""

import numpy as np
import pandas as pd

from eval import similarity
from eval.documents.dzurenko.printed import (
    EPSILON,
    EPSILONS,
    LAMBDA,
    SHARED_MEMORY,
    UNIFORMITIES,
)
from eval.metrics import NUMBERS
from eval.number import Number
from eval.pages.tables import with_spread
from eval.runs.store import numbers_of, stored
from eval.similarity import flip, psnr, ssim

MEASURES = {
    name: NUMBERS[name]
    for name in (
        "guides", "style", "penalization", "image_energy", "coverage", "entropy", "peak",
        "sharpness", "richness", "patches", "spilled",
    )
}  # fmt: skip
"""Each number of :func:`quality_table`."""


def seconds_of(job):
    """The time of a run: of the processor, all threads together; of a GPU by the clock.

    Parameters
    ----------
    job : Job
        It must be stored.

    Returns
    -------
    float
    """
    return stored(job).processor_seconds


def lambda_times(plan, target):
    """Tables of figures 4.1 to 4.7: times and ratios as λ grows.

    Parameters
    ----------
    plan : Plan
    target : str

    Returns
    -------
    pandas.DataFrame
        A row for StyLit and for each λ.
    """
    stylit = seconds_of(plan.stylit(target))
    rows = [("StyLit", stylit, None, "StyLit")]
    for uniformity in UNIFORMITIES:
        seconds = seconds_of(plan.ref(target, uniformity))
        rows.append((f"λ = {uniformity}", seconds, uniformity, f"propose_commit, λ = {uniformity}"))
    printed = LAMBDA[LAMBDA["target"] == target]
    table = []
    for name, seconds, uniformity, setting in rows:
        of_row = printed["lambda"].isna() if uniformity is None else printed["lambda"] == uniformity
        table.append(
            {
                "method": name,
                **_published(printed[of_row], {"stylit_over_time": "StyLit/time"}),
                "ours [s]": seconds,
                "ours StyLit/time": stylit / seconds,
                **_on_gpu(plan, target, setting, {"StyLit": stylit}),
            }
        )
    return pd.DataFrame(table)


def epsilon_times(plan, target):
    """Tables of figures 5.2 to 5.8: times and ratios as ε grows; parameters as above."""
    stylit, ref = seconds_of(plan.stylit(target)), seconds_of(plan.ref(target))
    rows = [("StyLit", stylit, "stylit", None, "StyLit")]
    rows.append(("ref, λ = 10000", ref, "ref", None, "propose_commit, λ = 10000"))
    for epsilon in EPSILONS:
        seconds = seconds_of(plan.guide_map(target, epsilon))
        setting = f"guide_map, ε = {epsilon}"
        rows.append((f"ε = {epsilon}", seconds, "guide_map", epsilon, setting))
    printed = EPSILON[EPSILON["target"] == target]
    table = []
    for name, seconds, method, epsilon, setting in rows:
        of_row = printed["method"] == method
        if epsilon is not None:
            of_row &= printed["epsilon"] == epsilon
        ratios = {"ref_over_time": "ref/time", "stylit_over_time": "StyLit/time"}
        table.append(
            {
                "method": name,
                **_published(printed[of_row], ratios),
                "ours [s]": seconds,
                "ours ref/time": ref / seconds,
                "ours StyLit/time": stylit / seconds,
                **_on_gpu(plan, target, setting, {"ref": ref, "StyLit": stylit}),
            }
        )
    return pd.DataFrame(table)


def shared_memory(plan):
    """Table of 5.1.3: every target, with and without shared memory; our numbers need a GPU."""
    table = []
    for target in plan.scenes:
        printed = SHARED_MEMORY[SHARED_MEMORY["target"] == target]
        row = {"target": target}
        if len(printed):
            names = {
                "shared_memory_s": "published shared [s]",
                "ref_s": "published ref [s]",
                "ref_over_shared": "published ref/shared",
                "stylit_over_shared": "published StyLit/shared",
            }
            row |= {title: printed[name].iloc[0] for name, title in names.items()}
        for device, record in plan.gpu_records(target).items():
            kinds = "shared memory", "propose_commit"
            shared, ref = (record["seconds"].get(f"{kind}, λ = 10000") for kind in kinds)
            if shared and ref:
                row |= {f"{device} shared [s]": shared, f"{device} ref/shared": ref / shared}
        table.append(row)
    return pd.DataFrame(table)


def quality_table(plan, target):
    """Every measure of every run on a target: mean over seeds, and spread where there are more.

    Returns
    -------
    pandas.DataFrame
        For each method a row with the mean and the sample standard deviation (``±``) of
        :data:`MEASURES`.
    """
    seeds = plan.seeds[target]
    methods = {"StyLit": [plan.stylit(target, seed) for seed in seeds]}
    for uniformity in UNIFORMITIES:
        methods[f"λ = {uniformity}"] = [plan.ref(target, uniformity, seed) for seed in seeds]
    for epsilon in EPSILONS:
        methods[f"ε = {epsilon}"] = [plan.guide_map(target, epsilon, seed) for seed in seeds]
    return pd.DataFrame(
        [{"method": name, **with_spread(map(_measures, jobs))} for name, jobs in methods.items()]
    )


def _measures(job):
    found = numbers_of(job)
    return {name: found[name] for name in MEASURES if name in found}


def similarity_table(plan, target):
    """How far the images are from ``ref`` with the same seed, and from StyLit.

    Returns
    -------
    pandas.DataFrame
        A row for each ε and λ, and for another seed of ``ref`` where there is one; means over
        seeds.
    """
    seeds = plan.seeds[target]
    methods = {
        f"ε = {epsilon}": [(plan.guide_map(target, epsilon, seed), seed) for seed in seeds]
        for epsilon in EPSILONS
    }
    methods |= {
        f"λ = {uniformity}": [(plan.ref(target, uniformity, seed), seed) for seed in seeds]
        for uniformity in UNIFORMITIES
    }
    if len(seeds) > 1:
        others = (*seeds[1:], seeds[0])
        methods["λ = 10000, another seed"] = [
            (plan.ref(target, seed=other), seed) for seed, other in zip(seeds, others, strict=True)
        ]
    table = []
    for name, jobs in methods.items():
        rows = []
        for job, seed in jobs:
            result = stored(job)
            ref, stylit = stored(plan.ref(target, seed=seed)), stored(plan.stylit(target, seed))
            rows.append(
                {
                    "white": result.guide_map.mean() if name.startswith("ε") else np.nan,
                    "PSNR": psnr(result.image, ref.image),
                    "SSIM": ssim(result.image, ref.image),
                    "FLIP": flip(result.image, ref.image),
                    "FLIP to StyLit": flip(result.image, stylit.image),
                }
            )
        table.append({"method": name, **with_spread(rows)})
    return pd.DataFrame(table)


SIMILARITIES = {
    "white": Number("white", "{:.1%}"),
    **similarity.NUMBERS,
    "FLIP to StyLit": Number("FLIP to StyLit", "{:.3f}"),
}
"""Each number of :func:`similarity_table`."""

SIMILARITY_DEFINITIONS = f"""\
- **white**: share of the finest level's target patches whose guides vary by less than ε (5.2).
{similarity.DEFINITION}: against the image of `ref` at λ = 10000 with the same seed."""


def formatted_times(table):
    """Text of a table of times and ratios; published numbers look as they are printed."""
    text = table.copy().astype(object)
    for name in table:
        digits = 6 if name.startswith(("published", "printed", "table")) else 4
        text[name] = [
            "" if pd.isna(value) else f"{value:.{digits}g}" if isinstance(value, float) else value
            for value in table[name]
        ]
    return text


def _published(row, ratios):
    if row.empty:
        return {}
    entry = {"published [s]": row["time_s"].iloc[0]}
    return entry | {f"published {title}": row[name].iloc[0] for name, title in ratios.items()}


def _on_gpu(plan, target, setting, baselines):
    entry = {}
    for device, record in plan.gpu_records(target).items():
        seconds = record["seconds"]
        if setting in seconds:
            entry[f"{device} [s]"] = seconds[setting]
            for name, baseline in baselines.items():
                entry[f"{name} on the CPU/{device}"] = baseline / seconds[setting]
    return entry
