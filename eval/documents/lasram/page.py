"""The page of the report on the paper: every table and figure."""

from functools import partial

from eval.documents.lasram import holes, patch_pictures, pictures, printed, tables
from eval.documents.lasram.claims import claims
from eval.documents.lasram.cut_quality import BEGUN, JUMP, RADIUS, cut_quality
from eval.documents.lasram.goals import goals
from eval.documents.lasram.interaction import BRUSH, THREADS, interaction
from eval.documents.lasram.peak_memory import SIDE, peak_memory
from eval.documents.lasram.plan import JITTERS
from eval.documents.lasram.timing import REPEATS, ceiling, timing
from eval.methods.hole_filling import CURES
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
    title = f"Lasram and Lefebvre 2012, preset {plan.name}"
    return Document(title, plan.tasks, partial(_sections, plan), [_CODE])


def _sections(plan, report):
    quality = tables.quality(plan)
    found = [*claims(plan), *goals(plan, quality)]
    return [
        _preface(plan),
        *verdict_section(found),
        *_pictures(plan, report),
        *_figures(plan, report),
        *claims_section("What the paper says, and what we found", found, report),
        *_performance(plan, report),
        *_quality(plan, quality, report),
        *_holes(plan, report),
        "## What the numbers are",
        definitions(tables.SHOWN),
        *made_on(plan.tasks),
    ]


def _preface(plan):
    seeds = " ".join(map(str, plan.preset.seeds))
    return (
        f"Our exemplars at 256x256, S at {plan.side}x{plan.side}, the paper's settings (section 8) "
        "where nothing else is said: R = 64, D_max = 32, N_ρ = 2, N_θ = 1.5, J_max = 4, γ = 1, 16 "
        f"iterations, rejection `after`. Seeds of the study of quality: {seeds}; 0 elsewhere. The "
        "paper does not publish its exemplars, η, nor its range of colours, so compare ratios and "
        "shapes. The machines are named at the end of the page."
    )


def _pictures(plan, report):
    exemplar = plan.exemplars[0]
    shown = {
        name: stored(job).image
        for name, job in (
            ("image quilting", plan.quilting(exemplar)),
            ("our default", plan.default(exemplar)),
            ("one R that does not fall", plan.of_one_radius(exemplar)),
        )
    }
    quilting, ours, one = shown.items()
    return [
        "## Pictures",
        f"{exemplar.capitalize()} beside image quilting, which cannot deform what it copies:",
        report.pair("beside_quilting_of", quilting, ours),
        "Patches that begin larger and become smaller keep more of the pattern:",
        report.pair("falling_radius_of", one, ours),
    ]


def _figures(plan, report):
    def figure(name, caption, draw, *arguments):
        return report.figure(name, caption, draw, *arguments, plan, committed=True)

    return [
        "## Figures of the paper",
        "### Exemplars and textures (1)",
        figure("textures", "exemplars and textures", pictures.teaser_figure),
        figure("overlay", "seams and the next patches", patch_pictures.overlay_figure),
        "Existing seams are red, patches to be accepted green, to be rejected blue; after 10 "
        "iterations.",
        "### A patch, its polar table and its cut (2)",
        figure("patch", "a patch, step by step", patch_pictures.patch_figure),
        "### Cuts between two pictures (3, 5)",
        figure("overlap", "three cuts", pictures.overlap_figure, False),
        figure("features", "three cuts across features", pictures.overlap_figure, True),
        "Numbers are costs in M. In the second, every cut has to cross the canes.",
        "### Aligned features (6, 7)",
        figure("alignment", "before and after alignment", patch_pictures.alignment_figure),
        figure("initial_state", "the start of D", patch_pictures.initial_state_figure),
        "Numbers are what the crossings of the cut cost, in M. The first shift is that to the "
        "right of the centre; the worst one is shown.",
        "### R (9)",
        figure("radius", "8 iterations at every R", pictures.radius_figure),
        "### Falling R (10)",
        figure("falling_radius", "R from 132 by 4 to 4", pictures.falling_radius_figure),
        "### Falling D_max (11)",
        figure(
            "falling_deformation", "D_max from 160 by 10 to 0", pictures.falling_deformation_figure
        ),
        "### Convergence (14)",
        figure("convergence", "cost and acceptance", pictures.convergence_figure),
        "### A large R (16)",
        figure("large_radius", "R = 128", pictures.large_radius_figure),
        _times_beside_pixels(plan),
        "### Completion (12)",
        figure("completion", "completed flowers", pictures.completion_figure),
        _size_of_completion(plan),
        "### Several exemplars (13)",
        figure("labels", "flowers and bricks", pictures.labels_figure),
        "### A global structure (17)",
        figure("door", "a wall with a door", pictures.door_figure),
    ]


def _times_beside_pixels(plan):
    ours = 1000 * stored(plan.large_radius("canes")).stages["cpu"]
    theirs = min(1000 * stored(plan.pixels("canes", label)).stages["cpu"] for label in JITTERS)
    return (
        f"16 iterations took {ours:.0f} ms of the processor here, the pixel-based rival "
        f"{theirs:.0f} ms after its analysis of E; in the paper {printed.RADIUS_128_MS} and "
        f"{printed.PIXELS_MS} ms on a GTX 580. The rival is our own, after Lefebvre and "
        "Hoppe (2005), on one processor. Look at the pictures: a high jitter breaks canes, a low "
        "one repeats E. Ours has broken canes too: large patches are few in an "
        "iteration, and 16 iterations may not be enough for them."
    )


def _size_of_completion(plan):
    size = "{1}x{0}".format(*plan.preset.completed)
    printed_size = "{1}x{0}".format(*printed.COMPLETED)
    if size == printed_size:
        return f"At {size}, as in the paper."
    return f"At {size}; in the paper S has {printed_size}, as in the preset full."


def _performance(plan, report):
    times, stages = tables.times(plan), tables.stages(plan)
    radii, cuts = tables.radii(plan), cut_quality(plan)
    return [
        "## Cut quality (section 4)",
        report.table("cut_quality", cuts, cuts.round(3).astype(object).fillna("")),
        f"Random patches over the nine exemplars, R = {RADIUS}, J = {JUMP}; the optimum is the "
        "best closed cut through any column of the first row, with the seams that it hides. With E "
        "zero, patches lie on the exemplar, wrapped, and hide nothing. In the midst of a "
        f"synthesis, after {BEGUN} iterations of our defaults, a cut gains, so that costs are "
        "negative and ratios are gains over optimal gains: 1 at best. The two passes "
        "include the smallest cut, around the centre alone.",
        "## Performance",
        report.table("times", times, times),
        "The paper's times are of a GTX 580, ours of the processors named above. The first "
        "iterations, from white noise, take longest. Memory is that of all arrays.",
        report.table("stages", stages, stages.astype(str)),
        "Shares of ours are of one patch alone, each stage the least of many: the rest is reading "
        "S, writing a patch twice, with deformation and without, and what it would cost.",
        *_threads(plan, report),
        "### As R grows (15)",
        report.figure(
            "radius_times", "time as R grows", pictures.radius_times_figure, plan, committed=True
        ),
        report.table("radius_times", radii, radii),
        "Processor time, that of all threads together, the least of three runs: a busy machine "
        "changes it little.",
        *_waits(plan, report),
    ]


def _waits(plan, report):
    waits, memory = interaction(plan.interaction), peak_memory(plan)
    text = [
        "### What a hand waits for",
        report.table("interaction", waits, waits.round(1).astype(str)),
        f"With {THREADS} threads, late in the synthesis. A patch is cut, stitched and dropped; a "
        f"stroke of a round brush of {BRUSH} px, pulled as far, is a hole that four iterations "
        "fill. The least time is that of a quiet machine.",
    ]
    if memory.empty:
        return text
    return [
        *text,
        f"### Memory at {SIDE}x{SIDE}",
        report.table("memory", memory, memory.round(2).astype(str)),
        "Of the whole program, with its PNG written; one iteration.",
    ]


def _where_ours_loses(beside):
    """In words, since the table shows it in numbers alone."""
    columns = {
        "has patches less like those of E (sw)": beside["sw over quilting's"] > 1,
        "copies larger pieces": beside["piece over quilting's"] > 1,
        "repeats itself more": beside["repetition less quilting's"] > 0,
        "has a border": ~beside["border"].between(*tables.BORDERS),
    }
    losses = [
        f"it {what} on {', '.join(beside.loc[loses, 'exemplar'])}"
        for what, loses in columns.items()
        if loses.any()
    ]
    return f"Where our default loses to image quilting: {'; '.join(losses) or 'nowhere'}."


def _holes(plan, report):
    filled, cures = holes.filled(plan), holes.without_cures(plan)
    well = filled.groupby("exemplar", sort=False)["cost"].max() <= holes.MOST_COST
    badly = ", ".join(name for name in well.index if not well[name])
    return [
        "## Holes",
        report.table("filled", filled, filled.round(3).astype(object)),
        "Holes in 256x256 pixels, filled from all others in at most "
        f"{filled['iterations'].max()} iterations. **changed**: known pixels that are not "
        "as they were; **left**: pixels of the hole that are still as they were at the start; "
        f"**cost**: M a pixel of the hole. At most {holes.MOST_COST:g} in all its holes: "
        f"{well.sum()} of {len(well)} exemplars{f'; not {badly}' if badly else ''}. "
        "Holes cost most whose border cuts through single things, such as flowers: the halves that "
        "would fit lie in the hole.",
        report.figure("filled", "without each cure", pictures.filled_figure, plan, committed=True),
        report.table("cures", cures, holes.shown_without_cures(cures)),
        f"The largest hole, filled without each cure ({len(CURES)} runs of an exemplar):",
        "\n".join(f"- {name}: {said}" for name, said in CURES.items()),
        "Seams across the border of the image are not counted here. A run without lock does not "
        "see the border of the image either.",
    ]


def _threads(plan, report):
    iterations, possible = timing(plan.of_threads), ceiling(plan.ceiling)
    large = iterations.iloc[-1]
    return [
        report.table("times_of_threads", iterations, iterations),
        f"One thread and two in turns, each the median of {REPEATS} runs from white noise; times "
        "as fast is of iterations 11 to 16. The 16 iterations with R = 128 take "
        f"{16 * large['2 threads, 1 to 16 [ms]']:.0f} ms on two threads; in the paper, at 512x512 "
        f"on a GTX 580, {printed.RADIUS_128_MS} ms.",
        report.table("ceiling", possible, possible),
        "What two threads gain on this machine where nothing but memory or arithmetic holds them "
        f"up, the least of {REPEATS} times: no iteration can gain more.",
    ]


def _quality(plan, quality, report):
    beside = tables.beside_quilting(quality)
    of_one_radius = tables.beside_quilting(quality, "one R")
    threes = [plan.exemplars[k : k + 3] for k in range(0, len(plan.exemplars), 3)]
    sheets = [
        report.figure(
            f"sheet_{k}", ", ".join(names), pictures.sheet_figure, names, plan, committed=True
        )
        for k, names in enumerate(threes, 1)
    ]
    absent = "" if plan.rivals else " No other program was named with --gmic or the like."
    return [
        "## Quality beside others",
        *sheets,
        report.table("quality", quality, tables.formatted(quality)),
        "Bounds: pieces at most "
        f"{tables.PIECE_BOUND:g} times image quilting's, repetition at most "
        f"{tables.REPETITION_BOUND:.0%} above it, border from {tables.BORDERS[0]} to "
        f"{tables.BORDERS[1]}, sw at most 1.5 times it. No number sees structures of more than 7 "
        "pixels: look at the sheets, where broken bricks and canes have a low sw. The tile of "
        "img2texture is smaller than E, and so shown larger. Times of other programs are those by "
        f"the clock.{absent}",
        report.table("beside_quilting", beside, beside),
        _where_ours_loses(beside),
        "The same if R is 64 and does not fall:",
        report.table("one_radius_beside_quilting", of_one_radius, of_one_radius),
    ]
