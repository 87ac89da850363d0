"""``stylit-ref`` from end to end, at a small size."""

import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
from exr_files import write_exr
from small_scene import small_scene

from stylit_ref import PRESETS, InputError, Params, read_image, stylize, write_image
from stylit_ref.cli import main
from stylit_ref.files.bit_depth import to_linear

QUICK = ["--pyramid-levels", "2", "--search-vote-iters", "1", "--patchmatch-iters", "1"]


@pytest.fixture
def scene(tmp_path):
    """Files of a small scene: (folder, style, source guides, target guides)."""
    style, sources, targets = small_scene()
    write_image(tmp_path / "style.png", style)
    for k, (source, target) in enumerate(zip(sources, targets, strict=True)):
        write_image(tmp_path / f"source_{k}.png", source)
        write_image(tmp_path / f"target_{k}.png", target)
    return tmp_path, style, sources, targets


def run(folder, *more, style="style.png", guides=("source_{}.png", "target_{}.png")):
    """Call ``run`` on the scene's files; ``more`` comes after them."""
    command = ["run", "--style", f"{folder / style}", "--output", f"{folder / 'out.png'}"]
    for k in range(2):
        command += ["--guide", *(f"{folder / guide.format(k)}" for guide in guides)]
    return main([*command, *QUICK, *map(str, more)])


def refused(capsys, code):
    """The one sentence a refusal printed."""
    assert code == 2
    message = capsys.readouterr().err.strip()
    assert message.startswith("stylit-ref: ")
    assert "\n" not in message
    return message


def test_run_writes_what_stylize_returns(scene):
    folder, *arrays = scene
    code = run(
        folder, "--uniformity", 3000, "--seed", 5, "--nnf", folder / "nnf.npy",
        "--save-levels", folder / "levels", "--threads", 1,
    )  # fmt: skip
    assert code == 0
    params = Params(levels=2, votes=1, patchmatch_iterations=1, uniformity=3000)
    expected = stylize(*arrays, params, seed=5)
    np.testing.assert_array_equal(read_image(folder / "out.png"), expected.image)
    np.testing.assert_array_equal(np.load(folder / "nnf.npy"), expected.nnf)
    assert read_image(folder / "levels" / "level_1.png").shape == (19, 22, 3)
    np.testing.assert_array_equal(read_image(folder / "levels" / "level_2.png"), expected.image)
    assert not [file for file in folder.iterdir() if file.name.startswith(".")]


def test_every_method_flag_reaches_the_parameters(scene, monkeypatch):
    folder = scene[0]
    seen = {}

    def spy(*arguments, **options):
        seen["params"] = arguments[3]
        return stylize(*arguments, **options)

    monkeypatch.setattr("stylit_ref.cli.stylize", spy)
    run(
        folder, "--patch-size", 3, "--pyramid-levels", 1, "--search-vote-iters", 2,
        "--patchmatch-iters", 3, "--uniformity", 7, "--guide-influence", 4,
        "--schedule", "scanline", "--weight", 0.5,
    )  # fmt: skip
    assert seen["params"] == Params(
        patch_width=3,
        levels=1,
        votes=2,
        patchmatch_iterations=3,
        uniformity=7,
        guide_influence=4,
        guide_weights=(1.0, 0.5),
        schedule="scanline",
    )


@pytest.mark.parametrize(
    ("flags", "values"),
    [
        (["--method", "guide_map", "--epsilon", 3.5], {"method": "guide_map", "epsilon": 3.5}),
        (
            ["--method", "stylit", "--budget", 0.9, "--fixed-share", 1, "--error-limit", 5],
            {"method": "stylit", "budget": 0.9, "fixed_share": 1.0, "error_limit": 5.0},
        ),
        (["--method", "stylit", "--budget", "hyperbola"], {"method": "stylit"}),
        (["--vote-outliers", 3], {"vote_outliers": 3}),
    ],
    ids=str,
)
def test_the_methods_of_the_python_interface(scene, flags, values):
    folder, *arrays = scene
    assert run(folder, *flags) == 0
    params = Params(**({"levels": 2, "votes": 1, "patchmatch_iterations": 1} | values))
    expected = stylize(*arrays, params)
    np.testing.assert_array_equal(read_image(folder / "out.png"), expected.image)


@pytest.mark.parametrize(
    ("flags", "message"),
    [
        (["--epsilon", 5], "--epsilon is for --method guide_map; the method is ref"),
        (
            ["--method", "stylit", "--uniformity", 5],
            "--uniformity is for --method ref, guide_map; the method is stylit",
        ),
        (["--method", "guide_map", "--budget", 0.5], "--budget is for --method stylit"),
        (["--method", "magic"], "--method is 'magic'; it must be"),
        (["--method", "stylit", "--budget", 0], "--budget is 0.0; it must be 'hyperbola' or"),
        (["--method", "stylit", "--error-limit", 0.5], "--error-limit is 0.5"),
        (["--patch-size", 6], "--patch-size is 6; it must be an odd"),
        (["--seed", -1], "--seed is -1"),
        (["--save-levels", "/proc/levels"], "/proc/levels: cannot be made"),
        (["--save-levels", "x" * 300], "cannot be made: File name too long"),
        (["--method", "stylit", "--schedule", "scanline"], "--schedule is 'scanline'; it is for"),
        (["--backend", "cuda:live", "--method", "stylit"], "has no kernels for a GPU"),
    ],
    ids=str,
)
def test_flags_that_do_not_go_together(scene, capsys, flags, message):
    assert message in refused(capsys, run(scene[0], *flags))


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


def test_progress_shows_the_share_that_is_fixed(scene, monkeypatch, capfd):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert run(scene[0], "--method", "stylit") == 0
    last = capfd.readouterr().err.strip().split("\r")[-1]
    assert re.search(r"100%.*level 2/2  δ \d+  retrieval \d+: \d+% fixed", last)


def test_presets_fill_in_what_is_not_said(scene, monkeypatch):
    folder = scene[0]
    seen = []

    def spy(*arguments, **options):
        seen.append(arguments[3])
        raise InputError("enough")

    monkeypatch.setattr("stylit_ref.cli.stylize", spy)
    command = ["run", "--style", f"{folder / 'style.png'}", "--output", f"{folder / 'out.png'}"]
    command += ["--guide", f"{folder / 'source_0.png'}", f"{folder / 'target_0.png'}"]
    for more in ([], ["--preset", "fast"], ["--preset", "fast", "--search-vote-iters", "3,9"]):
        assert main([*command, *more]) == 2
    assert seen == [
        Params(guide_weights=(1.0,)),
        Params(**PRESETS["fast"], guide_weights=(1.0,)),
        Params(**(PRESETS["fast"] | {"votes": (3, 9)}), guide_weights=(1.0,)),
    ]


@pytest.mark.parametrize(
    ("votes", "message"),
    [
        ("a", "--search-vote-iters"),
        ("1,", "--search-vote-iters"),
        ("1,0", ": --search-vote-iters is 0;"),
    ],
)
def test_votes_that_are_no_counts(capsys, votes, message):
    command = ["run", "--style", "s", "--guide", "a", "b", "--output", "o"]
    try:
        code = main([*command, "--search-vote-iters", votes])
    except SystemExit as stop:
        code = stop.code
    assert code == 2
    said = capsys.readouterr().err.strip()
    assert message in said
    assert "\n" not in said


def test_profile_names_the_stages(scene, capsys):
    assert run(scene[0], "--profile", "--quiet") == 0
    lines = capsys.readouterr().err.strip().split("\n")
    assert re.match(r"stage +seconds +share +calls", lines[0])
    assert lines[-1].startswith("elsewhere ")
    stages = {re.match(r"(.+?) {2,}\d", line).group(1): line.split()[-1] for line in lines[1:]}
    assert stages["propagation"] == str(2 * 3)  # levels by distances
    assert stages["commit"] == str(2 * 4)
    assert {"reading images", "writing images", "vote", "random_search"} <= stages.keys()


def test_weight_without_guide(scene, capsys):
    with pytest.raises(SystemExit) as caught:
        main(["run", "--weight", "2", "--style", "s.png", "--output", "o.png"])
    assert caught.value.code == 2
    message = capsys.readouterr().err.strip()
    assert "must follow the --guide" in message
    assert "\n" not in message


def test_progress_shows_the_energy(scene, monkeypatch, capfd):
    folder = scene[0]
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert run(folder) == 0
    last = capfd.readouterr().err.strip().split("\r")[-1]
    assert re.search(r"100%.*level 2/2  φ \d+ = δ \d+ \+ λρ \d+", last)


def test_mask_without_fill_is_transparent(scene):
    folder = scene[0]
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    write_image(folder / "mask.png", mask)
    assert run(folder, "--mask", folder / "mask.png") == 0
    np.testing.assert_array_equal(read_image(folder / "out.png")[:, :, 3], 255 - mask)


def test_mask_with_fill(scene):
    folder = scene[0]
    mask = np.zeros((38, 44), np.uint8)
    mask[10:30, 10:30] = 255
    fill = np.full((38, 44, 3), 77, np.uint8)
    write_image(folder / "mask.png", mask)
    write_image(folder / "fill.png", fill)
    assert run(folder, "--mask", folder / "mask.png", "--fill", folder / "fill.png") == 0
    assert (read_image(folder / "out.png")[mask > 0] == 77).all()


def test_exr_layers_as_guides(scene):
    """Layers of linear light give the result of the same guides as display values."""
    folder, _, sources, targets = scene
    for side, guides in (("source", sources), ("target", targets)):
        first, second = (to_linear(guide) for guide in guides)
        channels = {f"LDE.{name}": first[:, :, c] for c, name in enumerate("RGB")}
        write_exr(folder / f"{side}.exr", channels | {"ID.Y": second[:, :, 0]}, second.shape[:2])
    command = ["run", "--style", f"{folder}/style.png", "--output", f"{folder}/exr.png", *QUICK]
    for layer in ("LDE", "ID"):
        command += ["--guide", f"{folder}/source.exr:{layer}", f"{folder}/target.exr:{layer}"]
    assert main(command) == 0
    assert run(folder) == 0
    np.testing.assert_array_equal(read_image(folder / "exr.png"), read_image(folder / "out.png"))


def test_sixteen_bit_grey_and_alpha_styles(scene):
    folder, style, *_ = scene
    write_image(folder / "deep.png", style.astype(np.uint16) * 257)
    write_image(folder / "grey.png", style[:, :, 0])
    alpha = np.dstack([style, np.full(style.shape[:2], 200, np.uint8)])
    alpha[:, :, :3] = np.minimum(alpha[:, :, :3], 200)
    write_image(folder / "alpha.tif", alpha)
    assert run(folder) == 0
    reference = read_image(folder / "out.png")
    assert run(folder, style="deep.png") == 0
    np.testing.assert_array_equal(read_image(folder / "out.png"), reference)
    assert run(folder, style="grey.png") == 0
    assert read_image(folder / "out.png").shape == (38, 44, 1)
    assert run(folder, style="alpha.tif") == 0
    assert (read_image(folder / "out.png")[:, :, 3] == 200).all()


def test_transparent_and_grey_guides_fit_their_partners(scene):
    """A render with a background alpha beside an opaque one, and grey beside colour."""
    folder, _, _, targets = scene
    alpha = np.full(targets[0].shape[:2], 255, np.uint8)
    alpha[:5] = 0
    write_image(folder / "target_0.png", np.dstack([targets[0] * (alpha > 0)[..., None], alpha]))
    write_image(folder / "target_1.png", targets[1].repeat(3, axis=2))
    assert run(folder) == 0
    assert read_image(folder / "out.png").shape == (38, 44, 3)


def test_replay(scene):
    folder, style, *_ = scene
    assert run(folder, "--nnf", folder / "nnf.npy") == 0
    replay = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--output", f"{folder / 'again.png'}"]
    assert main([*replay, "--style", f"{folder / 'style.png'}"]) == 0
    again = read_image(folder / "again.png")
    np.testing.assert_array_equal(again, read_image(folder / "out.png"))

    large = (style.astype(np.uint16) * 257).repeat(2, axis=0).repeat(2, axis=1)
    write_image(folder / "large.tif", large)
    assert main([*replay, "--style", f"{folder / 'large.tif'}", "--scale", "2"]) == 0
    assert read_image(folder / "again.png").shape == (76, 88, 3)
    assert read_image(folder / "again.png").dtype == np.uint16


class TestRefusals:
    """One sentence, exit code 2, and no file."""

    @pytest.fixture(autouse=True)
    def _nothing_written(self, scene):
        yield
        assert not (scene[0] / "out.png").exists()

    def test_style_and_guide_of_different_sizes(self, scene, capsys):
        folder, style, *_ = scene
        write_image(folder / "wide.png", np.pad(style, ((0, 0), (0, 9), (0, 0))))
        message = refused(capsys, run(folder, style="wide.png"))
        assert "source_0.png is 46x40 but the style is 55x40" in message

    def test_even_patch(self, scene, capsys):
        assert "odd" in refused(capsys, run(scene[0], "--patch-size", 4))

    def test_patch_larger_than_the_image(self, scene, capsys):
        message = refused(capsys, run(scene[0], "--patch-size", 41))
        assert "41" in message
        assert "46x40" in message

    def test_fewer_target_guides_cannot_be_said(self, scene, capsys):
        with pytest.raises(SystemExit) as caught:
            main(["run", "--style", "s.png", "--output", "o.png", "--guide", "a.png"])
        assert caught.value.code == 2
        assert "--guide" in capsys.readouterr().err

    def test_missing_file(self, scene, capsys):
        message = refused(capsys, run(scene[0], style="none.png"))
        assert "none.png: no such file" in message

    def test_missing_layer(self, scene, capsys):
        folder = scene[0]
        write_exr(folder / "source_0.exr", {"LDE.R": 0.1, "LSE.R": 0.1}, (40, 46))
        guides = ("source_0.exr:LDDE", "target_{}.png")
        message = refused(capsys, run(folder, guides=guides))
        assert "no layer 'LDDE'" in message
        assert "LDE, LSE" in message

    def test_nan(self, scene, capsys):
        folder = scene[0]
        write_exr(folder / "nan.exr", {"R": np.nan, "G": 0, "B": 0}, (40, 46))
        message = refused(capsys, run(folder, style="nan.exr"))
        assert "1840 pixels are NaN or infinite" in message

    @pytest.mark.parametrize(
        ("option", "value", "message"),
        [
            ("--output", "none/out.png", "does not exist"),
            ("--output", "out.docx", "'.docx'"),
            ("--nnf", "none/nnf.npy", "does not exist"),
            ("--nnf", "nnf.txt", "written as .npy"),
            ("--save-levels", "style.png", "style.png: cannot be made"),
            ("--save-levels", "style.png/deep", "deep: cannot be made"),
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
        assert f"{taken}: is read too; name another file" in refused(capsys, code)
        assert (folder / taken).read_bytes() == before

    def test_outputs_of_one_name(self, scene, capsys):
        folder = scene[0]
        code = run(folder, "--save-levels", folder / "out.png")
        assert "out.png: is named twice" in refused(capsys, code)

    def test_a_full_disk(self, scene, capsys, monkeypatch):
        free = shutil.disk_usage(scene[0])._replace(free=5000)
        monkeypatch.setattr(shutil, "disk_usage", lambda _: free)
        message = refused(capsys, run(scene[0]))
        assert "out.png: cannot be written: it may need 0.1 MiB and 0.0 MiB are free" in message

    @pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
    def test_folder_without_permission(self, scene, capsys, tmp_path):
        locked = tmp_path / "locked"
        locked.mkdir(mode=0o500)
        assert "permission" in refused(capsys, run(scene[0], "--output", locked / "out.png"))

    def test_nothing_is_made_before_all_is_checked(self, scene, capsys):
        folder = scene[0]
        levels = folder / "new" / "levels"
        refused(capsys, run(folder, "--save-levels", levels, "--threads", 100000))
        assert not levels.parent.exists()

    def test_fill_without_mask(self, scene, capsys):
        assert "--mask" in refused(capsys, run(scene[0], "--fill", scene[0] / "style.png"))

    def test_mask_of_another_size(self, scene, capsys):
        folder = scene[0]
        assert "style.png is 46x40 but the target is 44x38" in refused(
            capsys, run(folder, "--mask", folder / "style.png")
        )

    def test_replay_of_something_else(self, scene, capsys):
        folder = scene[0]
        (folder / "text.npy").write_text("no array")
        np.save(folder / "objects.npy", np.array([{}], object), allow_pickle=True)
        (folder / "zip.npy").write_bytes(b"PK" + bytes(100))
        np.save(folder / "float.npy", np.zeros((4, 4, 2)))
        for name in ("none.npy", "text.npy", "objects.npy", "zip.npy", "float.npy"):
            replay = ["replay", "--nnf", f"{folder / name}", "--output", f"{folder / 'out.png'}"]
            code = main([*replay, "--style", f"{folder / 'style.png'}"])
            message = refused(capsys, code)
            assert name in message or "float64" in message


def test_replay_in_a_process_of_its_own(scene):
    """With nothing compiled before it, in the process or on disk."""
    folder, style, *_ = scene
    nnf = np.stack(np.mgrid[2:38, 2:44], axis=-1).astype(np.int32)
    np.save(folder / "nnf.npy", nnf)
    command = [sys.executable, "-m", "stylit_ref.cli", "replay", "--nnf", f"{folder / 'nnf.npy'}"]
    command += ["--style", f"{folder / 'style.png'}", "--output", f"{folder / 'out.png'}"]
    environment = os.environ | {"NUMBA_CACHE_DIR": str(folder / "kernels")}
    subprocess.run(command, check=True, env=environment)
    np.testing.assert_array_equal(read_image(folder / "out.png"), style[2:38, 2:44])


def test_interruption_leaves_nothing(scene):
    """Ctrl-C in the middle of the work: code 130, one sentence, no output.

    The signal comes when the first of two equally long levels is done.
    """
    folder = scene[0]
    command = [sys.executable, "-m", "stylit_ref.cli", "run", "--style", f"{folder}/style.png"]
    command += ["--output", f"{folder}/out.png", "--nnf", f"{folder}/nnf.npy", "--quiet"]
    command += ["--guide", f"{folder}/source_0.png", f"{folder}/target_0.png"]
    command += ["--save-levels", f"{folder}/levels", "--search-vote-iters", "300"]
    command += ["--pyramid-levels", "2"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    try:
        limit = time.monotonic() + 300
        while not (folder / "levels" / "level_1.png").exists():
            assert time.monotonic() < limit, "the first level takes too long"
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=120)
    finally:
        process.kill()
    # Where Ctrl-C strikes inside an exec, as when Numba makes a function of text, `python -m` ends
    # by the signal, though the exception was caught; to a shell that is 130 too.
    assert process.returncode in (130, -signal.SIGINT)
    assert errors.strip() == "stylit-ref: interrupted; no half-written file is left"
    assert not (folder / "out.png").exists()
    assert not (folder / "nnf.npy").exists()
    assert [file.name for file in (folder / "levels").iterdir()] == ["level_1.png"]
    assert not [file for file in folder.iterdir() if file.name.startswith(".")]


def test_the_example_can_be_stylized(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["example", "some scenes"]) == 0
    words = shlex.split(capsys.readouterr().out)
    assert words[0] == "stylit-ref"
    assert main([*words[1:], *QUICK]) == 0
    size = read_image("some scenes/teapot/FULL.png").shape[:2]
    assert read_image("some scenes/stylized.png").shape == (*size, 3)
    assert [file.name for file in tmp_path.iterdir()] == ["some scenes"]


def test_an_example_replaces_nothing(tmp_path, capsys):
    assert main(["example", str(tmp_path)]) == 2
    assert f"{tmp_path}: exists; name a new folder" in capsys.readouterr().err


def test_what_changes_nothing_is_noted(scene, capsys):
    folder = scene[0]
    write_image(folder / "my\rmask.png", np.zeros((38, 44, 1), np.uint8))
    assert run(folder, "--mask", folder / "my\rmask.png") == 0
    assert "my mask.png: no pixel is white, so none is left alone" in capsys.readouterr().err


def test_fewer_levels_are_noted_where_levels_were_asked_for(scene, capsys):
    folder, style, guide = scene[0], scene[0] / "style.png", scene[0] / "source_0.png"
    command = ["run", "--style", f"{style}", "--guide", f"{guide}", f"{guide}"]
    command += ["--preset", "fast", "--quiet", "--output", f"{folder / 'out.png'}"]
    assert main(command) == 0
    assert "pyramid levels" not in capsys.readouterr().err
    assert main([*command, "--pyramid-levels", "9"]) == 0
    assert "pyramid levels in place of 9" in capsys.readouterr().err
