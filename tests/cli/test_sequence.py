"""``stylit-ref sequence`` from end to end."""

import shutil
from dataclasses import replace

import numpy as np
import pytest
from cli.calls import QUICK, refused, run, sequence
from exr_files import write_exr

from stylit_ref import (
    ArrayShot,
    Coherence,
    Motion,
    Params,
    read_image,
    read_nnf,
    stylize_frames,
    write_image,
)
from stylit_ref.cli import main
from stylit_ref.cli.shot_out import ShotOut
from stylit_ref.files.motion_flo import write_flo
from stylit_ref.views.keyframes import values_of_time, weights_with_time
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.reading import read_motion
from stylit_ref.views.run_folder import Run

PARAMS = Params(levels=2, votes=1, patchmatch_iterations=1)


def motion(folder):
    return "--motion", f"{folder}/flow.%04d.flo"


def edges(folder, pairs, frames=(1, 2, 3)):
    """What the flow of the shot tells of pairs of places in ``frames``."""
    of_frame = [read_motion(folder / f"flow.{frame:04d}.flo") for frame in (1, 2, 3)]
    return {
        (to, other): motion_between(
            frames[to], frames[other], dict(enumerate(of_frame, 1)).__getitem__
        )
        for to, other in pairs
    }


def written(folder, frames=(1, 2, 3)):
    return [read_image(folder / f"out.{frame:04d}.png") for frame in frames]


@pytest.mark.parametrize(
    ("flags", "coherence", "pairs"),
    [
        ((), Coherence(weight=1, order="sequential"), [(1, 0), (2, 1)]),
        (
            ("--coherence", 0.5, "--coherence-form", "plain", "--order", "parallel"),
            Coherence(weight=0.5, form="plain", order="parallel"),
            [(0, 1), (1, 0), (1, 2), (2, 1)],
        ),
        (
            ("--following-iters", "2,3"),
            Coherence(weight=1, order="sequential", following_votes=(2, 3)),
            [(1, 0), (2, 1)],
        ),
    ],
)
def test_it_writes_what_stylize_frames_yields(shot, flags, coherence, pairs):
    folder, style, sources, frames = shot
    assert sequence(folder, *motion(folder), *flags, "--nnf", f"{folder}/nnf.####.npy") == 0
    results = list(
        stylize_frames(style, sources, frames, PARAMS, coherence, edges=edges(folder, pairs))
    )
    for result, image in zip(results, written(folder), strict=True):
        np.testing.assert_array_equal(result.image, image)
        field = read_nnf(folder / f"nnf.{result.frame + 1:04d}.npy")
        np.testing.assert_array_equal(field.nnf, result.nnf)


@pytest.mark.parametrize(
    ("flags", "following"),
    [
        ((), (1, 2, 4)),
        (("--search-vote-iters", "1,2,4"), None),
        (("--order", "sweeps"), None),
        (("--coherence", 0), None),
        (("--following-iters", "2"), 2),
    ],
)
def test_frames_that_follow_take_less_in_the_fast_preset(shot, flags, following):
    folder = shot[0]
    assert sequence(
        folder, *motion(folder), "--preset", "fast", *flags, "--run", folder / "run", quick=()
    ) == 0  # fmt: skip
    assert Run(folder / "run").coherence.following_votes == following


def test_frames_that_nothing_pulls_at_are_those_of_run_in_the_fast_preset(shot):
    folder = shot[0]
    assert sequence(folder, *motion(folder), "--preset", "fast", "--coherence", 0, quick=()) == 0
    guides = ("source_{}.png", "target_{}.0003.png")
    assert run(folder, "--preset", "fast", guides=guides, quick=()) == 0
    np.testing.assert_array_equal(read_image(folder / "out.png"), written(folder)[2])


def test_the_first_frame_is_that_of_run_in_the_fast_preset(shot):
    folder = shot[0]
    assert sequence(folder, *motion(folder), "--preset", "fast", quick=()) == 0
    guides = ("source_{}.png", "target_{}.0001.png")
    assert run(folder, "--preset", "fast", guides=guides, quick=()) == 0
    np.testing.assert_array_equal(read_image(folder / "out.png"), written(folder)[0])


def test_without_motion_every_frame_is_that_of_run(shot, capsys):
    folder = shot[0]
    assert sequence(folder, "--frames", "1,3") == 0
    assert "each frame is stylized by itself" in capsys.readouterr().err
    alone = []
    for frame in (1, 3):
        assert run(folder, guides=("source_{}.png", f"target_{{}}.{frame:04d}.png")) == 0
        alone.append(read_image(folder / "out.png"))
    np.testing.assert_array_equal(written(folder, (1, 3)), alone)
    assert not (folder / "out.0002.png").exists()


def test_coherence_of_0_is_told_where_motion_is_named(shot, capsys):
    assert sequence(shot[0], *motion(shot[0]), "--coherence", 0, "--frames", "1-2") == 0
    said = capsys.readouterr().err
    assert "--coherence is 0, so the motion is not used; with a larger number strokes move" in said
    assert "name the motion" not in said


def test_motion_is_followed_through_frames_that_are_left_out(shot):
    folder, style, sources, frames = shot
    assert sequence(folder, *motion(folder), "--frames", "1-3x2") == 0
    expected = stylize_frames(
        style, sources, frames[::2], PARAMS, edges=edges(folder, [(1, 0)], (1, 3))
    )
    np.testing.assert_array_equal(written(folder, (1, 3)), [result.image for result in expected])


def test_a_file_of_each_pair(shot):
    folder, style, sources, frames = shot
    size = frames[0][0].shape[:2]
    of_frame = {}
    for to, other in ((1, 2), (2, 1), (2, 3), (3, 2)):
        flow = np.tile(np.float32([other - to, 0]), (*size, 1))
        write_flo(folder / f"{to}_to_{other}.flo", flow)
        of_frame[to, other] = Motion(flow, np.ones(size, bool))
    assert sequence(folder, "--motion", f"{folder}/%d_to_%d.flo", "--order", "parallel") == 0
    both = {n: FrameMotion(of_frame.get((n, n + 1)), of_frame.get((n, n - 1))) for n in (1, 2, 3)}
    pairs = {(a - 1, b - 1): motion_between(a, b, both.get) for a, b in of_frame}
    coherence = Coherence(weight=1, order="parallel")
    expected = stylize_frames(style, sources, frames, PARAMS, coherence, edges=pairs)
    for result in expected:
        np.testing.assert_array_equal(written(folder)[result.frame], result.image)


def test_realtime_makes_single_frames(shot, capsys):
    message = refused(capsys, sequence(shot[0], "--method", "realtime"))
    assert (
        "--method is realtime, which makes single frames: give each to 'stylit-ref run'" in message
    )


def test_a_number_of_another_width_is_named_as_it_is(shot, capsys):
    folder = shot[0]
    message = refused(capsys, sequence(folder, "--motion", f"{folder}/flow.%d.flo"))
    assert f"there are files of {folder}/flow.%04d.flo" in message


def test_numbers_of_pairs_of_another_width_are_named_as_they_are(shot, capsys):
    folder = shot[0]
    for name in ("0002_to_0001", "0003_to_0002"):
        (folder / f"{name}.flo").touch()
    message = refused(capsys, sequence(folder, "--motion", f"{folder}/%d_to_%d.flo"))
    assert f"there are files of {folder}/%04d_to_%04d.flo" in message


@pytest.mark.parametrize(("order", "both"), [("sequential", False), ("sweeps", True)])
def test_the_files_of_pairs_that_are_needed_are_told(shot, capsys, order, both):
    folder, size = shot[0], shot[3][0][0].shape[:2]
    write_flo(folder / "2_to_1.flo", np.zeros((*size, 2), np.float32))
    flags = "--motion", f"{folder}/%d_to_%d.flo", "--order", order
    needed = "from each frame to the one before it" + " and to the one after it" * both
    assert f"{folder}/3_to_2.flo" in (message := refused(capsys, sequence(folder, *flags)))
    assert f"--motion needs a file that leads {needed}; files of one direction alone are" in message


def test_files_of_pairs_that_lead_ahead_only_are_turned_around(shot, capsys):
    folder, _, _, frames = shot
    size = frames[0][0].shape[:2]
    flow = np.tile(np.float32([1, 0]), (*size, 1))
    write_flo(folder / "1_to_2.flo", flow)
    vectors = "--motion", f"{folder}/%d_to_%d.flo"
    assert f"{folder}/2_to_3.flo: no such file" in refused(capsys, sequence(folder, *vectors))
    write_flo(folder / "2_to_3.flo", flow)
    assert sequence(folder, *vectors) == 0
    assert (
        "--motion has files that all lead the same way; they are turned" in capsys.readouterr().err
    )
    of_pairs = written(folder)
    for frame in (1, 2):
        write_flo(folder / f"ahead.{frame}.flo", flow)
    of_frames = "--motion", f"{folder}/ahead.%d.flo", "--motion-convention", "flo"
    assert sequence(folder, *of_frames) == 0
    np.testing.assert_array_equal(of_pairs, written(folder))
    write_flo(folder / "2_to_1.flo", -flow)
    capsys.readouterr()
    assert f"{folder}/3_to_2.flo: no such file" in refused(capsys, sequence(folder, *vectors))


def test_turned_files_of_pairs_are_followed_through_frames_that_are_left_out(shot):
    folder, _, _, frames = shot
    flow = np.tile(np.float32([1, 0]), (*frames[0][0].shape[:2], 1))
    ids = "--ids", f"{folder}/ids.%d.png", "--frames", "1,3"
    for frame in (1, 2, 3):
        things = frames[frame - 1][0][..., :1] > 99
        write_image(folder / f"ids.{frame}.png", np.uint8(50 * things))
    for frame in (1, 2):
        write_flo(folder / f"{frame}_to_{frame + 1}.flo", flow)
        write_flo(folder / f"ahead.{frame}.flo", flow)
    assert sequence(folder, "--motion", f"{folder}/%d_to_%d.flo", *ids) == 0
    of_pairs = written(folder, (1, 3))
    of_frames = "--motion", f"{folder}/ahead.%d.flo", "--motion-convention", "flo"
    assert sequence(folder, *of_frames, *ids) == 0
    np.testing.assert_array_equal(of_pairs, written(folder, (1, 3)))


def test_files_of_pairs_are_followed_through_frames_that_are_left_out(shot, capsys):
    folder, size = shot[0], shot[3][0][0].shape[:2]
    flags = "--motion", f"{folder}/%d_to_%d.flo", "--frames", "1,3"

    def write(to, other, step):
        write_flo(folder / f"{to}_to_{other}.flo", np.tile(np.float32([step, 0]), (*size, 1)))

    assert f"{folder}/3_to_1.flo: no such file" in refused(capsys, sequence(folder, *flags))
    write(3, 2, -1)
    assert f"{folder}/2_to_1.flo: no such file" in refused(capsys, sequence(folder, *flags))
    write(2, 1, -1)
    assert sequence(folder, *flags) == 0
    composed = written(folder, (1, 3))
    write(3, 1, -2)
    assert sequence(folder, *flags) == 0
    np.testing.assert_array_equal(written(folder, (1, 3)), composed)
    write(3, 1, 6)
    assert sequence(folder, *flags) == 0
    assert not np.array_equal(written(folder, (1, 3)), composed)


def test_the_same_command_goes_on_where_it_was_interrupted(shot, capsys, monkeypatch):
    folder = shot[0]
    assert sequence(folder, *motion(folder)) == 0
    expected = written(folder)
    writing = ShotOut.writing

    def interrupted(outputs, result):
        if result.frame == 1:
            raise KeyboardInterrupt
        return writing(outputs, result)

    capsys.readouterr()
    with monkeypatch.context() as patched:
        patched.setattr(ShotOut, "writing", interrupted)
        assert sequence(folder, *motion(folder), "--work", folder / "work") == 130
    said = capsys.readouterr().err.splitlines()[-1]
    assert said == (
        f"stylit-ref: interrupted; 1 of 3 frames are written; the same command goes on from "
        f"{folder}/work"
    )
    assert sequence(folder, *motion(folder), "--work", folder / "work") == 0
    assert "2 of them were finished before" in capsys.readouterr().err
    np.testing.assert_array_equal(written(folder), expected)


def test_an_interruption_without_work_folder_says_how_to_go_on(shot, capsys, monkeypatch):
    def interrupted(*arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(ShotOut, "writing", interrupted)
    assert sequence(shot[0]) == 130
    assert capsys.readouterr().err.splitlines()[-1] == (
        "stylit-ref: interrupted; 0 of 3 frames are written; nothing else is kept, so the same "
        "command begins anew; add --work FOLDER, and it goes on where it was interrupted"
    )


def test_missing_frames_are_all_named_at_once(shot, capsys):
    folder = shot[0]
    (folder / "target_0.0002.png").unlink()
    (folder / "target_1.0003.png").unlink()
    message = refused(capsys, sequence(folder, "--frames", "1-5"))
    assert f"{folder}/target_0.%04d.png: there is no file for frames 2,4-5" in message
    assert f"{folder}/target_1.%04d.png: there is no file for frames 3-5" in message
    message = refused(capsys, sequence(folder))
    assert "there is no file for frame 2;" in message
    assert not list(folder.glob("out*"))


def test_a_gap_in_the_numbers_is_no_choice(shot, capsys):
    folder = shot[0]
    for guide in (0, 1):
        (folder / f"target_{guide}.0002.png").unlink()
    message = refused(capsys, sequence(folder))
    assert "there is no file for frame 2; render what is missing, or choose" in message
    assert not list(folder.glob("out*"))
    assert sequence(folder, "--frames", "1,3") == 0


def test_help_shows_names_as_they_are_typed(capsys):
    for command in (["sequence"], ["motion", "check"], ["replay"]):
        with pytest.raises(SystemExit):
            main([*command, "--help"])
        said = capsys.readouterr().out
        assert "%04d" in said
        assert "%%" not in said


def test_all_that_is_missing_is_named_at_once(shot, capsys):
    folder = shot[0]
    for name in ("target_0.0002.png", "flow.0001.flo", "source_1.png"):
        (folder / name).unlink()
    beside = "--depth", f"{folder}/depth.%d.exr", "--ids", f"{folder}/ids.%d.png"
    message = refused(capsys, sequence(folder, *motion(folder), *beside, "--frames", "1-3"))
    for name, which in (
        ("target_0.%04d.png", "for frame 2"),
        ("flow.%04d.flo", "for frame 1"),
        ("depth.%d.exr", "of such a name"),
        ("ids.%d.png", "of such a name"),
    ):
        assert f"{folder}/{name}: there is no file {which}" in message
    assert f"{folder}/source_1.png: no such file" in message


def test_the_header_of_every_file_is_read_before_anything_runs(shot, capsys):
    folder, size = shot[0], shot[3][0][0].shape[:2]
    vector = [f"Vector.{role}" for role in "XYZW"]
    for frame, names in (
        (1, (vector, ["Depth.Z"], ["Ids.X"])),
        (2, (vector, ["Depth.Z"], ["Ids.X"])),
        (3, (["Other.R", "Other.G"], ["Depth.X", "Depth.Y"], ["R", "G", "B"])),
    ):
        for kind, channels in zip(("vector", "depth", "ids"), names, strict=True):
            write_exr(folder / f"{kind}.{frame}.exr", dict.fromkeys(channels, 1), size)
    write_image(folder / "target_1.0002.png", np.zeros((30, 20, 1), np.uint8))
    flags = "--motion", f"{folder}/vector.%d.exr", "--depth", f"{folder}/depth.%d.exr"
    message = refused(capsys, sequence(folder, *flags, "--ids", f"{folder}/ids.%d.exr"))
    assert "target_1.0002.png: is 20x30 but" in message
    assert "vector.3.exr: the names of its channels do not tell the convention" in message
    assert "depth.3.exr: has 2 channels of half; depth is one channel of floating" in message
    assert "ids.3.exr: holds colours in floating point; IDs are" in message
    assert not list(folder.glob("out*"))


def test_frames_of_other_sizes_are_all_named_at_once(shot, capsys):
    folder = shot[0]
    for frame in (2, 3):
        write_image(folder / f"target_1.{frame:04d}.png", np.zeros((30, 20, 1), np.uint8))
    message = refused(capsys, sequence(folder, "--work", folder / "work"))
    assert message == (
        f"stylit-ref: {folder}/target_1.%04d.png: is 20x30 but {folder}/target_0.0001.png is "
        f"44x38; all frames must have the same size (in {folder}/target_1.0002.png, "
        f"{folder}/target_1.0003.png)"
    )
    assert not list(folder.glob("out*"))
    assert not (folder / "work").exists()


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--frames", "1-"), "--frames is '1-'; it must be numbers and ranges"),
        (("--motion", "flow.flo"), "--motion flow.flo: names one file; write %04d"),
        (("--output", "out.png"), "--output out.png: names one file; write %04d"),
        (("--output", "out.*.png"), "--output out.*.png: has a star where the number of the frame"),
        (("--motion", "flow.*.flo"), "--motion flow.*.flo: has a star where the number of the"),
        (("--nnf", "nnf.npy"), "--nnf nnf.npy: names one file; write %04d"),
        (("--output", "out.%04d.nothing"), "out.0001.nothing"),
        (("--following-iters", 1), "--following-iters is of use with --motion alone"),
        (("--coherence", 1), "--coherence is of use with --motion alone"),
        (("--ids", "ids.%04d.png"), "--ids is of use with --motion alone"),
        (("--method", "realtime"), "--method"),
    ],
)
def test_options_that_cannot_be_used(shot, capsys, flags, said):
    assert said in refused(capsys, sequence(shot[0], *flags))
    assert not list(shot[0].glob("out*"))


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--order", "parallel"), "with order 'sequential' alone"),
        (("--coherence", 0), "with a coherence above 0 alone"),
    ],
)
def test_votes_of_frames_that_follow_need_such_frames(shot, capsys, flags, said):
    flags = *motion(shot[0]), *flags, "--following-iters", 2
    message = refused(capsys, sequence(shot[0], *flags))
    assert f"--following-iters is of use {said}" in message


def test_motion_that_is_missing_is_named(shot, capsys):
    folder = shot[0]
    (folder / "flow.0003.flo").unlink()  # nothing comes after the last frame
    assert sequence(folder, *motion(folder), "--frames", "2-3") == 0
    capsys.readouterr()
    (folder / "flow.0002.flo").unlink()
    message = refused(capsys, sequence(folder, *motion(folder), "--frames", "1,3"))
    assert "there is no file for frame 2; the motion is followed through the frames" in message
    message = refused(capsys, sequence(folder, *motion(folder)))
    assert message.endswith("flow.%04d.flo: there is no file for frame 2")
    message = refused(capsys, sequence(folder, "--motion", f"{folder}/none.%04d.flo"))
    assert "there is no file of such a name" in message


def test_vectors_that_are_all_0_are_noted(shot, capsys):
    folder = shot[0]
    assert sequence(folder, *motion(folder), "--frames", "1-2") == 0
    assert "no vectors but 0" not in capsys.readouterr().err
    write_flo(folder / "flow.0001.flo", np.zeros((*shot[3][0][0].shape[:2], 2), np.float32))
    assert sequence(folder, *motion(folder), "--frames", "1-2") == 0
    assert "--motion has no vectors but 0 between the first two frames" in capsys.readouterr().err


def test_one_frame_needs_no_motion(shot):
    folder = shot[0]
    assert sequence(folder, "--motion", f"{folder}/none.%04d.flo", "--frames", 2) == 0
    assert sequence(folder, "--frames", 2, "--output", f"{folder}/alone.%d.png") == 0
    np.testing.assert_array_equal(written(folder, (2,))[0], read_image(folder / "alone.2.png"))


def test_nothing_moves_to_another_thing(shot):
    folder, size = shot[0], shot[3][0][0].shape[:2]
    assert sequence(folder) == 0
    alone = written(folder)
    for frame in (1, 2, 3):
        write_image(folder / f"ids.{frame}.png", np.full(size, 50 * frame, np.uint8))
    assert sequence(folder, *motion(folder), "--ids", f"{folder}/ids.%d.png") == 0
    np.testing.assert_array_equal(written(folder), alone)


def test_motion_of_another_size_is_named_before_anything_runs(shot, capsys):
    folder = shot[0]
    for frame in (1, 2):
        write_flo(folder / f"flow.{frame:04d}.flo", np.zeros((30, 20, 2), np.float32))
    message = refused(capsys, sequence(folder, *motion(folder)))
    assert "flow.%04d.flo: is 20x30 but the frames are 44x38" in message
    assert message.endswith(f"(in {folder}/flow.0001.flo, {folder}/flow.0002.flo)")
    assert not list(folder.glob("out*"))


def test_depth_is_a_distance(shot, capsys):
    folder = shot[0]
    flags = "--depth", f"{folder}/target_1.%04d.png"
    message = refused(capsys, sequence(folder, *motion(folder), *flags))
    assert (
        "target_1.%04d.png: has one channel of uint8; depth is one channel of floating" in message
    )
    assert "larger where it is farther: name a layer of an EXR, such as" in message
    assert not list(folder.glob("out*"))


@pytest.fixture
def layered(shot):
    """The shot's command with guides of EXR files, those of the frames with two layers."""
    folder = shot[0]
    write_exr(folder / "source.exr", {"Depth.Z": 1}, (40, 46))
    for frame in (1, 2, 3):
        layers = {"Depth.Z": frame, "View.Combined.R": 1}
        write_exr(folder / f"scene.{frame:04d}.exr", layers, (38, 44))
    command = ["sequence", "--style", f"{folder}/style.png", "--output", f"{folder}/out.%04d.png"]
    return folder, [*command, "--guide", f"{folder}/source.exr", f"{folder}/scene.%04d.exr"]


def test_several_layers_of_a_pattern_are_told_of_the_pattern(layered, capsys):
    folder, command = layered
    assert refused(capsys, main(command)) == (
        f"stylit-ref: {folder}/scene.%04d.exr: has several layers; write "
        f"{folder}/scene.%04d.exr:View.Combined, or name layers of both files with "
        "--guide-layers; its layers are: Depth, View.Combined"
    )


@pytest.mark.parametrize(("option", "layer"), [("--depth", "Depth"), ("--ids", "View.IndexOB")])
def test_of_several_layers_the_one_that_is_meant_is_offered(layered, capsys, option, layer):
    folder, command = layered
    for frame in (1, 2, 3):
        layers = {"Depth.Z": frame, "View.Combined.R": 1, "View.IndexOB.X": 1}
        write_exr(folder / f"scene.{frame:04d}.exr", layers, (38, 44))
    moved = "--motion", f"{folder}/flow.%04d.flo", option, f"{folder}/scene.%04d.exr"
    message = refused(capsys, main([*command, "--guide-layers", "Depth", *moved]))
    assert f"has several layers; write {folder}/scene.%04d.exr:{layer}; its layers" in message


def test_a_layer_that_is_missing_is_told_once(layered, capsys):
    folder, command = layered
    write_exr(
        folder / "scene.0002.exr", {"Depth.Z": 1, "View.Combined.R": 1, "Mist.Z": 1}, (38, 44)
    )
    moved = "--motion", f"{folder}/flow.%04d.flo", "--depth", f"{folder}/scene.%04d.exr:Mist"
    message = refused(capsys, main([*command, "--guide-layers", "Depth,Glossy", *moved]))
    assert message.count("has no layer 'Glossy'") == 3  # the source, and two kinds of frames
    assert message.count("has no layer 'Mist'") == 1
    there = "its layers are: Depth, View.Combined"
    both = f"(in {folder}/scene.0001.exr, {folder}/scene.0003.exr)"
    for layer in ("Glossy", "Mist"):
        assert f"{folder}/scene.%04d.exr: has no layer '{layer}'; {there} {both}" in message


@pytest.mark.parametrize("name", ["IndexOB", "Object Index", "object_index"])
def test_ids_of_any_version_of_blender(shot, name):
    folder, size = shot[0], shot[3][0][0].shape[:2]
    for frame, layer in ((1, "View.IndexOB"), (2, "View.Object Index"), (3, "View.IndexOB")):
        write_exr(folder / f"ids.{frame}.exr", {f"{layer}.X": frame}, size)
    assert sequence(folder) == 0
    alone = written(folder)
    assert sequence(folder, *motion(folder), "--ids", f"{folder}/ids.%d.exr:{name}") == 0
    np.testing.assert_array_equal(written(folder), alone)


@pytest.fixture
def masked(shot):
    """A mask for each frame of the shot, and the options for them."""
    folder, frames = shot[0], shot[3]
    masks = np.zeros((3, *frames[0][0].shape[:2]), bool)
    for number, mask in enumerate(masks):
        mask[10:, : 8 + 4 * number] = True
        write_image(folder / f"mask.{number + 1}.png", mask.astype(np.uint8) * 255)
    return masks, ("--mask", f"{folder}/mask.%d.png")


def test_masked_pixels_are_left_alone(shot, masked):
    folder, style, sources, frames = shot
    masks, flags = masked
    assert sequence(folder, *motion(folder), *flags, "--nnf", f"{folder}/nnf.%d.npy") == 0
    moved = edges(folder, [(1, 0), (2, 1)])
    results = stylize_frames(style, sources, ArrayShot(frames, moved, masks=masks), PARAMS)
    for result, image in zip(results, written(folder), strict=True):
        np.testing.assert_array_equal(result.image, image)
        np.testing.assert_array_equal(image[:, :, 3] == 0, masks[result.frame])
        field = read_nnf(folder / f"nnf.{result.frame + 1}.npy")
        np.testing.assert_array_equal(field.mask, masks[result.frame])


def test_without_motion_a_masked_frame_is_that_of_run(shot, masked):
    folder = shot[0]
    assert sequence(folder, *masked[1], "--frames", 2) == 0
    names = "source_{}.png", "target_{}.0002.png"
    assert run(folder, "--mask", folder / "mask.2.png", guides=names) == 0
    np.testing.assert_array_equal(written(folder, (2,))[0], read_image(folder / "out.png"))


def test_a_run_of_masked_frames_is_replayed_transparent(shot, masked):
    folder = shot[0]
    assert sequence(folder, *masked[1], "--frames", "1-2", "--run", folder / "run") == 0
    command = ["replay", "--run", f"{folder}/run", "--style", f"{folder}/style.png"]
    assert main([*command, "--output", f"{folder}/again.%04d.png", "--quiet"]) == 0
    for frame, image in enumerate(written(folder, (1, 2)), 1):
        np.testing.assert_array_equal(read_image(folder / f"again.{frame:04d}.png"), image)


@pytest.mark.parametrize("name", ["fill.%d.png", "fill.2.png"])
def test_a_fill_is_shown_where_frames_are_left_alone(shot, masked, name):
    folder, (masks, flags) = shot[0], masked
    fills = np.random.default_rng(6).integers(0, 256, (3, *masks[0].shape, 3), dtype=np.uint8)
    for number, fill in enumerate(fills, 1):
        write_image(folder / f"fill.{number}.png", fill)
    assert sequence(folder, *flags, "--frames", "1-2") == 0
    transparent = written(folder, (1, 2))
    assert sequence(folder, *flags, "--frames", "1-2", "--fill", folder / name) == 0
    for number, image in enumerate(written(folder, (1, 2))):
        mask, fill = masks[number], fills[1 if name == "fill.2.png" else number]
        np.testing.assert_array_equal(image[mask], fill[mask])
        np.testing.assert_array_equal(image[~mask], transparent[number][~mask][:, :3])


def test_fills_that_do_not_fit_are_refused(shot, masked, capsys):
    folder, flags = shot[0], masked[1]
    assert "--fill needs a --mask" in refused(capsys, sequence(folder, "--fill", "a.png"))
    for number, size in enumerate(((38, 44, 3), (38, 44), (30, 20, 3)), 1):
        write_image(folder / f"fill.{number}.png", np.zeros(size, np.uint8))
    message = refused(capsys, sequence(folder, *flags, "--fill", folder / "fill.%d.png"))
    assert f"fill.2.png: has 1 channels, and {folder}/fill.1.png 3; all" in message
    assert "fill.3.png: is 20x30 but the target is 44x38" in message
    message = refused(capsys, sequence(folder, *flags, "--fill", folder / "none.png"))
    assert "none.png" in message
    assert not list(folder.glob("out*"))


def test_masks_that_do_not_fit_are_refused(shot, masked, capsys):
    folder, flags = shot[0], masked[1]
    message = refused(capsys, sequence(folder, *flags, "--output", f"{folder}/out.%d.jpg"))
    assert f"{folder}/out.1.jpg: " in message  # which cannot be transparent
    write_image(folder / "mask.2.png", np.full((38, 44), 255, np.uint8))
    write_image(folder / "mask.3.png", np.zeros((30, 20), np.uint8))
    message = refused(capsys, sequence(folder, *flags))
    assert "mask.2.png: covers the whole target, so nothing is left" in message
    assert "mask.3.png: is 20x30 but the target is 44x38" in message
    (folder / "mask.3.png").unlink()
    message = refused(capsys, sequence(folder, *flags))
    assert message.endswith("mask.%d.png: there is no file for frame 3")
    assert not list(folder.glob("out*"))


@pytest.fixture
def painted(shot):
    """Frames 1 and 3 are painted: (folder, styles, guides, command without an output)."""
    folder, frames = shot[0], shot[3]
    rng, size = np.random.default_rng(5), frames[0][0].shape[:2]
    styles = [rng.integers(0, 256, (*size, 3), dtype=np.uint8) for _ in range(2)]
    for frame, image in zip((1, 3), styles, strict=True):
        write_image(folder / f"key.{frame:04d}.png", image)
    command = ["sequence", "--style", f"{folder}/key.%04d.png", *motion(folder), *QUICK]
    for k in range(2):
        command += ["--guide", *[f"{folder}/target_{k}.%04d.png"] * 2]
    return folder, styles, frames, command


def test_several_painted_frames_are_one_style_with_a_guide_of_time(painted):
    folder, styles, frames, command = painted
    nnf = "--nnf", f"{folder}/nnf.%d.npy"
    assert main([*command, "--output", f"{folder}/out.%04d.png", *nnf]) == 0
    size = styles[0].shape[:2]
    times = [np.full((*size, 1), value, np.uint8) for value in values_of_time((1, 2, 3), (1, 3))]
    shown = [[*guides, time] for guides, time in zip(frames, times, strict=True)]
    guides = [np.hstack(pair) for pair in zip(shown[0], shown[2], strict=True)]
    channels = sum(np.atleast_3d(guide).shape[2] for guide in frames[0])
    params = replace(PARAMS, guide_weights=weights_with_time((1, 1), channels, 2))
    moved = edges(folder, [(1, 0), (2, 1)])
    for result in stylize_frames(np.hstack(styles), guides, shown, params, edges=moved):
        np.testing.assert_array_equal(written(folder)[result.frame], result.image)
        np.testing.assert_array_equal(
            read_nnf(folder / f"nnf.{result.frame + 1}.npy").nnf, result.nnf
        )


def test_a_painted_frame_shows_its_own_painting(painted):
    folder, styles, frames, command = painted
    for frame, tint in ((1, 0), (3, 40)):
        grey = np.atleast_3d(frames[frame - 1][0])[:, :, :1]
        write_image(folder / f"key.{frame:04d}.png", np.repeat(grey // 2 + np.uint8(tint), 3, 2))
    nnf = "--nnf", f"{folder}/nnf.%d.npy"
    assert main([*command, "--output", f"{folder}/out.%04d.png", *nnf]) == 0
    fields = [read_nnf(folder / f"nnf.{frame}.npy").nnf for frame in (1, 2, 3)]
    shares = [(field[:, :, 1] >= styles[0].shape[1]).mean() for field in fields]
    assert shares[0] < 0.05
    assert shares[2] > 0.95
    assert shares[0] <= shares[1] <= shares[2]


def test_paintings_of_something_else_have_no_time(painted):
    folder, styles, frames, command = painted
    for k in range(2):
        for frame in (1, 3):
            guide = np.squeeze(frames[frame - 1][k])
            write_image(folder / f"sphere_{k}.{frame:04d}.png", guide)
    sources = [each.replace("target", "sphere") if command[n - 1] == "--guide" else each
               for n, each in enumerate(command)]  # fmt: skip
    assert main([*sources, "--output", f"{folder}/out.%04d.png"]) == 0
    guides = [np.hstack(pair) for pair in zip(frames[0], frames[2], strict=True)]
    moved = edges(folder, [(1, 0), (2, 1)])
    for result in stylize_frames(np.hstack(styles), guides, frames, PARAMS, edges=moved):
        np.testing.assert_array_equal(written(folder)[result.frame], result.image)


def test_a_run_of_several_paintings_is_replayed_with_others(painted):
    folder, styles, _, command = painted
    run = "--run", f"{folder}/run"
    assert main([*command, "--output", f"{folder}/out.%04d.png", *run]) == 0
    np.testing.assert_array_equal(Run(folder / "run").style(), np.hstack(styles))
    replay = ["replay", *run, "--style", f"{folder}/key.%04d.png"]
    assert main([*replay, "--output", f"{folder}/again.%04d.png"]) == 0
    for frame, image in zip((1, 2, 3), written(folder), strict=True):
        np.testing.assert_array_equal(read_image(folder / f"again.{frame:04d}.png"), image)


def test_paintings_that_do_not_fit_are_refused(painted, capsys):
    folder, styles, _, command = painted
    out = "--output", f"{folder}/out.%04d.png"
    assert f"{folder}/source_0.png: names one file; write" in refused(
        capsys, sequence(folder, "--style", f"{folder}/key.%04d.png")
    )
    none = ["--style", f"{folder}/none.%04d.png"]
    assert f"{folder}/none.%04d.png: there is no file of such a name" in refused(
        capsys, main([*command, *none, *out])
    )
    write_image(folder / "key.0007.png", styles[0])
    said = "target_0.%04d.png: there is no file for frame 7, which is painted"
    assert said in refused(capsys, main([*command, *out]))
    (folder / "key.0007.png").unlink()
    write_image(folder / "key.0003.png", styles[0][1:])
    assert (
        f"{folder}/key.0003.png is 44x37 with 3 channels of uint8, {folder}/key.0001.png is 44x38"
    ) in refused(capsys, main([*command, *out]))
    assert not list(folder.glob("out*"))


def test_folders_may_have_the_number_and_layers_name_their_images(shot):
    folder = shot[0]
    assert sequence(folder) == 0
    expected = written(folder)
    for name in ("source", "01", "02", "03"):
        (folder / name).mkdir()
        for k in range(2):
            old = f"source_{k}.png" if name == "source" else f"target_{k}.00{name}.png"
            (folder / old).rename(folder / name / f"{k}.png")
    command = ["sequence", "--style", f"{folder}/style.png", "--output", f"{folder}/out.%04d.png"]
    command += ["--guide", f"{folder}/source", f"{folder}/%02d", "--guide-layers", "0,1"]
    for frame in (1, 2, 3):
        (folder / f"out.{frame:04d}.png").unlink()
    assert main([*command, *QUICK]) == 0
    np.testing.assert_array_equal(written(folder), expected)


def test_a_style_of_16_bits_gives_frames_of_16_bits(shot):
    folder, style = shot[:2]
    write_image(folder / "style.png", style.astype(np.uint16) * 257)
    assert sequence(folder, "--frames", 1) == 0
    image = written(folder, (1,))[0]
    assert image.dtype == np.uint16
    assert (image % 257).any()


def test_float_guides_are_encoded_alike_in_all_frames(shot):
    folder = shot[0]
    depth = np.linspace(0, 1, 38 * 44).reshape(38, 44)
    write_exr(folder / "source_2.exr", {"Depth.Z": 1}, (40, 46), depth="float")
    for frame in (1, 2, 3):
        channels = {"Depth.Z": frame * depth}
        write_exr(folder / f"target_2.{frame:04d}.exr", channels, (38, 44), depth="float")
    more = "--guide", f"{folder}/source_2.exr", f"{folder}/target_2.%04d.exr"
    assert sequence(folder, *more, "--nnf", f"{folder}/%04d.npy") == 0
    encodings = {read_nnf(folder / f"{frame:04d}.npy").guide_encodings for frame in (1, 2, 3)}
    assert len(encodings) == 1
    assert 2.9 < encodings.pop()[2].high < 3.1


def test_run_explains_a_name_that_stands_for_many_frames(shot, capsys, nothing_written):
    folder = shot[0]
    message = refused(capsys, run(folder, guides=("source_{}.png", "target_{}.%04d.png")))
    assert "target_0.%04d.png: stands for the files of many frames" in message
    assert "'stylit-ref sequence'" in message


@pytest.mark.parametrize("kept", ["style.png", "notes.txt"])
def test_a_run_is_not_written_over_other_files(shot, capsys, kept):
    folder = shot[0]
    (folder / "painted").mkdir()
    shutil.copy(folder / "style.png", folder / "painted" / kept)
    before = (folder / "painted" / kept).read_bytes()
    message = refused(capsys, sequence(folder, "--run", folder / "painted"))
    assert f"{folder}/painted: holds other files than those of a RUN; name a new" in message
    assert [each.name for each in (folder / "painted").iterdir()] == [kept]
    assert (folder / "painted" / kept).read_bytes() == before
    assert not list(folder.glob("out*"))


@pytest.mark.parametrize(
    ("flags", "said"),
    [
        (("--style", "run/style.png"), "run/style.png: the output would overwrite this input"),
        (("--output", "run/pictures/%d.png"), "two outputs have this name; name another"),
        (("--nnf", "run/nnfs/%d.npy"), "two outputs have this name; name another"),
        (("--style", "run/pictures/9.png"), "run/pictures/9.png: the output would overwrite"),
    ],
)
def test_files_of_a_run_are_not_for_others(shot, capsys, monkeypatch, flags, said):
    folder = shot[0]
    for name in ("style", "pictures/9"):
        write_image(folder / "run" / f"{name}.png", shot[1])
    facts = '{"schema": "stylit-ref run", "digests": {"style.png": "", "pictures/9.png": ""}}'
    (folder / "run" / "run.json").write_text(facts, encoding="utf-8")
    monkeypatch.chdir(folder)
    assert said in refused(capsys, sequence(folder, "--run", "run", *flags))
    assert (folder / "run" / "run.json").read_text(encoding="utf-8") == facts


def test_an_interrupted_run_goes_on_with_its_folder(shot, capsys, monkeypatch):
    folder = shot[0]

    def interrupted(*arguments):
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(ShotOut, "writing", interrupted)
        assert sequence(folder, "--run", folder / "run") == 130
    said = capsys.readouterr().err.splitlines()[-1]
    assert f"0 of 3 frames are written, and {folder}/run is no whole RUN yet; nothing else" in said
    assert sequence(folder, "--run", folder / "run") == 0
    assert Run(folder / "run").names == ("1", "2", "3")
