"""Metrics of frames by hand, and each where it must say that something is bad."""

from dataclasses import replace

import numpy as np
import pytest

from eval.frame_sets import FrameSet
from eval.metrics import METRICS, NUMBERS
from eval.metrics.gradient import gradient
from eval.metrics.guide_fidelity import guide_error
from eval.metrics.nnf_kept import kept
from eval.metrics.outlines import band, dark_share
from eval.metrics.surface_flicker import fast_share, followed
from eval.metrics.warping import change, warping_error
from eval.outcome import Outcome
from stylit_ref import InputError
from stylit_ref.views.frames import Motion, grid_pairs, sequence_pairs

HEIGHT, WIDTH, STEP = 16, 24, 2


def noise(seed=0, size=(HEIGHT, WIDTH)):
    return np.random.default_rng(seed).integers(0, 256, (*size, 3), dtype=np.uint8)


def moved(x, y=0):
    """Motion by whole pixels, visible wherever it ends inside."""
    rows, columns = np.mgrid[:HEIGHT, :WIDTH]
    inside = (rows + y >= 0) & (rows + y < HEIGHT) & (columns + x >= 0) & (columns + x < WIDTH)
    return Motion(np.full((HEIGHT, WIDTH, 2), (x, y), np.float32), inside)


def panorama(count):
    """A wide picture that frames show parts of, each STEP pixels further right."""
    wide = noise(size=(HEIGHT, WIDTH + STEP * count))
    images = np.stack([wide[:, STEP * k : STEP * k + WIDTH] for k in range(count)])
    edges = {(to, other): moved(STEP * (to - other)) for to, other in sequence_pairs(count)}
    return images, edges


def grid(rows=2, columns=2):
    """Views of a plane, STEP pixels apart on both axes."""
    plane = noise(size=(HEIGHT + STEP * rows, WIDTH + STEP * columns))
    places = [(STEP * (k // columns), STEP * (k % columns)) for k in range(rows * columns)]
    images = np.stack([plane[y : y + HEIGHT, x : x + WIDTH] for y, x in places])
    edges = {
        (to, other): moved(places[to][1] - places[other][1], places[to][0] - places[other][0])
        for to, other in grid_pairs(rows, columns)
    }
    return images, edges


def frame_set(images, edges, **extra):
    guides = tuple((image,) for image in images)
    return FrameSet("painted", images[0], (images[0],), guides, edges, images, **extra)


def numbers(metric, images, edges, nnf=None, **extra):
    return METRICS[metric].measure(frame_set(images, edges, **extra), Outcome(images, 0.0, nnf))


def test_a_change_of_one_value_is_its_error():
    grey = np.full((HEIGHT, WIDTH, 3), 100, np.uint8)
    assert change(grey, grey + np.uint8([0, 3, 6]), moved(0)) == 3


def test_the_nearest_pixel_is_taken_and_halves_round_up():
    ramp = np.repeat(np.arange(0, 5 * WIDTH, 5, dtype=np.uint8)[None, :, None], HEIGHT, axis=0)
    for motion, error in ((0.49, 0), (0.5, 5), (-0.5, 0), (-0.51, 5)):
        there = Motion(np.full((HEIGHT, WIDTH, 2), (motion, 0), np.float32), moved(1).visible)
        there.visible[:, 0] = False
        assert change(ramp, ramp, there) == error


def test_paint_that_moves_with_its_points_has_no_error_at_any_lag():
    images, edges = panorama(11)
    found = numbers("warping", images, edges)
    assert found == dict.fromkeys(("warping", "warping_2", "warping_5", "warping_10"), 0.0)


def test_paint_that_sticks_to_the_screen_is_bad_at_every_lag():
    _, edges = panorama(11)
    still = np.repeat(noise()[None], 11, axis=0)
    assert all(error > 60 for error in numbers("warping", still, edges).values())


def test_motion_of_the_wrong_sign_is_bad():
    images, edges = panorama(3)
    wrong = {pair: Motion(-motion.field, motion.visible) for pair, motion in edges.items()}
    assert numbers("warping", images, wrong)["warping"] > 60


def test_what_a_neighbour_hides_does_not_count():
    image, motion = noise(), moved(0)
    other = image.copy()
    other[3:9, 4:20] ^= 255
    assert change(image, other, motion) > 10
    motion.visible[3:9, 4:20] = False
    assert change(image, other, motion) == 0
    assert change(image, other, motion._replace(visible=np.zeros_like(motion.visible))) is None


def test_both_directions_of_an_edge_count():
    """Of two points one differs by 8. Frame 0 sees both in frame 1, which sees that one alone."""
    images = np.zeros((2, 1, 2, 1), np.uint8)
    images[1, 0, 1] = 8
    still = np.zeros((1, 2, 2), np.float32)
    edges = {(0, 1): Motion(still, np.array([[True, True]])),
             (1, 0): Motion(still, np.array([[False, True]]))}  # fmt: skip
    assert warping_error(images, edges, [(0, 1), (1, 0)]) == (4 + 8) / 2


def test_an_outline_that_moves_with_its_thing_is_still_as_a_stroke():
    """A square slides over white ground with a dark rim around it; the ground stands still."""
    images = np.full((2, HEIGHT, 40, 3), 240, np.uint8)
    depths = np.full((2, HEIGHT, 40), 20, np.float32)
    edges = {}
    for frame, left in enumerate((12, 17)):
        images[frame, 5:11, left : left + 8] = images[frame, 6:10, left - 1 : left + 9] = 10
        images[frame, 6:10, left : left + 8] = 130
        depths[frame, 6:10, left : left + 8] = 10
    for to, other in sequence_pairs(2):
        field = np.zeros((HEIGHT, 40, 2), np.float32)
        field[depths[to] == 10, 0] = 5 * (other - to)
        hidden = (depths[other] == 10) & (depths[to] == 20)
        edges[to, other] = Motion(field, ~hidden)
    found = numbers("warping", images, edges, depths=depths)
    assert found["strokes"] == 0
    assert found["warping"] > 5


def test_a_drift_shows_at_longer_lags_alone():
    images = np.stack([np.full((HEIGHT, WIDTH, 3), 10 + 2 * k, np.uint8) for k in range(11)])
    edges = {pair: moved(0) for pair in sequence_pairs(11)}
    assert numbers("warping", images, edges) == {
        "warping": 2, "warping_2": 4, "warping_5": 10, "warping_10": 20,
    }  # fmt: skip


def test_lags_that_do_not_occur_have_no_number():
    images, edges = panorama(4)
    assert numbers("warping", images, edges).keys() == {"warping", "warping_2"}


def test_a_round_of_a_plane_shows_the_same_paint_and_closes():
    images, edges = grid()
    assert numbers("loops", images, edges) == {"round": 0, "round_gap": 0}


def test_one_view_that_differs_shows_in_its_round():
    images, edges = grid()
    images = images // 2
    images[3] += 5
    assert numbers("loops", images, edges)["round"] == 5


def test_motion_that_does_not_close_is_bad():
    images, edges = grid()
    edges[0, 1] = Motion(edges[0, 1].field + np.float32([3, 4]), edges[0, 1].visible)
    found = numbers("loops", images, edges)
    assert found["round_gap"] == pytest.approx(5)
    assert found["round"] > 60


def test_a_sequence_has_no_rounds():
    assert numbers("loops", *panorama(5)) == {}


def test_points_are_followed_from_the_middle_and_keep_their_values():
    images, edges = panorama(5)
    values = followed(images, edges)
    assert values.shape == (5, HEIGHT * (WIDTH - 4 * STEP), 3)
    assert (values == values[0]).all()
    found = numbers("surface_flicker", images, edges)
    assert found == {"followed": 16 / 24, "flicker": 0, "fast": 0}


def test_flicker_is_the_deviation_of_a_value():
    images = np.stack([np.full((HEIGHT, WIDTH, 1), value, np.uint8) for value in (0, 10, 0, 10)])
    edges = {pair: moved(0) for pair in sequence_pairs(4)}
    assert numbers("surface_flicker", images, edges) == {"followed": 1, "flicker": 5}


def test_frames_painted_each_by_itself_flicker():
    _, edges = panorama(5)
    alone = np.stack([noise(seed) for seed in range(5)])
    assert numbers("surface_flicker", alone, edges)["flicker"] > 50


def test_frames_that_no_motion_joins_have_no_points_in_common():
    images, edges = panorama(5)
    joined = {pair: motion for pair, motion in edges.items() if pair not in ((2, 3), (3, 2))}
    with pytest.raises(InputError, match="no motion joins the frames 3, 4 to the others"):
        numbers("surface_flicker", images, joined)


@pytest.mark.parametrize("count", [8, 9])
def test_blinking_is_fast_and_a_slow_change_is_not(count):
    time = np.arange(count)
    blinking, slow = np.cos(np.pi * time), np.sin(2 * np.pi * time / count)
    assert fast_share(blinking[:, None, None]) > 0.9
    assert fast_share(slow[:, None, None]) < 0.01
    assert fast_share(np.zeros((count, 1, 1))) == 0


def test_the_share_of_fast_changes_is_that_of_their_variance():
    """A fast wave of half the amplitude has a fifth of the whole variance."""
    time = 2 * np.pi * np.arange(16) / 16
    wave = np.sin(time) + np.sin(6 * time) / 2
    assert fast_share(wave[:, None, None]) == pytest.approx(0.2)


def test_the_gradient_of_a_ramp_is_its_slope():
    rows, columns = np.mgrid[:10, :12]
    ramp = (3 * columns + 4 * rows).astype(np.uint8)[..., None]
    assert gradient(ramp) == 5
    assert gradient(np.repeat(ramp, 3, axis=2)) == pytest.approx(5)


def test_blur_lowers_gradient_and_sharpness():
    image = noise()
    mean = (image.astype(int) + np.roll(image, 1, axis=1) + np.roll(image, 1, axis=0)) // 3
    identity = np.stack(np.mgrid[:HEIGHT, :WIDTH], axis=-1)[None]
    sharp, blurred = (
        METRICS["gradient"].measure(frame_set(image[None], {}), Outcome(frames, 0.0, identity))
        for frames in (image[None], mean[None].astype(np.uint8))
    )
    assert sharp["crispness"] == pytest.approx(1)
    assert blurred["gradient"] < 0.7 * sharp["gradient"]
    assert blurred["crispness"] < 0.7


def a_thing_before_the_ground(rows=76):
    """A square before the ground: ids and depth; one pixel of band at 76 rows."""
    ids, depth = np.zeros((rows, 90, 1), np.uint8), np.full((rows, 90), 21, np.float32)
    ids[30:40, 20:50], depth[30:40, 20:50] = 255, 10
    return ids, depth


@pytest.mark.parametrize("behind", [21, 0])
def test_the_band_lies_beside_the_nearer_thing(behind):
    ids, depth = a_thing_before_the_ground()
    found = band(ids, np.where(depth == 21, np.float32(behind), depth))
    expected = np.zeros_like(found)
    expected[29, 20:50] = expected[40, 20:50] = expected[30:40, [19, 50]] = True
    np.testing.assert_array_equal(found, expected)


def test_the_band_grows_with_the_frame():
    found = band(*a_thing_before_the_ground(228))
    assert found[27:30, 35].all()
    assert not found[26, 35]


def test_the_border_of_a_part_that_is_hardly_nearer_is_no_silhouette():
    ids, depth = a_thing_before_the_ground()
    assert band(ids, np.maximum(depth, 20)).any()
    assert not band(ids, np.maximum(depth, 20.01)).any()
    assert not band(ids, np.zeros_like(depth)).any()


def test_a_lost_outline_is_bad():
    """The style is paper with a black line; dark is below the middle of both."""
    style = np.full((76, 90, 3), 240, np.uint8)
    style[:, :9] = 20
    ids, depth = a_thing_before_the_ground()
    outside = band(ids, depth)
    drawn = np.full((1, 76, 90, 3), 240, np.uint8)
    drawn[0, outside] = 20
    assert dark_share(drawn, outside[None], style) == 1
    drawn[0, 29, 20:50] = 131
    assert dark_share(drawn, outside[None], style) == 50 / 80
    extra = {"ids": ids[None], "depths": depth[None]}
    assert numbers("outlines", style[None], {}, **extra) == {"outlines": 0}


def test_the_error_of_guides_is_the_mean_over_channels():
    source = np.zeros((4, 4, 3), np.uint8), np.zeros((4, 4), np.uint8)
    source[0][1, 2] = 8, 4, 0
    source[1][1, 2] = 20
    target = np.zeros((2, 2, 3), np.uint8), np.zeros((2, 2), np.uint8)
    nnf = np.zeros((2, 2, 2), np.int32)
    assert guide_error(nnf, source, target) == 0
    nnf[0, 0] = 1, 2
    assert guide_error(nnf, source, target) == (8 + 4 + 20) / 16


def test_patches_from_anywhere_have_unlike_guides():
    images, edges = panorama(2)
    identity = np.stack(np.mgrid[:HEIGHT, :WIDTH], axis=-1)
    nnf = np.stack([identity, identity])
    assert numbers("guide_fidelity", images[[0, 0]], edges, nnf) == {"guide_error": 0}
    assert numbers("guide_fidelity", images[[0, 0]], edges, nnf[:, ::-1])["guide_error"] > 60


def test_a_point_keeps_its_source_pixel_or_one_beside_it():
    own = np.zeros((HEIGHT, WIDTH, 2), np.int32)
    own[..., 1] = 40
    other = own.copy()
    assert kept(own, other, moved(2)) == 1
    other[:, : WIDTH // 2] += (1, -1)
    assert kept(own, other, moved(0)) == 1
    other[:, : WIDTH // 2] += (1, 0)
    assert kept(own, other, moved(0)) == 0.5
    assert kept(own, other, Motion(moved(0).field, moved(0).visible & False)) is None


def test_frames_made_each_by_itself_keep_little():
    images, edges = panorama(2)
    nnf = np.random.default_rng(1).integers(0, 400, (2, HEIGHT, WIDTH, 2), dtype=np.int32)
    assert numbers("nnf_kept", images, edges, nnf)["kept"] < 0.01


def test_metrics_of_frames_say_nothing_of_a_single_scene():
    other = replace(frame_set(*panorama(2)))
    for name in (
        "warping", "loops", "surface_flicker", "gradient", "outlines", "guide_fidelity", "nnf_kept",
    ):  # fmt: skip
        assert METRICS[name].measure(object(), Outcome(other.renderings[0], 0.0)) == {}
        assert set(METRICS[name].NUMBERS) <= set(NUMBERS)


def test_no_two_metrics_give_a_number_of_the_same_name():
    assert len(NUMBERS) == sum(len(metric.NUMBERS) for metric in METRICS.values())


def test_a_frame_set_tells_its_size_and_what_methods_see():
    images, edges = panorama(3)
    frames = frame_set(images, edges)
    assert (frames.frames, frames.size, frames.pixels) == (3, "24x16", 3 * 24 * 16)
    assert replace(frames, renderings=images + 1).digest == frames.digest
    assert replace(frames, renderings=images + 1).digest_of_ids != frames.digest_of_ids
    hidden = {pair: Motion(m.field, m.visible & False) for pair, m in edges.items()}
    for changed in (
        {"edges": hidden}, {"style": images[1]}, {"guides": frames.guides[::-1]},
        {"depths": images[..., 0]},
    ):  # fmt: skip
        assert replace(frames, **changed).digest != frames.digest
