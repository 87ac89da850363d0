"""The motion between two frames, from whatever there is."""

import numpy as np
import pytest
from views.motion.moving_square import (
    GROUND,
    SIZE,
    SQUARE,
    depth_of,
    frame_motion,
    labels_of,
    motion,
    unmasked,
)

from stylit_ref import InputError
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.between import motion_between
from stylit_ref.views.motion.composition import composed
from stylit_ref.views.motion.conventions import FrameMotion
from stylit_ref.views.motion.inversion import inverted, unhidden
from stylit_ref.views.motion.silhouettes import along_silhouettes, silhouettes_of
from stylit_ref.views.motion.visibility import cancelling, same_labels


def both(frame):
    return frame_motion(frame)


def forward_only(frame):
    return frame_motion(frame, backward=False)


def beside(motion, to, other):
    """The same, where strokes beside the square move with it."""
    return along_silhouettes(motion, *(silhouettes_of(depth_of(frame)) for frame in (to, other)))


def agrees(found, true):
    """The field is true wherever something is shown, and nothing is shown that is hidden."""
    assert not (found.visible & ~true.visible).any()
    assert np.array_equal(found.field[found.visible], true.field[found.visible])


@pytest.mark.parametrize(("to", "other"), [(0, 1), (1, 0)])
def test_both_ways_known(to, other):
    """Where motion forth and back cancels is exactly what both frames show."""
    found, true = motion_between(to, other, both), motion(to, other)
    assert np.array_equal(found.visible, true.visible)
    agrees(found, true)


def test_forward_alone_is_splatted_backwards():
    found, true = motion_between(1, 0, forward_only, depth_of=depth_of), beside(motion(1, 0), 1, 0)
    assert np.array_equal(found.visible, true.visible)
    agrees(found, true)


def test_without_depth_only_what_is_contested_is_hidden_beside():
    """Where the square covers what was ground, nothing says which of the two is nearer."""
    found, true = motion_between(1, 0, forward_only), motion(1, 0)
    agrees(found, true)
    lost = true.visible & ~found.visible
    assert (labels_of(1)[lost] == 2).all()
    assert 0 < lost.sum() < (labels_of(1) == 2).sum()


@pytest.mark.parametrize("depth", [None, depth_of])
def test_forward_alone_forward(depth):
    found, true = motion_between(0, 1, forward_only, depth_of=depth), motion(0, 1)
    agrees(found, beside(true, 0, 1) if depth else true)
    if depth:
        assert np.array_equal(found.visible, beside(true, 0, 1).visible)


def test_ids_hide_what_forward_vectors_alone_leave_open():
    found = motion_between(0, 1, forward_only, labels_of=labels_of)
    agrees(found, motion(0, 1))


@pytest.mark.parametrize("to_other", [(0, 3), (3, 0)])
@pytest.mark.parametrize("known", [both, forward_only])
def test_skipped_frames_are_composed(to_other, known):
    found = motion_between(*to_other, known, depth_of=depth_of)
    agrees(found, beside(motion(*to_other), *to_other))


def test_a_mask_of_the_file_is_taken_as_it_is():
    true = motion(0, 1)
    odd = Motion(true.field, np.random.default_rng(0).random(SIZE) < 0.5)
    files = {0: FrameMotion(odd, None, tells_visible=True), 1: both(1)}
    assert np.array_equal(motion_between(0, 1, files.get).visible, odd.visible)


def test_with_a_mask_of_the_file_the_motion_back_is_not_read():
    def read(frame):
        assert frame == 0
        return FrameMotion(motion(0, 1), None, tells_visible=True)

    assert np.array_equal(motion_between(0, 1, read).visible, motion(0, 1).visible)


def test_missing_vectors_are_refused():
    files = {0: forward_only(0), 2: forward_only(2)}
    with pytest.raises(InputError, match="from frame 1 to frame 2: there are neither forward"):
        motion_between(0, 3, files.get)


def test_backward_vectors_of_the_frame_after_serve_where_forward_ones_are_missing():
    files = {1: frame_motion(1, forward=False)}
    found = motion_between(0, 1, files.get, depth_of=depth_of)
    agrees(found, beside(motion(0, 1), 0, 1))


def test_different_sizes_are_refused():
    cut = both(1)
    cut = FrameMotion(*(Motion(m.field[1:], m.visible[1:]) for m in cut[:2]))
    with pytest.raises(InputError, match="frame 0 is 32x20 and that of frame 1 32x19"):
        motion_between(0, 1, {0: both(0), 1: cut}.get)


def naive_inverse(motion, depth):
    """Every pixel of the other frame asks all pixels which of them lands on it."""
    height, width = motion.visible.shape
    field, visible = np.zeros((height, width, 2), np.float32), np.zeros((height, width), bool)
    for row, column in np.ndindex(height, width):
        landed = []
        for y, x in np.ndindex(height, width):
            dx, dy = map(float, motion.field[y, x])
            place = np.floor(y + dy + 0.5), np.floor(x + dx + 0.5)
            if motion.visible[y, x] and place == (row, column):
                away_y, away_x = 256 * (y + dy - row), 256 * (x + dx - column)
                near = 0 if depth is None else depth[y, x]
                landed.append((near, away_y**2 + away_x**2, y, x))
        if landed:
            best = motion.field[min(landed)[2:]]
            field[row, column] = -best
            spread = [abs(motion.field[y, x] - best).max() for *_, y, x in landed]
            visible[row, column] = depth is not None or max(spread) <= 1
    return Motion(field, visible)


@pytest.mark.parametrize("with_depth", [False, True])
def test_inverse_is_that_of_the_brute_force_twin(with_depth):
    rng = np.random.default_rng(3)
    steps = rng.integers(-640, 641, (9, 11, 2)) / 256
    forward = Motion(steps.astype(np.float32), rng.random((9, 11)) < 0.9)
    depth = rng.integers(1, 4, (9, 11)).astype(np.float32) if with_depth else None
    found, twin = inverted(forward, depth), naive_inverse(forward, depth)
    # Cracks are filled by a rule of their own.
    assert not (twin.visible & ~found.visible).any()
    assert np.array_equal(found.field[twin.visible], twin.field[twin.visible])


@pytest.mark.parametrize("way", [(2, 0), (0, 2), (-2, 0), (0, -2)])
@pytest.mark.parametrize("nothing", [0, -1, np.nan, 1e9])
def test_nothing_lies_behind_a_thing_that_lands_on_it(nothing, way):
    """A thing of one pixel moves, to a pixel before or after it."""
    field, depth = np.zeros((5, 5, 2), np.float32), np.full((5, 5), nothing, np.float32)
    field[2, 2], depth[2, 2] = way, 5
    moved, place = Motion(field, np.ones((5, 5), bool)), (2 + way[1], 2 + way[0])
    assert inverted(moved, depth).field[place].tolist() == [-way[0], -way[1]]
    shown = unhidden(moved, depth)
    assert (shown[2, 2], shown[place]) == (True, False)


def zooming(size, factor):
    """The motion of a surface that comes nearer."""
    y, x = np.mgrid[: size[0], : size[1]]
    field = np.dstack([(factor - 1) * (x - size[1] / 2), (factor - 1) * (y - size[0] / 2)])
    return Motion(field.astype(np.float32), np.ones(size, bool))


def test_cracks_of_a_surface_that_comes_nearer_are_filled():
    forward = zooming((40, 40), 1.2)
    back = inverted(forward)
    true = zooming((40, 40), 1 / 1.2)
    assert np.abs(back.field - true.field)[back.visible].max() <= 1
    assert back.visible[4:-4, 4:-4].mean() > 0.99


def test_composition_follows_one_motion_and_then_the_other():
    first, second = motion(0, 1), motion(1, 2)
    found = composed(first, second)
    for y, x in np.ndindex(SIZE):
        if first.visible[y, x]:
            dx, dy = first.field[y, x].astype(int)
            assert found.visible[y, x] == second.visible[y + dy, x + dx]
            expected = first.field[y, x] + second.field[y + dy, x + dx]
            assert np.array_equal(found.field[y, x], expected)
        else:
            assert not found.visible[y, x]


def test_cancelling_is_the_rule_of_sundaram():
    rng = np.random.default_rng(1)
    steps = rng.integers(-512, 513, (2, 8, 9, 2)).astype(np.float32) / 256
    ahead = Motion(steps[0], np.ones((8, 9), bool))
    back = Motion(steps[1], rng.random((8, 9)) < 0.8)
    found = cancelling(ahead, back)
    for y, x in np.ndindex(8, 9):
        f = ahead.field[y, x].astype(float)
        row, column = int(np.floor(y + f[1] + 0.5)), int(np.floor(x + f[0] + 0.5))
        expected = False
        if 0 <= row < 8 and 0 <= column < 9 and back.visible[row, column]:
            b = back.field[row, column].astype(float)
            expected = ((f + b) ** 2).sum() <= 0.01 * ((f**2).sum() + (b**2).sum()) + 0.5
        assert found[y, x] == expected
    assert found.any()


def test_same_labels():
    true = motion(0, 1)
    assert np.array_equal(same_labels(unmasked(true), labels_of(0), labels_of(1)), true.visible)


def test_unhidden_hides_both_without_depth():
    moved = unmasked(motion(0, 1))
    without, with_depth = unhidden(moved), unhidden(moved, depth_of(0))
    assert (without <= with_depth).all()
    assert (labels_of(0)[with_depth & ~without] == 2).all()
    assert GROUND != SQUARE


def test_depth_of_one_frame_is_not_compared_with_ids_of_the_other():
    thing = {frame: np.where(labels_of(frame) == 2, np.uint32(2), np.uint32(0)) for frame in (0, 1)}

    def along(depths, labels):
        return motion_between(0, 1, both, depth_of=depths.get, labels_of=labels.get)

    by_ids, without = along({}, thing), motion_between(0, 1, both)
    assert (by_ids.field != without.field).any()
    for depths in ({0: depth_of(0)}, {1: depth_of(1)}):
        found = along(depths, thing)
        assert np.array_equal(found.field, by_ids.field)
        assert np.array_equal(found.visible, by_ids.visible)
        alone = along(depths, {1 - frame: thing[1 - frame] for frame in depths})
        assert np.array_equal(alone.field, without.field)
        assert np.array_equal(alone.visible, without.visible)


def test_a_note_says_that_silhouettes_are_not_known(caplog):
    with caplog.at_level("INFO", "stylit_ref"):
        motion_between(0, 1, both)
        motion_between(1, 2, both)
        motion_between(0, 1, both, depth_of=depth_of)
    assert [record.getMessage()[:38] for record in caplog.records] == [
        "neither depth nor IDs are known of bot"
    ]


def test_any_number_of_threads_gives_the_same_bytes():
    def found():
        return motion_between(3, 0, forward_only, depth_of=depth_of, labels_of=labels_of)

    with using_threads(1):
        one = found()
    several = found()
    assert one.field.tobytes() == several.field.tobytes()
    assert one.visible.tobytes() == several.visible.tobytes()
