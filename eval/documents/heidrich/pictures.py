"""The figures of chapter 6, of our stage."""

import numpy as np
from matplotlib.figure import Figure

from eval.documents.heidrich.artefacts import ARTEFACTS
from eval.documents.heidrich.places import densest, window_of
from eval.documents.heidrich.plan import BUFFERS, METHODS, STYLES, THESIS
from eval.documents.heidrich.tables import depths, widths
from eval.metrics import NUMBERS
from eval.metrics.image_energy import masks_apart
from eval.pages.figures import contact_sheet
from eval.runs.store import stored

SHORT = {"optimized": "OV", "simple": "EV"}
TITLES = {method: f"{method} ({short})" for method, short in SHORT.items()}


def sheet_figure(plan, file):
    """All methods in all styles."""
    rows = []
    for style in STYLES:
        images = [(style, plan.scene(style).style)]
        rows.append(images + [(name, stored(plan.picture(style, name)).image) for name in METHODS])
    contact_sheet(rows, file, tile=190)


def method_figure(method, plan, file):
    """Figures 21 and 22: a method in all styles."""
    images = [(style, stored(plan.large_picture(style, method)).image) for style in STYLES]
    contact_sheet([images[:2], images[2:]], file, tile=360)


def masks_figure(plan, file):
    """Figure 23: what source and target show in the same place."""
    scene = plan.scene(STYLES[0])
    rows = []
    for name in ("FULL", "IDMASK", "LIGHTMASK"):
        source, target = scene.buffers[name]
        apart = np.abs(source.astype(int) - target).astype(np.uint8)
        rows.append(
            [(f"{name} of the source", source), ("of the target", target), ("apart", apart)]
        )
    region = np.repeat(255 * masks_apart(scene)[..., None].astype(np.uint8), 3, axis=2)
    rows.append([("a mask differs", region)])
    contact_sheet(rows, file, tile=240)


def apart_figure(plan, file):
    """Figure 24: artefacts where source and target differ, beside StyLit."""
    columns = []
    for artefact in ARTEFACTS[:4]:
        style = "pen" if "pen" in artefact.styles[:1] else "oil"
        window = window_of(artefact.number, plan.picture(style, "optimized"))
        scene = plan.scene(style)
        crops = [
            (method, stored(plan.picture(style, method)).image[window])
            for method in ("optimized", "simple", "StyLit")
        ]
        guide = scene.shown_guide[window]
        name = NUMBERS[artefact.number].title
        columns.append([(f"{name}: style", scene.style[window]), ("target", guide), *crops])
    contact_sheet(list(map(list, zip(*columns, strict=True))), file, tile=200)


def artefacts_figure(plan, file):
    """Figure 25: where each artefact is worst, with either method."""
    rows = []
    for method in ("optimized", "simple"):
        row = []
        for artefact in ARTEFACTS:
            style = "pen" if artefact.number in ("hatching", "bent") else "oil"
            job = plan.large_picture(style, method)
            crop = stored(job).image[window_of(artefact.number, job)]
            row.append((f"{SHORT[method]}: {NUMBERS[artefact.number].title}", crop))
        rows += [row[:4], row[4:]]
    contact_sheet(rows, file, tile=200)


def comparison_figure(plan, file):
    """Figure 26: Lit Sphere, StyLit, both methods and ours."""
    images = [
        (TITLES.get(name, name), stored(plan.picture("oil", name)).image)
        for name in ("Lit Sphere", "StyLit", "optimized", "simple", "best")
    ]
    contact_sheet([[("style", plan.scene("oil").style), *images[:2]], images[2:]], file, tile=400)


def buffers_figure(plan, file):
    """Figure 27: where a buffer left out changes most, below the same place with all of them."""
    style, rows = plan.preset.studied[0], []
    for method in THESIS:
        whole = stored(plan.picture(style, method)).image
        with_all, without = [], []
        for weights in BUFFERS:
            image = stored(plan.weighted(style, method, weights)).image
            window = densest(np.abs(image.astype(int) - whole).sum(axis=2))
            with_all.append((f"{method}, all", whole[window]))
            without.append((weights, image[window]))
        rows += [with_all, without]
    contact_sheet(rows, file, tile=160)


def structures_figure(plan, file):
    """Figure 28: where both methods differ most, in each style."""
    rows = [[], [], []]
    for style in STYLES:
        images = {method: stored(plan.large_picture(style, method)).image for method in THESIS}
        window = densest(np.abs(images["simple"].astype(int) - images["optimized"]).sum(axis=2))
        guide = plan.large_picture(style, "simple").scene.shown_guide
        rows[0].append((f"{style}: target", guide[window]))
        rows[1].append(("optimized (OV)", images["optimized"][window]))
        rows[2].append(("simple (EV)", images["simple"][window]))
    contact_sheet(rows, file, tile=210)


def sweeps_figure(plan, file):
    """Time and energy as w and D grow."""
    figure = Figure(figsize=(11, 3.6), layout="constrained")
    for place, table in zip(figure.subplots(1, 2), (widths(plan), depths(plan)), strict=True):
        name = table.columns[0]
        for side in plan.sides:
            place.plot(table[name], table[f"{side}² [ms]"], marker=".", label=f"{side}²")
        energies = place.twinx()
        energies.plot(table[name], table["energy"], color="grey", linestyle=":", marker=".")
        energies.set_ylabel("energy (dotted)")
        energies.set_ylim(0)
        place.set_ylim(0)
        place.set_xticks(table[name])
        place.set_xlabel(name)
        place.set_ylabel("ms a frame, one thread")
        place.legend(fontsize=8)
    figure.savefig(file, dpi=100)
