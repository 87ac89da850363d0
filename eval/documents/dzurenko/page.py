"""The page of the report on chapters 4 and 5: every table and figure."""

import hashlib
from functools import partial
from pathlib import Path

import pandas as pd
from tqdm import tqdm

from eval.documents.dzurenko import pictures, printed, tables
from eval.documents.dzurenko.claims import claims
from eval.documents.dzurenko.plan import ROUNDS
from eval.metrics import definitions
from eval.pages.claims import claims_section, verdict_section
from eval.pages.document import Document, made_on
from eval.pages.tables import formatted_with_spread
from eval.runs.store import stored
from stylit_ref.machine.code_digest import code_digest


def document(plan):
    """The report on a plan.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    Document
    """
    title = f"Chapters 4 and 5 of the thesis, preset {plan.name}"
    inputs = [_CODE, _digest_of_files(), [plan.gpu_records(target) for target in plan.scenes]]
    return Document(title, plan.tasks, partial(_sections, plan), inputs)


def _sections(plan, report):
    similarities = {target: tables.similarity_table(plan, target) for target in plan.scenes}
    found = claims(plan, similarities)
    sections = [
        _preface(plan),
        *verdict_section(found),
        *_pictures(plan, report),
        *claims_section("What the thesis says, and what we found", found, report),
        *_errata(report),
    ]
    for target in tqdm(plan.scenes, unit="target", disable=None):
        sections += _target(plan, target, similarities[target], report)
    return [
        *sections,
        *_overall(plan, report),
        "## What the numbers are",
        definitions(tables.MEASURES),
        tables.SIMILARITY_DEFINITIONS,
        *made_on(plan.tasks),
    ]


def _pictures(plan, report):
    target = plan.background

    def image(job):
        return stored(job).image

    def figure(name, caption, draw):
        return report.figure(name, caption, draw, plan, committed=True)

    return [
        "## Pictures",
        f"λ decides how evenly the patches of the painting are used. On {target}, without it "
        "(left) the style washes out:",
        report.pair(
            "washed_out",
            ("λ = 0", image(plan.ref(target, 0))),
            ("λ = 10000", image(plan.ref(target))),
        ),
        "Guide maps settle pixels early, as their guides say. What they change at ε = 10000, where "
        "they are coarsest:",
        report.pair(
            "guide_maps",
            ("ref", image(plan.ref(target))),
            ("guide maps, ε = 10000", image(plan.guide_map(target, 10000))),
        ),
        "The same painting carried over by other methods (1.1). (d) is Hertzmann et al. 2001 with "
        "the first guide alone, as in the thesis; (g) is StyLit with every patch of the style used "
        "alike, in the manner of Jamriška et al. 2015.",
        figure("background", f"Methods compared on {target}", pictures.background_figure),
        "The picture is made from coarse to fine (2.3).",
        figure("pyramid", f"{target} as it leaves each level", pictures.pyramid_figure),
    ]


def _preface(plan):
    scene = plan.scenes[plan.background]
    seeds = ", ".join(
        f"{target} {' '.join(map(str, seeds))}" for target, seeds in plan.seeds.items()
    )
    return (
        f"Our scenes at {scene.size}, the thesis' configuration (4.1): patch width 5, 6 levels "
        "(fewer where the image is too small), 6 votes, 6 PatchMatch iterations, μ = 2; λ = 10000 "
        f"where none is said. Seeds: {seeds}; times are of the first. Published times are of a "
        "GeForce GTX 660, StyLit's of four threads of a CPU, at 1200x912: compare ratios, not "
        "seconds. Ours are seconds of the processor, all threads together, kernels compiled "
        f"before; the least of {ROUNDS} runs, but for StyLit, which is run once. The machines "
        "are named at the end of the page."
    )


def _errata(report):
    errata = printed.errata()
    return [
        "## Errata",
        "Rows of the published tables whose ratio does not follow from their times, rounding "
        "allowed for:",
        report.table("errata", errata, tables.formatted_times(errata)),
    ]


def _target(plan, target, similarity, report):
    lambda_times, epsilon_times = (
        make(plan, target) for make in (tables.lambda_times, tables.epsilon_times)
    )
    quality = tables.quality_table(plan, target)
    known = target in printed.TARGETS
    figures = [
        f" ({printed.figure(numbers, target)})" if known else ""
        for numbers in (printed.LAMBDA, printed.EPSILON)
    ]

    def figure(name, symbol, draw):
        caption, alone = f"Every {symbol} on {target}", target == plan.background
        return report.figure(f"{name}_{target}", caption, draw, plan, target, committed=alone)

    return [
        f"## {target}",
        f"### λ{figures[0]}",
        figure("lambda", "λ", pictures.lambda_figure),
        report.table(f"lambda_times_{target}", lambda_times, tables.formatted_times(lambda_times)),
        f"### ε{figures[1]}",
        figure("epsilon", "ε", pictures.epsilon_figure),
        report.table(
            f"epsilon_times_{target}", epsilon_times, tables.formatted_times(epsilon_times)
        ),
        report.table(
            f"similarity_{target}",
            similarity,
            formatted_with_spread(similarity, tables.SIMILARITIES),
        ),
        f"### Quality on {target}",
        report.table(f"quality_{target}", quality, formatted_with_spread(quality, tables.MEASURES)),
    ]


def _overall(plan, report):
    def figure(name, caption, draw):
        return report.figure(name, caption, draw, plan, committed=True)

    shared = tables.shared_memory(plan)
    sections = [
        "## All targets",
        "### Time and quality",
        figure("trends", "time and quality against λ and ε", pictures.trends_figure),
        "### Energy",
        figure("energy", "mean φ by iteration", pictures.energy_figure),
        "### Shared memory (5.1.3)",
        report.table("shared_memory", shared, tables.formatted_times(shared)),
    ]
    if not any(plan.gpu_records(target) for target in plan.scenes):
        ptx = pd.read_csv(CHECKOUT / "reports" / "ptx" / "ptx.csv")
        ptx = ptx[ptx["kernel"].str.match(r"(propagation|random_search)(, shared)?$")]
        sections += [
            "No GPU was at hand, so there are no times of ours. What is known without one: in "
            "Numba's simulator both kernels give the same bytes, and the assembler says of them:",
            report.table("shared_memory_ptx", ptx, ptx),
        ]
    return sections


CHECKOUT = Path(__file__).parents[3]

_CODE = code_digest(__file__)


def _digest_of_files():
    """Identifies the files that the page shows."""
    digest = hashlib.sha256()
    published = Path(__file__).parent.glob("published/*.csv")
    for file in sorted([*published, *(CHECKOUT / "reports" / "ptx").glob("*.csv")]):
        digest.update(file.read_bytes())
    return digest.hexdigest()
