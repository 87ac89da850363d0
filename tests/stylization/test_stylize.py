"""``stylize`` as a user calls it."""

import logging
import weakref

import numba
import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import PRESETS, Field, InputError, Params, replay, stylize
from stylit_ref.stylization.checks import most_levels
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.target import Target

QUICK = Params(levels=3, votes=2, patchmatch_iterations=2)


def quick(schedule="propose_commit", **changes):
    values = {"levels": 3, "votes": 2, "patchmatch_iterations": 2, "schedule": schedule}
    return Params(**(values | changes))


def assert_same(a, b):
    for name in ("image", "nnf", "omega", "error"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), err_msg=name)
    assert a.history == b.history


@pytest.mark.parametrize("schedule", ["propose_commit", "scanline"])
def test_result_has_the_promised_form(schedule):
    scene = small_scene()
    result = stylize(*scene, quick(schedule))
    assert result.image.shape == (38, 44, 3)
    assert result.image.dtype == np.uint8
    assert result.nnf.shape == (38, 44, 2)
    assert result.nnf.dtype == np.int32
    assert result.nnf.min() >= 2
    assert (result.nnf.max(axis=(0, 1)) <= (37, 43)).all()
    assert result.omega.shape == (40, 46)
    assert result.omega.sum() == 25 * 38 * 44
    assert result.error.shape == (38, 44)
    assert result.error.dtype == np.float32
    assert np.isfinite(result.error).all()
    assert len(result.history) == 3 * 2 * 2
    assert [step.done for step in result.history] == sorted(step.done for step in result.history)
    assert result.history[-1].done == 1


@pytest.mark.parametrize("threads", [1, 2])
def test_same_seed_same_bytes_with_any_number_of_threads(threads):
    if threads > numba.config.NUMBA_NUM_THREADS:
        pytest.skip(f"this machine offers {numba.config.NUMBA_NUM_THREADS} threads")
    scene = small_scene()
    first = stylize(*scene, QUICK, seed=3, threads=1)
    for _ in range(2):
        assert_same(first, stylize(*scene, QUICK, seed=3, threads=threads))


def test_another_seed_is_another_result():
    scene = small_scene()
    a, b = (stylize(*scene, QUICK, seed=seed) for seed in (0, 1 << 63))
    assert (a.nnf != b.nnf).any()


@pytest.mark.parametrize(
    ("guide_channels", "style_channels"), [((1,), 1), ((3, 3, 1), 2), ((3,) * 8, 4), ((31,), 3)]
)
def test_any_number_of_channels(guide_channels, style_channels):
    scene = small_scene(guide_channels=guide_channels, style_channels=style_channels)
    result = stylize(*scene, QUICK)
    assert result.image.shape[2] == style_channels
    assert result.error.mean() < result.history[0].delta


@pytest.mark.parametrize("patch_width", [3, 5, 7])
def test_a_guide_map_without_white_is_the_reference(patch_width):
    scene = small_scene()
    mapped = stylize(*scene, quick(method="guide_map", epsilon=0, patch_width=patch_width))
    assert_same(stylize(*scene, quick(patch_width=patch_width)), mapped)
    assert len(mapped.guide_maps) == 3
    assert not any(white.any() for white in mapped.guide_maps)


def test_white_grows_with_epsilon_and_changes_the_result():
    scene = small_scene()
    results = [
        stylize(*scene, quick(method="guide_map", epsilon=epsilon), threads=threads)
        for epsilon, threads in ((0, 1), (100, 1), (100, None), (1e6, None))
    ]
    white = [result.guide_maps[-1].mean() for result in results]
    assert white[0] == 0 < white[1] == white[2] < white[3] == 1
    assert_same(results[1], results[2])
    assert (results[1].nnf != results[0].nnf).any()
    assert [white.shape for white in results[0].guide_maps] == [(9, 11), (19, 22), (38, 44)]


@pytest.mark.parametrize("method", ["guide_map", "stylit"])
def test_methods_leave_masked_pixels_alone(method):
    style, sources, targets = small_scene()
    mask = np.zeros((38, 44), bool)
    mask[:20, 10:] = True
    result = stylize(style, sources, targets, quick(method=method), mask=mask)
    assert (result.nnf[2:16, 14:] == -1).all()
    assert (result.image[:, :, 3] == 255 * ~mask).all()
    assert (result.nnf[~mask] >= 0).all()


@pytest.mark.parametrize("method", ["guide_map", "stylit"])
@pytest.mark.parametrize(
    "sizes",
    [
        ((5, 5), (5, 5)),
        ((5, 40), (30, 6)),
        ((60, 60), (5, 7)),
        pytest.param(((6, 5), (40, 40)), marks=pytest.mark.slow),  # hundreds of retrievals
    ],
    ids=str,
)
def test_methods_take_narrow_and_uneven_images(method, sizes):
    scene = small_scene(source_size=sizes[0], target_size=sizes[1])
    result = stylize(*scene, Params(method, levels=1, votes=2, patchmatch_iterations=2))
    assert result.image.shape[:2] == sizes[1]
    assert (result.nnf >= 2).all()
    assert (result.nnf < np.array(sizes[0]) - 2).all()


def test_grey_style_without_a_channel_axis():
    style, sources, targets = small_scene(style_channels=1)
    flat = stylize(style[:, :, 0], sources, targets, QUICK)
    assert flat.image.shape == (38, 44)
    np.testing.assert_array_equal(flat.image, stylize(style, sources, targets, QUICK).image[..., 0])


def test_target_like_the_source_gives_the_style_back():
    style, sources, _ = small_scene()
    params = Params(levels=3, votes=4, patchmatch_iterations=6, uniformity=1000)
    result = stylize(style, sources, sources, params)
    expected = np.stack(np.mgrid[:40, :46], axis=-1)
    inside = np.s_[4:-4, 4:-4]
    assert (result.nnf == expected)[inside].all(axis=2).mean() > 0.9
    assert np.abs(result.image.astype(int) - style)[inside].mean() < 3


def test_uniformity_spreads_usage():
    scene = small_scene()
    peaks = [stylize(*scene, quick(uniformity=value)).omega.max() for value in (0, 3000, 100000)]
    assert peaks[0] > peaks[1] > peaks[2]


def test_guide_weight_zero_ignores_a_guide():
    style, sources, targets = small_scene(guide_channels=(3, 3))
    noise = np.random.default_rng(9).integers(0, 256, targets[1].shape, dtype=np.uint8)
    params = quick(guide_weights=(1.0, 0.0))
    a = stylize(style, sources, targets, params)
    b = stylize(style, sources, [targets[0], noise], params)
    assert_same(a, b)


def test_equal_weights_are_the_default():
    scene = small_scene()
    assert_same(stylize(*scene, QUICK), stylize(*scene, quick(guide_weights=(1.0, 1.0))))


def test_progress_and_levels_are_reported():
    scene = small_scene()
    steps, levels = [], []
    result = stylize(
        *scene, QUICK, progress=steps.append, on_level=lambda level, image: levels.append(image)
    )
    assert tuple(steps) == result.history
    assert [image.shape[:2] for image in levels] == [(9, 11), (19, 22), (38, 44)]
    np.testing.assert_array_equal(levels[-1], result.image)


def test_too_many_levels_are_reduced_and_noted(caplog):
    with caplog.at_level("INFO", "stylit_ref"):
        result = stylize(*small_scene(), quick(levels=9))
    assert result.history[-1].levels == 3
    said = "levels is 9, but 3 are used: a coarser level would be smaller than a patch"
    assert caplog.record_tuples == [("stylit_ref", logging.INFO, said)]


def test_all_levels_are_as_many_as_fit_and_no_note_is_due(caplog):
    with caplog.at_level("INFO", "stylit_ref"):
        result = stylize(*small_scene(), quick(levels="all"))
    assert result.history[-1].levels == 3
    assert_same(result, stylize(*small_scene(), quick(levels=3)))
    assert caplog.record_tuples == []


@pytest.mark.parametrize(
    ("size", "levels"), [((5, 9), 1), ((10, 11), 2), ((228, 300), 6), ((912, 1200), 8)]
)
def test_the_coarsest_of_all_levels_is_the_smallest_that_holds_a_patch(size, levels):
    assert most_levels(5, size, (2000, 3000)) == most_levels(5, (2000, 3000), size) == levels
    assert min(size) >> (levels - 1) >= 5 > min(size) >> levels


def test_guides_that_all_weigh_nothing_are_noted(caplog):
    stylize(*small_scene(), quick(guide_weights=(0, 0)))
    said = "guide_weights is 0 for every guide, so the guides guide nothing"
    assert caplog.record_tuples == [("stylit_ref", logging.WARNING, said)]


def test_threads_that_are_not_there_are_left_out_and_noted(caplog):
    offered = numba.config.NUMBA_NUM_THREADS
    with caplog.at_level("INFO", "stylit_ref"):
        assert_same(stylize(*small_scene(), QUICK), stylize(*small_scene(), QUICK, threads=100000))
    said = f"threads is 100000, but {offered} are used, all that there are"
    assert caplog.record_tuples == [("stylit_ref", logging.INFO, said)]
    assert numba.get_num_threads() == offered


def test_a_note_comes_once_for_all_frames(caplog):
    with caplog.at_level("INFO", "stylit_ref"):
        for seed in range(3):
            stylize(*small_scene(), quick(levels=9), seed=seed)
        stylize(*small_scene(), quick(levels=8))
    assert [record.getMessage()[:11] for record in caplog.records] == ["levels is 9", "levels is 8"]


def test_a_target_of_one_patch_and_a_source_of_one_patch():
    style, sources, targets = small_scene(source_size=(5, 5), target_size=(5, 5))
    result = stylize(style, sources, targets, Params(levels=1, votes=1, patchmatch_iterations=1))
    assert (result.nnf == 2).all()


class TestMask:
    mask = np.zeros((38, 44), bool)
    mask[10:30, 8:36] = True

    def test_masked_pixels_show_the_fill(self):
        scene = small_scene()
        fill = np.random.default_rng(1).integers(0, 256, (38, 44, 3), dtype=np.uint8)
        result = stylize(*scene, QUICK, mask=self.mask, fill=fill)
        np.testing.assert_array_equal(result.image[self.mask], fill[self.mask])
        assert result.image.shape == (38, 44, 3)

    def test_masked_pixels_are_transparent_without_fill(self):
        result = stylize(*small_scene(), QUICK, mask=self.mask)
        assert result.image.shape == (38, 44, 4)
        np.testing.assert_array_equal(result.image[..., 3] == 0, self.mask)

    @pytest.mark.parametrize("schedule", ["propose_commit", "scanline"])
    def test_no_patch_is_spent_deep_inside(self, schedule):
        result = stylize(*small_scene(), quick(schedule), mask=self.mask)
        assert (result.nnf[12:28, 10:34] == -1).all()
        assert np.isnan(result.error[12:28, 10:34]).all()
        assigned = (result.nnf[..., 0] >= 0).sum()
        assert assigned == 38 * 44 - 16 * 24
        assert result.omega.sum() == 25 * assigned

    def test_what_lies_under_the_mask_does_not_matter(self):
        """Guides more than two radii inside the mask are never read at the finest level."""
        style, sources, targets = small_scene()
        changed = [target.copy() for target in targets]
        changed[0][15:25, 13:31] = 255
        one_level = quick(levels=1)
        a, b = (
            stylize(style, sources, guides, one_level, mask=self.mask)
            for guides in (targets, changed)
        )
        assert_same(a, b)

    def test_an_empty_mask_adds_an_opaque_alpha_and_changes_nothing(self):
        scene = small_scene()
        plain = stylize(*scene, QUICK)
        masked = stylize(*scene, QUICK, mask=np.zeros((38, 44), bool))
        np.testing.assert_array_equal(masked.image[:, :, :3], plain.image)
        assert (masked.image[:, :, 3] == 255).all()
        np.testing.assert_array_equal(masked.nnf, plain.nnf)


class TestReplay:
    @pytest.mark.parametrize("patch_width", [3, 5])
    def test_replay_of_the_style_is_the_image(self, patch_width):
        scene = small_scene()
        result = stylize(*scene, quick(patch_width=patch_width))
        again = replay(result.nnf, scene[0], patch_width=patch_width)
        np.testing.assert_array_equal(again, result.image)

    def test_sixteen_bits_stay_sixteen(self):
        style, *guides = small_scene()
        result = stylize(style, *guides, QUICK)
        deep = replay(result.nnf, style.astype(np.uint16) * 257)
        assert deep.dtype == np.uint16
        assert np.abs(deep / 257 - result.image).max() <= 0.51
        assert len(np.unique(deep)) > 256

    def test_float_is_not_rounded(self):
        style, *guides = small_scene()
        result = stylize(style, *guides, QUICK)
        image = replay(result.nnf, style.astype(np.float32) / 255)
        assert image.dtype == np.float32
        np.testing.assert_allclose(image * 255, result.image, atol=0.51)

    def test_enlarged_style(self):
        style, *guides = small_scene()
        result = stylize(style, *guides, QUICK)
        large = replay(result.nnf, style.repeat(3, axis=0).repeat(3, axis=1), scale=3)
        np.testing.assert_array_equal(large, result.image.repeat(3, axis=0).repeat(3, axis=1))

    def test_a_forgotten_scale_is_noticed(self, caplog):
        style, *guides = small_scene()
        result = stylize(style, *guides, QUICK)
        replay(result.nnf, style.repeat(3, axis=0).repeat(3, axis=1))
        said = (
            "scale is 1, but the NNF uses less than half of the style's 138x120; if the style is "
            "an enlargement, give a larger scale"
        )
        assert caplog.record_tuples == [("stylit_ref", logging.WARNING, said)]

    def test_votes_that_a_run_left_out_are_left_out_again(self):
        scene = small_scene()
        result = stylize(*scene, quick(vote_outliers=4))
        again = replay(Field(result.nnf, vote_outliers=4), scene[0])
        np.testing.assert_array_equal(again, result.image)
        assert (replay(result.nnf, scene[0]) != result.image).any()

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"nnf": np.zeros((4, 4, 2))}, "float64"),
            ({"nnf": np.zeros((4, 4), np.int32)}, r"shape \(4, 4\)"),
            ({"style": np.zeros((20, 20, 3), np.uint8)}, "20x20"),
            ({"style": np.zeros((40, 46, 3))}, "float64"),
            ({"nnf": np.full((8, 8, 2), -1, np.int32)}, "nnf assigns nothing"),
            ({"patch_width": 4}, "patch_width is 4"),
            ({"scale": 3}, "multiples of the scale 3"),
            ({"scale": 2.0}, "scale is 2.0"),
        ],
        ids=str,
    )
    def test_bad_input(self, change, message):
        nnf = np.full((8, 8, 2), 36, np.int32)
        arguments = {"nnf": nnf, "style": np.zeros((40, 46, 3), np.uint8)} | change
        with pytest.raises(InputError, match=message):
            replay(**arguments)


def bad_scene(**changes):
    style, sources, targets = small_scene()
    return {"style": style, "source_guides": sources, "target_guides": targets} | changes


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"source_guides": []}, "target_guides holds 2 guides but source_guides holds 0"),
        ({"source_guides": [], "target_guides": []}, "source_guides is empty"),
        ({"style": np.zeros((40, 47, 3), np.uint8)}, "46x40 but the style is 47x40"),
        ({"style": np.zeros((40, 46, 5), np.uint8)}, "5 channels"),
        ({"style": np.zeros((40, 46, 3))}, "float64"),
        ({"style": np.zeros(40, np.uint8)}, r"shape \(40,\)"),
        ({"style": np.zeros((0, 46, 3), np.uint8)}, r"shape \(0, 46, 3\)"),
        ({"params": Params(guide_weights=(1.0,))}, "guide_weights holds 1 weights for 2 guides"),
        ({"params": "fast"}, r"params is 'fast'; write Params.preset\('fast'\)"),
        (
            {"params": "slow"},
            "preset is 'slow'; it must be 'final', 'fast', 'thesis' or 'architecture'",
        ),
        ({"params": PRESETS["fast"]}, r"params is a dict; write Params.preset\('fast'\)"),
        ({"params": {}}, r"params is a dict; write Params.preset\('thesis'\)"),
        ({"params": {"levels": 3}}, r"params is a dict; write Params\(\*\*params\)"),
        ({"params": np.zeros(3)}, "params is of type ndarray; it must be a Params"),
        (
            {"source_guides": np.zeros((40, 46, 3), np.uint8)},
            r"source_guides is one array of shape \(40, 46, 3\); put it in a list: "
            r"\[source_guide\]",
        ),
        ({"target_guides": np.zeros((38, 44), np.uint8)}, r"in a list: \[target_guide\]"),
        ({"params": Params(patch_width=41)}, "source is 46x40"),
        ({"params": Params(patch_width=39, levels=1)}, "target is 44x38"),
        ({"params": Params(uniformity=1e12)}, "uniformity is 1e"),
        ({"params": Params(guide_weights=(1e9, 1.0))}, "guide weight 1e"),
        ({"params": Params(guide_weights=(1e-9, 1.0))}, "too small to count"),
        ({"seed": -1}, "seed is -1"),
        ({"seed": 1 << 64}, "seed is"),
        ({"seed": 0.5}, "seed is 0.5"),
        ({"threads": 1.0}, "threads is 1.0"),
        ({"threads": 0}, "threads is 0"),
        ({"threads": -1}, "threads is -1; it must be an integer of at least 1"),
        ({"backend": "gpu"}, "must be 'cpu', 'auto', 'cuda', 'cuda:shared_memory', 'cuda:live' or"),
        ({"mask": np.ones((38, 44), bool)}, "mask covers the whole target"),
        ({"mask": np.zeros((38, 43), bool)}, "mask is 43x38 but the target is 44x38"),
        ({"mask": np.zeros((38, 44))}, "float64"),
        ({"mask": np.zeros((38, 44, 1), bool)}, r"\(38, 44, 1\)"),
        ({"mask": np.eye(38, 44, dtype=bool), "fill": np.zeros((38, 43, 3), np.uint8)}, "43x38"),
        (
            {"mask": np.eye(38, 44, dtype=bool), "fill": np.zeros((38, 44, 5), np.uint8)},
            r"fill has shape \(38, 44, 5\); it must be grey or RGB",
        ),
    ],
    ids=lambda value: value if isinstance(value, str) else ",".join(value),
)
def test_bad_input_is_one_sentence(change, message):
    with pytest.raises(InputError, match=message) as caught:
        stylize(**bad_scene(**change))
    assert "\n" not in str(caught.value)


def test_a_guide_map_of_wide_patches_needs_smaller_weights():
    """Squares of sums over a patch are w² times as large as sums of squares."""
    scene = small_scene(source_size=(70, 70), target_size=(70, 70))
    values = {"patch_width": 63, "guide_influence": 1000.0, "levels": 1, "votes": 1}
    values |= {"patchmatch_iterations": 1}
    stylize(*scene, Params(**values))
    with pytest.raises(InputError, match="overflows 64-bit"):
        stylize(*scene, Params("guide_map", **values))


def test_a_weight_too_small_for_fixed_point_is_said(caplog):
    style, sources, targets = small_scene()
    params = quick(patch_width=21, levels=1, uniformity=10)
    stylize(style, sources, targets, params)
    (record,) = caplog.records
    assert record.levelno == logging.WARNING
    assert record.parameter == "uniformity"
    assert record.sentence == (
        "is 10, but 10.7864 is used: the nearest fixed-point value with patches of width 21"
    )


def test_guide_weights_may_be_any_sequence():
    scene = small_scene()
    a, b = (stylize(*scene, quick(guide_weights=w)) for w in ((2.0, 1.0), np.array([2.0, 1.0])))
    assert_same(a, b)


def test_guides_of_different_sizes_or_channels():
    style, sources, targets = small_scene()
    with pytest.raises(InputError, match=r"target_guides\[1\] is 40x38 but target_guides\[0\] is"):
        stylize(style, sources, [targets[0], targets[1][:, :40]])
    with pytest.raises(InputError, match=r"source_guides\[0\] has 3 channels but target_g"):
        stylize(style, sources, [targets[0][:, :, :1], targets[1]])


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_by_name(name):
    assert Params.preset(name) == Params(**PRESETS[name])


@pytest.mark.parametrize("name", ["quick", "", None, 3])
def test_a_preset_that_is_not_there(name):
    with pytest.raises(
        InputError,
        match=f"preset is {name!r}; it must be 'final', 'fast', 'thesis' or 'architecture'",
    ):
        Params.preset(name)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"patch_width": 4}, "odd"),
        ({"patch_width": 1}, "from 3"),
        ({"patch_width": 5.0}, "odd integer"),
        ({"levels": 0}, "levels is 0"),
        ({"votes": -1}, "votes is -1"),
        ({"votes": (1, 0)}, "votes is 0"),
        ({"votes": ()}, r"votes is \(\)"),
        ({"patchmatch_iterations": 1.5}, "patchmatch_iterations is 1.5"),
        ({"uniformity": -1}, "uniformity is -1"),
        ({"uniformity": float("nan")}, "uniformity is nan"),
        ({"uniformity": 1e305}, r"uniformity is 1e\+305"),
        ({"guide_influence": float("inf")}, "guide_influence is inf"),
        ({"guide_weights": (1.0, -2.0)}, "guide weight 2 is -2.0"),
        ({"guide_weights": 1.0}, "must be a list of numbers"),
        ({"schedule": "random"}, "'random'"),
        ({"method": "magic"}, "'ref', 'guide_map' or 'stylit'"),
        ({"method": "stylit", "schedule": "scanline"}, "for method 'ref' alone"),
        ({"epsilon": -1}, "epsilon is -1"),
        ({"epsilon": float("nan")}, "epsilon is nan"),
        ({"budget": "knee"}, "budget is 'knee'"),
        ({"budget": 1.1}, "budget is 1.1"),
        ({"fixed_share": 0}, "fixed_share is 0"),
        ({"error_limit": 0.9}, "error_limit is 0.9"),
        ({"vote_outliers": 25}, "from 0 to 24"),
        ({"vote_outliers": 1.5}, "vote_outliers is 1.5"),
    ],
    ids=str,
)
def test_bad_parameters(change, message):
    with pytest.raises(InputError, match=message):
        Params(**change)


def test_votes_by_level_count_from_the_finest():
    style, sources, targets = small_scene()
    steps = stylize(
        style, sources, targets, Params(levels=3, votes=(1, 3), patchmatch_iterations=2)
    ).history
    assert [(step.level, step.vote) for step in steps[::2]] == [
        (1, 1), (1, 2), (1, 3), (2, 1), (2, 2), (2, 3), (3, 1),
    ]  # fmt: skip
    assert [step.done for step in steps] == sorted(step.done for step in steps)
    assert steps[-1].done == 1


def test_images_that_nobody_else_holds_are_freed_once_they_are_packed():
    style, sources, targets = small_scene()
    large = [[each.copy() for each in targets], [each.copy() for each in sources], style.copy()]
    watched = [weakref.ref(each) for each in (*large[0], *large[1], large[2])]
    there = []
    stylize(
        large.pop(), large.pop(), large.pop(), QUICK,
        progress=lambda step: there.append(sum(each() is not None for each in watched)),
    )  # fmt: skip
    assert set(there) == {0}


def test_levels_are_freed_when_the_run_needs_them_no_more(monkeypatch):
    forgotten = []
    for part in (Exemplar, Target):

        def forget(self, depth, part=part, forget=part.forget):
            forgotten.append((part, depth))
            forget(self, depth)

        monkeypatch.setattr(part, "forget", forget)
    stylize(*small_scene(), QUICK)
    assert forgotten == [(part, depth) for depth in (2, 1, 0) for part in (Target, Exemplar)]
