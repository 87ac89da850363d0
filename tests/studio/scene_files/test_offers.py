"""Scenes of folders and of EXR files: what there is to pick from, and what is picked."""

import numpy as np
import pytest
from exr_files import write_exr
from studio.small_studio import SIZE, TARGET_SIZE, write_passes

from stylit_ref import InputError, read_image, write_image
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS
from stylit_ref.studio.scene_files.layers_in import layers_in
from stylit_ref.studio.scene_files.offer import offer_of_files


def offered(folder, source_layers, target_layers):
    source = write_passes(folder / "source", SIZE, source_layers)
    return offer_of_files("it", source, write_passes(folder / "it", TARGET_SIZE, target_layers))


def test_the_seven_passes_of_the_thesis_are_picked(tmp_path):
    names = (*STAGE_BUFFERS, "NORMAL", "DEPTH")
    offer = offered(tmp_path, names, (*names, "WIREFRAME"))
    assert set(offer.layers) == set(names)
    assert offer.usual == STAGE_BUFFERS
    assert (offer.size, offer.target_size) == (SIZE, TARGET_SIZE)


def test_of_others_pictures_and_labels_are_picked(tmp_path):
    offer = offered(tmp_path, ("FULL", "DIFFUSE", "NORMAL", "IDMASK"), ("FULL", "NORMAL", "IDMASK"))
    assert offer.layers == ("FULL", "IDMASK", "NORMAL")
    assert offer.usual == ("FULL", "IDMASK")


def test_a_scene_has_the_bytes_of_its_files(tmp_path):
    offer = offered(tmp_path, ("FULL", "LDE"), ("FULL", "LDE"))
    scene = offer.read(["LDE"])
    assert scene.buffers == ("LDE",)
    assert np.array_equal(scene.source["LDE"], read_image(tmp_path / "source" / "LDE.png"))
    assert np.array_equal(scene.target(0)["LDE"], read_image(tmp_path / "it" / "LDE.png"))
    assert scene.layers == offer.layers
    with pytest.raises(InputError, match="no layer 'NONE'"):
        offer.read(["NONE"])


def test_files_are_matched_by_the_end_of_their_names(tmp_path):
    for name, size in (("sphere", SIZE), ("robot", TARGET_SIZE)):
        (tmp_path / name).mkdir()
        write_image(tmp_path / name / f"{name}_full.png", np.zeros((*size, 3), np.uint8))
    assert offer_of_files("it", tmp_path / "sphere", tmp_path / "robot").layers == ("FULL",)


def test_scenes_without_a_common_layer_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"it: has no layer .* called FULL, here LDE"):
        offered(tmp_path, ("FULL",), ("LDE",))


@pytest.mark.parametrize("what", ["nothing", "empty", "text.txt"])
def test_what_holds_no_images_is_refused(tmp_path, what):
    (tmp_path / "empty").mkdir()
    (tmp_path / "text.txt").write_text("no image")
    with pytest.raises(InputError, match=what):
        layers_in(tmp_path / what)


def test_layers_of_an_exr_are_picked_by_name(tmp_path):
    channels = {f"ViewLayer.{layer}.{c}": 0.25 for layer in ("Combined", "DiffDir") for c in "RGB"}
    channels["ViewLayer.Depth.Z"] = 1.0
    source = write_exr(tmp_path / "sphere.exr", channels)
    target = write_exr(tmp_path / "robot.exr", {**channels, "ViewLayer.Mist.Z": 1.0}, (5, 7))
    offer = offer_of_files("it", source, target)
    assert offer.layers == tuple(f"VIEWLAYER.{name}" for name in ("COMBINED", "DEPTH", "DIFFDIR"))
    assert offer.usual == ("VIEWLAYER.COMBINED", "VIEWLAYER.DIFFDIR")
    scene = offer.read(["VIEWLAYER.DIFFDIR"])
    assert scene.files.targets == ((f"{target}:ViewLayer.DiffDir",),)
    assert scene.target(0)["VIEWLAYER.DIFFDIR"].shape == (5, 7, 3)
    assert offer.rendering().shape == (6, 8, 3)
    assert not offer.things().any()
