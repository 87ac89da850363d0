"""Steps of a frame, one at a time or an iteration or a level at once."""

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref.errors import InputError
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.studio.engine.events import Stepped
from stylit_ref.studio.engine.stepping import Stepper

PARAMS = RealtimeParams(levels=2, mu=(4, 0), iterations=(2, 3))


@pytest.fixture
def stepper():
    return Stepper(lambda: make_session(make_case(), PARAMS))


def test_it_says_what_may_follow(stepper):
    assert stepper.state == Stepped(0, 0, False, ("restart", "pyramid"))
    for operation, state in [
        ("pyramid", Stepped(1, 0, False, ("restart", "upsample", "level"))),
        ("upsample", Stepped(1, 0, False, ("restart", "half", "iteration", "level"))),
        ("half", Stepped(1, 0, False, ("restart", "half", "iteration", "level"))),
        ("iteration", Stepped(1, 1, False, ("restart", "half", "iteration", "level"))),
        ("level", Stepped(1, 3, False, ("restart", "upsample", "level"))),
        ("upsample", Stepped(0, 0, False, ("restart", "blend", "level"))),
        ("blend", Stepped(0, 0, False, ("restart", "half", "iteration", "level"))),
        ("iteration", Stepped(0, 1, False, ("restart", "half", "iteration", "level"))),
        ("half", Stepped(0, 1, False, ("restart", "half", "iteration", "level"))),
        ("half", Stepped(0, 2, False, ("restart", "blend", "level"))),
        ("blend", Stepped(0, 2, True, ("restart",))),
        ("restart", Stepped(0, 0, False, ("restart", "pyramid"))),
    ]:
        stepper.do(operation)
        assert stepper.state == state, operation


def test_levels_end_in_the_frame(stepper):
    for operation in ("pyramid", "level", "level"):
        picture = stepper.do(operation)
    assert np.array_equal(picture, make_session(make_case(), PARAMS).frame())


def test_the_pyramid_shows_the_painting_on_all_levels(stepper):
    picture, style = stepper.do("pyramid"), make_case().style
    assert np.array_equal(picture[:40, :36], style)
    assert picture.shape == (40, 36 + 18, 3)
    of_four = style[:2, :2].astype(int).sum(axis=(0, 1))
    assert np.array_equal(picture[0, 36], (of_four + 2) // 4)


def test_another_operation_than_the_next_is_refused(stepper):
    with pytest.raises(InputError, match="half is not what comes next; possible are restart, pyr"):
        stepper.do("half")
    stepper.do("restart")  # can always be done
