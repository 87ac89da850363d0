"""Warp errors by hand, and a frozen picture that must not pass for calm."""

from dataclasses import replace

import numpy as np
import pytest
from small_scene import small_scene

from data_gen.multilayer_exr import write_layers
from eval.flicker import calm, read_motion, warp_error
from eval.metrics.image_energy import image_energy
from eval.scenes import Scene

HEIGHT, WIDTH = 20, 30


def still():
    return np.zeros((HEIGHT, WIDTH, 2), np.float32), np.ones((HEIGHT, WIDTH), np.bool_)


def noise(seed=0):
    return np.random.default_rng(seed).integers(0, 256, (HEIGHT, WIDTH, 3), dtype=np.uint8)


def test_the_same_picture_on_a_still_target_does_not_flicker():
    assert warp_error(noise(), noise(), *still()) == 0


def test_a_step_of_one_value_is_its_warp_error():
    grey = np.full((HEIGHT, WIDTH, 3), 100, np.uint8)
    brighter = grey + np.uint8([0, 3, 6])
    assert warp_error(grey, brighter, *still()) == 3


def test_paint_that_moves_with_its_point_does_not_flicker():
    before = noise()
    after = np.roll(before, (2, 5), axis=(0, 1))
    motion, visible = still()
    motion[:] = 5, 2
    visible[:] = False
    visible[:-2, :-5] = True
    assert warp_error(before, after, motion, visible) == 0
    assert warp_error(before, before, motion, visible) > 50


def test_between_pixels_the_second_frame_is_interpolated():
    ramp = np.repeat(np.arange(0, 2 * WIDTH, 2, dtype=np.uint8)[None], HEIGHT, axis=0)[..., None]
    motion, visible = still()
    motion[..., 0] = 0.25
    visible[:, -1] = False
    assert warp_error(ramp, ramp, motion, visible) == pytest.approx(0.5)


def test_what_the_other_frame_hides_does_not_count():
    after = noise().copy()
    motion, visible = still()
    after[5:9, 3:20] ^= 255
    visible[5:9, 3:20] = False
    assert warp_error(noise(), after, motion, visible) == 0
    assert warp_error(noise(), after, motion, np.zeros_like(visible)) == 0


def test_flicker_of_a_sequence_is_the_mean_of_its_steps():
    dark, bright = (np.full((HEIGHT, WIDTH, 3), value, np.uint8) for value in (10, 14))
    result = calm([dark, bright, bright], [still(), still()], 101.0, 100.0)
    assert result == (2.0, 1.01)
    assert result.holds
    assert not calm([dark, bright], [still()], 102.0, 100.0).holds


def test_a_frozen_picture_is_calm_and_fails():
    """Where the target has changed, patches of a picture that has not fit it worse."""
    style, sources, _ = small_scene(source_size=(40, 46))
    scene = Scene("self", None, ("a", "b"), style, tuple(sources), tuple(sources), 1)
    turned = replace(scene, target_guides=tuple(np.roll(each, 9, axis=1) for each in sources))
    motion = np.zeros((*style.shape[:2], 2)), np.ones(style.shape[:2], np.bool_)
    redrawn = np.ascontiguousarray(np.roll(style, 9, axis=1))
    cold = image_energy(turned, redrawn).mean
    frozen = calm([style, style], [motion], image_energy(turned, style).mean, cold)
    assert frozen.flicker == 0
    assert not frozen.holds
    assert calm([style, redrawn], [motion], cold, cold).holds


def test_motion_is_read_from_the_data_sets_files(tmp_path):
    motion = np.random.default_rng(0).integers(-4, 5, (HEIGHT, WIDTH, 2)).astype(np.float32)
    visible = (np.indices((HEIGHT, WIDTH)).sum(axis=0) % 3 > 0).astype(np.float32)[..., None]
    write_layers(tmp_path / "07_to_08.exr", {"MOTION": motion, "VISIBLE": visible})
    read = read_motion(tmp_path, 7)
    np.testing.assert_array_equal(read[0], motion)
    np.testing.assert_array_equal(read[1], visible[..., 0] > 0)
