"""The page's passes against the vectors of ``oracle/interpolation``: from the places on exact.

A page finds motion itself, so vectors of the stage ``shift`` cannot be given to it. Those of
``transfer`` can: what is seen, and two cameras. With the faces of ``shift`` they lead to places.
"""

from pathlib import Path

import numpy as np
import pytest

from oracle.cases import read_cases
from oracle.families import INTERPOLATION
from oracle.stages import run_case
from stylit_ref.views.interpolation import passes

pytestmark = pytest.mark.slow  # a browser is a process of its own

VERSION = INTERPOLATION.versions[-1]
RUN_PASS, RUN_SHIFT = (
    Path(__file__).with_name(name).read_text(encoding="utf-8")
    for name in ("run_pass.js", "run_shift.js")
)
STAGES = "vote", "fetch", "search", "mix", "mix_shifted", "frame"
CASES = {case.title: case for case in read_cases(VERSION, STAGES)}
NOT_OF_PAGES = {"search/three"}
"""A fourth channel, which pages do not have, counts in the search."""

WHOLE = 65536


@pytest.fixture(scope="module", params=["webgl", "script"])
def page(request, open_shared_page, page_file):
    return open_shared_page(page_file, f"?engine={request.param}").started().page


@pytest.mark.parametrize("title", sorted(set(CASES) - NOT_OF_PAGES))
def test_a_pass_gives_what_it_must(page, title):
    case = CASES[title]
    (expected,) = case.expected.values() if case.stage != "fetch" else [case.expected["nnf"]]
    height, width = expected.shape[:2]
    given = {
        "width": width, "height": height, "radius": case.parameters.get("patch_width", 5) // 2,
        "style": image(case.arrays.get("style", np.zeros((20, 20, 3), np.uint8))),
        "weights": [WHOLE],
    } | GIVEN[case.stage](case)  # fmt: skip
    found = np.array(page.evaluate(RUN_PASS, given)).reshape(height, width, -1)
    channels = min(expected.shape[2], 3 if given["buffer"] not in ("shifted", "searched") else 2)
    assert np.array_equal(found[..., :channels], expected[..., :channels])


@pytest.mark.parametrize("name", ["turned", "same", "lens", "behind"])
@pytest.mark.parametrize("faces", ["four", "far"])
def test_places_are_those_of_the_vectors(page, name, faces):
    """At least 998 of 1000, says the text; here there are fewer pixels than that."""
    seen = read("transfer", name)
    inverse = seen.arrays["inverse"]
    pixels = np.moveaxis(np.mgrid[: inverse.shape[0], : inverse.shape[1]], 0, -1)[..., ::-1]
    motion = (seen.expected["seen"] - pixels).astype(np.float32)[None]
    a = read("shift", faces).arrays
    a = a | {"motion": motion, "view_labels": a["view_labels"][:1]}
    expected = run_case(INTERPOLATION, "shift", {}, a, passes)
    given = {
        "width": inverse.shape[1], "height": inverse.shape[0], "inverse": flat(inverse),
        "faces": flat(a["labels"] & 65535), "viewFaces": flat(a["view_labels"] & 65535),
        "beside": places_of(a["beside"][None], np.zeros(motion.shape[:3], bool))[0],
        "lens": lens(seen.arrays["camera"]), "viewLens": lens(seen.arrays["other"]),
    }  # fmt: skip
    assert page.evaluate(RUN_SHIFT, given) == places_of(**expected)[0]


def read(stage, name):
    (case,) = (case for case in read_cases(VERSION, [stage]) if case.name == name)
    return case


def lens(camera):
    """A camera's matrix as the page has it."""
    rays = np.linalg.inv(camera[:, :3])
    across, down, depth = camera.tolist()
    right, below, corner = rays.T.tolist()
    eye = (-rays @ camera[:, 3]).tolist()
    return {
        "across": across, "down": down, "depth": depth, "eye": eye, "near": 0.01,
        "right": right, "below": below, "corner": corner,
    }  # fmt: skip


def of_vote(case):
    nnf = case.arrays["nnf"]
    places = places_of(*itself(1, nnf.shape[:2]))
    views = [{"field": flat(nnf)}]
    return {"mode": "nnf", "buffer": "voted", "views": views, "places": places}


def of_fetch(case):
    return shifting(case.arrays, "nnf", "shifted")


def of_search(case):
    a = case.arrays
    places, _ = itself(len(a["candidates"]), a["nnf"].shape[:2])
    masked = a["candidates"][..., 0] < 0
    given = {"nnfs": np.maximum(a["candidates"], 0), "places": places, "masked": masked}
    kept = {"shifted": flat(a["nnf"]), "voted": image(a["picture"])["rgba"]}
    return shifting(given, "limited", "searched") | kept


def of_mix(case):
    views = [{"picture": image(picture)["rgba"]} for picture in case.arrays["pictures"]]
    weights = case.arrays["weights"].tolist()
    return {"mode": "linear", "buffer": "mixed", "views": views, "weights": weights}


def of_mix_shifted(case):
    places = places_of(case.arrays["places"], case.arrays["masked"])
    return of_mix(case) | {"mode": "blend", "places": places}


def of_frame(case):
    a = case.arrays
    given = a | run_case(INTERPOLATION, "shift", {}, dict(a), passes)
    weights = case.parameters["weights"]
    buffer = "mixed" if np.count_nonzero(weights) > 1 else "frame0"
    return shifting(given, "fade", buffer) | {"weights": weights}


GIVEN = {
    "vote": of_vote, "fetch": of_fetch, "search": of_search,
    "mix": of_mix, "mix_shifted": of_mix_shifted, "frame": of_frame,
}  # fmt: skip


def shifting(arrays, mode, buffer):
    views = [{"field": flat(nnf)} for nnf in arrays["nnfs"]]
    places = places_of(arrays["places"], arrays["masked"])
    weights = [WHOLE] + [0] * (len(views) - 1)
    return {"mode": mode, "buffer": buffer, "views": views, "places": places, "weights": weights}


def itself(count, size):
    """Places and masks of views that do not move."""
    places = np.moveaxis(np.mgrid[: size[0], : size[1]], 0, -1)
    return np.stack([places] * count), np.zeros((count, *size), bool)


def places_of(places, masked):
    numbers = places[..., 0] * places.shape[2] + places[..., 1]
    return [flat(view) for view in np.where(masked, ~numbers, numbers)]


def image(colours):
    """Grey as three channels; of more than three the first ones."""
    height, width, channels = colours.shape
    rgba = np.full((height, width, 4), 255, np.uint8)
    rgba[..., :3] = colours[..., : 1 if channels == 1 else 3]
    return {"width": width, "height": height, "rgba": flat(rgba)}


def flat(array):
    return array.ravel().tolist()
