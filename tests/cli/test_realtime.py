"""``stylit-ref run --method realtime``, and what it has in common with other methods."""

import numpy as np
import pytest
from cli.calls import refused
from exr_files import write_exr

from data_gen.guides import LIGHT_PASSES
from stylit_ref import read_any_field, read_image, read_uint8, write_image
from stylit_ref.cli import main
from stylit_ref.realtime.packing.stage import STAGE_BUFFERS

SCENES = "data_gen/bundled"
LAYERS = ",".join(STAGE_BUFFERS)


@pytest.fixture
def folders(tmp_path):
    """Folders of a small stage: every sixth pixel of bundled scenes, and a painting."""
    for scene in ("source", "golem"):
        (tmp_path / scene).mkdir()
        for name in STAGE_BUFFERS:
            image = read_uint8(f"{SCENES}/{scene}/{name}.png")[::6, ::6]
            write_image(tmp_path / scene / f"{name}.png", image)
    style = read_uint8(f"{SCENES}/source/styles/oil.png")[::6, ::6]
    write_image(tmp_path / "style.png", style)
    return tmp_path


def call(folder, *more, style="style.png", layers=LAYERS, target="golem"):
    command = ["run", "--method", "realtime", "--preset", "quick", "--threads", "1"]
    command += ["--style", folder / style, "--guide", folder / "source", folder / target]
    command += ["--guide-layers", layers, "--output", folder / "out.png", *more]
    return main([str(word) for word in command])


def test_a_frame_of_folders_and_its_replay(folders, capsys):
    assert call(folders, "--nnf", folders / "nnf.npy") == 0
    assert "wrote" in capsys.readouterr().err
    replay = ["replay", "--nnf", folders / "nnf.npy", "--style", folders / "style.png"]
    assert main([str(word) for word in [*replay, "--output", folders / "again.png"]]) == 0
    assert np.array_equal(read_uint8(folders / "again.png"), read_uint8(folders / "out.png"))


def test_a_warm_frame_starts_from_a_file(folders):
    assert call(folders, "--nnf", folders / "nnf.npy") == 0
    cold = read_any_field(folders / "nnf.npy").nnf
    assert call(folders, "--warm-start", folders / "nnf.npy", "--nnf", folders / "2.npy") == 0
    warm = read_any_field(folders / "2.npy").nnf
    assert 0 < (cold == warm).all(axis=-1).mean() < 1


def test_the_same_seed_gives_the_same_bytes(folders):
    assert call(folders, "--seed", 3) == 0
    once = (folders / "out.png").read_bytes()
    assert call(folders, "--seed", 3, "--quiet") == 0
    assert (folders / "out.png").read_bytes() == once
    assert call(folders, "--seed", 4) == 0
    assert (folders / "out.png").read_bytes() != once


def test_a_weight_of_zero_leaves_a_guide_out(folders):
    layers = LAYERS.replace(",FRESNEL", "")
    fresnel = ["--guide", folders / "source/FRESNEL.png", folders / "golem/FRESNEL.png"]
    pictures = {}
    for weight in (0, 1):
        for value in (0, 90):
            flat = np.full((38, 50, 1), value, np.uint8)
            write_image(folders / "golem" / "FRESNEL.png", flat)
            more = ["--packing", "packed", *fresnel, "--weight", weight]
            assert call(folders, *more, layers=layers) == 0
            pictures[weight, value] = read_uint8(folders / "out.png")
    assert np.array_equal(pictures[0, 0], pictures[0, 90])
    assert not np.array_equal(pictures[1, 0], pictures[1, 90])


def test_layers_of_exr_files(folders):
    channels = {}
    for scene in ("source", "golem"):
        image = read_uint8(folders / scene / "FULL.png") / np.float32(255)
        ids = (read_uint8(folders / scene / "IDMASK.png")[..., 0] > 127).astype(np.float32)
        channels = {f"ViewLayer.Combined.{c}": image[..., k] for k, c in enumerate("RGB")}
        channels["ViewLayer.IndexOB.X"] = ids
        write_exr(folders / f"{scene}.exr", channels, ids.shape)
        (folders / scene).rename(folders / f"{scene}_png")
    command = ["run", "--method", "realtime", "--style", folders / "style.png", "--guide"]
    command += [folders / "source.exr", folders / "golem.exr", "--guide-layers"]
    command += ["Combined,IndexOB", "--output", folders / "out.png"]
    assert main([str(word) for word in command]) == 0
    assert read_uint8(folders / "out.png").shape == (38, 50, 3)


def test_a_deep_style_with_alpha_keeps_both(folders):
    style = read_uint8(folders / "style.png").astype(np.uint16) * 257
    alpha = np.full_like(style[:, :, :1], 65535)
    alpha[:5] = 30000
    write_image(folders / "deep.png", np.concatenate([style, alpha], axis=2))
    assert call(folders, style="deep.png") == 0
    image = read_image(folders / "out.png")
    assert (image.dtype, image.shape[2]) == (np.uint16, 4)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--uniformity", 3], "--uniformity is for --method ref, guide_map"),
        (["--mask", "x.png"], "--mask is for --method ref, guide_map, stylit; the method is "
                              "realtime, so leave it out"),
        (["--backend", "auto"], "--backend is for --method ref"),
        (["--weight", 0.5], "--weight must be a whole number from 0 with --method realtime"),
        (["--weight", "inf"], "--weight must be a whole number from 0 with --method realtime"),
        (["--packing", "pca", "--weight", 2], "--weight cannot be given with --packing pca"),
        (["--pyramid-levels", "all"], "--pyramid-levels is 'all'; it must be an integer"),
        (["--radii", ","], "--radii: is ','"),
        (["--warm-start", "missing.npy"], "missing.npy: cannot be read"),
    ],
)  # fmt: skip
def test_what_does_not_go_together_is_refused(folders, capsys, more, said):
    try:
        code = call(folders, *more)
    except SystemExit as ended:
        code = ended.code
    assert code == 2
    assert said in capsys.readouterr().err
    assert not (folders / "out.png").exists()


@pytest.mark.parametrize("more", [["--mu", "3"], ["--warm-start", "x.npy"], ["--preset", "best"]])
def test_its_options_are_refused_by_other_methods(folders, capsys, more):
    command = ["run", "--style", folders / "style.png", "--output", folders / "out.png", "--guide"]
    command += [folders / "source/FULL.png", folders / "golem/FULL.png", *more]
    message = refused(capsys, main([str(word) for word in command]))
    assert more[0] in message
    assert "for --method" in message


def test_a_thing_that_the_source_lacks_is_refused_by_its_place(folders, capsys):
    assert call(folders, "--packing", "pca") == 0  # what it compiles is told before a refusal
    capsys.readouterr()
    ids = read_uint8(folders / "golem" / "IDMASK.png")
    ids[3, 7] = 1, 2, 3
    write_image(folders / "golem" / "IDMASK.png", ids)
    message = refused(capsys, call(folders, "--packing", "pca"))
    assert "the pixel at x 7, y 3, of the colour 1, 2, 3, belongs to a thing" in message
    assert call(folders, "--packing", "pca", "--labels", "no") == 0


def test_a_shadow_that_the_source_lacks_is_refused_by_its_place(folders, capsys):
    lit = np.full((38, 50, 3), (0, 255, 0), np.uint8)
    lit[0, 0] = 255, 0, 0
    write_image(folders / "source" / "LIGHTMASK.png", lit)
    lit[3, 7] = 0, 0, 255
    write_image(folders / "golem" / "LIGHTMASK.png", lit)
    layers = LAYERS.replace(",IDMASK", "")
    assert call(folders, "--packing", "packed", layers=layers) == 2
    message = capsys.readouterr().err
    assert "golem/LIGHTMASK.png: the pixel at x 7, y 3, of the colour 0, 0, 255" in message


def test_weights_do_not_ask_for_a_guide_of_things(folders):
    layers = LAYERS.replace(",IDMASK", "")
    assert call(folders, "--packing", "packed", "--weight", 1, layers=layers) == 0
    once = read_uint8(folders / "out.png")
    assert call(folders, "--packing", "packed", layers=layers) == 0
    assert np.array_equal(read_uint8(folders / "out.png"), once)


def test_a_dense_finish_is_kept_for_a_style_of_another_depth(folders, capsys):
    style = read_uint8(folders / "style.png")
    write_image(folders / "deep.png", style.astype(np.uint16) * 257)
    assert call(folders, "--dense-finish", "yes", "--nnf", folders / "nnf.npy") == 0
    assert "--nnf keeps the matches before --dense-finish" in capsys.readouterr().err
    shallow = read_uint8(folders / "out.png")
    assert call(folders, "--dense-finish", "yes", style="deep.png") == 0
    deep = read_image(folders / "out.png")
    assert deep.dtype == np.uint16
    assert np.abs(deep / 257 - shallow).max() <= 0.5


def test_a_start_of_another_run_is_refused(folders, capsys):
    assert call(folders, "--nnf", folders / "nnf.npy", "--quiet") == 0
    (folders / "out.png").unlink()
    code = call(folders, "--warm-start", folders / "nnf.npy", "--patch-size", 7)
    message = refused(capsys, code)
    assert "is of a run with patches of width 5, and this one has 7" in message
    assert not (folders / "out.png").exists()


def test_a_start_that_has_lost_the_facts_of_its_run_is_refused(folders, capsys):
    assert call(folders, "--nnf", folders / "nnf.npy", "--quiet") == 0
    np.save(folders / "nnf.npy", np.load(folders / "nnf.npy"))
    message = refused(capsys, call(folders, "--warm-start", folders / "nnf.npy"))
    assert "nnf.npy: does not say which run it is of; name what --method realtime" in message


def test_buffers_without_ids_are_told(folders, capsys):
    assert call(folders, layers=",".join(LIGHT_PASSES[:2])) == 0
    assert "no guide tells things apart" in capsys.readouterr().err


def test_a_folder_without_layers_is_refused(folders, capsys):
    command = ["run", "--style", folders / "style.png", "--output", folders / "out.png", "--guide"]
    command += [folders / "source", folders / "golem"]
    message = refused(capsys, main([str(word) for word in command]))
    assert message.endswith("is a folder; name its images with --guide-layers")


def test_kernels_are_compiled_ahead(capsys):
    assert main(["warm-up", "--method", "realtime"]) == 0
    capsys.readouterr()
    assert main(["warm-up", "--method", "realtime"]) == 0
    assert "compiled 0 of" in capsys.readouterr().err
