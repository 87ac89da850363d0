"""Files that ``run`` writes."""

import os
import shutil

import numpy as np
import pytest
from cli.calls import refused, run

from stylit_ref import Params, read_image, stylize, write_image


def test_guide_maps_are_saved_with_the_levels(scene):
    folder, *arrays = scene
    more = ["--method", "guide_map", "--epsilon", 200, "--save-levels", folder / "levels"]
    assert run(folder, *more) == 0
    params = Params("guide_map", levels=2, votes=1, patchmatch_iterations=1, epsilon=200)
    expected = stylize(*arrays, params).guide_maps
    assert 0 < expected[-1].mean() < 1
    for level, white in enumerate(expected, 1):
        saved = read_image(folder / "levels" / f"guide_map_{level}.png")
        np.testing.assert_array_equal(saved[:, :, 0], white * 255)


@pytest.mark.usefixtures("nothing_written")
class TestRefusals:
    """One sentence, exit code 2, and no file."""

    @pytest.mark.parametrize(
        ("option", "value", "message"),
        [
            ("--output", "style.png/out.png", "style.png: is a file; name a folder"),
            ("--output", "out.docx", "'.docx'"),
            ("--nnf", "style.png/deep/nnf.npy", "style.png: is a file; name a folder"),
            ("--nnf", "nnf.txt", "must end in .npy"),
            ("--save-levels", "style.png", "style.png: is a file; name a folder"),
            ("--save-levels", "style.png/deep", "style.png: is a file; name a folder"),
        ],
    )
    def test_unwritable_outputs(self, scene, capsys, option, value, message):
        assert message in refused(capsys, run(scene[0], option, scene[0] / value))

    @pytest.mark.parametrize("taken", ["style.png", "source_0.png", "mask.png"])
    def test_outputs_that_would_overwrite_inputs(self, scene, capsys, taken):
        folder = scene[0]
        write_image(folder / "mask.png", np.zeros((38, 44, 1), np.uint8))
        before = (folder / taken).read_bytes()
        code = run(
            folder, "--mask", folder / "mask.png", "--output", folder / ".." / folder.name / taken
        )
        assert f"{taken}: the output would overwrite this input; name another file" in refused(
            capsys, code
        )
        assert (folder / taken).read_bytes() == before

    def test_outputs_of_one_name(self, scene, capsys):
        folder = scene[0]
        code = run(folder, "--save-levels", folder / "out.png")
        assert "out.png: two outputs have this name" in refused(capsys, code)

    def test_a_full_disk(self, scene, capsys, monkeypatch):
        free = shutil.disk_usage(scene[0])._replace(free=5000)
        monkeypatch.setattr(shutil, "disk_usage", lambda _: free)
        message = refused(capsys, run(scene[0]))
        assert (
            "out.png: cannot be written: it may need 0.1 MiB, and the disk has 0.0 MiB free"
            in message
        )

    @pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
    def test_folder_without_permission(self, scene, capsys, tmp_path):
        locked = tmp_path / "locked"
        locked.mkdir(mode=0o500)
        assert "permission" in refused(capsys, run(scene[0], "--output", locked / "out.png"))
