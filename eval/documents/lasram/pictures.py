"""The figures of the paper, of our exemplars."""

import numpy as np
from matplotlib.figure import Figure

from eval.documents.lasram import overlap
from eval.documents.lasram.plan import JITTERS, LARGEST_HOLE, RADII
from eval.documents.lasram.tables import radii
from eval.methods.hole_filling import CURES, hole_of
from eval.methods.texture_completion import holes
from eval.pages.figures import contact_sheet
from eval.runs.store import stored
from eval.textures import load_texture


def teaser_figure(plan, file):
    """Figure 1, left: exemplars and what is synthesized from them."""
    rows = [
        [(name, plan.default(name).scene.exemplar) for name in plan.exemplars],
        [("", stored(plan.default(name)).image) for name in plan.exemplars],
    ]
    contact_sheet(rows, file, tile=165)


def overlap_figure(aligned, plan, file):
    """Figures 3 and 5: graph-cut, image quilting and our cut, above the error map."""
    exemplar = plan.default("canes" if aligned else "pebbles").scene.exemplar
    if aligned:  # turned by a quarter, canes lie across the overlap, and every cut crosses them
        exemplar = np.ascontiguousarray(np.rot90(exemplar))
    left, right = exemplar[20:212, 10:138], exemplar[27:219, 100:228]
    along, down = overlap.edge_costs(left, right)
    labels = {
        "graph-cut": overlap.graph_cut(along, down),
        "quilting, J = 1": overlap.column_cut(along, down, 1),
        "ours, J = 16": overlap.column_cut(along, down, 16),
    }
    costs = {name: overlap.border_cost(shows, along, down) for name, shows in labels.items()}
    map_of_errors = np.minimum(255, 20 * np.log1p((along + down) / 16)).astype(np.uint8)
    top, bottom = (
        [
            ("left", left),
        ],
        [("right", right)],
    )
    for name, shows in labels.items():
        top.append((f"{name}: {costs[name]:.2f}", np.where(shows[..., None], left, right)))
        shown = np.repeat(map_of_errors[..., None], 3, axis=2)
        border = shows & ~np.roll(shows, -1, axis=1)
        border[:-1] |= shows[:-1] != shows[1:]
        shown[border] = (60, 255, 60)
        bottom.append(("error map", shown))
    contact_sheet([top, bottom], file, tile=220)


def radius_figure(plan, file):
    """Figure 9: 8 iterations at every R."""
    row = [(f"R = {radius}", stored(plan.of_radius(radius)).image) for radius in RADII]
    contact_sheet([[("E", plan.default("flowers").scene.exemplar), *row]], file, tile=260)


def falling_radius_figure(plan, file):
    """Figure 10: R from 132 by 4 to 4."""
    row = [(f"R = {radius}", stored(plan.falling_radius(radius)).image) for radius in (72, 4)]
    contact_sheet([[("E", plan.falling_radius(4).scene.exemplar), *row]], file, tile=340)


def falling_deformation_figure(plan, file):
    """Figure 11: D_max from 160 by 10 to 0."""
    jobs = {value: plan.falling_deformation("bricks", value) for value in (100, 50, 0)}
    row = [(f"D_max = {value}", stored(job).image) for value, job in jobs.items()]
    contact_sheet([[*row, ("E", jobs[0].scene.exemplar)]], file, tile=260)


def convergence_figure(plan, file):
    """Figure 14: global cost, 100 at iteration 4, and acceptance."""
    figure = Figure(figsize=(11, 3.6), layout="constrained")
    cost, acceptance = figure.subplots(1, 2)
    for name in plan.exemplars:
        history = stored(plan.long(name)).history[3:]
        cost.plot(history["number"], 100 * history["cost"] / history["cost"].iloc[0], label=name)
        acceptance.plot(history["number"], 100 * history["accepted"] / history["cells"])
    for place, title in ((cost, "global cost, 100 at iteration 4"), (acceptance, "accepted [%]")):
        place.set_title(title, fontsize=10)
        place.set_xlabel("iteration")
        place.axvline(10, color="grey", linewidth=0.5)
    cost.set_yscale("log")
    cost.legend(fontsize=7)
    figure.savefig(file, dpi=100)


def radius_times_figure(plan, file):
    """Figure 15: time of an iteration as R grows."""
    table = radii(plan).set_index("R")
    figure = Figure(figsize=(5, 3.4), layout="constrained")
    place = figure.add_subplot()
    for name in table:
        place.plot(table.index, table[name], marker=".", label=f"S of {name}")
    place.set_xlabel("R")
    place.set_ylabel("processor ms an iteration (11 to 16)")
    place.legend(fontsize=8)
    figure.savefig(file, dpi=100)


def large_radius_figure(plan, file):
    """Figure 16: pixel-based synthesis and ours with R = 128."""
    job = plan.large_radius("canes")
    row = [
        ("E", job.scene.exemplar),
        *((label, stored(plan.pixels("canes", label)).image) for label in JITTERS),
        ("ours, R = 128", stored(job).image),
    ]
    contact_sheet([row], file, 400)


def completion_figure(plan, file):
    """Figure 12: E, the mask, and what is filled where it is black, and where it is white."""
    exemplar = plan.completed(False).scene.exemplar
    mask = np.repeat(255 * holes(exemplar.shape[:2])[..., None], 3, axis=2).astype(np.uint8)
    rows = [
        [("E", exemplar), ("mask", mask)],
        [("black filled", stored(plan.completed(True)).image),
         ("white filled", stored(plan.completed(False)).image)],
    ]  # fmt: skip
    contact_sheet(rows, file, max(300, exemplar.shape[1] // 2))


def filled_figure(plan, file):
    """The largest hole in several exemplars: with all cures, and without each."""
    rows = []
    for name in plan.with_holes:
        job = plan.filled(name, LARGEST_HOLE)
        shown = job.scene.exemplar.copy()
        shown[hole_of(LARGEST_HOLE, shown.shape[:2])] = 0
        jobs = {"filled": job}
        jobs |= {f"without {cure}": plan.filled(name, LARGEST_HOLE, cure) for cure in CURES}
        rows.append([(name, shown), *((title, stored(job).image) for title, job in jobs.items())])
    contact_sheet(rows, file, 256)


def labels_figure(plan, file):
    """Figure 13: several exemplars."""
    job = plan.labelled()
    labels = np.repeat(255 * holes(job.scene.shape)[..., None], 3, axis=2).astype(np.uint8)
    others = load_texture(job.method.other).exemplar
    row = [
        ("E, black", job.scene.exemplar), ("E, white", others), ("labels", labels),
        ("E[S]", stored(job).image),
    ]  # fmt: skip
    contact_sheet([row], file, 300)


def door_figure(plan, file):
    """Figure 17: a global structure."""
    job = plan.paper("door")
    contact_sheet([[("E", job.scene.exemplar), ("E[S]", stored(job).image)]], file, 400)


def sheet_figure(exemplars, plan, file):
    """Every method on some exemplars, at full size."""
    rows = []
    for name in exemplars:
        results = [
            ("default", plan.default(name)), ("one R", plan.of_one_radius(name)),
            ("paper", plan.paper(name)), ("image quilting", plan.quilting(name)),
        ]  # fmt: skip
        results += [(program.name, plan.rival(name, program)) for program in plan.rivals]
        row = [(title, stored(job).image) for title, job in results]
        rows.append([(f"{name}: E", plan.default(name).scene.exemplar), *row])
    contact_sheet(rows, file, tile=300)
