"""A saved sparse NNF gives its frame again, and an enlarged or deeper one."""

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref import InputError, RealtimeField, RealtimeParams, replay_realtime
from stylit_ref.files.realtime_field import read_any_field, write_realtime_field


def framed(case, params):
    session = make_session(case, params)
    image = session.frame()
    field = RealtimeField(
        session.nnf, params.patch_width, params.step, case.style.shape[:2], case.target.shape[:2]
    )
    return image, field


@pytest.mark.parametrize("width", [3, 5, 7])
@pytest.mark.parametrize("spacing", ["default", "widest"])
@pytest.mark.parametrize(("source", "target"), [((40, 36), (37, 41)), ((1, 9), (6, 1)),
                                                ((1, 1), (1, 1)), ((3, 4), (7, 2))])  # fmt: skip
def test_the_style_of_a_frame_gives_the_frame(width, spacing, source, target):
    case = make_case(source, target)
    spacing = None if spacing == "default" else width
    params = RealtimeParams.preset("quick", patch_width=width, spacing=spacing, levels=2)
    image, field = framed(case, params)
    assert np.array_equal(replay_realtime(field, case.style), image)


def test_an_enlarged_style_gives_an_enlarged_frame():
    case, params = make_case(), RealtimeParams(levels=2)
    image, field = framed(case, params)
    large = replay_realtime(field, case.style.repeat(3, 0).repeat(3, 1))
    assert np.array_equal(large[1::3, 1::3], image)


def test_a_deeper_style_keeps_its_depth_and_channels():
    case, params = make_case(), RealtimeParams(levels=2)
    image, field = framed(case, params)
    deep = np.concatenate([case.style, case.style[:, :, :1]], axis=2).astype(np.float32)
    replayed = replay_realtime(field, deep)
    assert replayed.dtype == np.float32
    assert np.array_equal(np.floor(replayed[:, :, :3] + 0.5), image)


def test_a_style_of_another_size_is_refused():
    case = make_case()
    field = framed(case, RealtimeParams(levels=2))[1]
    with pytest.raises(InputError, match="style is 36x39, but the style of the run was 36x40"):
        replay_realtime(field, case.style[1:])


def test_a_file_holds_all_of_a_field(tmp_path):
    field = framed(make_case(), RealtimeParams(levels=2))[1]
    write_realtime_field(tmp_path / "field.npy", field)
    read = read_any_field(tmp_path / "field.npy")
    assert isinstance(read, RealtimeField)
    assert np.array_equal(read.nnf, field.nnf)
    assert (read.patch_width, read.spacing) == (field.patch_width, field.spacing)
    assert (read.style_size, read.target_size) == (field.style_size, field.target_size)
