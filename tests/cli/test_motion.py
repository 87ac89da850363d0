"""``stylit-ref motion check``, and the shot that Blender rendered, end to end."""

from pathlib import Path

import numpy as np
import pytest
from cli.calls import QUICK, refused
from scipy.ndimage import map_coordinates
from views.motion.blender_shot import FOLDER
from views.motion.moving_square import motion, picture

from stylit_ref import motion_between, read_motion, read_uint8, write_image
from stylit_ref.cli import main
from stylit_ref.files.motion_flo import write_flo
from stylit_ref.views.motion.places import fetched, places_in_other

SINTEL = Path(__file__).parents[3] / "shared/data/sintel"


def check(*words):
    return main(["motion", "check", *map(str, words)])


def of_blender(shot, *more):
    frames = f"{FOLDER}/{shot}/shot.%04d.exr"
    return check("--guide", f"{frames}:ViewLayer.Combined", "--motion", frames, *more)


@pytest.fixture
def shot(tmp_path):
    """Pictures of the moving square, and forward vectors, a file for each pair of frames."""
    for frame in range(4):
        write_image(tmp_path / f"square.{frame}.png", picture(frame))
        write_flo(tmp_path / f"{frame}_to_{frame + 1}.flo", motion(frame, frame + 1).field)
        write_flo(tmp_path / f"ahead.{frame}.flo", motion(frame, frame + 1).field)
    return tmp_path


def last_line(capsys):
    return capsys.readouterr().out.splitlines()[-1]


def test_blender_is_named(capsys):
    assert of_blender("perspective") == 0
    *lines, still, last = capsys.readouterr().out.splitlines()
    assert len(lines) == 32
    assert lines[0].split()[1] == "blender"
    assert still.endswith("  without motion")
    assert last.startswith("blender explains the pictures")


@pytest.mark.skipif(not SINTEL.is_dir(), reason=f"no frames of MPI Sintel in {SINTEL}")
def test_sintels_flow_is_named(capsys):
    frames = [word for n in (2, 3) for word in ("--guide", SINTEL / f"frame_000{n}.png")]
    assert check(*frames, "--motion", SINTEL / "gt_frame_0002.flo") == 0
    first, *_, last = capsys.readouterr().out.splitlines()
    assert first.split()[1] == "flo"
    assert last.startswith("flo explains the pictures")


@pytest.mark.parametrize(("name", "code"), [("blender", 0), ("blender-flip-y", 2), ("flo", 2)])
def test_a_named_convention_is_confirmed_or_refused(capsys, name, code):
    assert of_blender("perspective", "--motion-convention", name) == code
    if code:
        error = capsys.readouterr().err.splitlines()[-1]
        assert error.startswith(f"stylit-ref: --motion-convention {name} ")
        assert "blender" in error


def test_blenders_silent_failures_are_refused(capsys):
    message = refused(capsys, of_blender("blurred"))
    assert message.endswith("when motion blur is on: turn it off and render them again")
    message = refused(capsys, of_blender("orthographic"))
    assert message.endswith("when an orthographic camera moves: use a perspective camera")


def test_two_pictures_and_the_vectors_between_them(capsys, shot):
    guides = "--guide", shot / "square.0.png", "--guide", shot / "square.1.png"
    assert check(*guides, "--motion", shot / "0_to_1.flo") == 0
    assert last_line(capsys).startswith("flo explains the pictures")


def test_vectors_of_each_picture(capsys, shot):
    words = [f"--{kind}" for _ in range(3) for kind in ("guide", "motion")]
    files = [shot / f"{kind}" for n in range(3) for kind in (f"square.{n}.png", f"ahead.{n}.flo")]
    assert check(*[word for pair in zip(words, files, strict=True) for word in pair]) == 0
    assert last_line(capsys).startswith("flo explains the pictures")


@pytest.mark.parametrize("vectors", ["ahead.#.flo", "%d_to_%d.flo"])
def test_patterns(capsys, shot, vectors):
    assert check("--guide", shot / "square.%d.png", "--motion", shot / vectors) == 0
    assert last_line(capsys).startswith("flo explains the pictures")


def test_a_still_shot_is_undecided(capsys, shot):
    still = shot / "square.0.png"
    assert check("--guide", still, "--guide", still, "--motion", shot / "0_to_1.flo") == 1
    assert last_line(capsys).startswith("undecided: the pictures do not move; name frames of the")


def test_vectors_without_pictures_beside_them_are_refused(capsys, shot):
    (shot / "square.1.png").unlink()
    (shot / "square.3.png").unlink()
    words = "--guide", shot / "square.%d.png", "--motion"
    message = refused(capsys, check(*words, shot / "ahead.%d.flo"))
    assert "no frame of it has a picture of its own and one beside it" in message
    message = refused(capsys, check(*words, shot / "%d_to_%d.flo"))
    assert message.endswith("there are no two neighbouring frames")


@pytest.mark.parametrize(
    ("pictures", "vectors", "option"),
    [("circle.%d.png", "ahead.%d.flo", "guide"), ("square.%d.png", "back.%d.flo", "motion")],
)
def test_patterns_that_no_file_fits_are_refused(capsys, shot, pictures, vectors, option):
    message = refused(capsys, check("--guide", shot / pictures, "--motion", shot / vectors))
    assert f"--{option} " in message
    assert message.endswith("there is no file of such a name")


def test_one_file_of_vectors_for_a_shot_is_refused(capsys, shot):
    words = "--guide", shot / "square.%d.png", "--motion", shot / "0_to_1.flo"
    assert "names one file, and --guide those of a shot" in refused(capsys, check(*words))


def test_frames_further_apart_decide_a_slow_shot(capsys, tmp_path):
    """Moved by 0.4 pixels a frame, and by 4 from the first to the last."""
    base = picture(0).astype(float)
    for name, shift in (("first", 0), ("next", 0.4), ("last", 4)):
        write_image(tmp_path / f"{name}.png", _moved(base, shift))
        flow = np.tile(np.float32([shift, 0]), (*base.shape[:2], 1))
        write_flo(tmp_path / f"to_{name}.flo", flow)
    for name, code in (("next", 1), ("last", 0)):
        guides = "--guide", tmp_path / "first.png", "--guide", tmp_path / f"{name}.png"
        assert check(*guides, "--motion", tmp_path / f"to_{name}.flo") == code
        said = last_line(capsys)
        assert "or frames further apart and the vectors" in said if code else "flo explains" in said


def _moved(image, shift):
    """Moved to the right by as many pixels."""
    places = np.mgrid[: image.shape[0], : image.shape[1], : image.shape[2]].astype(float)
    places[1] -= shift
    return map_coordinates(image, places, order=1, mode="nearest").round().astype(np.uint8)


def test_several_layers_are_told_of_the_pattern(capsys):
    frames = f"{FOLDER}/perspective/shot.%04d.exr"
    message = refused(capsys, check("--guide", frames, "--motion", frames))
    assert f"several layers; write {frames}:ViewLayer.Combined; its" in message


@pytest.mark.parametrize("option", ["--guide", "--motion"])
def test_a_star_is_no_number_of_a_frame(capsys, shot, option):
    words = {"--guide": "square.%d.png", "--motion": "ahead.%d.flo"}
    words[option] = words[option].replace("%d", "*")
    command = [word for name, file in words.items() for word in (name, shot / file)]
    message = refused(capsys, check(*command))
    assert f"{option} {shot / words[option]}: has a star where the number of the frame" in message


def test_other_numbers_of_files_are_refused(capsys, shot):
    words = "--guide", shot / "square.0.png", "--motion", shot / "0_to_1.flo"
    assert "names 1 files of vectors for 1 pictures" in refused(capsys, check(*words))


def test_an_unknown_convention_is_refused(capsys):
    message = refused(capsys, of_blender("perspective", "--motion-convention", "blander"))
    assert message.startswith("stylit-ref: --motion-convention is 'blander'; write auto or one of")


def test_grey_pictures_are_compared_too(capsys, shot):
    for frame in range(2):
        grey = picture(frame).mean(axis=2).astype(np.uint8)
        write_image(shot / f"grey.{frame}.png", grey)
    guides = "--guide", shot / "grey.0.png", "--guide", shot / "grey.1.png"
    assert check(*guides, "--motion", shot / "0_to_1.flo") == 0
    assert last_line(capsys).startswith("flo explains the pictures")


def test_blenders_shot_is_stylized_coherently(tmp_path):
    """By its multilayer files alone: passes, vectors, depth and IDs."""
    first, frames = f"{FOLDER}/perspective/shot.0001.exr", f"{FOLDER}/perspective/shot.%04d.exr"
    style = read_uint8(f"{first}:Combined")[:, :, :3]
    write_image(tmp_path / "style.png", style)
    words = ["sequence", "--style", str(tmp_path / "style.png"), *QUICK]
    for layer in ("Diffuse Direct", "Object Index"):
        words += ["--guide", f"{first}:{layer}", f"{frames}:{layer}"]
    moved = ["--motion", frames, "--depth", f"{frames}:Depth", "--ids", f"{frames}:Object Index"]
    errors = []
    for name, more in (("alone", []), ("coherent", moved)):
        assert main([*words, *more, "--output", f"{tmp_path}/{name}.%d.png"]) == 0
        shown = [read_uint8(tmp_path / f"{name}.{frame}.png").astype(float) for frame in (1, 2, 3)]
        for to in (1, 2):
            motion = motion_between(to, to - 1, lambda frame: read_motion(frames % (frame + 1)))
            there = fetched(shown[to - 1], places_in_other(motion))
            errors.append(np.abs(shown[to] - there)[motion.visible].mean())
    assert sum(errors[2:]) < 0.8 * sum(errors[:2])
