"""States on the disk."""

import os

import numpy as np
import pytest

from stylit_ref import InputError
from stylit_ref.views.work.state import State
from stylit_ref.views.work.work_folder import WorkFolder


def state(largest=300):
    rng = np.random.default_rng(0)
    nnf = rng.integers(0, largest, (5, 7, 2), dtype=np.int32)
    nnf[0, 0] = largest
    return State(nnf, rng.integers(0, 256, (5, 7, 3), dtype=np.uint8))


@pytest.mark.parametrize(("largest", "coordinate"), [(32767, 2), (32768, 4)])
def test_a_state_comes_back(tmp_path, largest, coordinate):
    folder, kept = WorkFolder(tmp_path / "new" / "work"), state(largest)
    folder.put("key", kept)
    found = folder.get("key")
    assert np.array_equal(found.nnf, kept.nnf)
    assert found.nnf.dtype == np.int32
    assert np.array_equal(found.picture, kept.picture)
    (file,) = folder.folder.iterdir()
    assert file.stat().st_size == 48 + 70 * coordinate + 105


@pytest.mark.parametrize("damage", ["emptied", "cut off", "changed"])
def test_a_damaged_state_is_missing(tmp_path, damage):
    folder = WorkFolder(tmp_path)
    folder.put("key", state())
    (file,) = tmp_path.iterdir()
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 1
    file.write_bytes({"emptied": b"", "cut off": data[:-40], "changed": data}[damage])
    assert folder.get("key") is None


def test_what_a_killed_writer_left_goes_after_an_hour(tmp_path):
    for name, age in ((".old.state", 4000), (".new.state", 0)):
        (tmp_path / name).touch()
        then = (tmp_path / name).stat().st_mtime - age
        os.utime(tmp_path / name, (then, then))
    WorkFolder(tmp_path)
    assert [file.name for file in tmp_path.iterdir()] == [".new.state"]


def test_a_file_in_the_place_of_the_folder_is_refused(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(InputError, match="file: is a file; name a folder"):
        WorkFolder(tmp_path / "file")
