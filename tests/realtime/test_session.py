"""A session: what it keeps, what it refuses, and that frames depend on nothing else."""

import time
from threading import Thread
from types import SimpleNamespace

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref.errors import InputError
from stylit_ref.machine.replaced import replaced
from stylit_ref.realtime import passes
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.params import REALTIME_PRESETS, RealtimeParams
from stylit_ref.realtime.session import _TURN, FrameCancelledError, Session

PRESETS = list(REALTIME_PRESETS)


def counted():
    """The passes, and how often each was called."""
    calls = {}

    def count(name, function):
        def call(*arguments):
            calls[name] = calls.get(name, 0) + 1
            return function(*arguments)

        return call

    names = {}
    for name in passes.__all__:
        function = getattr(passes, name)
        if name.startswith("make_"):
            names[name] = lambda *c, make=function, name=name: count(name[5:], make(*c))
        else:
            names[name] = count(name, function)
    return SimpleNamespace(**names, __all__=passes.__all__), calls


@pytest.mark.parametrize("preset", PRESETS)
@pytest.mark.parametrize("with_labels", [False, True])
def test_frames_do_not_depend_on_threads(preset, with_labels):
    case = make_case((90, 100), (130, 120))
    one, two = (make_session(case, preset, with_labels, threads=n) for n in (1, 2))
    assert np.array_equal(one.frame(), two.frame())
    assert np.array_equal(one.frame(warm=True), two.frame(warm=True))


@pytest.mark.parametrize("preset", PRESETS)
@pytest.mark.parametrize(
    ("source", "target"),
    [((1, 1), (1, 1)), ((1, 9), (7, 1)), ((3, 4), (5, 5)), ((33, 17), (1, 40)), ((9, 9), (31, 2))],
)
def test_every_size_gives_colours_of_the_style(preset, source, target):
    case = make_case(source, target)
    case.style[:] = (10, 200, 77)
    session = make_session(case, preset, with_labels=False)
    expected = np.full((*target, 3), (10, 200, 77), np.uint8)
    assert np.array_equal(session.frame(), expected)
    assert np.array_equal(session.frame(warm=True), expected)


def test_a_target_that_is_the_source_is_its_style():
    case = make_case()
    session = Session("best", seed=1)
    session.set_exemplar(case.guides, case.style)
    session.set_target(case.guides)
    picture = session.frame()
    assert (picture[6:-6, 6:-6] == case.style[6:-6, 6:-6]).all(-1).mean() > 0.8


@pytest.mark.parametrize("preset", PRESETS)
def test_a_stroke_gives_the_bytes_of_a_cold_frame(preset):
    case = make_case()
    session = make_session(case, preset)
    session.frame()
    case.style[10:14] = 250
    session.set_style(case.style)
    assert np.array_equal(session.frame(), make_session(case, preset).frame())


def test_a_stroke_leaves_the_guides_alone():
    ours, calls = counted()
    session = make_session(make_case(), "best", passes=ours)
    session.frame()
    cold = dict(calls)
    calls.clear()
    session.set_style(make_case(seed=2).style)
    assert calls == {"fill": 1, "halve": 5, "insert_style": 6}
    calls.clear()
    session.frame()
    assert "random_nnf" not in calls
    assert calls["upsample_nnf"] == 4  # levels 3 to 0
    assert calls["search"] == 2 * (1 + 4 + 6 + 8)
    assert cold["search"] == calls["search"] + 2 * (8 + 8)


def test_a_target_leaves_the_source_alone():
    ours, calls = counted()
    case = make_case()
    session = make_session(case, "quick", passes=ours)
    session.frame()
    calls.clear()
    session.set_target(case.target, case.target_labels)
    assert calls == {
        "fill": 1, "halve": 5, "mark_labels": 1, "decimate_labels": 6, "free_lost_labels": 6,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("level", "expected"),
    [
        (0, {"search": 6, "mark_moving": 2, "blend": 4}),  # level 0 alone
        (
            4,
            {
                "random_nnf": 1,
                "upsample_nnf": 1,
                "renew": 1,
                "search": 22,
                "mark_moving": 2,
                "blend": 4,
            },
        ),
        (
            3,
            {
                "random_nnf": 1,
                "upsample_nnf": 2,
                "renew": 1,
                "search": 30,
                "mark_moving": 2,
                "blend": 8,
            },
        ),
    ],
)
def test_a_warm_frame_searches_level_0_and_those_it_renews_from(level, expected):
    ours, calls = counted()
    params = RealtimeParams(renewal_level=level, warm_iterations=3)
    session = make_session(make_case(), params, passes=ours)
    session.frame()
    calls.clear()
    session.frame(warm=True)
    assert calls == expected


@pytest.mark.parametrize("preset", ["best", "quick"])
def test_a_warm_frame_is_given_by_the_nnf_before_it(preset):
    case = make_case()
    session, other = (make_session(case, preset) for _ in range(2))
    session.frame()
    other.nnf = session.nnf
    assert np.array_equal(session.frame(warm=True), other.frame(warm=True))
    assert np.array_equal(session.nnf, other.nnf)


@pytest.mark.parametrize("preset", ["best", "quick"])
def test_a_cold_frame_after_a_warm_one_is_that_of_a_new_session(preset):
    case = make_case()
    session = make_session(case, preset)
    session.frame()
    session.frame(warm=True)
    assert np.array_equal(session.frame(), make_session(case, preset).frame())


def test_a_new_style_counts_in_a_warm_frame_that_reads_what_a_cold_one_does_not():
    case, other = make_case(), make_case(seed=1)
    session = make_session(case, "quick")
    session.frame()
    session.frame(warm=True)
    session.set_style(other.style)
    before, picture = session.nnf, session.frame(warm=True)
    fresh = make_session(case._replace(style=other.style), "quick")
    fresh.nnf = before
    assert np.array_equal(fresh.frame(warm=True), picture)


def test_a_warm_frame_is_reproduced_from_seed_nnf_and_inputs():
    case = make_case()
    first, second = make_session(case), make_session(case)
    first.frame()
    second.nnf = first.nnf
    second.seed = first.seed
    assert np.array_equal(first.frame(warm=True), second.frame(warm=True))


def test_replay_paints_with_the_last_nnf():
    case = make_case()
    session = make_session(case)
    picture = session.frame()
    assert np.array_equal(session.replay(), picture)
    session.set_style(255 - case.style)
    assert np.abs(session.replay().astype(int) - (255 - picture)).max() <= 1


def test_a_view_is_as_good_as_a_copy():
    case = make_case()
    session = make_session(case)
    expected = session.frame()
    other = Session(seed=5)
    other.set_exemplar(case.guides, case.style, case.labels)
    other.target_view(*case.target.shape[:2])[:] = case.target
    other.view_changed(case.target_labels)
    assert np.array_equal(other.frame(), expected)


def test_a_view_leaves_the_session_as_it_is_until_it_is_taken():
    case = make_case()
    session = make_session(case)
    expected = session.frame()
    session.target_view(*case.target.shape[:2])[:] = 255 - case.target
    with pytest.raises(InputError, match="have 9 in the target, but not in the source"):
        session.view_changed(np.full_like(case.target_labels, 9))
    session.target_view(3, 4)[:] = 7
    assert np.array_equal(session.frame(), expected)
    assert session.frame(warm=True).shape == expected.shape


def test_views_of_one_size_keep_the_frame_before():
    case = make_case()
    session = make_session(case)
    session.frame()
    expected = session.frame(warm=True)
    session.frame()
    for _ in range(3):
        session.target_view(*case.target.shape[:2])[:] = case.target
        session.view_changed(case.target_labels)
    assert np.array_equal(session.frame(warm=True), expected)


def test_a_view_is_taken_once():
    session = make_session(make_case())
    with pytest.raises(InputError, match="view is not there; call target_view"):
        session.view_changed()


def test_weights_of_0_leave_channels_out():
    case = make_case()
    session = make_session(case)
    session.set_weights((1,) * 9 + (0,))
    expected = session.frame()
    case.target[..., 9] = 3
    session.set_target(case.target, case.target_labels)
    assert np.array_equal(session.frame(), expected)
    session.set_weights(None)
    assert not np.array_equal(session.frame(), expected)


def test_a_label_that_decimation_loses_is_free_there():
    case = make_case((64, 64), (64, 64))
    case.labels[:], case.target_labels[:] = 0, 0
    case.labels[33, 33:36] = 7  # three pixels, none of which survives beyond level 0
    case.target_labels[30:40, 30:40] = 7
    session = make_session(case, RealtimeParams(iterations=(8,)))
    session.frame()
    is_7 = case.target_labels[::3, ::3] == 7
    y, x = session.nnf[..., 0], session.nnf[..., 1]
    assert (case.labels[y, x][~is_7] == 0).all()
    assert (case.labels[y, x][is_7] == 7).any()
    assert (session._target.labels[0] == 7).any()
    assert (session._target.labels[1] == -1).any()


def test_cancelling_ends_a_frame_and_leaves_the_last_state():
    case = make_case((200, 200), (200, 200))
    session = make_session(case, RealtimeParams(iterations=(1000,)))
    quick = make_session(case)
    quick.frame()
    session.nnf = quick.nnf
    ended = []

    def compute():
        try:
            session.frame()
        except FrameCancelledError:
            ended.append(time.perf_counter())

    thread = Thread(target=compute)
    thread.start()
    time.sleep(0.2)
    session.cancel()
    thread.join()
    assert len(ended) == 1
    assert np.array_equal(session.nnf, quick.nnf)


def test_a_warm_frame_after_a_cancelled_one_is_as_without_it():
    """A frame may be cancelled after any blend, B' done in part: the next does not build on it."""
    case = make_case()
    cold = make_session(case)
    cold.frame()
    blends = []
    cuts = [0]

    def make_blend(*constants):
        blend = passes.make_blend(*constants)

        def cancels(*arguments):
            blend(*arguments)
            blends.append(constants)
            if len(blends) == cuts[-1]:
                session.cancel()

        return cancels

    params = RealtimeParams(warm_iterations=3)
    session = make_session(case, params, passes=replaced(passes, make_blend=make_blend))
    session.nnf = cold.nnf
    expected = session.frame(warm=True)
    for cut in range(1, len(blends) + 1):
        cuts.append(cut)
        session.nnf = cold.nnf
        blends.clear()
        with pytest.raises(FrameCancelledError):
            session.frame(warm=True)
        assert np.array_equal(session.frame(warm=True), expected)


def test_a_frame_that_waits_is_cancelled_too():
    case = make_case()
    session = make_session(case)
    expected, ended = session.frame(), []

    def compute():
        try:
            session.frame(seed=9)
        except FrameCancelledError:
            ended.append(True)

    thread = Thread(target=compute)
    with _TURN:
        thread.start()
        time.sleep(0.1)
        session.cancel()
    thread.join()
    assert ended == [True]
    assert session.seed == 5
    assert np.array_equal(session.frame(), expected)


def test_an_interrupted_exemplar_is_not_there(monkeypatch):
    case = make_case()
    session = make_session(case)
    expected = session.frame()

    def interrupted(*_):
        raise KeyboardInterrupt

    larger = make_case((50, 51))
    with monkeypatch.context() as patched:
        patched.setattr(Exemplar, "set_labels", interrupted)
        with pytest.raises(KeyboardInterrupt):
            session.set_exemplar(larger.guides, larger.style, larger.labels)
    with pytest.raises(InputError, match="exemplar is not set"):
        session.frame()
    session.set_exemplar(case.guides, case.style, case.labels)
    assert np.array_equal(session.frame(), expected)


def test_both_sides_change_their_labels_by_way_of_a_target_without():
    case = make_case()
    session = make_session(case)
    expected = session.frame()
    labels, target_labels = (np.where(side == 3, 7, 8).astype(np.uint8)
                             for side in (case.labels, case.target_labels))  # fmt: skip
    with pytest.raises(InputError, match="set a target without labels before both sides change"):
        session.set_exemplar(case.guides, case.style, labels)
    session.set_target(case.target)
    session.set_exemplar(case.guides, case.style, labels)
    session.set_target(case.target, target_labels)
    assert np.array_equal(session.frame(), expected)


def test_what_a_session_cannot_change_is_refused():
    session = make_session(make_case())
    with pytest.raises(AttributeError):
        session.params = RealtimeParams(levels=2)
    with pytest.raises(InputError, match="threads is 0; it must be an integer of at least 1"):
        Session(threads=0)


def test_threads_wait_for_each_other():
    case = make_case((90, 100), (130, 120))
    session = make_session(case)
    expected = session.frame()
    pictures = []
    threads = [Thread(target=lambda: pictures.append(session.frame())) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(picture, expected) for picture in pictures)
    assert len(pictures) == 4


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda s, c: s.set_target(c.target[..., :9]), "target_guides has 9 channels, but"),
        (lambda s, c: s.set_style(c.style[1:]), "style is 36 x 39 pixels, but the source guides"),
        (lambda s, c: s.set_style(c.style[..., 0]), "style has the shape"),
        (lambda s, c: s.set_target(np.zeros((1, 32768, 10), np.uint8)), "is 32768 x 1 pixels"),
        (lambda s, c: s.set_target(c.target, c.target_labels + 1), "have 1 in the target"),
        (lambda s, c: s.set_target(c.target, c.target_labels[1:]), "target_labels has the shape"),
        (lambda s, c: s.set_weights((1, 2)), "weights must be 10 integers"),
        (lambda s, c: s.set_weights((129,) * 10), "weights give a weight of"),
        (lambda s, c: s.set_exemplar(c.guides[..., :4], c.style), "begin a new Session"),
        (lambda s, c: setattr(s, "nnf", np.zeros((2, 2, 2), np.int32)), "nnf has the shape"),
        (lambda s, c: s.frame(seed=-1), "seed is -1"),
    ],
)
def test_refusals_leave_the_session_as_it_was(change, message):
    case = make_case()
    session = make_session(case)
    expected = session.frame()
    with pytest.raises(InputError, match=message):
        change(session, case)
    assert np.array_equal(session.frame(), expected)


def test_what_is_missing_is_named():
    session = Session()
    with pytest.raises(InputError, match="exemplar is not set; call set_exemplar first"):
        session.frame()
    case = make_case()
    session.set_exemplar(case.guides, case.style)
    with pytest.raises(InputError, match="target is not set; call set_target first"):
        session.frame()
    session.set_target(case.target)
    with pytest.raises(InputError, match="warm is true, but there is no frame"):
        session.frame(warm=True)


@pytest.mark.parametrize("start", ["vote", "bilinear"])
def test_an_nnf_reproduces_a_warm_frame(start):
    """Whatever frame a session had before."""
    case, params = make_case(), RealtimeParams(start=start)
    session = make_session(case, params)
    session.frame()
    nnf = session.nnf
    other = make_session(case, params)
    other.nnf = nnf
    assert np.array_equal(other.frame(warm=True), session.frame(warm=True))


def test_a_source_may_have_other_channels_while_there_is_no_target():
    few, many = make_case(channels=3), make_case(channels=10)
    session = Session(seed=5, threads=1)
    session.set_exemplar(few.guides, few.style)
    session.set_weights((1, 2, 3))
    session.set_exemplar(many.guides, many.style)
    session.set_target(many.target)
    assert np.array_equal(session.frame(), make_session(many, with_labels=False).frame())


def test_a_refused_frame_keeps_the_seed():
    session = make_session(make_case(), seed=3)
    with pytest.raises(InputError, match="no frame to start from"):
        session.frame(warm=True, seed=5)
    assert session.seed == 3


def test_labels_are_those_that_were_given():
    case = make_case()
    session = make_session(case)
    picture = session.frame()
    case.labels[:] = case.target_labels[:] = 0
    assert np.array_equal(session.frame(), picture)


@pytest.mark.parametrize("preset", PRESETS)
def test_levels_that_a_warm_frame_leaves_out_can_be_looked_at(preset):
    session = make_session(make_case(), preset)
    session.frame()
    before = session.picture_at(1)
    session.frame(warm=True)
    assert np.array_equal(session.picture_at(1), before)


def test_levels_of_a_larger_source_are_forgotten():
    session = make_session(make_case((90, 90)))
    session.frame()
    case = make_case((20, 20))
    case.style[:] = (10, 200, 77)
    session.set_exemplar(case.guides, case.style, case.labels)
    session.nnf = np.full((13, 14, 2), 9, np.int32)
    assert (session.picture_at(1) == (10, 200, 77)).all()
