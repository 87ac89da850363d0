"""``stylit-ref studio``: what it reads, says and refuses; serving itself is tested elsewhere."""

import sys

import numpy as np
import pytest
from cli.calls import refused
from small_run import write_run
from studio.small_studio import SIZE, TARGET_SIZE, write_passes

from stylit_ref import read_image, write_image
from stylit_ref.cli import main
from stylit_ref.cli.bundled_scenes import bundled_source
from stylit_ref.studio.painting.held import held


@pytest.fixture
def served(tmp_path, monkeypatch):
    """Stands in for the server: takes down what it is given, and is interrupted at once."""
    from stylit_ref.cli import studio_server

    given = {}

    def serve(beginning, engine, door, access, *, panels, listens):
        with door:
            listens()
        given.update(beginning=beginning, access=access,
                     panels=[panel.name for panel in panels])  # fmt: skip
        raise KeyboardInterrupt

    opened = []
    monkeypatch.setattr(studio_server, "serve", serve)
    monkeypatch.setattr(studio_server.webbrowser, "open", opened.append)
    monkeypatch.chdir(tmp_path)
    write_passes(tmp_path / "sphere", SIZE)
    write_passes(tmp_path / "robot", TARGET_SIZE, seed=1)
    given["opened"] = opened
    return given


def studio(*more):
    return main(["studio", *map(str, more)])


def own(*more, targets=("robot",)):
    return studio(*targets, "--source", "sphere", "--port", "0", *more)


def test_the_address_is_printed_and_a_file_opened_that_leads_there(served, tmp_path, capsys):
    assert own() == 130
    said = capsys.readouterr()
    address = served["access"].address
    assert said.out == f"The studio is at {address}\n"
    assert said.err.endswith("stylit-ref: interrupted; nothing was painted\n")
    assert served["opened"] == [(tmp_path / "painting/open_studio.html").as_uri()]
    assert not (tmp_path / "painting").exists()


def test_no_browser_and_quiet(served, capsys):
    assert own("--no-browser", "--quiet") == 130
    assert served["opened"] == []
    assert capsys.readouterr().err == "stylit-ref: interrupted; nothing was painted\n"


def test_the_bundled_scenes_are_offered(served):
    assert studio("--port", "0") == 130
    names = [offer.name for offer in served["beginning"].shelf]
    assert names[-7:-5] == ["golem", "teapot"]


def test_a_bundled_style_is_known_by_its_name(served):
    assert studio("--style", "oil", "--port", "0") == 130
    oil = next((bundled_source() / "styles").glob("oil.*"))
    assert np.array_equal(served["beginning"].saved.painting, read_image(oil))


def test_several_targets_are_offered(served, tmp_path):
    write_passes(tmp_path / "more" / "robot", TARGET_SIZE, seed=2)
    assert own(targets=["robot", "more/robot"]) == 130
    offers = list(served["beginning"].shelf)
    assert [offer.name for offer in offers] == ["1_robot", "2_robot"]
    assert [offer.title for offer in offers] == ["robot", "more/robot"]


def test_a_watched_file_that_is_not_there_is_written(served, tmp_path, capsys):
    assert own("--watch", "paint.png") == 130
    assert np.array_equal(read_image("paint.png"), read_image("sphere/FULL.png"))
    assert "paint.png is new" in capsys.readouterr().err
    assert str(served["beginning"].watch.file) == "paint.png"


def test_a_watched_file_that_is_there_is_the_painting(served):
    painting = np.full((*SIZE, 3), 7, np.uint8)
    write_image("paint.png", painting)
    assert own("--watch", "paint.png") == 130
    assert np.array_equal(served["beginning"].saved.painting, painting)


def test_a_style_that_is_neither_a_file_nor_bundled_leads_to_those_that_are(served, capsys):
    said = refused(capsys, studio("--style", "oils", "--port", "0"))
    assert "oils: no such file, and no bundled painting; those are crayon, oil, pen" in said


@pytest.mark.parametrize(
    ("more", "sentence"),
    [
        (["--port", "80"], "--port is 80; it must be 0, or from 1024 to 65535"),
        (["--port", "70000"], "--port is 70000; "),
        (["--threads", "0"], "--threads is 0; "),
        (["--style", "none.png"], "none.png"),
        (["--style", "robot/FULL.png"], "robot/FULL.png: is 28x20, but the painting is 32x24"),
        (["--painting", "sphere/FULL.png"], "sphere/FULL.png: is a file; name a folder"),
        (["--texture", "none.png"], "none.png: no such file"),
        (["--views", "none"], "none"),
        (["--watch", "painting/style.png"], "--watch is painting/style.png, where the studio"),
    ],
)
def test_what_cannot_be_used_is_a_sentence(served, capsys, more, sentence):
    assert sentence in refused(capsys, own(*more))
    assert "beginning" not in served


def test_a_target_that_is_not_there_is_refused(served, capsys):
    assert "nowhere: no such file or folder" in refused(capsys, own(targets=["nowhere"]))


def test_a_folder_that_another_studio_has_open_is_refused(served, tmp_path, capsys):
    with held(tmp_path / "painting"):
        assert "another studio has it open" in refused(capsys, own())
    assert own() == 130
    assert not (tmp_path / "painting").exists()  # nothing was painted


def test_a_source_without_a_target_is_refused(served, capsys):
    assert "--source is of no use without a TARGET" in refused(capsys, studio("--source", "sphere"))


@pytest.mark.parametrize("package", ["starlette", "uvicorn", "websockets"])
def test_a_missing_package_names_the_extra(tmp_path, monkeypatch, capsys, hidden, package):
    monkeypatch.chdir(tmp_path)
    _forget(monkeypatch, "stylit_ref.studio.server", "stylit_ref.cli.studio_server", "uvicorn")
    hidden(package)
    message = refused(capsys, studio())
    assert package in message
    assert "pip install 'stylit-ref[studio]'" in message


@pytest.mark.parametrize(
    ("room", "panel", "options"),
    [
        ("stylit_ref.texture", "texture", ["--texture", "sphere/FULL.png"]),
        ("stylit_ref.viewer", "views", ["--views", "run"]),
        ("stylit_ref.studio.sheet", "scan", []),
    ],
)
def test_a_panel_whose_room_is_missing_is_absent(served, monkeypatch, capsys, room, panel, options):
    names = "texture_panel", "texture_process", "dropped_texture", "scan_panel"
    own_names = (f"stylit_ref.studio.server.{name}" for name in names)
    _forget(monkeypatch, room, "stylit_ref.cli.studio_views", *own_names)
    monkeypatch.setitem(sys.modules, room, None)
    assert own(*options) == 130
    assert panel not in served["panels"]
    assert f"since {room}" in capsys.readouterr().err


def test_panels_are_there_when_they_are_asked_for(served, tmp_path):
    write_run(tmp_path / "run")
    assert own("--texture", "sphere/FULL.png") == 130
    assert served["panels"] == ["scan", "texture"]
    assert own("--views", "run") == 130
    assert served["panels"] == ["scan", "views"]


def _forget(monkeypatch, *names):
    """Have modules imported anew, and those within them."""
    for name in list(sys.modules):
        if any(name == each or name.startswith(f"{each}.") for each in names):
            monkeypatch.delitem(sys.modules, name)
