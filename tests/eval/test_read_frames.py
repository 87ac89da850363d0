"""Views and their motion from a data set."""

import numpy as np
import pytest

from data_gen.manifest import Manifest
from data_gen.multilayer_exr import write_layers
from eval.metrics.warping import warping_error
from eval.read_frames import GUIDES, read_frames
from eval.scenes import BUNDLED
from stylit_ref import InputError, write_image
from stylit_ref.views.frames import grid_pairs


def test_the_bundled_house_is_a_grid():
    house = read_frames("house", "oil", BUNDLED)
    assert (house.name, house.frames, house.size) == ("house_oil", 9, "300x228")
    assert list(map(len, house.guides)) == [len(GUIDES)] * 9
    assert house.edges.keys() == set(grid_pairs(3, 3))
    right, wrong = (
        warping_error(house.renderings, edges, [(0, 1), (3, 0)])
        for edges in (house.edges, {pair[::-1]: motion for pair, motion in house.edges.items()})
    )
    assert right < 3 < wrong
    np.testing.assert_array_equal(house.renderings[4], house.guides[4][0])
    assert 16 < np.median(house.depths[4][house.depths[4] > 0]) < 24
    assert (house.depths == 0).any()


def test_of_a_sequence_the_first_frames_are_read(tmp_path):
    manifest = Manifest.open(tmp_path / "shot")
    for name in ("sketched_walk", "walk/00", "walk/01", "walk/02"):
        folder = manifest.folder / name
        folder.mkdir(parents=True)
        if name == "sketched_walk":
            (folder / "sketches").mkdir()
            write_image(folder / "sketches/wash.png", np.full((5, 7, 3), 99, np.uint8))
        for layer in ("FULL", "IDMASK", "DEPTH"):
            write_image(folder / f"{layer}.png", np.full((5, 7, 1), int(name[-1], 36), np.uint8))
        manifest.add(name)
    (manifest.folder / "walk/motion").mkdir()
    layers = {"MOTION": np.ones((5, 7, 2)), "VISIBLE": np.eye(5, 7)[..., None]}
    for to, other in ((0, 1), (1, 0), (1, 2), (2, 1)):
        file = manifest.folder / f"walk/motion/{to:02}_to_{other:02}.exr"
        write_layers(file, {name: np.float32(layer) for name, layer in layers.items()})
    manifest.add("walk/motion")
    walk = read_frames("walk", "wash", manifest.folder, ("FULL",), 2)
    assert (walk.style == 99).all()
    assert [int(frame[0][0, 0, 0]) for frame in walk.guides] == [0, 1]
    assert walk.edges.keys() == {(0, 1), (1, 0)}
    np.testing.assert_array_equal(walk.edges[1, 0].visible, np.eye(5, 7) > 0)


def test_a_mesh_beside_the_views_is_no_view(tmp_path):
    manifest = Manifest.open(tmp_path / "shot")
    for name in ("sketched_walk", "walk/00", "walk/mesh"):
        (manifest.folder / name).mkdir(parents=True)
    (manifest.folder / "sketched_walk/sketches").mkdir()
    images = [f"{view}/{layer}" for view in ("sketched_walk", "walk/00")
              for layer in ("FULL", "IDMASK", "DEPTH")]  # fmt: skip
    for image in ("sketched_walk/sketches/wash", *images):
        write_image(manifest.folder / f"{image}.png", np.full((5, 7, 3), 99, np.uint8))
    (manifest.folder / "walk/mesh/scene.obj").touch()
    for name in ("sketched_walk", "walk/00", "walk/mesh"):
        manifest.add(name)
    assert read_frames("walk", "wash", manifest.folder, ("FULL",)).frames == 1


def test_what_is_not_there_is_one_sentence(tmp_path):
    with pytest.raises(InputError, match="holds no views of castle"):
        read_frames("castle", "oil", BUNDLED)
    with pytest.raises(InputError, match=r"no style gouache over source; there are crayon, oil"):
        read_frames("house", "gouache", BUNDLED)
    with pytest.raises(InputError, match="holds no manifest"):
        read_frames("house", "oil", tmp_path)
