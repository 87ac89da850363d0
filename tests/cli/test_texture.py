"""``stylit-ref texture`` and ``replay-texture``."""

import re
import signal

import numpy as np
import pytest
from cli.calls import refused
from small_textures import identity, quick, spots

from stylit_ref import (
    TextureField,
    TextureParams,
    TextureSession,
    complete_texture,
    make_tileable,
    overlay,
    read_image,
    synthesize_texture,
    write_image,
    write_texture_field,
)
from stylit_ref.cli import main
from stylit_ref.cli.positions import size_of

QUICK = ["--radius", "8", "--iterations", "4", "--candidates", "8"]
PARAMS = quick(iterations=4, candidates=8)
SMALL = TextureParams.preset("complete", radius=8, iterations=4, candidates=8)


@pytest.fixture
def folder(tmp_path):
    """A folder with exemplars and maps."""
    for number in range(3):
        write_image(tmp_path / f"{number}.png", spots(number))
    write_image(tmp_path / "grey.png", spots(4, channels=1))
    write_image(tmp_path / "thin.png", spots(6)[:2, :9])
    write_image(tmp_path / "deep.png", spots(5).astype(np.uint16) * 250)
    labels = np.zeros((40, 56), np.uint8)
    labels[10:30, 10:40] = 200
    write_image(tmp_path / "labels.png", labels)
    hole = np.zeros((48, 48), np.uint8)
    hole[10:20, 20:40] = 255
    write_image(tmp_path / "hole.png", hole)
    saved = TextureField(identity(40, 56) // 2 * np.array([0, 1, 1], np.int32), ((48, 48),))
    write_texture_field(tmp_path / "saved.npy", saved)
    return tmp_path


def texture(folder, *more):
    """Call ``texture``; names of files are those of the folder."""
    named = [str(folder / each) if re.search(r"\.(png|npy)$", str(each)) else each for each in more]
    return main(["texture", *QUICK, "--output", str(folder / "out.png"), *map(str, named)])


def written(folder, name="out.png"):
    return read_image(folder / name)


def test_a_texture_is_that_of_the_library(folder, capsys):
    assert texture(folder, "--exemplar", "0.png", "--size", "56x40", "--seed", 3) == 0
    expected = synthesize_texture(spots(0), (40, 56), PARAMS, seed=3)
    assert np.array_equal(written(folder), expected.image)
    last, wrote = capsys.readouterr().err.strip().split("\n")
    assert re.fullmatch(r"iteration 4 of 4, cost \S+ a pixel, \d+ of \d+ patches accepted", last)
    assert re.fullmatch(r"wrote .*out\.png \(56x40\) in \d+\.\d s", wrote)


def test_quiet_says_nothing(folder, capsys):
    assert texture(folder, "--exemplar", "0.png", "--size", "56x40", "--quiet") == 0
    assert capsys.readouterr().err == ""


def test_progress_tells_cost_and_acceptance(folder, monkeypatch, capfd):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert texture(folder, "--exemplar", "0.png", "--size", "56x40") == 0
    shown = re.split(r"[\r\n]+", capfd.readouterr().err)
    pattern = r"100% \|.+\| [\d:<]+  iteration 4 of 4, cost \S+ a pixel, \d+ of \d+ patches.*"
    assert any(re.fullmatch(pattern, line) for line in shown)


def test_the_preset_of_the_paper(folder):
    more = ["--exemplar", "0.png", "--size", "56x40", "--preset", "paper", "--max-deformation", 8]
    assert texture(folder, *more) == 0
    params = TextureParams.preset("paper", radius=8, iterations=4, candidates=8, max_deformation=8)
    assert np.array_equal(written(folder), synthesize_texture(spots(0), (40, 56), params).image)


def test_a_tiled_preview(folder):
    assert texture(
        folder, "--exemplar", "0.png", "--size", "56x40", "--save-tiled", "tiled.png"
    ) == 0  # fmt: skip
    assert np.array_equal(written(folder, "tiled.png"), np.tile(written(folder), (2, 2, 1)))


def test_labels_choose_exemplars_by_their_values(folder, capsys):
    assert texture(
        folder, "--exemplar", "0.png", "--exemplar", "1.png", "--labels", "labels.png"
    ) == 0  # fmt: skip
    labels = (read_image(folder / "labels.png")[:, :, 0] > 0).astype(np.uint8) + 1
    expected = synthesize_texture([spots(0), spots(1)], (40, 56), PARAMS, labels=labels)
    assert np.array_equal(written(folder), expected.image)
    said = capsys.readouterr().err
    assert "less than 1 %" not in said
    assert f"colour 0 is {folder / '0.png'}; 200 is {folder / '1.png'}" in said


def test_shares(folder):
    assert texture(
        folder, "--exemplar", "0.png", "--exemplar", "1.png", "--size", "56x40", "--shares",
        "0.3,0.7",
    ) == 0  # fmt: skip
    expected = synthesize_texture([spots(0), spots(1)], (40, 56), PARAMS, shares=(0.3, 0.7))
    assert np.array_equal(written(folder), expected.image)


def test_a_guide_of_weight_0_changes_nothing(folder):
    guide = ["--guide-source", "1.png", "--guide-target", "2.png"]
    assert texture(folder, "--exemplar", "0.png", *guide, "--guide-weight", 0) == 0
    without = written(folder)
    assert np.array_equal(without, synthesize_texture(spots(0), (48, 48), PARAMS).image)
    assert texture(folder, "--exemplar", "0.png", *guide, "--guide-weight", 5) == 0
    assert not np.array_equal(written(folder), without)


def test_holes_are_filled(folder, capsys):
    assert texture(folder, "--complete", "0.png", "--mask", "hole.png") == 0
    hole = read_image(folder / "hole.png")[:, :, 0] > 0
    assert np.array_equal(written(folder), complete_texture(spots(0), hole, SMALL).image)
    assert texture(folder, "--complete", "0.png", "--mask", "hole.png", "--inverted-mask") == 0
    assert np.array_equal(written(folder), complete_texture(spots(0), ~hole, SMALL).image)


def test_a_radius_that_nobody_gave_fits_between_holes(folder, capsys):
    known = np.zeros((48, 48), np.uint8)
    known[10:25, 5:40] = 255
    write_image(folder / "known.png", known)
    assert main([
        "texture", "--complete", f"{folder / '0.png'}", "--mask", f"{folder / 'known.png'}",
        "--inverted-mask", "--iterations", "2", "--output", f"{folder / 'out.png'}",
    ]) == 0  # fmt: skip
    assert "note: --radius is 47, but 15 is used: between its holes, " in capsys.readouterr().err


def test_holes_are_filled_from_an_exemplar(folder):
    assert texture(
        folder, "--complete", "0.png", "--mask", "hole.png", "--exemplar", "1.png"
    ) == 0  # fmt: skip
    hole = read_image(folder / "hole.png")[:, :, 0] > 0
    expected = complete_texture(spots(0), hole, SMALL, exemplars=[spots(1)])
    assert np.array_equal(written(folder), expected.image)


def test_unlocked_tells_how_many_known_pixels_changed(folder, capsys):
    assert texture(folder, "--complete", "0.png", "--mask", "hole.png", "--unlocked") == 0
    hole = read_image(folder / "hole.png")[:, :, 0] > 0
    changed = ((written(folder) != spots(0)).any(axis=-1) & ~hole).sum()
    assert changed > 0
    assert f"{changed} of {(~hole).sum()} known pixels changed" in capsys.readouterr().err


def test_tile_in_place(folder):
    assert texture(folder, "--tile-in-place", "0.png", "--band", 10) == 0
    assert np.array_equal(written(folder), make_tileable(spots(0), 10, SMALL).image)


def test_a_replay_of_the_exemplar_is_the_texture(folder):
    assert texture(
        folder, "--exemplar", "0.png", "--size", "56x40", "--save-coordinates", "s.npy"
    ) == 0  # fmt: skip
    assert main([
        "replay-texture", "--coordinates", f"{folder / 's.npy'}", "--exemplar",
        f"{folder / '0.png'}", "--output", f"{folder / 'again.png'}",
    ]) == 0  # fmt: skip
    assert (folder / "again.png").read_bytes() == (folder / "out.png").read_bytes()


def test_the_texture_has_the_depth_of_its_exemplar(folder):
    assert texture(folder, "--exemplar", "deep.png", "--size", "56x40") == 0
    assert written(folder).dtype == np.uint16
    shown = ((written(folder).astype(np.uint32) + 128) // 257).astype(np.uint8)
    seen = ((spots(5).astype(np.uint32) * 250 + 128) // 257).astype(np.uint8)
    assert np.array_equal(shown, synthesize_texture(seen, (40, 56), PARAMS).image)


def test_grey_exemplars_stand_beside_coloured_ones(folder):
    assert texture(
        folder, "--exemplar", "grey.png", "--exemplar", "0.png", "--size", "56x40"
    ) == 0  # fmt: skip
    assert written(folder).shape == (40, 56, 3)


def test_a_texture_smaller_than_a_cell_says_which_radius_is_used(folder, capsys):
    assert texture(folder, "--exemplar", "0.png", "--size", "10x30") == 0
    assert "note: --radius is 8, but 5 is used: the texture has 10 x 30" in capsys.readouterr().err


@pytest.mark.parametrize("size", ["1x30", "30x1", "1x1"])
def test_thin_textures(folder, size):
    assert texture(folder, "--exemplar", "0.png", "--size", size) == 0
    assert written(folder).shape[:2] == size_of(size)


def test_a_saved_texture_goes_on(folder):
    whole = ["--exemplar", "0.png", "--size", "56x40", "--seed", 3]
    assert texture(folder, *whole) == 0
    expected = (folder / "out.png").read_bytes()
    assert texture(folder, *whole, "--iterations", 1, "--save-coordinates", "s.npy") == 0
    assert (folder / "out.png").read_bytes() != expected
    for size in ([], ["--size", "56x40"]):
        goes_on = ["--exemplar", "0.png", "--seed", 3, "--start", "s.npy", *size]
        assert texture(folder, *goes_on) == 0
        assert (folder / "out.png").read_bytes() == expected


def test_a_texture_that_has_all_its_iterations_is_told(folder, capsys):
    assert texture(
        folder, "--exemplar", "0.png", "--size", "56x40", "--save-coordinates", "s.npy"
    ) == 0  # fmt: skip
    before = (folder / "out.png").read_bytes()
    capsys.readouterr()
    assert texture(folder, "--exemplar", "0.png", "--start", "s.npy") == 0
    assert "s.npy: has 4 iterations already; give --iterations a larger number" in (
        capsys.readouterr().err
    )
    assert (folder / "out.png").read_bytes() == before


def test_the_overlay_is_that_of_the_library(folder):
    begins = ["--exemplar", "0.png", "--size", "56x40", "--save-coordinates", "s.npy"]
    assert texture(folder, *begins, "--save-overlay", "seams.png") == 0
    session = TextureSession([spots(0)], (40, 56), PARAMS)
    for _ in range(4):
        session.step()
    expected = overlay(session)
    assert np.array_equal(written(folder, "seams.png"), expected)
    later = ["--exemplar", "0.png", "--start", "s.npy", "--save-overlay", "again.png"]
    assert texture(folder, *later) == 0
    assert np.array_equal(written(folder, "again.png"), expected)


def test_an_exemplar_that_has_gone_is_told(folder, capsys):
    write_image(folder / "flat.png", np.full((48, 48, 3), 90, np.uint8))
    assert texture(
        folder, "--exemplar", "flat.png", "--size", "32x32", "--save-coordinates", "s.npy"
    ) == 0  # fmt: skip
    capsys.readouterr()
    both = ["--exemplar", "flat.png", "--exemplar", "0.png", "--start", "s.npy"]
    assert texture(folder, *both) == 0
    assert "note: exemplar 2 has less than 1 % of the texture; shares" in capsys.readouterr().err


def test_shares_that_are_no_shares_are_told(folder, capsys):
    both = ["--exemplar", "0.png", "--exemplar", "1.png", "--size", "20x20"]
    assert texture(folder, *both, "--shares", "1,1") == 0
    assert "note: --shares is 1, 1, which is taken as 0.5, 0.5" in capsys.readouterr().err
    assert texture(folder, *both, "--shares", "0.25,0.75") == 0
    assert "--shares" not in capsys.readouterr().err


def test_what_is_transparent_in_an_exemplar_is_told(folder, capsys):
    leaf = np.dstack([spots(0), np.full((48, 48), 255, np.uint8)])
    leaf[:, :12, 3] = 0
    write_image(folder / "leaf.png", leaf)
    assert texture(folder, "--exemplar", "leaf.png", "--size", "20x20") == 0
    assert "leaf.png: 25% of its pixels are transparent; they are matched as if on black" in (
        capsys.readouterr().err
    )
    assert written(folder).shape[2] == 4


def test_a_mask_that_is_a_photograph_is_told(folder, capsys):
    ramp = np.tile(np.linspace(0, 255, 48).astype(np.uint8), (48, 1))
    write_image(folder / "ramp.png", ramp)
    assert texture(folder, "--complete", "0.png", "--mask", "ramp.png") == 0
    assert "ramp.png: 79% of it is neither black nor white; a mask is white" in (
        capsys.readouterr().err
    )
    assert texture(folder, "--complete", "0.png", "--mask", "hole.png") == 0
    assert "neither black nor white" not in capsys.readouterr().err


REFUSALS = [
    ([], "--exemplar is needed"),
    (["--exemplar", "0.png"], "--size is needed: width and height"),
    (["--exemplar", "0.png", "--size", "0x20"], "--size is 0 x 20 pixels; each side must be"),
    (["--exemplar", "0.png", "--size", "65536x65536"], "--size is 65536 x 65536 pixels, which"),
    (
        ["--exemplar", "0.png", "--size", "200x200", "--radius", 64],
        "--radius is 64, too large for the exemplar of 48 x 48 pixels; 47 is the largest that fits",
    ),
    (["--exemplar", "0.png", "--size", "20x20", "--radius", 0], "--radius is 0; it must be"),
    (["--exemplar", "0.png", "--size", "20x20", "--max-jump", 65], "--max-jump is 65; it must"),
    (["--exemplar", "9.png", "--size", "20x20"], "9.png: "),
    (["--complete", "0.png"], "--complete needs a --mask"),
    (["--complete", "0.png", "--mask", "labels.png"], "labels.png: has 56 x 40 pixels, and "),
    (["--exemplar", "0.png", "--size", "20x20", "--mask", "hole.png"], "--mask is for --complete"),
    (["--exemplar", "0.png", "--size", "20x20", "--band", 3], "--band is for --tile-in-place"),
    (["--tile-in-place", "0.png", "--band", 24], "--band is 24; for 48 x 48 pixels it must be"),
    (["--tile-in-place", "thin.png"], "the picture has 9 x 2 pixels; it needs at least 3 x 3"),
    (["--tile-in-place", "0.png", "--size", "9x9"], "--size cannot be given with --tile-in-place"),
    (["--tile-in-place", "0.png", "--exemplar", "1.png"], "--exemplar cannot be given with"),
    (["--tile-in-place", "0.png", "--complete", "1.png"], "--complete and --tile-in-place"),
    (
        ["--exemplar", "0.png", "--labels", "labels.png"],
        "labels.png: has 2 colours, and --ex",
    ),
    (
        ["--exemplar", "0.png", "--exemplar", "1.png", "--labels", "labels.png", "--size", "9x9"],
        "labels.png: has 56 x 40 pixels, and --size is 9 x 9",
    ),
    (["--exemplar", "0.png", "--size", "20x20", "--shares", "0.5,0.5"], "--shares is [0.5, 0.5]"),
    (["--exemplar", "0.png", "--guide-target", "1.png"], "--guide-source is needed, too"),
    (
        ["--exemplar", "0.png", "--guide-source", "labels.png", "--guide-target", "1.png"],
        "the guide of exemplar 1 has 56 x 40 pixels, the exemplar 48 x 48",
    ),
    (
        ["--exemplar", "0.png", "--size", "20x20", "--guide-weight", 2],
        "--guide-weight is for --guide-source and --guide-target",
    ),
    (["--complete", "0.png", "--mask", "hole.png", "--start", "s.npy"], "--start cannot be given"),
    (["--tile-in-place", "0.png", "--save-overlay", "o.png"], "--save-overlay cannot be given"),
    (["--exemplar", "0.png", "--start", "s.npy"], "s.npy: cannot be read"),
    (
        ["--exemplar", "1.png", "--start", "saved.npy", "--size", "9x9"],
        "saved.npy: has 56 x 40 pixels, and --size is 9 x 9; leave --size out",
    ),
    (["--exemplar", "labels.png", "--start", "saved.npy"], "--start was made from an exemplar 1"),
    (["--exemplar", "0.png", "--size", "20x20", "--save-overlay", "0.png"], "0.png: the output"),
    (["--exemplar", "0.png", "--size", "20x20", "--seed", -1], "--seed is -1; it must be"),
    (["--exemplar", "0.png", "--size", "20x20", "--threads", 0], "--threads is 0; it must be"),
    (["--exemplar", "0.png", "--size", "20x20", "--save-coordinates", "s.png"], "s.png: the file"),
    (["--exemplar", "0.png", "--size", "20x20", "--save-tiled", "0.png"], "0.png: the output"),
]


@pytest.mark.parametrize(("options", "said"), REFUSALS, ids=[said for _, said in REFUSALS])
def test_bad_input_is_refused_and_nothing_written(folder, capsys, options, said):
    before = {file.name: file.read_bytes() for file in folder.iterdir()}
    message = refused(capsys, texture(folder, *options))
    assert message.replace(f"{folder}/", "").startswith(f"stylit-ref: {said}")
    assert {file.name: file.read_bytes() for file in folder.iterdir()} == before


@pytest.mark.parametrize("text", ["1024", "x", "10x", "axb", "1.5x2", "-5x5", "-5"])
def test_a_size_is_width_by_height(folder, capsys, text):
    with pytest.raises(SystemExit) as end:
        texture(folder, "--exemplar", "0.png", "--size", text)
    assert end.value.code == 2
    assert f"--size: is '{text}'; it must be WIDTHxHEIGHT" in capsys.readouterr().err


@pytest.mark.parametrize("option", ["--seed", "--threads", "--band", "--iterations"])
def test_a_number_is_a_number(folder, capsys, option):
    with pytest.raises(SystemExit) as end:
        texture(folder, "--exemplar", "0.png", option, "many")
    assert end.value.code == 2
    assert f"{option}: is 'many'; it must be an integer (--help" in capsys.readouterr().err


def test_a_texture_beyond_memory_is_refused_before_it_is_taken(folder, capsys, monkeypatch):
    monkeypatch.setattr("stylit_ref.texture.checks.physical_memory", lambda: 2**30)
    said = refused(capsys, texture(folder, "--exemplar", "0.png", "--size", "8192x8192"))
    assert "take about 1.7 GiB; the machine has 1.0 GiB of memory; make it smaller" in said


def test_a_map_that_does_not_match_is_refused(folder, capsys):
    assert texture(
        folder, "--exemplar", "0.png", "--size", "56x40", "--save-coordinates", "s.npy"
    ) == 0  # fmt: skip
    capsys.readouterr()
    said = refused(capsys, main([
        "replay-texture", "--coordinates", f"{folder / 's.npy'}", "--exemplar",
        f"{folder / 'labels.png'}", "--output", f"{folder / 'again.png'}",
    ]))  # fmt: skip
    assert "map 1 has 56 x 40 pixels, exemplar 1 had 48 x 48" in said
    assert not (folder / "again.png").exists()


@pytest.fixture
def interrupted(monkeypatch):
    """Ctrl-C comes in the third iteration of a synthesis."""
    from stylit_ref.texture.session import TextureSession

    step = TextureSession.step

    def interrupted_step(session, params=None):
        if session.iteration == 2:
            signal.raise_signal(signal.SIGINT)
        return step(session, params)

    monkeypatch.setattr(TextureSession, "step", interrupted_step)


@pytest.mark.usefixtures("interrupted")
def test_interruption_leaves_nothing(folder, capsys):
    assert texture(folder, "--exemplar", "0.png", "--size", "56x40") == 130
    assert capsys.readouterr().err == "stylit-ref: interrupted; no half-written file is left\n"
    assert not (folder / "out.png").exists()


@pytest.mark.usefixtures("interrupted")
def test_interruption_keeps_whole_iterations_on_request(folder, monkeypatch, capsys):
    assert texture(folder, "--exemplar", "0.png", "--size", "56x40", "--keep-interrupted") == 0
    assert "iteration 3 of 4" in capsys.readouterr().err
    monkeypatch.undo()
    three = synthesize_texture(spots(0), (40, 56), quick(iterations=3, candidates=8))
    assert np.array_equal(written(folder), three.image)
