"""How λ changes the result (thesis 4.2, 4.3)."""

from dataclasses import replace

import pandas as pd
from tqdm import tqdm

from eval.figures import comparison, detailed_window
from eval.measures import DEFINITIONS, formatted, measure
from eval.report import table, write_report
from eval.runs import run
from eval.sharpness import detail
from stylit_ref import Params, write_image

UNIFORMITIES = (0, 5000, 10000, 15000)
_BAR = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


def lambda_report(scene, folder, seed=0):
    """Stylize a scene at four λ and write images, numbers and a page.

    Parameters
    ----------
    scene : Scene
    folder : Path
    seed : int

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
            write_image(folder / f"lambda_{uniformity}.png", image)
            images.append((f"λ = {uniformity}", image))
            bar.update(done + 1 - bar.n)
    frame = pd.DataFrame(rows)
    frame.to_csv(folder / "lambda.csv", index=False)

    guide = scene.target_guides[_shown_guide(scene)]
    comparison(
        folder / "lambda.png",
        [[("style", scene.style), ("target guide", guide), *images]],
        detailed_window(detail(guide)),
    )
    write_report(
        folder,
        f"λ on {scene.name}, {scene.size}",
        [
            "![style, target and results](lambda.png)",
            table(formatted(frame)),
            _washout(frame),
            f"Patch width 5, 6 levels (fewer where the image is too small), 6 votes, 6 PatchMatch "
            f"iterations, μ = 2, seed {seed}. Times are of the synthesis, compiled before.",
            DEFINITIONS,
        ],
    )
    return frame


def _shown_guide(scene):
    """The full render where there is one."""
    names = scene.guide_names
    return names.index("fullgi") if "fullgi" in names else 0


def _washout(frame):
    """Whether wash-out at λ = 0 (thesis 4.3) shows, in numbers."""
    zero, default = (frame[frame["λ"] == value].iloc[0] for value in (0, 10000))
    names = {"sharpness": "sharpness", "richness": "richness", "distinct": "distinct assigned"}
    changes = ", ".join(
        f"{title} {zero[name]:.3f} against {default[name]:.3f}" for name, title in names.items()
    )
    shows = "shows" if zero["richness"] < default["richness"] else "does not show"
    return (
        f"Wash-out at λ = 0 (thesis 4.3) {shows} as less fine detail than at λ = 10000: {changes}."
    )
