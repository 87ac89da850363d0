"""The page of the report on the thesis: every table and figure of chapter 6, and the claims."""

from functools import partial
from pathlib import Path

from eval.documents.heidrich import pictures, tables
from eval.documents.heidrich.claims import claims
from eval.documents.heidrich.hand_times import WAITED
from eval.documents.heidrich.requirements import DEFINITION, requirements
from eval.documents.heidrich.stage import GUIDES, STYLES
from eval.metrics import definitions
from eval.pages.claims import claims_section, verdict_section
from eval.pages.document import Document, made_on
from eval.runs.store import stored
from stylit_ref.machine.code_digest import code_digest

_CODE = code_digest(__file__)


def document(plan):
    """The report on a plan.

    Parameters
    ----------
    plan : Plan

    Returns
    -------
    Document
    """
    title = f"Heidrich 2017, preset {plan.name}"
    return Document(title, plan.tasks, partial(_sections, plan), [_CODE])


def _sections(plan, report):
    required = requirements(plan)
    found = claims(plan, required)
    return [
        _preface(plan),
        *verdict_section(found),
        *_pictures(plan, report),
        *_figures(plan, report),
        *claims_section("What the thesis says, and what we found", found, report),
        *_requirements(required, report),
        *_times(plan, report),
        *_quality(plan, report),
        *_large(plan, report),
        *_choices(plan, report),
        *(block for aside in plan.asides for block in aside.sections(report)),
        Path(__file__).with_name("left_open.md").read_text("utf-8"),
        "## What the numbers are",
        definitions((*tables.SHOWN, "background")),
        *made_on(plan.tasks),
    ]


def _pictures(plan, report):
    style = plan.preset.studied[0]

    def image(name):
        return name, stored(plan.picture(style, name)).image

    return [
        "## Pictures",
        f"What is lost for speed, in {style}: StyLit beside the thesis' optimized method.",
        report.pair("speed", image("StyLit"), image("optimized")),
        "The same beside our preset `best`, which is as fast:",
        report.pair("products", image("StyLit"), image("best")),
    ]


def _preface(plan):
    scene = plan.scene(STYLES[0])
    timed = {side: plan.times(side).scene.name for side in plan.sides}
    enlarged = [f"{side} x {side}" for side, name in timed.items() if "enlarged" in name]
    rendered = [f"{side} x {side}" for side, name in timed.items() if "enlarged" not in name]
    note = (f" Frames of {' and '.join(rendered)} are rendered ones." if rendered else "") + (
        f" Frames of {' and '.join(enlarged)} are of the bundled scene, its pixels repeated: they "
        "have as many pixels and candidates, and their pictures are not shown. `make data "
        "SIZE=500x500 SCENES=golem` renders the scene itself, which is taken if it is there."
        if enlarged
        else ""
    )
    return (
        f"Our golem on our stage, pictures of {scene.size.replace('x', ' x ')} pixels, seed 0; the "
        "thesis' model and styles are not published, so compare ratios and shapes. It measured a "
        "GTX 1080: a verdict on time says whether a claim holds on a processor too. `simple` is "
        "its EV, `optimized` its OV (L = 6, two iterations, w = 5, D = 3); `quick`, `best` are "
        f"ours; `ref` and `StyLit` match every pixel and are guided by {', '.join(GUIDES)}. What "
        "is studied alone, by default in one style, is "
        f"so in {', '.join(plan.preset.studied)}.{note}"
    )


def _requirements(required, report):
    shown = required.copy()
    for name in shown:
        if name[0].isdigit():
            shown[name] = ["yes" if met else "no" for met in shown[name]]
        elif name != "method":
            shown[name] = shown[name].map("{:.2f}".format)
    return [
        "## The four requirements (1.1)",
        report.table("requirements", required, shown),
        DEFINITION,
    ]


def _times(plan, report):
    one, hand, others = tables.table_1(plan), tables.hand_times(plan), tables.others(plan)
    ablation, widths, depths = tables.ablation(plan), tables.widths(plan), tables.depths(plan)
    return [
        "## Times",
        "### Table 1",
        report.table("table_1", one, one.astype(object).fillna("")),
        "A cold frame from the buffers in memory to a picture, packing included, rendering not: "
        f"ours the median of {plan.preset.rounds}, methods in turns. One thread: time of its "
        "processor. All threads: wall time, and frames a second from it; beside other programs a "
        "session uses one thread alone. The thesis' are of a GTX 1080, and its rows with rendering "
        "are cited alone.",
        "### What a hand waits for",
        report.table("hand_times", hand, hand),
        f"Medians of {plan.preset.of_a_hand} on all threads, in turns, packing included where "
        "there is another target. "
        f"{'; '.join(f'*{kind}*: {what}' for kind, what in WAITED.items())}.",
        *_turning(plan, report),
        "### Others (4.2)",
        report.table("others", others, others),
        "Ours are seconds of the processor for a megapixel: of the dense methods at the rate of a "
        "pixel of our pictures, of the others a frame of the larger size.",
        "### The three savings (4.2)",
        report.table("ablation", ablation, ablation.astype(object)),
        "Milliseconds on one thread, methods in turns. The simple method is the one without the "
        "scale space.",
        "### As w and D grow",
        report.figure("sweeps", "time and energy", pictures.sweeps_figure, plan, committed=True),
        report.table("widths", widths, widths.astype(object)),
        report.table("depths", depths, depths.astype(object)),
        "With w the grid thins: entries lie (w + 1) / 2 pixels apart.",
    ]


def _turning(plan, report):
    if plan.turning is None:
        return []
    table = tables.turning(plan)
    return [
        "### A target that turns",
        report.table("turning", table, table),
        "The golem turns by 1° from frame to frame. Flicker is the mean change of points that two "
        "neighbouring frames show, in 8-bit steps. A picture that is never drawn anew flickers "
        "least on still ground and no longer fits its target, so read flicker and energy together.",
    ]


def _quality(plan, report):
    quality = tables.quality(plan)
    return [
        "## Quality",
        report.figure("sheet", "all methods", pictures.sheet_figure, plan, committed=True),
        "Lit Sphere and StyleBlit paint the object alone.",
        report.table("quality", quality, tables.formatted(quality)),
        "Energy asks the same of all: how well patches of style and guides match the picture. An "
        "empty picture has little, so look at the sheet. Rivals have no ground, and do not tell "
        "where a pixel comes from. *Background broken* does not see wall on the ground, which are "
        "one background to the thesis; *spilled* does.",
    ]


def _large(plan, report):
    if plan.large is None:
        return []
    table = tables.large(plan)
    size = plan.large_picture(STYLES[0], "simple").scene.size.replace("x", " x ")
    return [
        f"### At {size}",
        report.table("large", table, tables.formatted(table)),
        "The thesis' size, where coarse levels are larger and highlights wider. This tells of "
        "artefacts of the methods in real time; the table above compares them with others. "
        "Figures 21, 22, 25 and 28 are of this size.",
    ]


def _figures(plan, report):
    def figure(name, caption, draw, *arguments):
        return report.figure(name, caption, draw, *arguments, plan, committed=True)

    return [
        "## Figures of the thesis",
        "### The optimized method (21)",
        figure("optimized", "the optimized method", pictures.method_figure, "optimized"),
        "### The simple method (22)",
        figure("simple", "the simple method", pictures.method_figure, "simple"),
        "### Where source and target differ (23)",
        figure("masks", "buffers of source and target", pictures.masks_figure),
        "### Artefacts where they differ (24)",
        figure("apart", "four artefacts", pictures.apart_figure),
        "Places are those where the optimized method shows the artefact most. The style's border "
        "hardly shows here, since our patches lie wholly inside the style.",
        "### Characteristic artefacts (25)",
        figure("artefacts", "eight artefacts", pictures.artefacts_figure),
        "Above the optimized method, below the simple one, each where its number is worst; strokes "
        "in pen, the rest in oil.",
        "### Beside Lit Sphere and StyLit (26)",
        figure("comparison", "four methods", pictures.comparison_figure),
        "### Buffers left out (27)",
        figure("buffers", "buffers left out", pictures.buffers_figure),
        "### Structures (28)",
        figure("structures", "both methods", pictures.structures_figure),
    ]


def _choices(plan, report):
    buffers, choices, fewest = tables.buffers(plan), tables.choices(plan), tables.fewest(plan)
    shown = tables.formatted(buffers.drop(columns="changed"))
    shown.insert(2, "changed", buffers["changed"].map("{:.2f}".format))
    return [
        "## Buffers left out, in numbers",
        report.table("buffers", buffers, shown),
        "Changed is the mean absolute difference to the picture of all buffers.",
        "## Other choices",
        report.table("choices", choices, tables.formatted(choices)),
        "## The outlook (7)",
        "The fewest buffers of the simple method within 2 % of its energy: each left out alone, "
        "then more from row to row, the least missed first.",
        report.table("fewest", fewest, fewest.astype(object)),
        "Another seed alone changes energy by a few percent (see the buffers above), so read small "
        "differences with care.",
        "A compromise of both methods is the last row of the choices above.",
    ]
