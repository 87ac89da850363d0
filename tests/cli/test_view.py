"""``stylit-ref view`` from end to end."""

import numpy as np
import pytest
from cli.calls import refused
from PIL import Image
from small_run import write_run

from stylit_ref import read_image, views_of_run
from stylit_ref.cli import main
from stylit_ref.cli.places import places_along


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    return write_run(tmp_path_factory.mktemp("run"))


def view(run, *more):
    """Call ``view``."""
    return main(["view", "--from", str(run.folder), *map(str, more)])


def test_a_place(run, tmp_path, capsys):
    out = tmp_path / "picture.png"
    assert view(run, "--at", "2.5,-1.25", "-o", out) == 0
    np.testing.assert_array_equal(read_image(out), views_of_run(run).picture((2.5, -1.25)))
    said = capsys.readouterr().err
    assert "frames fade into each other over 4 to 4.8 degrees; --fade makes that narrower" in said
    assert f"wrote {out} (34x27) in" in said


def test_to_the_left_in_another_mode(run, tmp_path):
    out = tmp_path / "picture.png"
    assert view(run, "--at=-2.5,1", "--mode", "image", "--output", out) == 0
    np.testing.assert_array_equal(read_image(out), views_of_run(run).picture((-2.5, 1), "image"))


def test_a_path_as_numbered_frames(run, tmp_path, capsys):
    out = tmp_path / "frame.%02d.png"
    assert view(run, "--path", "-1,0 0,0 0,1", "--step", 0.5, "-o", out, "--fade", 0) == 0
    places = [(-1, 0), (-0.5, 0), (0, 0), (0, 0.5), (0, 1)]
    assert sorted(each.name for each in tmp_path.iterdir()) == [
        f"frame.{number:02}.png" for number in range(1, 6)
    ]
    for number, place in enumerate(places, 1):
        expected = views_of_run(run, band=0).picture(place)
        np.testing.assert_array_equal(read_image(tmp_path / f"frame.{number:02}.png"), expected)
    assert "wrote 5 frames, " in capsys.readouterr().err


def test_a_path_as_one_picture_that_moves(run, tmp_path):
    out = tmp_path / "turning.webp"
    assert view(run, "--path", "-1,0 1,0", "--step", 1, "-o", out, "--fps", 10) == 0
    moving = Image.open(out)
    assert moving.n_frames == 3
    assert moving.info["loop"] == 0
    for number, place in enumerate([(-1, 0), (0, 0), (1, 0)]):
        moving.seek(number)
        expected = views_of_run(run).picture(place)
        np.testing.assert_array_equal(np.array(moving.convert("RGB")), expected)
        assert moving.info["duration"] == 100


def test_places_along_a_path_are_no_farther_apart_than_a_step():
    places = places_along([(0, 0), (1, 0), (1, 0.3)], 0.25)
    expected = [(0, 0), (0.25, 0), (0.5, 0), (0.75, 0), (1, 0), (1, 0.15), (1, 0.3)]
    np.testing.assert_allclose(places, expected)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--at", "30,0", "-o", "a.png"], "30 degrees to the right lies outside of the grid"),
        (["--path", "0,0 0,30", "-o", "a.%02d.png"], "degrees upwards lies outside of the grid"),
        (["--at", "0,0", "-o", "a.xyz"], "no image format has the suffix"),
        (["--path", "0,0 1,0", "-o", "a.png"], "a.png"),
        (["--at", "0,0", "-o", "a.png", "--fade", "2"], "--fade is 2; it must be between 0 and 1"),
    ],
)
def test_what_cannot_be_shown(run, tmp_path, monkeypatch, capsys, more, said):
    monkeypatch.chdir(tmp_path)
    assert said in refused(capsys, view(run, *more))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--at", "left"], "--at: is 'left'; it must be RIGHT,UP, two numbers such as 2.5,-1.25"),
        (["--at", "nan,0"], "--at: is 'nan,0'; it must be RIGHT,UP"),
        (["--path", "0,0"], "--path: is '0,0'; it must be two places or more in quotes"),
        (["--at", "0,0", "--step", "0"], "--step: is '0'; it must be a number above 0"),
    ],
)
def test_words_that_are_no_places(run, capsys, more, said):
    with pytest.raises(SystemExit):
        view(run, *more, "-o", "a.png")
    assert said in capsys.readouterr().err


def test_a_folder_that_is_no_run(tmp_path, capsys):
    message = refused(capsys, main(["view", "--from", str(tmp_path), "--at", "0,0", "-o", "a.png"]))
    assert "is no RUN, since it holds no run.json" in message
