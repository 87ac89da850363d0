"""Adding a rival, a metric or a report edits no file: each is tried on a copy of the code."""

import pytest
from code_copy import CodeCopy

RIVAL = '''"""The target's guide in the place of a painting."""

from dataclasses import dataclass

from eval.outcome import Outcome


@dataclass(frozen=True)
class Unpainted:
    """The guide itself, so many steps darker."""

    darker: int = 0

    name = "unpainted"
    code = "1"
    device = "any"
    cost = 0.1

    def run(self, scene, seed, progress=None):
        return Outcome(scene.target_guides[0] - self.darker, seconds=0.5)
'''

METRIC = '''"""How bright a picture is."""

from eval.number import Number

NUMBERS = {"brightness": Number("brightness", "{:.1f}")}

DEFINITION = "- **brightness**: mean over all pixels."


def measure(scene, outcome):
    return {"brightness": float(outcome.image.mean())}
'''

REPORT = '''"""How a scene is called."""

from eval.pages.options import add_scene, scene_of


def add_options(parser):
    add_scene(parser, "golem/oil")
    parser.add_argument("--loud", action="store_true")


def main(options):
    name = scene_of(options).name
    print(name.upper() if options.loud else name)
    return 0
'''

SCENE = """
import numpy as np
from eval.scenes import Scene
grey = np.full((20, 20, 3), 90, np.uint8)
scene = Scene("grey", None, ("a",), grey, (grey,), (grey,), 1)
"""


@pytest.fixture
def code(tmp_path):
    """A copy of the code."""
    return CodeCopy(tmp_path, ("eval", "stylit_ref", "gpu_cuda", "data_gen"))


@pytest.mark.slow
def test_a_rival_is_a_file(code):
    code.add("eval/methods/unpainted.py", RIVAL)
    said = code.python(
        "-c",
        SCENE
        + """
from eval.methods.unpainted import Unpainted
from eval.runs.complete import Task, complete
from eval.runs.job import Job
from eval.runs.store import numbers_of, stored
jobs = [Job(scene, Unpainted(darker)) for darker in (0, 40)]
metrics = ("energy", "usage", "sharpness", "spilling", "split_delta")
assert complete([Task(job, metrics) for job in jobs]) == {}
runs = [stored(job) for job in jobs]
print([int(run.image.mean()) for run in runs], [run.guide_map for run in runs])
print(sorted(numbers_of(jobs[0])))
""",
    )
    assert said.splitlines() == ["[90, 50] [None, None]", "['richness']"]
    (run, other) = sorted(file.name for file in (code.folder / "build/runs").iterdir())
    assert run.startswith("grey_20x20-unpainted-seed_0-")
    assert other != run
    assert not code.edited


@pytest.mark.slow
def test_a_metric_is_a_file_and_measured_of_runs_that_are_stored(code):
    code.add("eval/methods/unpainted.py", RIVAL)
    measures = (
        SCENE
        + """
from eval.methods.unpainted import Unpainted
from eval.runs.job import Job
from eval.runs.local import numbers
print(numbers(Job(scene, Unpainted()), METRICS))
"""
    )
    assert "richness" in code.python("-c", f"METRICS = ['sharpness']{measures}")
    (file,) = (code.folder / "build/runs").iterdir()
    made = file.stat().st_mtime_ns
    code.add("eval/metrics/brightness.py", METRIC)
    assert code.python("-c", f"METRICS = ['brightness']{measures}") == "{'brightness': 90.0}\n"
    assert file.stat().st_mtime_ns == made
    said = code.python(
        "-c",
        "import pandas as pd; from eval.metrics import definitions\n"
        "from eval.pages.tables import formatted, table\n"
        "print(table(formatted(pd.DataFrame({'brightness': [90.0]}))))\n"
        "print(definitions(['brightness']))",
    )
    assert "| brightness   |" in said
    assert said.endswith("- **brightness**: mean over all pixels.\n")
    assert not code.edited


@pytest.mark.slow
def test_a_report_is_a_file(code):
    code.add("eval/reports/called.py", REPORT)
    assert code.python("-m", "eval", "called", "--scene", "hand/pen", "--loud") == "HAND_PEN\n"
    assert "How a scene is called." in code.python("-m", "eval", "--help")
    assert not code.edited


CODES = """
from eval.metrics import CODES
from eval.methods.image_analogies import ImageAnalogies
from eval.methods.stylit_ref import StylitRef
print(CODES["image_energy"], CODES["sharpness"], ImageAnalogies().code, StylitRef().code)
"""


@pytest.mark.slow
def test_what_is_stored_is_kept_under_the_code_it_ran(code):
    """Image energy runs the library's search, whoever made the picture; sharpness does not."""
    names = "image_energy", "sharpness", "image_analogies", "ref"

    before = code.python("-c", CODES).split()

    def changed(path, old, new):
        file = code.folder / path
        text = file.read_text(encoding="utf-8")
        assert old in text
        file.write_text(text.replace(old, new, 1), encoding="utf-8")
        after = code.python("-c", CODES).split()
        file.write_text(text, encoding="utf-8")
        pairs = zip(names, before, after, strict=True)
        return {name for name, old_code, new_code in pairs if old_code != new_code}

    formula = "stylit_ref/formulae/candidates.py"
    assert changed(formula, "import numpy", "# A comment.\nimport numpy") == set()
    assert changed(formula, '"""', '"""So it is that ') == set()
    assert changed("gpu_cuda/passes/commit.py", "import numpy", "import os\nimport numpy") == set()
    assert changed(formula, "return ", "return 1 and ") == {"image_energy", "ref"}
    analogies = "eval/methods/image_analogies.py"
    assert changed(analogies, "NEAREST = 8", "NEAREST = 9") == {"image_analogies"}
    assert changed("eval/metrics/sharpness.py", "SIGMA = 1.0", "SIGMA = 2.0") == {"sharpness"}
