"""A frame step by step: it ends in the bytes of the frame, by the operations that are told."""

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref.errors import InputError
from stylit_ref.realtime.formulae.grid import level_size
from stylit_ref.realtime.frame_steps import FrameSteps
from stylit_ref.realtime.params import REALTIME_PRESETS, RealtimeParams


def finished(steps):
    operations = []
    while steps.upcoming:
        operations.append(steps.advance())
    return operations


@pytest.mark.parametrize("preset", REALTIME_PRESETS)
def test_all_steps_are_the_frame(preset):
    case = make_case()
    steps = FrameSteps(make_session(case, preset))
    finished(steps)
    assert np.array_equal(steps.picture(), make_session(case, preset).frame())


def test_a_dense_finish_is_the_last_step():
    case = make_case()
    params = RealtimeParams(dense_finish=True)
    steps = FrameSteps(make_session(case, params))
    finished(steps)
    assert np.array_equal(steps.picture(), make_session(case, params).frame())


def test_operations_are_those_of_the_parameters():
    params = RealtimeParams(levels=2, mu=(4, 0), iterations=(2, 1))
    operations = finished(FrameSteps(make_session(make_case(), params)))
    assert operations == [
        ("upsample", 1, 0), ("half", 1, 0), ("half", 1, 0),
        ("upsample", 0, 0), ("blend", 0, 0), ("half", 0, 0), ("half", 0, 0),
        ("blend", 0, 1), ("half", 0, 1), ("half", 0, 1),
        ("blend", 0, 2),
    ]  # fmt: skip


def test_every_step_has_a_picture_of_its_level():
    steps = FrameSteps(make_session(make_case(target=(37, 41))))
    while steps.upcoming:
        level = steps.advance().level
        assert steps.picture().shape == (level_size(37, level), level_size(41, level), 3)


def test_a_look_on_the_way_changes_nothing():
    case = make_case()
    looked, other = (FrameSteps(make_session(case)) for _ in range(2))
    while looked.upcoming:
        looked.advance()
        looked.picture()
    finished(other)
    assert np.array_equal(looked.picture(), other.picture())


def test_what_is_not_there_is_refused():
    steps = FrameSteps(make_session(make_case()))
    with pytest.raises(InputError, match="no step of the frame is done yet"):
        steps.picture()
    finished(steps)
    with pytest.raises(InputError, match="the frame is finished"):
        steps.advance()


def test_a_level_of_a_frame_is_blended_from_its_matches():
    session = make_session(make_case())
    picture = session.frame()
    assert np.array_equal(session.picture_at(0), picture)
    assert session.picture_at(2).shape == (10, 11, 3)
    with pytest.raises(InputError, match="level is 6; it must be an integer from 0 to 5"):
        session.picture_at(6)
