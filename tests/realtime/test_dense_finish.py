"""The dense finish against one that knows patches as arrays."""

import numpy as np
import pytest
from small_realtime import make_case, make_session

from stylit_ref.errors import InputError
from stylit_ref.machine.vector_patch import STYLE_LANES, row_lanes
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.passes.dense_finish import make_dense_nnf, make_vote
from stylit_ref.realtime.passes.image import make_image
from stylit_ref.realtime.replaying import replay_dense


def patch(image, y, x, radius):
    padded = np.pad(image, ((radius, radius), (radius, radius), (0, 0)), "edge").astype(int)
    return padded[y : y + 2 * radius + 1, x : x + 2 * radius + 1]


def brute_dense(case, nnf, picture, mu, width, step, labelled):
    """Each pixel's best of the entries around it."""
    radius = width // 2
    size, source = case.target.shape[:2], np.array(case.style.shape[:2])
    first = np.minimum(radius, (source - 1) // 2)
    last = np.maximum(source - 1 - radius, (source - 1) // 2)
    out = np.zeros((*size, 2), int)
    for pixel in np.ndindex(size):
        best = np.inf
        for entry in np.ndindex(nnf.shape[:2]):
            offset = np.array(pixel) - np.array(entry) * step
            at_end = np.array(entry) == np.array(nnf.shape[:2]) - 1
            if not ((np.abs(offset) <= radius) | (at_end & (offset > 0))).all():
                continue
            place = np.clip(nnf[entry] + offset, first, last)
            energy = sum(
                weight * ((patch(ours, *pixel, radius) - patch(theirs, *place, radius)) ** 2).sum()
                for weight, ours, theirs in (
                    (16 - mu, case.target, case.guides), (mu, picture, case.style),
                )
            )  # fmt: skip
            if labelled and case.labels[tuple(place)] != case.target_labels[pixel]:
                energy = 1e18
            if energy < best:
                best, out[pixel] = energy, place
    return out


def brute_vote(dense, style, radius):
    height, width = dense.shape[:2]
    picture = np.zeros((height, width, 3), np.uint8)
    for y, x in np.ndindex(height, width):
        colours = []
        for a in range(max(y - radius, 0), min(y + radius + 1, height)):
            for b in range(max(x - radius, 0), min(x + radius + 1, width)):
                place = np.clip(dense[a, b] + (y - a, x - b), 0, np.array(style.shape[:2]) - 1)
                colours.append(style[tuple(place)].astype(int))
        picture[y, x] = (sum(colours) + len(colours) // 2) // len(colours)
    return picture


@pytest.mark.parametrize("width", [3, 5])
@pytest.mark.parametrize("mu", [0, 4, 16])
@pytest.mark.parametrize("labelled", [False, True])
@pytest.mark.parametrize(("source", "target"), [((16, 14), (13, 12)), ((1, 3), (4, 1))])
def test_against_patches_as_arrays(width, mu, labelled, source, target):
    case = make_case(source, target, channels=5)
    own = {"patch_width": width, "mu": (mu,), "levels": 2}
    plain = make_session(case, RealtimeParams(**own), labelled)
    session = make_session(case, RealtimeParams(**own, dense_finish=True), labelled)
    blended, picture = plain.frame(), session.frame()
    expected = brute_dense(case, session.nnf, blended, mu, width, width // 2 + 1, labelled)
    assert np.array_equal(session.dense_nnf(), expected)
    assert np.array_equal(plain.dense_nnf(), expected)
    assert np.array_equal(picture, brute_vote(expected, case.style, width // 2))
    assert np.array_equal(replay_dense(expected, case.style, width), picture)


def test_a_replay_votes_with_the_matches_of_the_frame():
    case = make_case()
    session = make_session(case, RealtimeParams(dense_finish=True))
    picture, dense = session.frame(), session.dense_nnf()
    assert np.array_equal(session.replay(), picture)
    session.set_style(255 - case.style)
    assert np.abs(session.replay().astype(int) - (255 - picture)).max() <= 1
    assert np.array_equal(session.dense_nnf(), dense)


def test_without_it_the_dense_nnf_is_of_the_inputs_as_they_are():
    case = make_case()
    asked, other = make_session(case), make_session(case)
    asked.frame()
    other.frame()
    before = asked.dense_nnf()
    for session in (asked, other):
        session.set_target(case.target[::-1].copy(), case.target_labels[::-1].copy())
    assert np.array_equal(asked.dense_nnf(), other.dense_nnf())
    assert not np.array_equal(asked.dense_nnf(), before)


def test_a_dense_replay_keeps_depth_and_channels():
    case = make_case()
    session = make_session(case, RealtimeParams(dense_finish=True))
    picture = session.frame()
    grey = case.style[:, :, :1].astype(np.uint16) * 257
    replayed = replay_dense(session.dense_nnf(), grey, 5)
    assert (replayed.dtype, replayed.shape) == (np.uint16, (*picture.shape[:2], 1))
    assert np.abs(replayed[..., 0] / 257 - picture[..., 0]).max() <= 0.5


def test_it_does_not_depend_on_threads():
    case = make_case((90, 100), (130, 120))
    params = RealtimeParams(dense_finish=True)
    one, two = (make_session(case, params, threads=n) for n in (1, 2))
    assert np.array_equal(one.frame(), two.frame())


def test_scale_space_has_no_patches_to_finish_with():
    with pytest.raises(InputError, match="dense_finish compares patches"):
        RealtimeParams(dense_finish=True, scale_space=True)
    session = make_session(make_case(), "optimized")
    session.frame()
    with pytest.raises(InputError, match="scale_space compares no patches"):
        session.dense_nnf()


def test_a_stopped_finish_writes_nothing():
    image = make_image(9, 9, 3, STYLE_LANES)
    dense, picture = np.full((9, 9), -1, np.int32), np.full((9, 9, 3), 7, np.uint8)
    none, stop = np.zeros((0, 0), np.uint8), np.ones(1, np.uint8)
    make_dense_nnf(5, 3, STYLE_LANES)(
        np.zeros((3, 3), np.int32), image, image, image,
        np.ones(row_lanes(5, STYLE_LANES), np.int16), none, none, dense, stop,
    )  # fmt: skip
    make_vote(5)(np.zeros((9, 9), np.int32), image, picture, stop)
    assert (dense == -1).all()
    assert (picture == 7).all()
