"""Ebsynth, replaced by a program that copies the style."""

import re
import sys

import numpy as np
import pytest

from eval.methods.ebsynth import Ebsynth
from eval.metrics import METRICS
from eval.scenes import load_scene
from stylit_ref import InputError

PROGRAM = """#!{python}
import sys
from pathlib import Path
from stylit_ref import read_image, write_image
Path("arguments.txt").write_text(" ".join(sys.argv))
image = read_image(sys.argv[sys.argv.index("-style") + 1])
write_image(sys.argv[sys.argv.index("-output") + 1], image[:38, :44])
"""


@pytest.mark.slow
def test_a_picture_is_all_it_gives(folder):
    program = folder.parent / "program"
    program.write_text(PROGRAM.format(python=sys.executable))
    program.chmod(0o755)
    scene = load_scene(folder)
    made = Ebsynth(str(program), uniformity=100, levels=2).run(scene, seed=0)
    np.testing.assert_array_equal(made.image, scene.style[:38, :44])
    assert made.nnf is made.omega is made.guide_map is None
    said = (folder.parent / "arguments.txt").read_text()
    assert "-uniformity 100 -pyramidlevels 2 -searchvoteiters 6 -patchmatchiters 4" in said
    assert re.findall(r"target_(\S+)\.png -weight (\S+)", said) == [
        ("fullgi", "1.5"),
        ("id", "0.5"),
    ]
    assert METRICS["sharpness"].measure(scene, made).keys() == {"richness"}
    for metric in ("energy", "usage", "split_delta", "spilling"):
        assert METRICS[metric].measure(scene, made) == {}


def test_a_program_that_is_not_there_or_fails_is_named(folder):
    with pytest.raises(InputError, match="none: is not a program that can be started"):
        Ebsynth("./none").run(load_scene(folder), seed=0)
    with pytest.raises(InputError, match="false failed with code 1"):
        Ebsynth("false").run(load_scene(folder), seed=0)
