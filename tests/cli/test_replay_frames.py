"""``stylit-ref replay --run``: another style through all frames of a RUN."""

import numpy as np
import pytest
from cli.calls import refused, sequence

from stylit_ref import read_image, write_image
from stylit_ref.cli import main
from stylit_ref.views.run_folder import Run


@pytest.fixture
def shot_with_run(shot):
    """The shot's folder, with a RUN of it in ``run``."""
    folder = shot[0]
    motion = "--motion", f"{folder}/flow.%04d.flo"
    assert sequence(folder, *motion, "--run", folder / "run", "--seed", 3) == 0
    return folder


def replay(folder, *more, style="style.png", output="again.{view}.png"):
    command = ["replay", "--run", f"{folder}/run", "--style", f"{folder}/{style}"]
    return main([*command, "--output", f"{folder}/{output}", *more])


def test_the_run_is_whole(shot_with_run):
    run = Run(shot_with_run / "run")
    assert run.names == ("1", "2", "3")
    assert (run.pairs, run.seed, run.coherence.order) == (((1, 0), (2, 1)), 3, "sequential")
    for frame in range(3):
        image = read_image(shot_with_run / f"out.000{frame + 1}.png")
        np.testing.assert_array_equal(run.picture(frame), image)


@pytest.mark.parametrize("output", ["again.{view}.png", "again.%d.png"])
def test_the_same_style_gives_the_same_frames(shot_with_run, output):
    folder = shot_with_run
    assert replay(folder, output=output) == 0
    for frame in (1, 2, 3):
        image = read_image(folder / f"again.{frame}.png")
        np.testing.assert_array_equal(image, read_image(folder / f"out.{frame:04d}.png"))


def test_a_larger_style_of_more_bits(shot_with_run):
    folder = shot_with_run
    style = read_image(folder / "style.png").astype(np.uint16) * 257
    write_image(folder / "large.png", style.repeat(2, axis=0).repeat(2, axis=1))
    assert replay(folder, style="large.png") == 0
    image = read_image(folder / "again.2.png")
    small = read_image(folder / "out.0002.png")
    assert image.shape == (2 * small.shape[0], 2 * small.shape[1], 3)
    assert image.dtype == np.uint16


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--mask", "m.png"), "--mask is not for --run"),
        (("--output", "again.png"), "--output again.png: names one file; write %04d"),
        (("--run", "none"), "none: is no RUN"),
    ],
)
def test_what_cannot_be_replayed(shot_with_run, capsys, flags, said):
    capsys.readouterr()
    assert said in refused(capsys, replay(shot_with_run, *flags))
    assert not list(shot_with_run.glob("again*"))


def test_frames_with_names_need_their_names(shot_with_run, capsys):
    capsys.readouterr()
    file = shot_with_run / "run" / "run.json"
    text = file.read_text(encoding="utf-8").replace('"name": "1"', '"name": "left"')
    file.write_text(text, encoding="utf-8")
    message = refused(capsys, replay(shot_with_run, output="again.%d.png"))
    assert "the frames are called left, 2, 3, ...; write {view}" in message


def test_the_runs_own_files_are_not_overwritten(shot_with_run, capsys):
    capsys.readouterr()
    before = (shot_with_run / "run" / "pictures" / "1.png").read_bytes()
    message = refused(capsys, replay(shot_with_run, output="run/pictures/{view}.png"))
    assert "run/pictures/1.png: the output would overwrite this input; name another" in message
    assert (shot_with_run / "run" / "pictures" / "1.png").read_bytes() == before
