"""How λ changes the result (thesis 4.2, 4.3)."""

from dataclasses import replace

import pandas as pd
from tqdm import tqdm

from eval.figures import comparison, detailed_window
from eval.measures import COLUMNS, DEFINITIONS, formatted, measure
from eval.report import table, write_report
from eval.runs import run
from eval.sharpness import detail
from stylit_ref import Params, write_image

UNIFORMITIES = (0, 5000, 10000, 15000)
_BAR = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


def lambda_report(scene, folder, seed=0, pictures=True):
    """Stylize a scene at four λ and write images, numbers and a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    seed : int
    pictures : bool
        False leaves out every image, for scenes that are not ours to show.

    Returns
    -------
    pandas.DataFrame
    """
    folder.mkdir(parents=True, exist_ok=True)
    rows, images = [], []
    with tqdm(total=len(UNIFORMITIES), bar_format=_BAR, disable=None) as bar:
        for done, uniformity in enumerate(UNIFORMITIES):
            params = replace(Params(), uniformity=uniformity)

            def show(step, done=done, uniformity=uniformity):
                phi = step.delta + step.penalization
                bar.set_description_str(f"λ = {uniformity}, φ {phi:.0f}", refresh=False)
                bar.update(done + step.done - bar.n)

            rows.append({"λ": uniformity, **measure(scene, params, seed, show)})
            image = run(scene, params, seed).image
            images.append((uniformity, image))
            bar.update(done + 1 - bar.n)
    frame = pd.DataFrame(rows)
    frame.to_csv(folder / "lambda.csv", index=False)

    if pictures:
        _save_pictures(scene, folder, images)
    write_report(
        folder,
        f"λ on {scene.name}, {scene.size}",
        [
            *["![style, target and results](lambda.png)"] * pictures,
            table(formatted(frame)),
            _washout(frame),
            f"Patch width 5, 6 levels (fewer where the image is too small), 6 votes, 6 PatchMatch "
            f"iterations, μ = 2, seed {seed}. Times are of the synthesis, compiled before.",
            DEFINITIONS,
        ],
    )
    return frame


def _save_pictures(scene, folder, images):
    """Every result at full size, and all side by side with the style and the full render."""
    for uniformity, image in images:
        write_image(folder / f"lambda_{uniformity}.png", image)
    guide = scene.shown_guide
    results = [(f"λ = {uniformity}", image) for uniformity, image in images]
    comparison(
        folder / "lambda.png",
        [[("style", scene.style), ("target guide", guide), *results]],
        detailed_window(detail(guide)),
    )


def _washout(frame):
    """Whether wash-out at λ = 0 (thesis 4.3) shows, in numbers."""
    zero, default = (frame[frame["λ"] == value].iloc[0] for value in (0, 10000))
    lines = ["Wash-out at λ = 0 (thesis 4.3), against λ = 10000:", ""]
    for name, low in (
        ("sharpness", "voting blurs more"),
        ("richness", "smoother parts of the style are used"),
        ("distinct", "patches repeat"),
    ):
        verdict = low if zero[name] < default[name] else "no wash-out by this measure"
        lines.append(f"- {COLUMNS[name][0]} {zero[name]:.3f} and {default[name]:.3f}: {verdict};")
    return "\n".join(lines)[:-1] + "."
