"""Vectors in the files of several programs."""

import tracemalloc

import numpy as np
import pytest
from exr_files import write_exr, write_named_parts

from stylit_ref import InputError, write_image
from stylit_ref.files.motion_file import VectorsLook, look_at_vectors, read_vectors
from stylit_ref.files.motion_flo import MARK, read_flo, write_flo
from stylit_ref.views.motion.reading import read_motion

BLENDER = {"X": -8, "Y": -4, "Z": -16, "W": -2}
COLOURS = dict.fromkeys(("ViewLayer.Combined.R", "ViewLayer.Combined.G", "ViewLayer.Combined.B"), 1)


def values(vectors):
    return tuple(pair if pair is None else tuple(map(float, pair[0, 0])) for pair in vectors.pairs)


@pytest.mark.parametrize("name", ["ViewLayer.Vector", "RenderLayer.Vector", "Vector"])
def test_blender_in_one_part(tmp_path, name):
    channels = COLOURS | {f"{name}.{role}": value for role, value in BLENDER.items()}
    vectors = read_vectors(write_exr(tmp_path / "a.exr", channels))
    assert (values(vectors), vectors.dialect) == (((-8, -4), (-16, -2)), "blender")
    assert vectors.visible is None


@pytest.mark.parametrize("prefix", ["ViewLayer.Vector.", ""])
def test_blender_in_many_parts(tmp_path, prefix):
    vector = {f"{prefix}{role}": value for role, value in BLENDER.items()}
    parts = [({"name": "ViewLayer.Combined"}, COLOURS), ({"name": "ViewLayer.Vector"}, vector)]
    file = write_named_parts(tmp_path / "a.exr", parts)
    for path in (file, f"{file}:ViewLayer.Vector", f"{file}:Vector"):
        vectors = read_vectors(path)
        assert (values(vectors), vectors.dialect) == (((-8, -4), (-16, -2)), "blender")


def test_two_view_layers_with_vectors_are_refused(tmp_path):
    channels = {f"{name}.Vector.{role}": 0 for name in ("Near", "Far") for role in BLENDER}
    file = write_exr(tmp_path / "a.exr", channels)
    with pytest.raises(InputError, match=r"name one after a colon: Far.Vector, Near.Vector"):
        read_vectors(file)
    assert read_vectors(f"{file}:Far.Vector").dialect == "blender"


@pytest.mark.parametrize(
    ("names", "expected"),
    [
        (("forward", "backward"), ((3, 4), (5, 6))),
        (("forward",), ((3, 4), None)),
        (("backward",), (None, (5, 6))),
    ],
)
def test_nuke(tmp_path, names, expected):
    stored = {"forward.u": 3, "forward.v": 4, "backward.u": 5, "backward.v": 6}
    channels = {name: v for name, v in stored.items() if name.partition(".")[0] in names}
    vectors = read_vectors(write_exr(tmp_path / "a.exr", channels | dict.fromkeys("RGB", 1)))
    assert (values(vectors), vectors.dialect) == (expected, "nuke")


def test_own(tmp_path):
    visible = np.arange(48).reshape(6, 8) % 2
    channels = {"MOTION.X": 3, "MOTION.Y": -4, "VISIBLE.Y": visible}
    vectors = read_vectors(write_exr(tmp_path / "a.exr", channels))
    assert (values(vectors), vectors.dialect) == (((3, -4),), "own")
    assert np.array_equal(vectors.visible, visible == 1)


def test_a_named_layer_of_another_program(tmp_path):
    channels = {"motionvector.R": 3, "motionvector.G": -4, "motionvector.B": 0, "Z": 1}
    file = write_exr(tmp_path / "a.exr", channels)
    vectors = read_vectors(f"{file}:motionvector")
    assert (values(vectors), vectors.dialect) == (((3, -4),), "other")


def test_flo(tmp_path):
    vectors = np.random.default_rng(0).normal(size=(3, 5, 2)).astype(np.float32)
    write_flo(tmp_path / "a.flo", vectors)
    assert (tmp_path / "a.flo").read_bytes()[:12] == MARK + b"\5\0\0\0\3\0\0\0"
    read = read_vectors(tmp_path / "a.flo")
    assert np.array_equal(read.pairs[0], vectors)
    assert read.known[0].all()
    assert read.dialect == "flo"


@pytest.mark.parametrize("broken", [2e9, -2e9, np.nan, np.inf])
def test_unknown_vectors_are_zero_and_not_known(tmp_path, broken):
    vectors = np.ones((2, 3, 2), np.float32)
    vectors[1, 2, 0] = broken
    write_flo(tmp_path / "a.flo", vectors)
    read = read_vectors(tmp_path / "a.flo")
    assert read.known[0].tolist() == [[True] * 3, [True, True, False]]
    assert read.pairs[0][1, 2].tolist() == [0, 0]


def test_a_vector_unknown_in_one_direction_is_known_in_the_other(tmp_path):
    broken = np.zeros((6, 8))
    broken[1, 2] = np.inf
    file = write_exr(tmp_path / "a.exr", BLENDER | {"Z": broken})
    read = read_vectors(file)
    assert read.known[0].all()
    assert np.array_equal(read.known[1], np.isfinite(broken))
    assert (read.pairs[0] == (BLENDER["X"], BLENDER["Y"])).all()
    motion = read_motion(file)
    assert motion.backward.visible.all()
    assert np.argwhere(~motion.forward.visible).tolist() == [[1, 2]]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"PIEH", "does not begin with PIEH"),
        (b"\x89PNG\r\n\x1a\n" + bytes(99), "does not begin with PIEH"),
        (MARK + np.int32([-1, 3]).tobytes(), "declares -1x3 pixels"),
        (MARK + np.int32([1 << 20, 1 << 20]).tobytes(), "declares 1048576x1048576 pixels"),
        (MARK + np.int32([2, 1]).tobytes() + bytes(15), "has 27 bytes, and 2x1 pixels need 28"),
        (MARK + np.int32([2, 1]).tobytes() + bytes(17), "has 29 bytes, and 2x1 pixels need 28"),
    ],
)
def test_broken_flo_files_are_refused(tmp_path, content, message):
    (tmp_path / "a.flo").write_bytes(content)
    with pytest.raises(InputError, match=message):
        read_flo(tmp_path / "a.flo")


def test_a_picture_of_whole_numbers_is_refused(tmp_path):
    write_image(tmp_path / "a.png", np.zeros((4, 4, 3), np.uint8))
    with pytest.raises(InputError, match="holds whole numbers; write vectors as floating point"):
        read_vectors(tmp_path / "a.png")


def test_one_channel_is_refused(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"Z": 1})
    with pytest.raises(InputError, match="has one channel; vectors need two"):
        read_vectors(file)


def test_a_look_reads_the_header_alone(tmp_path):
    with (tmp_path / "a.flo").open("wb") as file:
        file.write(MARK + np.int32([1024, 512]).tobytes())
        file.truncate(12 + 8 * 1024 * 512)
    tracemalloc.start()
    look = look_at_vectors(tmp_path / "a.flo")
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert look == VectorsLook((512, 1024), (True,), "flo")
    assert most < 100_000


@pytest.mark.parametrize(
    ("channels", "pairs", "dialect"),
    [
        ([f"ViewLayer.Vector.{role}" for role in BLENDER], (True, True), "blender"),
        (["forward.u", "forward.v"], (True, False), "nuke"),
        (["backward.u", "backward.v"], (False, True), "nuke"),
        (["MOTION.X", "MOTION.Y", "VISIBLE.Y"], (True,), "own"),
        (["a.R", "a.G"], (True,), "other"),
    ],
)
def test_a_look_tells_what_vectors_there_are(tmp_path, channels, pairs, dialect):
    file = write_exr(tmp_path / "a.exr", dict.fromkeys(channels, 1), (6, 9))
    assert look_at_vectors(file) == VectorsLook((6, 9), pairs, dialect)
