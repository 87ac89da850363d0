"""The artefacts of Heidrich 2017, each provoked by construction and each absent by construction."""

from dataclasses import replace

import numpy as np
import pytest

from eval.metrics import METRICS
from eval.metrics.background import background_broken
from eval.metrics.copying import stretched, style_border
from eval.metrics.strokes import bent_strokes, hatching_kept
from eval.metrics.wrong_things import (
    BACKGROUND,
    CAST_SHADOW,
    FOREGROUND,
    foreground_outside,
    lost_highlights,
    silhouette_lines,
    view_of,
)
from eval.outcome import Outcome
from eval.scenes import load_scene

HEIGHT, WIDTH = 60, 80
Y, X = np.mgrid[:HEIGHT, :WIDTH]
IDENTITY = np.stack([Y, X], axis=-1).astype(np.int32)
DISC = np.where((Y - 30) ** 2 + (X - 40) ** 2 < 400, FOREGROUND, BACKGROUND)


def at(image, nnf):
    return image[nnf[..., 0], nnf[..., 1]]


def hatching(angle):
    """Lines 6 pixels apart."""
    across = X * np.sin(angle) - Y * np.cos(angle)
    wave = np.uint8(127.5 + 127 * np.sin(2 * np.pi * across / 6))
    return np.repeat(wave[..., None], 3, axis=2)


def blocks(side, seed=0):
    """An NNF of square pieces from anywhere."""
    rng = np.random.default_rng(seed)
    corners = rng.integers(0, (HEIGHT - side, WIDTH - side), (HEIGHT, WIDTH, 2))
    nnf = corners[Y // side * side, X // side * side]
    return (nnf + np.stack([Y % side, X % side], axis=-1)).astype(np.int32)


def test_masks_of_the_stage():
    idmask, lightmask = np.zeros((1, 5, 3), np.uint8), np.zeros((1, 5, 3), np.uint8)
    idmask[0, :3, 0] = 255
    lightmask[0, [0, 1, 2, 3, 4], [0, 1, 2, 1, 2]] = 255
    view = view_of(idmask, lightmask)
    assert view.labels.tolist() == [[FOREGROUND] * 3 + [BACKGROUND, CAST_SHADOW]]
    assert view.highlight.tolist() == [[True, False, False, False, False]]
    assert view.lit.tolist() == [[False, True, False, False, False]]


def test_foreground_in_the_background():
    assert foreground_outside(DISC, DISC) == 0
    outside = int((DISC == BACKGROUND).sum())
    spot = DISC.copy()
    spot[2:6, 3:8] = FOREGROUND
    assert foreground_outside(spot, DISC) == 20 / outside
    assert foreground_outside(np.full_like(DISC, BACKGROUND), DISC) == 0


def test_lines_at_the_silhouette():
    """A ring of background around the disc takes the disc's paint; far from it nothing counts."""
    assert silhouette_lines(DISC, DISC) == 0
    ring = np.where((Y - 30) ** 2 + (X - 40) ** 2 < 22**2, FOREGROUND, BACKGROUND)
    assert silhouette_lines(ring, DISC) > 0.25
    far = DISC.copy()
    far[:4] = FOREGROUND
    assert silhouette_lines(far, DISC) == 0


def test_lost_highlights():
    idmask, lightmask = np.zeros((2, HEIGHT, WIDTH, 3), np.uint8)
    idmask[DISC == FOREGROUND, 0] = 255
    lightmask[..., 1] = 255
    lightmask[20:26, 40:50] = 255, 0, 0
    view = view_of(idmask, lightmask)
    style = np.full((HEIGHT, WIDTH, 3), (200, 40, 30), np.uint8)
    style[view.highlight] = 250, 240, 230
    assert lost_highlights(style, style, view, view) == 0
    image = style.copy()
    image[20:26, 40:45] = 200, 40, 30
    assert lost_highlights(image, style, view, view) == 0.5


def test_the_styles_border_shows_where_pieces_run_into_it():
    assert style_border(IDENTITY, (HEIGHT, WIDTH)) == 0
    anywhere = np.random.default_rng(0).integers(0, (HEIGHT, WIDTH), (400, 400, 2))
    assert style_border(anywhere, (HEIGHT, WIDTH)) == pytest.approx(1, abs=0.05)
    shifted = np.maximum(IDENTITY - (0, 30), 0)
    assert style_border(shifted, (HEIGHT, WIDTH)) > 3
    assert style_border(IDENTITY[:10, :10], (HEIGHT, WIDTH)) == 0


def test_structures_that_are_stretched_or_squeezed():
    assert stretched(IDENTITY) == 0
    assert stretched(blocks(10)) < 0.02  # seams are no stretching
    twice = np.stack([Y // 2, X], axis=-1)
    assert stretched(twice) == pytest.approx(0.25, abs=0.02)  # half of the pairs below
    squeezed = np.stack([Y, np.minimum(2 * X, WIDTH - 1)], axis=-1)
    assert stretched(squeezed) > 0.4
    assert stretched(IDENTITY[:1, :1]) == 0


def test_strokes_that_are_bent():
    style = hatching(0.6)
    assert bent_strokes(style, style, IDENTITY) == 0
    turned = hatching(0.6 + np.radians(30))
    assert bent_strokes(turned, style, IDENTITY) == pytest.approx(30, abs=3)
    mirrored = hatching(0.6 + np.pi / 2)
    assert bent_strokes(mirrored, style, IDENTITY) == pytest.approx(90, abs=3)
    flat = np.full_like(style, 9)
    assert bent_strokes(flat, flat, IDENTITY) == 0


def test_hatching_that_is_broken():
    style = hatching(0.6)
    assert hatching_kept(style, style, IDENTITY) == 1
    whole = hatching_kept(at(style, blocks(20)), style, blocks(20))
    broken = hatching_kept(at(style, blocks(5)), style, blocks(5))
    assert whole > 0.9
    assert broken < 0.75
    assert hatching_kept(np.full_like(style, 9), np.full_like(style, 9), IDENTITY) == 1


def test_background_that_does_not_go_on():
    """Behind the source's disc the style shows none of it; the target has no disc."""
    style = hatching(0.6)
    style[DISC == FOREGROUND] = 200, 30, 30
    source, everywhere = DISC == BACKGROUND, np.ones(DISC.shape, np.bool_)
    assert background_broken(hatching(0.6), style, source, everywhere) < 3
    pieces = hatching(0.6)
    pieces[DISC == FOREGROUND] = at(pieces, blocks(6))[DISC == FOREGROUND]
    assert background_broken(pieces, style, source, everywhere) > 15
    assert background_broken(style, style, source, everywhere) > 50  # the disc's own paint
    assert background_broken(style, style, everywhere, everywhere) is None


@pytest.fixture(scope="module")
def scene():
    """The source's own view as target, so that the painting is the perfect picture."""
    read = load_scene("golem/oil", step=2, buffers=("LIGHTMASK",))
    return replace(
        read,
        target_guides=read.source_guides,
        ids=(read.ids[0],) * 2,
        buffers={name: (source,) * 2 for name, (source, _) in read.buffers.items()},
    )


def measured(scene, image, nnf):
    names = "background", "copying", "strokes", "wrong_things"
    outcome = Outcome(image, 0.0, nnf=nnf)
    return {
        name: number
        for metric in names
        for name, number in METRICS[metric].measure(scene, outcome).items()
    }


def test_the_painting_itself_has_no_artefact(scene):
    height, width = scene.style.shape[:2]
    own = np.stack(np.mgrid[:height, :width], axis=-1)
    assert measured(scene, scene.style, own) == {
        "style_border": 0, "stretched": 0, "bent": 0, "hatching": 1, "wrong_id": 0,
        "foreground_outside": 0, "silhouette_lines": 0, "lost_highlights": 0,
    }  # fmt: skip


def test_a_picture_of_nothing_but_wall_has_many(scene):
    height, width = scene.style.shape[:2]
    nnf = np.stack(np.mgrid[:height, :width], axis=-1) % (12, 20)
    numbers = measured(scene, at(scene.style, nnf), nnf)
    assert numbers["wrong_id"] > 0.15
    assert numbers["lost_highlights"] > 0.5
    assert numbers["silhouette_lines"] > 0.4
    assert numbers["foreground_outside"] == 0


def test_without_masks_or_an_nnf_nothing_is_claimed():
    plain = load_scene("golem/oil", step=6)
    assert measured(plain, plain.style, None) == {}
