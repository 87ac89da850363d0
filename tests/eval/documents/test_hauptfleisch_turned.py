"""Turned copies of a sketch: what turns with the picture, and when lines have improved."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from data_gen.camera import HOUSE
from data_gen.manifest import Manifest
from eval.documents.hauptfleisch.turned import ALONE, TOLD, TURNED, claim, shown_table, turned_scene
from eval.documents.hauptfleisch.turned_copies import (
    Turned,
    projected_direction,
    turned_back,
    with_turned_copies,
)
from eval.metrics.off_surface import DIRECTION, FACE, off_surface
from eval.pages.claims import HELD, NOT_HELD
from eval.read_frames import GUIDES
from eval.scenes import Scene
from stylit_ref import InputError, Params, write_image

HEIGHT, WIDTH = 60, 80
Y, X = np.mgrid[:HEIGHT, :WIDTH]


@pytest.mark.parametrize(
    ("normal", "line"),
    [((0.0, 0.8, 0.6), (0.0, 0.6, -0.8)), ((0.6, 0.0, 0.8), (0, 1, 0)), ((0, 1, 0), (1, 0, 0))],
    ids=["roof", "wall", "ground"],
)
def test_the_direction_is_that_of_a_short_line_on_the_surface(normal, line):
    camera = HOUSE.at(30, 8)
    normals = np.broadcast_to(
        np.uint8(np.round(127.5 * (np.array(normal) + 1))), (HEIGHT, WIDTH, 3)
    )
    found = projected_direction(normals, camera)
    for y, x in ((5, 8), (30, 40), (50, 70)):
        point = np.array(camera.origin) + 20 * camera.directions(HEIGHT, WIDTH)[y, x]
        ends = camera.project(np.stack([point, point + 1e-3 * np.array(line)]), HEIGHT, WIDTH)
        down, right = ends[1] - ends[0]
        double = 2 * np.arctan2(down, right)
        expected = 127.5 * (1 + np.array([np.cos(double), np.sin(double)]))
        # Normals on 8 bits are off by a part of a degree.
        np.testing.assert_allclose(found[y, x], expected, atol=127.5 * np.radians(2))


def test_there_is_no_direction_where_nothing_is_seen():
    nothing = np.full((HEIGHT, WIDTH, 3), 128, np.uint8)
    assert (projected_direction(nothing, HOUSE.at(0, 0)) == 128).all()


@pytest.fixture
def scene():
    """Strokes that run down a surface which descends straight down."""
    strokes = np.repeat(np.uint8(190 + 60 * np.cos(X))[..., None], 3, axis=2)
    down = np.broadcast_to(np.uint8([0, 128]), (HEIGHT, WIDTH, 2))
    face = np.zeros((HEIGHT, WIDTH, 1), np.uint8)
    grey = np.uint8(2 * X)[..., None]
    return Scene(
        "strokes", Path(), ("FULL",), strokes, (grey,), (grey,), 1,
        buffers={DIRECTION: (down, down), FACE: (face, face)},
    )  # fmt: skip


def test_strokes_and_their_direction_turn_alike(scene):
    copies = with_turned_copies(scene, (0.0, 20.0))
    assert copies.guide_names == ("FULL", DIRECTION)
    assert copies.style.shape == (HEIGHT, 2 * WIDTH, 3)
    np.testing.assert_array_equal(copies.style[:, :WIDTH], scene.style)
    inner = np.s_[15:-15, WIDTH + 20 : -20]
    direction = copies.source_guides[1][inner]
    double = np.radians(2 * (90 + 20))
    expected = 127.5 * (1 + np.array([np.cos(double), np.sin(double)]))
    np.testing.assert_allclose(direction, np.broadcast_to(expected, direction.shape), atol=1.5)
    original, face = np.s_[15:-15, 20:-20], scene.buffers[FACE][0]
    off = off_surface(
        copies.style[inner], scene.style[original],
        (direction, scene.buffers[DIRECTION][0][original]), 2 * (face[original],),
    )  # fmt: skip
    assert off < 1.5
    assert (copies.source_guides[1][0, WIDTH] == 128).all()


def test_places_in_copies_lead_back_to_the_picture(scene):
    """A guide of which every copy shows the column: after the way back it is the pixel's own."""
    angles = -20.0, 0.0, 20.0
    column = with_turned_copies(scene, angles).source_guides[0][..., 0]
    for copy in range(3):
        places = np.stack([Y, X + copy * WIDTH], axis=-1)[15:-15, 20:-20]
        back = turned_back(places, angles, (HEIGHT, WIDTH))
        shown = column[places[..., 0], places[..., 1]]
        np.testing.assert_allclose(2 * back[..., 1], shown, atol=2)


def test_a_run_tells_the_share_of_each_copy(scene):
    method = Turned(Params(levels=2, votes=1, patchmatch_iterations=1), angles=(0.0, 20.0))
    outcome = method.run(scene, 0)
    assert outcome.image.shape == scene.style.shape
    assert outcome.history["angle"].tolist() == [0.0, 20.0]
    assert outcome.history["share"].sum() == pytest.approx(1)
    assert outcome.history["share"][0] > 0.9
    assert (outcome.nnf < (HEIGHT, WIDTH)).all()


def test_a_face_is_told_by_part_plane_and_shadow(tmp_path):
    manifest = Manifest.open(tmp_path / "set")
    for view in ("sketched_house", "house/0_2"):
        for name in (*GUIDES, "IDMASK", "NORMAL", "sketches/hatched"):
            file = tmp_path / "set" / view / f"{name}.png"
            file.parent.mkdir(parents=True, exist_ok=True)
            image = np.full((6, 8, 3), 7, np.uint8)
            if name == "LIGHTMASK":
                image[:, 4:, 2] = 255
            write_image(file, image)
        manifest.add(view)
    scene = turned_scene(tmp_path / "set", (0, 2))
    assert scene.guide_names == GUIDES
    assert len(np.unique(scene.buffers[FACE][1].reshape(-1, 7), axis=0)) == 2
    with pytest.raises(InputError, match="does not list house/2_0"):
        turned_scene(tmp_path / "set", (2, 0))


def numbers(turned):
    """A table of two views in which only strokes of turned copies may differ."""
    rows = [
        {"view": view, "run": run, "off_surface": off, "crooked": 1.0, "lost_lines": 0.1}
        | {"guide_error": 3.0, "sharpness": 0.8, "richness": 1.0, "turned": 0.5, "cpu": 1.0}
        | (turned if run == TURNED else {})
        for view in ("0_0", "0_2")
        for run, off in ((ALONE, 20.0), (TOLD, 18.0), (TURNED, 5.0))
    ]
    return pd.DataFrame(rows)


@pytest.mark.parametrize(
    ("turned", "verdict"),
    [
        ({}, HELD),
        ({"off_surface": 19.0}, NOT_HELD),
        ({"crooked": 1.1}, NOT_HELD),
        ({"lost_lines": 0.12}, NOT_HELD),
        ({"guide_error": 3.2}, NOT_HELD),
        ({"sharpness": 0.6}, NOT_HELD),
    ],
)
def test_lines_improve_if_strokes_turn_and_nothing_else_gets_worse(turned, verdict):
    assert claim(numbers(turned)).verdict == verdict


def test_the_table_is_shown_with_units():
    assert shown_table(numbers({}))["strokes off the surface"].tolist()[:3] == [
        "20.0°", "18.0°", "5.0°",
    ]  # fmt: skip
