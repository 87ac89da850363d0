"""The claims of the thesis about pictures, by the numbers of ours."""

import numpy as np

from eval.documents.heidrich.artefacts import ARTEFACTS
from eval.documents.heidrich.plan import BUFFERS, ITERATIONS, SCHEDULES, STYLES, THESIS
from eval.documents.heidrich.reach import READINGS, reach
from eval.documents.heidrich.tables import buffers, energy
from eval.metrics import NUMBERS
from eval.metrics.wrong_things import BACKGROUND, views_of
from eval.pages.claims import OPEN, Claim, by_case, listed, majority, verdict
from eval.runs.store import numbers_of, stored


def claims_of_quality(plan):
    """These claims, in the order of the thesis.

    Parameters
    ----------
    plan : Plan
        Its runs must be stored.

    Returns
    -------
    list of Claim
    """
    return [
        _reach(),
        _less_distinctive(plan),
        _schedule(
            plan, "both terms from the coarsest level",
            "The style's term does not matter at coarse levels",
        ),
        _early(plan),
        _schedule(
            plan, "both terms to the finest level",
            "At the finest levels the guides can be neglected",
        ),
        _loss(plan),
        _apart(plan),
        *(_artefact(plan, artefact) for artefact in ARTEFACTS),
        _stylit_continues(plan),
        Claim(
            "Lit Sphere bends strokes as well", "6.2.2", OPEN,
            "strokes are turned more than with StyLit",
            "Lit Sphere paints the object alone, and the number needs a match for every pixel",
        ),
        _no_ground(plan),
        _full_alone(plan),
        _little_changes(plan),
        _most_changes(plan),
        _mostly_right(plan),
        _fine(plan),
        _highlights(plan),
        _surfaces(plan),
        _hatching(plan),
    ]  # fmt: skip


def _of(plan, style, method, name):
    return numbers_of(plan.picture(style, method))[name]


def _by_style(plan, name, methods, styles=STYLES):
    """Values of a number, an array for each style: one for each method."""
    return {s: np.array([_of(plan, s, m, name) for m in methods]) for s in styles}


def _told(found, name, methods):
    """Values by style as a sentence."""
    form = NUMBERS[name].form
    values = {style: listed(list(map(form.format, row))) for style, row in found.items()}
    return f"{listed(methods)} {'has' if len(methods) == 1 else 'have'} {by_case(values)}"


def _reach():
    reached = {name: [reach(means, d) for d in (3, 4)] for name, means in READINGS.items()}
    return Claim(
        "D = 3 reaches 27 x 27 pixels with three reads",
        "4.2.3",
        verdict(max(three for three, _ in reached.values()) >= 27),
        "a pixel's three scales are means of 27 x 27 pixels, by either reading of what a scale is",
        "they reach "
        + listed([f"{three} x {three} pixels with {name}" for name, (three, _) in reached.items()])
        + "; with the D + 1 scales of equation 20, which are four reads, it is "
        + listed([f"{four} x {four}" for _, four in reached.values()]),
    )


def _less_distinctive(plan):
    found = _by_style(plan, "image_energy", THESIS)
    return Claim(
        "Patches are much more distinctive than scales",
        "4.2.3",
        majority([row[0] < row[1] for row in found.values()]),
        "in most styles the simple method's energy is lower",
        _told(found, "image_energy", THESIS),
    )


def _schedule(plan, schedule, claim):
    styles = plan.preset.studied
    printed = energy([plan.picture(style, "simple") for style in styles])
    other = energy([plan.scheduled(style, schedule) for style in styles])
    mu = " ".join(f"{each / 16:g}" for each in SCHEDULES[schedule])
    return Claim(
        claim,
        "4.2.4",
        verdict(other >= 0.95 * printed),
        f"with {schedule} the simple method's energy is at most 5 % lower",
        f"its energy is {other:.0f} so, and {printed:.0f} as printed; μ is {mu} from the finest "
        "level on",
    )


def _early(plan):
    styles = plan.preset.studied
    found = [energy([plan.iterated(style, count) for style in styles]) for count in ITERATIONS]
    falls = -np.diff(found)
    return Claim(
        "Most changes in the early iterations",
        "3.3.3, 4.2.4",
        verdict(falls[0] == falls.max() and falls[0] > 0),
        "from one iteration a level to two the simple method's energy falls more than from two to "
        "four and from four to eight",
        "the energy is "
        + listed([f"{value:.0f} after {n}" for value, n in zip(found, ITERATIONS, strict=True)]),
    )


def _loss(plan):
    methods = ("StyLit", *THESIS)
    found = _by_style(plan, "image_energy", methods)
    return Claim(
        "Quality is lost for speed",
        "6.1",
        verdict(all(row[0] < row[1:].min() for row in found.values())),
        "StyLit's energy is lower than that of both methods in every style",
        _told(found, "image_energy", methods),
    )


def _apart(plan):
    votes, text = [], []
    for method in THESIS:
        apart, alike = (_by_style(plan, f"energy_{w}", [method]) for w in ("apart", "alike"))
        ratios = [float(apart[style][0] / alike[style][0]) for style in STYLES]
        votes.append(min(ratios) > 1)
        text.append(f"{min(ratios):.2f} to {max(ratios):.2f} times as high with {method}")
    return Claim(
        "Artefacts lie where source and target differ",
        "6.2.1",
        verdict(all(votes)),
        "with both methods energy is higher where IDMASK or LIGHTMASK differ than elsewhere, "
        "in every style",
        f"there it is {listed(text)}",
    )


def _artefact(plan, artefact):
    methods = ("StyLit", *THESIS)
    found = _by_style(plan, artefact.number, methods, artefact.styles)
    votes = [
        bool((artefact.sign * (row[1:] - row[0]) > 0).all() and (row[1:] >= artefact.least).all())
        for row in found.values()
    ]
    shows = f" and at least {artefact.least:g}, where it shows," if artefact.least else ""
    few = "less" if artefact.sign < 0 else "more"
    return Claim(
        artefact.name,
        artefact.section,
        majority(votes),
        f"*{NUMBERS[artefact.number].title}* is {few} with both methods than with StyLit{shows} in "
        "most styles that can show it",
        _told(found, artefact.number, methods),
    )


def _stylit_continues(plan):
    methods = ("StyLit", *THESIS)
    found = _by_style(plan, "energy_apart", methods)
    return Claim(
        "StyLit continues structures where source and target differ",
        "6.2.2",
        majority([row[0] < row[1:].min() for row in found.values()]),
        "in most styles its energy there is lower than that of both methods",
        _told(found, "energy_apart", methods),
    )


def _no_ground(plan):
    colours = []
    for style in STYLES:
        job = plan.picture(style, "Lit Sphere")
        outside = views_of(job.scene)[1].labels
        ground = stored(job).image[outside != outside.max()]
        colours.append(len(np.unique(ground, axis=0)))
    return Claim(
        "Lit Sphere makes neither background nor cast shadow",
        "6.2.2",
        verdict(max(colours) == 1),
        "all that is no object has one colour",
        f"it has {max(colours)} in the style that has most",
    )


def _shine_from_ground(job):
    """Share of the target's highlights taken from the source's background."""
    source, target = views_of(job.scene)
    nnf = stored(job).nnf[target.highlight]
    return float((source.labels[nnf[:, 0], nnf[:, 1]] == BACKGROUND).mean())


def _full_alone(plan):
    styles = plan.preset.studied
    shares = {}
    for method in THESIS:
        alone = [plan.weighted(style, method, "FULL alone") for style in styles]
        every = [plan.picture(style, method) for style in styles]
        shares[method] = [float(np.mean(list(map(_shine_from_ground, j)))) for j in (alone, every)]
    return Claim(
        "FULL alone confuses the highlight with the background",
        "6.3",
        verdict(all(a >= max(0.05, 2 * b) for a, b in shares.values())),
        "with both methods at least 5 % of the highlights' pixels come from the background, and "
        "twice as many as with all buffers",
        "they are "
        + listed(
            [f"{a:.1%} with {m}, and {b:.1%} with all buffers" for m, (a, b) in shares.items()],
        ),
    )


def _changes(plan):
    table = buffers(plan).set_index(["method", "buffers"])["changed"]
    alone = [name for name in BUFFERS if name.startswith("without")]
    return table, alone


def _little_changes(plan):
    table, alone = _changes(plan)
    ratios = {
        method: table[method][alone].max() / table[method]["all, another seed"] for method in THESIS
    }
    return Claim(
        "Leaving a buffer out changes little",
        "6.3",
        verdict(max(ratios.values()) <= 1.25),
        "no buffer left out changes the picture by more than 1.25 times what another seed does",
        "it changes at most "
        + listed([f"{ratio:.2f} times as much with {method}" for method, ratio in ratios.items()]),
    )


def _most_changes(plan):
    table, alone = _changes(plan)
    ranked = table["simple"][alone].sort_values(ascending=False)
    return Claim(
        "With the simple method LDE changes most",
        "6.3",
        verdict(ranked.index[0] == "without LDE"),
        "no other buffer left out changes its picture more",
        "the picture changes by "
        + listed([f"{value:.2f} {name}" for name, value in ranked.items()]),
    )


def _mostly_right(plan):
    found = _by_style(plan, "wrong_id", ["optimized"])
    return Claim(
        "The optimized method assigns most places correctly",
        "6.3",
        verdict(max(row[0] for row in found.values()) <= 0.1),
        "at most a tenth of all pixels are taken from another thing, in every style",
        _told(found, "wrong_id", ["optimized"]),
    )


def _fine(plan):
    found = _by_style(plan, "richness", THESIS)
    return Claim(
        "The simple method transfers fine structures and contours better",
        "6.4, 28d e",
        majority([abs(row[0] - 1) < abs(row[1] - 1) for row in found.values()]),
        "in most styles its picture has nearer to as much fine detail as the style (richness 1)",
        _told(found, "richness", THESIS),
    )


def _highlights(plan):
    found = _by_style(plan, "lost_highlights", THESIS)
    return Claim(
        "The simple method restores highlights better",
        "6.4, 28a",
        majority([row[0] < row[1] for row in found.values()]),
        "in most styles it loses fewer of their pixels",
        _told(found, "lost_highlights", THESIS),
    )


def _surfaces(plan):
    found = _by_style(plan, "energy_apart", THESIS)
    return Claim(
        "The optimized method continues surfaces better",
        "6.4, 28b c",
        majority([row[1] < row[0] for row in found.values()]),
        "in most styles its energy is lower where IDMASK or LIGHTMASK differ",
        _told(found, "energy_apart", THESIS),
    )


def _hatching(plan):
    found = _by_style(plan, "image_energy", ("StyLit", *THESIS))
    ratios = {style: row[1:] / row[0] for style, row in found.items()}
    others = np.mean([ratios[style] for style in STYLES if style != "pen"], axis=0)
    return Claim(
        "Structures with a direction, as hatching, suffer most",
        "6.4",
        verdict(bool((ratios["pen"] > others).all())),
        "with both methods energy over StyLit's is higher in pen than the other styles' mean",
        "it is "
        + listed(
            [
                f"{pen:.2f} times StyLit's in pen and {other:.2f} times elsewhere with {method}"
                for method, pen, other in zip(THESIS, ratios["pen"], others, strict=True)
            ],
        ),
    )
