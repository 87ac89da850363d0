"""Files of motion, depth and IDs as ``sequence`` and ``views`` read them."""

import numpy as np
import pytest
from exr_files import write_exr

from stylit_ref import InputError, write_image
from stylit_ref.cli.motion_files import (
    VectorsOfFrames,
    VectorsOfPairs,
    read_depth,
    read_ids,
)
from stylit_ref.files.motion_flo import write_flo
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.reading import read_motion

SIZE = 24, 30


@pytest.fixture
def files(tmp_path):
    """A bar that moves by 2 pixels in front of a still ground: flow, depth and IDs by frame."""
    named = {"flow": {}, "depth": {}, "ids": {}}
    for frame in (1, 2):
        bar = np.zeros(SIZE, bool)
        bar[:, 10 + 2 * frame : 14 + 2 * frame] = True
        named["flow"][frame] = str(tmp_path / f"{frame}.flo")
        write_flo(named["flow"][frame], np.stack([2 * bar, 0 * bar], axis=2).astype(np.float32))
        depth = {"Depth.Z": np.where(bar, 1, 9)}
        named["depth"][frame] = str(write_exr(tmp_path / f"d{frame}.exr", depth, SIZE))
        named["ids"][frame] = str(tmp_path / f"i{frame}.png")
        write_image(named["ids"][frame], np.where(bar, 200, 0).astype(np.uint8))
    return named


def expected(files, to, other):
    def read(name, how):
        return {frame: how(file) for frame, file in files[name].items()}.get

    return motion_between(
        to, other, read("flow", read_motion),
        depth_of=read("depth", read_depth), labels_of=read("ids", read_ids),
    )  # fmt: skip


@pytest.mark.parametrize(("to", "other"), [(1, 2), (2, 1)])
def test_a_file_of_each_frame(files, to, other):
    motion = VectorsOfFrames(to, other, files["flow"], "flo", files["depth"], files["ids"])
    for found, wanted in zip(motion.read(), expected(files, to, other), strict=True):
        np.testing.assert_array_equal(found, wanted)


def test_a_file_of_a_pair(files):
    del files["flow"][2]  # nothing leads back
    depth, ids = (dict(enumerate(files[name].values())) for name in ("depth", "ids"))
    motion = VectorsOfPairs((files["flow"][1],), (None,), "flo", depth, ids)
    for found, wanted in zip(motion.read(), expected(files, 1, 2), strict=True):
        np.testing.assert_array_equal(found, wanted)


@pytest.mark.parametrize("leads_back", [False, True])
def test_files_of_pairs_over_a_frame_between(tmp_path, leads_back):
    """As files of frames that say the same."""
    flow = {}
    for to, other, step in ((1, 2, 2), (2, 3, 3), (2, 1, -2), (3, 2, -3)):
        flow[to, other] = str(tmp_path / f"{to}_to_{other}.flo")
        write_flo(flow[to, other], np.tile(np.float32([step, 0]), (*SIZE, 1)))
    backs = (flow[2, 1], flow[3, 2]) if leads_back else (None, None)
    found = VectorsOfPairs((flow[1, 2], flow[2, 3]), backs, "flo", {}, {}).read()
    of_frames = {
        frame: FrameMotion(_forward(flow.get((frame, frame + 1))), back)
        for frame, back in (
            (1, None),
            (2, _forward(flow[2, 1]) if leads_back else None),
            (3, _forward(flow[3, 2]) if leads_back else None),
        )
    }
    for one, other in zip(found, motion_between(1, 3, of_frames.get), strict=True):
        np.testing.assert_array_equal(one, other)
    assert (found.field[found.visible] == (5, 0)).all()
    assert found.visible.any()


def _forward(path):
    return read_motion(path).forward if path else None


@pytest.mark.parametrize("place", ["ahead", "back"])
def test_a_file_of_a_pair_leads_into_one_frame(files, tmp_path, place):
    vectors = {f"Vector.{channel}": 1 for channel in "XYZW"}
    both = str(write_exr(tmp_path / "both.exr", vectors, SIZE))
    ahead, back = (both, None) if place == "ahead" else (files["flow"][1], both)
    with pytest.raises(InputError, match=r"both.exr: leads into the frame before and into the"):
        VectorsOfPairs((ahead,), (back,), "auto", {}, {}).read()


def test_the_digest_tells_what_the_motion_depends_on(files, tmp_path):
    flow, depth, ids = files["flow"], files["depth"], files["ids"]
    whole = VectorsOfFrames(1, 2, flow, "flo", depth, ids)
    others = [
        VectorsOfFrames(2, 1, flow, "flo", depth, ids),
        VectorsOfFrames(1, 2, {1: flow[1]}, "flo", depth, ids),
        VectorsOfFrames(1, 2, flow, "flo-flip-y", depth, ids),
        VectorsOfFrames(1, 2, flow, "flo", {}, ids),
        VectorsOfFrames(1, 2, flow, "flo", depth, {}),
        VectorsOfPairs((flow[1],), (flow[2],), "flo", {}, {}),
        VectorsOfPairs((flow[1],), (None,), "flo", {}, {}),
        VectorsOfPairs((flow[1], flow[2]), (None, None), "flo", {}, {}),
        VectorsOfPairs((flow[1],), (None,), "flo", {0: depth[1]}, {}),
        VectorsOfPairs((flow[1],), (None,), "flo", {1: depth[1]}, {}),
    ]
    before = whole.digest()
    assert len({before, *(other.digest() for other in others)}) == 1 + len(others)
    assert VectorsOfFrames(1, 2, flow, "flo", depth, ids).digest() == before
    write_image(ids[2], np.zeros(SIZE, np.uint8))
    assert whole.digest() != before


def test_every_colour_is_an_id(tmp_path):
    colours = np.zeros((*SIZE, 3), np.uint8)
    colours[:, 10:] = 1, 0, 0
    colours[:, 20:] = 0, 1, 0
    write_image(tmp_path / "ids.png", colours)
    ids = read_ids(str(tmp_path / "ids.png"))
    assert ids[0, 0] == 0
    assert len(np.unique(ids)) == 3


def test_colours_in_floating_point_are_no_ids(tmp_path):
    file = write_exr(tmp_path / "ids.exr", dict.fromkeys("RGB", 0.5), SIZE)
    with pytest.raises(InputError, match="IDs are whole numbers, or flat colours"):
        read_ids(str(file))
