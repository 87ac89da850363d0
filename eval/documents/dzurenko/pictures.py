"""The figures of chapters 1, 2, 4 and 5, of our scenes."""

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from eval.documents.dzurenko.printed import EPSILONS, UNIFORMITIES
from eval.documents.dzurenko.tables import seconds_of
from eval.metrics.sharpness import detail
from eval.pages.figures import comparison, contact_sheet, detailed_window
from eval.runs.store import numbers_of, stored

MAPS_SHOWN = (100, 500, 5000)


def lambda_figure(plan, target, file):
    """Figures 4.1 to 4.7: style, target guide, StyLit, then λ rising, each with its zoom-in."""
    scene = plan.scenes[target]
    first = [
        ("(a) style", scene.style),
        ("(b) target guide", scene.shown_guide),
        ("(c) StyLit", stored(plan.stylit(target)).image),
    ]
    rising = [
        (f"({'defghi'[k]}) λ = {uniformity}", stored(plan.ref(target, uniformity)).image)
        for k, uniformity in enumerate(UNIFORMITIES)
    ]
    rows = [[*first, *rising[:2]], rising[2:]]
    comparison(rows, detailed_window(detail(scene.shown_guide)), file)


def epsilon_figure(plan, target, file):
    """Figures 5.2 to 5.8: style, guide, StyLit, ref, then ε rising, and guide maps."""
    scene = plan.scenes[target]
    first = [
        ("(a) style", scene.style),
        ("(b) target guide", scene.shown_guide),
        ("(c) StyLit", stored(plan.stylit(target)).image),
        ("(d) ref, λ = 10000", stored(plan.ref(target)).image),
    ]
    runs = {epsilon: stored(plan.guide_map(target, epsilon)) for epsilon in EPSILONS}
    rising = [
        (f"({'efghijkl'[k]}) ε = {epsilon}", run.image)
        for k, (epsilon, run) in enumerate(runs.items())
    ]
    maps = [
        (f"guide map, ε = {epsilon}", runs[epsilon].guide_map[:, :, None] * np.uint8(255))
        for epsilon in MAPS_SHOWN
    ]
    rows = [[*first, rising[0]], rising[1:6], [*rising[6:], *maps]]
    comparison(rows, detailed_window(detail(scene.shown_guide)), file)


def background_figure(plan, file):
    """Figure 1.1, without Gatys et al. and Bénard et al."""
    target = plan.background
    scene = plan.scenes[target]
    row = [
        ("(a) style", scene.style),
        ("(b) target guide", scene.shown_guide),
        ("(d) Image Analogies", stored(plan.image_analogies(target)).image),
        ("(f) λ = 0 (Wexler et al.)", stored(plan.ref(target, 0)).image),
    ]
    second = [
        ("(g) uniform usage", stored(plan.uniform_usage(target)).image),
        ("(h) StyLit", stored(plan.stylit(target)).image),
        ("(i) ref, λ = 10000", stored(plan.ref(target)).image),
    ]
    comparison([row, second], detailed_window(detail(scene.shown_guide)), file)


def pyramid_figure(plan, file):
    """Figure 2.3: B' as it leaves each level."""
    levels = stored(plan.ref(plan.background)).levels
    sizes = ["{1}x{0}".format(*image.shape) for image in levels]
    contact_sheet([list(zip(sizes, levels, strict=True))], file)


def energy_figure(plan, file):
    """φ after every PatchMatch iteration, at every λ."""
    columns = min(len(plan.scenes), 4)
    rows = -(-len(plan.scenes) // columns)
    figure = Figure(figsize=(3.2 * columns, 2.6 * rows + 0.4), layout="constrained")
    for k, target in enumerate(plan.scenes):
        place = figure.add_subplot(rows, columns, k + 1)
        for uniformity in UNIFORMITIES:
            history = stored(plan.ref(target, uniformity)).history
            phi = history["delta"] + history["penalization"]
            place.plot(np.arange(1, len(phi) + 1), phi, label=f"λ = {uniformity}", linewidth=1)
        place.set_yscale("log")
        place.yaxis.set_minor_formatter(NullFormatter())
        place.set_title(target, fontsize=10)
        place.set_xlabel("PatchMatch iterations", fontsize=8)
        place.tick_params(labelsize=8)
    figure.axes[0].set_ylabel("mean φ")
    figure.axes[0].legend(fontsize=7)
    figure.savefig(file, dpi=100)


def trends_figure(plan, file):
    """Time and quality against λ and ε, a line for every target."""
    figure = Figure(figsize=(13, 6.5), layout="constrained")
    axes = figure.subplots(2, 4)
    for target in plan.scenes:
        refs = [plan.ref(target, uniformity) for uniformity in UNIFORMITIES]
        maps = [plan.guide_map(target, epsilon) for epsilon in EPSILONS]
        ref = plan.ref(target)
        for row, (values, jobs, base) in enumerate(
            ((UNIFORMITIES, refs, refs[0]), (EPSILONS, maps, ref))
        ):
            seconds = [seconds_of(job) / seconds_of(base) for job in jobs]
            axes[row, 0].plot(values, seconds, marker=".", label=target)
            for place, measure in zip(axes[row, 1:], ("patches", "guides", "style"), strict=True):
                numbers = [numbers_of(job)[measure] for job in jobs]
                place.plot(values, numbers, marker=".", label=target)
    for row, (symbol, base) in enumerate((("λ", "λ = 0"), ("ε", "ref"))):
        titles = f"time over that of {base}", "patch distance", "δ, guides", "δ, style"
        for place, title in zip(axes[row], titles, strict=True):
            place.set_title(title, fontsize=10)
            place.set_xlabel(symbol)
            place.set_xscale("symlog", linthresh=5000 if symbol == "λ" else 3)
            place.tick_params(labelsize=8)
    axes[0, 0].legend(fontsize=7)
    figure.savefig(file, dpi=100)
