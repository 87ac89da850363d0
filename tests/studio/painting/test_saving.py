"""The painting on the disk: whole at any time, the newest state, and not too often."""

import json
import subprocess
import sys
from threading import Event

import numpy as np
import pytest

from stylit_ref import InputError, read_image
from stylit_ref.studio.painting.autosave import Autosave
from stylit_ref.studio.painting.easel import Easel
from stylit_ref.studio.painting.folder import PaintingFolder, Saved, Setting

SIZE = 30, 40


def saved(value, **setting):
    painting = np.full((*SIZE, 3), value, np.uint8)
    return Saved(painting, np.zeros_like(painting), Setting(**setting))


def test_what_is_saved_is_loaded(tmp_path):
    folder = PaintingFolder(tmp_path / "deep" / "painting")
    assert folder.load(SIZE) is None
    setting = {"scene": "golem", "step": 2, "seed": 7, "serial": 12, "parameters": {"mu": [1, 0]},
               "weights": {"LDE": 3}, "layers": {"golem": ["LDE"]}}  # fmt: skip
    folder.save(saved(9, **setting))
    back = folder.load(SIZE)
    assert (back.painting == 9).all()
    assert (back.beginning == 0).all()
    assert vars(back.setting) == setting
    assert {file.name for file in folder.folder.iterdir()} == {
        "style.png", "beginning.png", "studio.json",
    }  # fmt: skip


def test_a_painting_of_another_size_is_refused(tmp_path):
    folder = PaintingFolder(tmp_path)
    folder.save(saved(1))
    with pytest.raises(InputError, match=r"style.png: is 40x30, .* 31x30; .* --painting"):
        folder.load((30, 31))


@pytest.mark.parametrize(
    "text",
    [
        "", "{", "[]", "{}", '{"version": 2}', '{"version": 1, "more": 1}',
        '{"version": 1, "step": "a"}', '{"version": 1, "step": -1}', '{"version": 1, "serial": -1}',
        '{"version": 1, "serial": 4294967296}', "[" * 5000,
    ],
)  # fmt: skip
def test_a_damaged_setting_leaves_the_painting(tmp_path, text, caplog):
    folder = PaintingFolder(tmp_path)
    folder.save(saved(4, seed=3))
    (tmp_path / "studio.json").write_text(text)
    back = folder.load(SIZE)
    assert (back.painting == 4).all()
    assert back.setting == Setting()
    assert "studio.json: cannot be read" in caplog.text


def test_the_newest_state_is_saved_in_few_steps(tmp_path):
    told, first = [], Event()

    def tell(error):
        told.append(error)
        first.set()

    autosave = Autosave(PaintingFolder(tmp_path), tell, pause=60)
    autosave.save(saved(0))
    assert first.wait(10)
    for value in range(1, 20):
        autosave.save(saved(value))
    autosave.close()  # does not wait for the pause to end
    assert (read_image(tmp_path / "style.png") == 19).all()
    assert told == [None, None]


def test_what_cannot_be_saved_is_told_and_tried_once_more_in_the_end(tmp_path):
    told, first = [], Event()

    def tell(error):
        told.append(error)
        first.set()

    folder = PaintingFolder(tmp_path / "painting")
    (tmp_path / "painting").write_text("a file")
    autosave = Autosave(folder, tell)
    autosave.save(saved(1))
    assert first.wait(10)
    with pytest.raises(InputError, match="painting"):
        autosave.close()
    assert len(told) == 2
    first.clear()
    autosave = Autosave(folder, tell)
    autosave.save(saved(2))
    assert first.wait(10)
    (tmp_path / "painting").unlink()
    autosave.close()
    assert (read_image(tmp_path / "painting" / "style.png") == 2).all()


def test_a_failure_that_nobody_foresaw_is_told_and_saving_goes_on(tmp_path, monkeypatch, caplog):
    told, first = [], Event()

    def tell(error):
        told.append(error)
        first.set()

    def fail(folder, state):
        monkeypatch.undo()
        raise RuntimeError("nobody foresaw it")

    monkeypatch.setattr(PaintingFolder, "save", fail)
    autosave = Autosave(PaintingFolder(tmp_path), tell)
    autosave.save(saved(1))
    assert first.wait(10)
    assert "nobody foresaw it" in caplog.text
    assert str(told[0]) == "something went wrong; the terminal says what"
    autosave.save(saved(2))
    autosave.close()
    assert (read_image(tmp_path / "style.png") == 2).all()


def test_an_easel_that_cannot_be_closed_goes_on(tmp_path):
    easel = Easel(PaintingFolder(tmp_path / "painting"), saved(1), [].append)
    (tmp_path / "painting").write_text("a file")
    easel.paint(2, 3, np.full((4, 5, 3), 8, np.uint8), 6)
    with pytest.raises(InputError, match="painting"):
        easel.close()
    (tmp_path / "painting").unlink()
    easel.close()
    assert (read_image(tmp_path / "painting" / "style.png")[3:7, 2:7] == 8).all()


def test_an_easel_saves_what_has_changed(tmp_path):
    told = []
    easel = Easel(PaintingFolder(tmp_path / "painting"), saved(1), told.append)
    easel.close()
    assert told == []
    assert not (tmp_path / "painting").exists()
    easel = Easel(PaintingFolder(tmp_path / "painting"), saved(1), told.append)
    easel.paint(2, 3, np.full((4, 5, 3), 8, np.uint8), 6)
    easel.close()
    painting = read_image(tmp_path / "painting" / "style.png")
    assert (painting[3:7, 2:7] == 8).all()
    assert np.count_nonzero(painting == 8) == 4 * 5 * 3
    assert json.loads((tmp_path / "painting" / "studio.json").read_text())["serial"] == 6


SAVER = """
import sys
import numpy as np
from stylit_ref.studio.painting import folder as rooms

place, stop = sys.argv[1:]
folder = rooms.PaintingFolder(place)
folder.save(rooms.Saved(*[np.full((30, 40, 3), value, np.uint8) for value in (1, 0)],
                        rooms.Setting(serial=1)))

def wait(*arguments):
    print("ready", flush=True)
    sys.stdin.read()

if stop == "before the rename":
    import os
    os.replace = wait
else:
    rooms.write_text = wait
folder.save(rooms.Saved(*[np.full((30, 40, 3), value, np.uint8) for value in (2, 0)],
                        rooms.Setting(serial=2)))
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("stop", "value"), [("before the rename", 1), ("between the two files", 2)]
)
def test_killed_while_it_saves(tmp_path, stop, value):
    process = subprocess.Popen(
        [sys.executable, "-c", SAVER, tmp_path, stop],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "ready\n"
    process.kill()
    process.wait()
    process.stdin.close()
    process.stdout.close()
    back = PaintingFolder(tmp_path).load(SIZE)
    assert (back.painting == value).all()
    assert back.setting.serial == 1  # so a page that has painted more sends it again
    PaintingFolder(tmp_path).save(saved(3, serial=3))
    assert (PaintingFolder(tmp_path).load(SIZE).painting == 3).all()
