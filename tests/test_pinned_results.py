"""The bytes of the canonical schedule.

Computed before the first speed-up and kept by every one since. Whoever changes one of
them has changed the schedule, not its speed: say so, and measure the new one.
"""

import hashlib

import numpy as np
import pytest

from eval.scenes import load_scene
from stylit_ref import Params, stylize

CASES = {
    "defaults": ({}, np.s_[:], False),
    "wide patch without penalization": ({"patch_width": 7, "uniformity": 0}, np.s_[:2], False),
    "even use of a grey style, masked": ({"uniformity": 100000, "levels": 2}, np.s_[1:], True),
    "scanline": (
        {"schedule": "scanline", "levels": 2, "patchmatch_iterations": 2},
        np.s_[:],
        False,
    ),
}
PINNED = {
    "defaults": "9e68709bfbaed3c6",
    "wide patch without penalization": "0cce29abe8479421",
    "even use of a grey style, masked": "8b494a567343b208",
    "scanline": "4212de0f314fde5c",
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("threads", [None, 1])
def test_bytes(case, threads):
    values, guides, grey = CASES[case]
    scene = load_scene("golem/crayon", step=3)
    mask = np.zeros(scene.target_guides[0].shape[:2], bool)
    mask[20:50, 30:60] = grey
    result = stylize(
        scene.style[:, :, 1] if grey else scene.style,
        scene.source_guides[guides],
        scene.target_guides[guides],
        Params(**({"levels": 3, "votes": 2, "patchmatch_iterations": 3} | values)),
        seed=11,
        mask=mask if grey else None,
        threads=threads,
    )
    digest = hashlib.sha256(result.nnf.tobytes() + result.image.tobytes()).hexdigest()
    assert digest[:16] == PINNED[case]
