"""How guides become 8 bits: what is chosen, and what it does to values."""

import json

import numpy as np
import pytest

from stylit_ref import GuideEncoding, InputError, to_uint8
from stylit_ref.files.guides.choose_encoding import choose_encoding
from stylit_ref.files.picture import Picture

RNG = np.random.default_rng(0)


def light(pixels, alpha_channel=None):
    return Picture(np.float32(pixels), alpha_channel, True, "Combined")


def data(pixels, *words):
    return Picture(np.float32(pixels), None, False, "Data", frozenset(words))


def clipped(pixels, low, high):
    """Share of values beyond, counted one by one."""
    values = pixels.ravel().tolist()
    return (
        sum(value < low for value in values) / len(values),
        sum(value > high for value in values) / len(values),
    )


class TestIntegersAndLightWithinOne:
    @pytest.mark.parametrize("dtype", ["uint8", "uint16"])
    def test_integers_stay(self, dtype):
        pixels = RNG.integers(0, np.iinfo(dtype).max, (20, 30, 3), dtype)
        picture = Picture(pixels, None, True, "a.png")
        encoding = choose_encoding([picture, picture])
        assert encoding == GuideEncoding("light")
        np.testing.assert_array_equal(encoding.encode(picture), to_uint8(pixels))

    @pytest.mark.parametrize("share", [0, 0.005])
    def test_light_that_hardly_clips_stays(self, share):
        pixels = RNG.random((20, 50, 3))
        pixels.reshape(-1, 3)[: int(share * 1000)] = 7
        encoding = choose_encoding([light(pixels), light(pixels)])
        assert encoding == GuideEncoding("light")
        np.testing.assert_array_equal(
            encoding.encode(light(pixels)), to_uint8(np.float32(pixels), curve="srgb")
        )

    def test_light_beside_integers_stays(self):
        integers = Picture(np.zeros((4, 4, 3), np.uint8), None, True, "a.png")
        assert choose_encoding([integers, light(np.full((4, 4, 3), 9))]).is_plain


class TestExposure:
    def test_at_most_half_a_percent_of_each_picture_is_clipped(self):
        dark, bright = (RNG.exponential(size, (40, 50, 3)) for size in (0.3, 2))
        encoding = choose_encoding([light(dark), light(bright)])
        for pixels in (dark, bright):
            assert clipped(np.float32(pixels).max(axis=2), 0, encoding.high)[1] <= 0.005
        # One pixel more would be.
        brightest = np.sort(np.float32(bright).max(axis=2).ravel())
        assert encoding.high == brightest[-11]

    def test_values_go_through_the_curve(self):
        pixels = RNG.random((3, 4, 3)) * 4
        encoding = GuideEncoding("light", high=2.0)
        shown = encoding.encode(light(pixels))
        np.testing.assert_array_equal(shown, to_uint8(np.float32(pixels) / 2, curve="srgb"))

    def test_alpha_is_no_light_and_colours_count_without_it(self):
        pixels = np.zeros((20, 20, 4))
        pixels[..., 3] = 0.5
        pixels[..., :3] = 1  # 2 without alpha
        encoding = choose_encoding([light(pixels, 3), light(pixels, 3)])
        assert encoding.high == 2
        assert encoding.encode(light(pixels, 3))[0, 0].tolist() == [128, 128, 128, 128]

    def test_what_is_not_seen_does_not_count(self):
        pixels = np.zeros((20, 20, 4))
        pixels[:2, :, 3], pixels[:2, :, :3] = 1, 3
        assert choose_encoding([light(pixels, 3)] * 2).high == 3

    @pytest.mark.parametrize("kind", ["light", "data"])
    def test_the_picture_is_not_changed(self, kind):
        picture = light(np.full((4, 4, 3), 8))
        GuideEncoding(kind, 0.0, 8.0).encode(picture)
        assert (picture.pixels == 8).all()


class TestData:
    def test_within_one_it_stays(self):
        pixels = RNG.random((20, 20, 3))
        encoding = choose_encoding([data(pixels), data(pixels)])
        assert encoding == GuideEncoding("data")
        np.testing.assert_array_equal(
            encoding.encode(data(pixels)), to_uint8(np.float32(pixels), curve="none")
        )

    def test_both_sides_share_one_range(self):
        near, far = 5 + RNG.random((20, 50, 1)), 9 + RNG.random((20, 50, 1))
        encoding = choose_encoding([data(near), data(far)])
        assert clipped(np.float32(near), encoding.low, encoding.high)[0] <= 0.005
        assert clipped(np.float32(far), encoding.low, encoding.high)[1] <= 0.005
        assert encoding.encode(data(near)).max() < encoding.encode(data(far)).min()

    @pytest.mark.parametrize("empty", [1e10, np.inf])
    def test_empty_depth_is_the_farthest_and_stretches_nothing(self, empty):
        depth = np.linspace(6, 15, 1000).reshape(20, 50, 1)
        with_sky = depth.copy()
        with_sky[:5] = empty
        encoding = choose_encoding([data(depth), data(with_sky)])
        assert encoding.high <= 15
        shown = encoding.encode(data(with_sky))
        assert (shown[:5] == 255).all()
        assert shown[6:].min() < 100

    def test_nothing_but_empty_depth_is_no_range(self):
        depth = np.linspace(6, 15, 1000).reshape(20, 50, 1)
        empty = np.full((20, 50, 1), np.inf)
        encoding = choose_encoding([data(depth), data(empty)])
        assert 6 <= encoding.low < 7
        assert choose_encoding([data(empty), data(empty)]).is_plain

    def test_one_value_is_no_range(self):
        assert choose_encoding([data(np.full((4, 4, 1), 7))] * 2).is_plain


class TestSigned:
    @pytest.mark.parametrize("word", ["normal", "vector"])
    def test_signs_survive(self, word):
        one = data(RNG.uniform(-0.3, 0.5, (9, 9, 3)), word)
        encoding = choose_encoding([one, one])
        assert (encoding.low, encoding.high) == (-1, 1)
        shown = encoding.encode(data([[[-1, 0, 1]]], word))
        assert shown.tolist() == [[[0, 128, 255]]]

    def test_motion_of_many_pixels_keeps_its_middle(self):
        one = data(RNG.uniform(-3, 9, (40, 50, 2)), "vector")
        encoding = choose_encoding([one, one])
        assert encoding.low == -encoding.high
        assert 8.5 < encoding.high < 9

    def test_normals_of_zero_to_one_are_mapped_already(self):
        one = data(RNG.random((9, 9, 3)), "normal")
        assert choose_encoding([one, one]).is_plain


class TestLabels:
    def test_equal_labels_have_equal_colours(self):
        source = data(RNG.integers(1, 4, (9, 9, 1)), "index")
        target = data(RNG.integers(2, 6, (7, 9, 1)), "index")
        encoding = choose_encoding([source, target])
        table = dict(encoding.labels)
        assert sorted(table) == [1, 2, 3, 4, 5]
        assert len(set(table.values())) == 5
        for picture in (source, target):
            shown = encoding.encode(picture)
            for y, x in np.ndindex(picture.pixels.shape[:2]):
                assert tuple(shown[y, x]) == table[picture.pixels[y, x, 0]]

    def test_the_order_of_the_pictures_is_no_matter(self):
        first, second = (data(np.full((2, 2, 1), label), "id") for label in (7, 3))
        assert choose_encoding([first, second]) == choose_encoding([second, first])

    def test_fractions_are_no_labels(self):
        assert choose_encoding([data(np.full((2, 2, 1), 1.5), "id")] * 2).kind == "data"

    def test_data_of_another_name_is_none(self):
        assert choose_encoding([data(np.full((2, 2, 1), 2), "depth")] * 2).kind == "data"

    def test_integers_of_32_bits_are_labels(self):
        one = Picture(np.uint32([[[1], [4_000_000_000]]]), None, False, "ID")
        encoding = choose_encoding([one, one])
        assert [label for label, _ in encoding.labels] == [1, 4_000_000_000]

    def test_an_unknown_label_is_refused(self):
        encoding = choose_encoding([data([[[1], [3]]], "id")] * 2)
        for unknown in (0, 2, 9):
            with pytest.raises(InputError, match=f"no colour for label {unknown} of Data"):
                encoding.encode(data([[[1], [unknown]]], "id"))

    def test_colours_are_no_labels(self):
        encoding = choose_encoding([data([[[1], [3]]], "id")] * 2)
        with pytest.raises(InputError, match="is for labels, and Combined has 3 channels"):
            encoding.encode(light(np.ones((2, 2, 3))))

    def test_too_many_are_refused(self):
        many = data(np.arange(5000).reshape(50, 100, 1), "id")
        with pytest.raises(InputError, match="cannot give 5000 labels a colour each"):
            choose_encoding([many, many])


@pytest.mark.parametrize(
    "encoding",
    [
        GuideEncoding("light", high=2.4000000953674316),
        GuideEncoding("data", -1.0, 1.0),
        GuideEncoding("labels", labels=((0, (0, 0, 0)), (4_000_000_000, (255, 255, 255)))),
    ],
)
def test_an_encoding_comes_back_from_json(encoding):
    assert GuideEncoding.from_dict(json.loads(json.dumps(encoding.to_dict()))) == encoding


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"kind": "light", "low": 0, "high": "bright", "labels": []},
        {"kind": "light", "low": 1, "high": 1, "labels": []},
        {"kind": "light", "low": 0, "high": float("inf"), "labels": []},
        {"kind": "data", "low": float("nan"), "high": 1, "labels": []},
        {"kind": "labels", "low": 0, "high": 1, "labels": [[2**80, [0, 0, 0]]]},
        {"kind": "labels", "low": 0, "high": 1, "labels": [[1, [0, 0, 256]]]},
        {"kind": "dark", "low": 0, "high": 1, "labels": []},
        {"kind": "labels", "low": 0, "high": 1, "labels": []},
        {"kind": "labels", "low": 0, "high": 1, "labels": [[2, [0, 0, 0]], [1, [9, 9, 9]]]},
    ],
)
def test_what_is_no_encoding_is_refused(values):
    with pytest.raises(InputError, match="guide_encoding"):
        GuideEncoding.from_dict(values)
