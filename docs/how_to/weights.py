"""The sheet of weights in choosing_parameters.md: ``python -m docs.how_to.weights``."""

from pathlib import Path

from eval.methods.stylit_ref import StylitRef
from eval.metrics.sharpness import richness
from eval.pages.figures import contact_sheet
from eval.runs.job import Job
from eval.runs.local import run
from eval.scenes import load_scene
from stylit_ref import Params

INFLUENCES = (0.1, 0.5, 2, 8)
HIGHLIGHTS = (0, 1, 4, 16)

scene = load_scene("teapot/oil")
highlight = scene.guide_names.index("LSE")


def weighed(weight):
    """Weights of all guides with LSE's."""
    return tuple(weight if k == highlight else 1.0 for k in range(len(scene.guide_names)))


def shown(title, **params):
    """A run and its title."""
    image = run(Job(scene, StylitRef(Params(**params)))).image
    return f"{title}, richness {richness(image, scene.style):.2f}", image


rows = [
    [
        ("style", scene.style),
        *(shown(f"--guide-influence {value:g}", guide_influence=value) for value in INFLUENCES),
    ],
    [
        ("target, FULL", scene.shown_guide),
        *(shown(f"LSE: --weight {value}", guide_weights=weighed(value)) for value in HIGHLIGHTS),
    ],
]
contact_sheet(rows, Path(__file__).with_suffix(".webp"))
