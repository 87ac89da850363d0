"""``stylit-ref edit-texture``."""

import numpy as np
import pytest
from cli.calls import refused
from small_textures import quick, spots

from stylit_ref import (
    TextureSession,
    drag,
    drop,
    overlay,
    paint,
    read_image,
    read_texture_field,
    synthesize_texture,
    write_image,
    write_texture_field,
)
from stylit_ref.cli import main

EXEMPLARS = [spots(0), spots(1)]
SIZE = 40, 56
STROKE = np.zeros(SIZE, np.bool_)
STROKE[10:20, 20:50] = True


@pytest.fixture
def folder(tmp_path):
    """A folder with a saved texture of the first exemplar, and a stroke."""
    for number, exemplar in enumerate(EXEMPLARS):
        write_image(tmp_path / f"{number}.png", exemplar)
    made = synthesize_texture(EXEMPLARS[0], SIZE, quick())
    write_texture_field(tmp_path / "s.npy", made.field)
    write_image(tmp_path / "stroke.png", STROKE[:, :, None].astype(np.uint8) * 255)
    write_image(tmp_path / "black.png", np.zeros((*SIZE, 1), np.uint8))
    write_image(tmp_path / "large.png", np.full((48, 48, 1), 255, np.uint8))
    return tmp_path


def edit(folder, *more, exemplars=("0.png",), radius=("--radius", "8")):
    """Call the command; names of files are those of the folder."""
    words = [*radius, "--coordinates", "s.npy", "--output", "out.png"]
    for exemplar in exemplars:
        words += ["--exemplar", exemplar]
    named = [
        str(folder / word) if str(word).endswith((".png", ".npy")) else str(word)
        for word in [*words, *more]
    ]
    return main(["edit-texture", *named])


def session(folder, exemplars):
    """A session that goes on with what is saved."""
    return TextureSession(exemplars, SIZE, quick(), start=read_texture_field(folder / "s.npy"))


def test_a_stroke_is_that_of_the_library(folder, capsys):
    painting = ["--paint", "stroke.png", "--iterations", 3, "--candidates", 16]
    assert edit(folder, *painting, exemplars=("0.png", "1.png")) == 0
    expected = session(folder, EXEMPLARS)
    paint(expected, STROKE, 2, 3)
    assert np.array_equal(read_image(folder / "out.png"), expected.image)
    assert "out.png (56x40) in " in capsys.readouterr().err


def test_what_is_painted_can_be_painted_over(folder):
    painting = ["--paint", "stroke.png", "--save-coordinates", "painted.npy"]
    assert edit(folder, *painting, exemplars=("0.png", "1.png")) == 0
    painted = read_texture_field(folder / "painted.npy").coordinates[..., 0]
    assert np.array_equal(painted == 1, STROKE)
    over = ["--coordinates", "painted.npy", "--paint", "stroke.png", "--from-exemplar", 1]
    assert edit(
        folder, *over, "--save-coordinates", "over.npy", exemplars=("0.png", "1.png")
    ) == 0  # fmt: skip
    assert not read_texture_field(folder / "over.npy").coordinates[..., 0].any()


def test_a_patch_is_that_of_the_library(folder):
    patch = ["--patch", "24,20", "--drop-at", "55,3", "--least-radius", 4]
    assert edit(folder, *patch, "--save-overlay", "seams.png", "--candidates", 16) == 0
    expected = session(folder, EXEMPLARS[:1])
    drop(expected, drag(expected, (1, 20, 24), (3, 55), least_radius=4))
    assert np.array_equal(read_image(folder / "out.png"), expected.image)
    assert np.array_equal(read_image(folder / "seams.png"), overlay(expected))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "--paint MASK and --patch X,Y: give one of them"),
        (["--paint", "stroke.png", "--patch", "1,1"], "--paint MASK and --patch X,Y: give one of"),
        (["--patch", "20,20"], "--drop-at is needed, too"),
        (["--paint", "stroke.png", "--drop-at", "1,1"], "--patch is needed, too"),
        (["--patch", "20,20", "--drop-at", "56,1"], "--drop-at is y = 1, x = 56; these must be"),
        (["--patch", "2,20", "--drop-at", "5,1"], "--patch is y = 20, x = 2 of exemplar 1, too"),
        (["--paint", "large.png"], "large.png: has 48 x 48 pixels, and the texture 56 x 40"),
        (["--paint", "black.png"], "black.png: has no white pixel; paint in white what to fill"),
        (["--paint", "stroke.png", "--from-exemplar", 2], "--from-exemplar is 2; it must be 1"),
        (["--paint", "stroke.png", "--from-exemplar", 0], "--from-exemplar is 0; it must be 1"),
        (["--paint", "stroke.png", "--save-tiled", "stroke.png"], "stroke.png: the output"),
        (["--paint", "stroke.png", "--coordinates", "no.npy"], "no.npy: cannot be read"),
    ],
)
def test_bad_input_is_refused_and_nothing_written(folder, capsys, words, said):
    before = {file.name: file.read_bytes() for file in folder.iterdir()}
    message = refused(capsys, edit(folder, *words))
    assert message.replace(f"{folder}/", "").startswith(f"stylit-ref: {said}")
    assert {file.name: file.read_bytes() for file in folder.iterdir()} == before


def test_other_exemplars_are_refused_by_the_option_that_was_typed(folder, capsys):
    write_image(folder / "0.png", spots(0, 40))
    said = refused(capsys, edit(folder, "--paint", "stroke.png"))
    assert said.startswith("stylit-ref: --coordinates was made from an exemplar 1 of 48 x 48")


def test_a_radius_that_nobody_gave_fits(folder):
    assert edit(folder, "--paint", "stroke.png", "--iterations", 1, radius=()) == 0
    assert (read_image(folder / "out.png")[STROKE] != 0).any()


@pytest.mark.parametrize("text", ["12", "1,2,3", "a,b", "-1,2"])
def test_a_position_is_x_and_y(folder, capsys, text):
    with pytest.raises(SystemExit) as end:
        edit(folder, "--patch", text, "--drop-at", "1,1")
    assert end.value.code == 2
    assert f"--patch: is '{text}'; it must be X,Y in pixels" in capsys.readouterr().err
