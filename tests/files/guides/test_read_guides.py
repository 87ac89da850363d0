"""Guides of a run: channels that agree, one encoding for all sides, and notes."""

import logging

import numpy as np
import OpenImageIO as oiio
import pytest
from exr_files import write_exr

from stylit_ref import GuideEncoding, InputError, read_guides, read_uint8, write_image
from stylit_ref.files.layers.cryptomatte import id_of

RAMP = np.linspace(0, 1, 48).reshape(6, 8)
WAVES = np.random.default_rng(0).random((6, 8))


@pytest.fixture
def said(caplog):
    """The notes, without the folder of the test's files."""
    caplog.set_level(logging.INFO)
    return lambda folder: [
        record.getMessage().replace(f"{folder}/", "") for record in caplog.records
    ]


def pair(folder, source, target, layer=""):
    """A guide of two EXR files, with that layer's channels or a whole dict of them."""
    paths = []
    for name, channels in (("s.exr", source), ("t.exr", target)):
        write_exr(folder / name, channels, depth="float")
        paths.append(f"{folder / name}:{layer}" if layer else folder / name)
    return paths


class TestChannels:
    def read(self, tmp_path, source, target):
        write_image(tmp_path / "s.png", source)
        write_image(tmp_path / "t.png", target)
        guides = read_guides([(tmp_path / "s.png", tmp_path / "t.png")])
        return guides.source[0], guides.targets[0][0]

    def test_alpha_is_kept_in_both_if_one_is_transparent(self, tmp_path, image):
        alpha = np.tile([0, 255], (6, 4)).astype(np.uint8)
        rgba = np.dstack([image * (alpha > 0)[..., None], alpha])
        source, target = self.read(tmp_path, image, rgba)
        np.testing.assert_array_equal(source, np.dstack([image, np.full((6, 8), 255)]))
        np.testing.assert_array_equal(target, rgba)

    def test_opaque_alpha_is_dropped_from_both(self, tmp_path, image):
        rgba = np.dstack([image, np.full((6, 8), 255, np.uint8)])
        source, target = self.read(tmp_path, rgba, image)
        np.testing.assert_array_equal(source, image)
        np.testing.assert_array_equal(target, image)

    def test_grey_is_spread_beside_colour(self, tmp_path, image):
        source, target = self.read(tmp_path, image[:, :, 0], image)
        np.testing.assert_array_equal(source, image[:, :, :1].repeat(3, axis=2))
        np.testing.assert_array_equal(target, image)


def test_one_source_has_several_targets(tmp_path):
    files = [
        write_exr(tmp_path / f"{k}.exr", {"Z": RAMP * (k + 1)}, depth="float") for k in range(3)
    ]
    guides = read_guides([files])
    assert 2.9 < guides.encodings[0].high <= 3
    assert [target[0].max() for target in guides.targets] == [170, 255]
    assert guides.source[0].max() == 85


def test_encodings_of_an_earlier_call_are_kept(tmp_path):
    files = pair(tmp_path, {"Z": RAMP * 4}, {"Z": RAMP * 2})
    first = read_guides([files])
    write_exr(tmp_path / "t.exr", {"Z": RAMP}, depth="float")
    again = read_guides([files], first.encodings)
    assert again.encodings == first.encodings
    np.testing.assert_array_equal(again.source[0], first.source[0])
    assert again.targets[0][0].max() < 70


def test_blenders_empty_depth_in_half_floats(tmp_path):
    depth = np.where(WAVES > 0.5, 1e10, 5 + RAMP)
    for name in ("s.exr", "t.exr"):
        write_exr(tmp_path / name, {"V.Depth.Z": depth, "V.Combined.R": 0.5})
    paths = [f"{tmp_path / name}:Depth" for name in ("s.exr", "t.exr")]
    guides = read_guides([paths])
    assert guides.encodings[0].high < 7
    assert (guides.source[0][WAVES > 0.5] == 255).all()


@pytest.mark.parametrize("value", [np.nan, -np.inf])
def test_what_is_no_depth_is_refused(tmp_path, value):
    files = pair(tmp_path, {"Z": RAMP}, {"Z": value})
    with pytest.raises(InputError, match="48 pixels are NaN or infinite"):
        read_guides([files])


def test_infinite_light_is_refused(tmp_path):
    files = pair(tmp_path, {"R": RAMP}, {"R": np.inf})
    with pytest.raises(InputError, match="NaN or infinite"):
        read_guides([files])


@pytest.mark.parametrize(
    ("channel", "kind"),
    [
        ("ViewLayer.IndexOB.X", "labels"),
        ("ViewLayer.Object Index.X", "labels"),
        ("material_id.Y", "labels"),
        ("objectId", "labels"),
        ("ViewLayer.Depth.Z", "data"),
        ("ViewLayer.Combined.R", "light"),
    ],
)
def test_whole_numbers_are_labels_where_the_name_says_so(tmp_path, channel, kind):
    whole = np.floor(RAMP * 3.9)
    guides = read_guides([pair(tmp_path, {channel: whole}, {channel: whole})])
    assert guides.encodings[0].kind == kind


def test_an_index_of_integers_is_labels(tmp_path):
    for name in ("s.exr", "t.exr"):
        spec = oiio.ImageSpec(8, 6, 1, "uint")
        spec.channelnames = ("ID.X",)
        output = oiio.ImageOutput.create(str(tmp_path / name))
        output.open(str(tmp_path / name), spec)
        output.write_image((WAVES > 0.5).astype(np.uint32)[:, :, None] + 70000)
        output.close()
    guides = read_guides([(tmp_path / "s.exr", tmp_path / "t.exr")])
    assert [label for label, _ in guides.encodings[0].labels] == [70000, 70001]


class TestCryptomatte:
    """A pixel belongs to what covers most of it."""

    def write(self, path, *objects):
        """Objects and what they cover of each pixel, the most first."""
        channels = {"V.Combined.R": 0.5}
        for rank, (name, covered) in enumerate(objects):
            id_, share = ("rg", "ba")[rank % 2]
            ids = np.where(covered > 0, np.uint32(id_of(name)).view(np.float32), 0)
            channels[f"V.CryptoObject{rank // 2:02}.{id_}"] = ids
            channels[f"V.CryptoObject{rank // 2:02}.{share}"] = covered
        return write_exr(path, channels, depth="float")

    def test_the_largest_coverage_wins(self, tmp_path):
        left = np.where(RAMP < 0.5, 0.7, 0.4)
        paths = [
            f"{self.write(tmp_path / name, ('box', left), ('ball', 1 - left))}:CryptoObject"
            for name in ("s.exr", "t.exr")
        ]
        guides = read_guides([paths])
        table = dict(guides.encodings[0].labels)
        assert sorted(table) == sorted([id_of("box"), id_of("ball")])
        for y, x in np.ndindex(6, 8):
            name = "box" if RAMP[y, x] < 0.5 else "ball"
            assert tuple(guides.source[0][y, x]) == table[id_of(name)]

    def test_what_nothing_covers_is_a_label_too(self, tmp_path):
        covered = np.where(RAMP < 0.5, 0.6, 0.3)
        paths = [
            f"{self.write(tmp_path / name, ('box', covered))}:V.CryptoObject00"
            for name in ("s.exr", "t.exr")
        ]
        guides = read_guides([paths])
        table = dict(guides.encodings[0].labels)
        assert sorted(table) == [0, id_of("box")]
        assert tuple(guides.source[0][-1, -1]) == table[0]
        assert tuple(guides.source[0][0, 0]) == table[id_of("box")]

    def test_without_encoding_it_is_refused(self, tmp_path):
        path = f"{self.write(tmp_path / 's.exr', ('box', RAMP))}:CryptoObject"
        with pytest.raises(InputError, match="CryptoObject, which holds labels"):
            read_guides([(path, path)], "none")


class TestNotes:
    def test_one_note_tells_all_encodings(self, tmp_path, said):
        channels = {
            "Combined.R": RAMP * 4,
            "Depth.Z": RAMP * 9 + 1,
            "Object Index.X": np.floor(RAMP * 2.9),
        }
        layers = "Combined", "Depth", "Object Index"
        files = [pair(tmp_path, channels, channels, layer) for layer in layers]
        read_guides(files)
        assert said(tmp_path) == [
            "guide_encoding makes 8 bits of floating point, in source and target alike: Combined "
            "at 0.25 of its brightness, Depth from 1 to 10, Object Index as 3 labels with a colour "
            "each; with none, values outside [0, 1] would be clipped"
        ]

    def test_integers_are_no_news(self, tmp_path, image, said):
        write_image(tmp_path / "a.png", image)
        read_guides([(tmp_path / "a.png", tmp_path / "a.png")])
        assert said(tmp_path) == []

    def test_without_encoding_what_is_clipped_is_told_once(self, tmp_path, said):
        files = [
            pair(tmp_path, {"A.R": RAMP * 2, "B.R": RAMP}, {"A.R": RAMP * 4, "B.R": RAMP}, layer)
            for layer in "AB"
        ]
        guides = read_guides(files, "none")
        assert guides.encodings == (GuideEncoding("light"),) * 2
        np.testing.assert_array_equal(guides.source[1], read_uint8(files[1][0]))
        assert said(tmp_path) == [
            "50% of s.exr:A, 75% of t.exr:A: these values are too dark or too bright for 8 bits "
            "and are clipped"
        ]

    def test_labels_of_one_side_alone(self, tmp_path, said):
        few, more = np.floor(RAMP * 1.9) + 1, np.floor(RAMP * 2.9) + 2
        read_guides([pair(tmp_path, {"id.X": few}, {"id.X": more}, "id")])
        assert said(tmp_path)[1:] == [
            "of the labels of id only the source has 1 and only the target has 3, 4: give what "
            "corresponds the same index or name in both scenes"
        ]

    def test_of_many_the_first_are_named(self, tmp_path, said):
        layers = [f"L{k:02}" for k in range(10)]
        channels = {f"{layer}.R": RAMP * 4 for layer in layers}
        read_guides([pair(tmp_path, channels, channels, layer) for layer in layers])
        (note,) = said(tmp_path)
        assert "L07 at 0.25 of its brightness and 2 more; with none" in note

    def test_transparent_on_one_side(self, tmp_path, image, said):
        alpha = np.tile([0, 255], (6, 4)).astype(np.uint8)
        write_image(tmp_path / "s.png", image)
        write_image(tmp_path / "t.png", np.dstack([image * (alpha > 0)[..., None], alpha]))
        read_guides([(tmp_path / "s.png", tmp_path / "t.png")])
        assert said(tmp_path) == [
            "t.png is transparent in parts and s.png nowhere: they can hardly correspond; render "
            "both with a transparent background or both without"
        ]

    @pytest.mark.parametrize("channels", [1, 3])
    def test_grey_on_one_side(self, tmp_path, image, said, channels):
        write_image(tmp_path / "s.png", image)
        write_image(tmp_path / "t.png", image[:, :, :1].repeat(channels, axis=2))
        read_guides([(tmp_path / "s.png", tmp_path / "t.png")])
        assert said(tmp_path) == [
            "s.png has colours and t.png is grey: values that are grey on one side alone can "
            "hardly correspond"
        ]

    def test_one_value_all_over(self, tmp_path, image, said):
        write_image(tmp_path / "s.png", image[:, :, 0])
        write_image(tmp_path / "t.png", np.full((6, 8), 9, np.uint8))
        read_guides([(tmp_path / "s.png", tmp_path / "t.png")])
        assert said(tmp_path) == ["t.png has one value all over: such a guide guides nothing"]

    def test_all_that_differs_is_clipped_away(self, tmp_path, said):
        files = pair(tmp_path, {"Z": RAMP}, {"Z": RAMP + 2})
        read_guides([files], "none")
        assert said(tmp_path) == [
            "t.exr has one value all over (2 to 3 are clipped, or one step of 256): such a guide "
            "guides nothing"
        ]


@pytest.mark.parametrize(
    ("files", "encoding", "message"),
    [
        ("a.exr", "auto", "files must hold, for each guide"),
        (["a.exr", "b.exr"], "auto", "files must hold, for each guide"),
        ([], "auto", "files holds guides of no files"),
        ([["a.exr"]], "auto", "files holds guides of 1 files"),
        ([["a", "b"], ["a", "b", "c"]], "auto", "files holds guides of 2, 3 files"),
        ([["a", "b"]], "some", "guide_encoding is 'some'; it must be 'auto', 'none'"),
        ([["a", "b"]], (), "guide_encoding holds 0 encodings for 1 guides"),
    ],
)
def test_what_fits_not_together_is_refused(files, encoding, message):
    with pytest.raises(InputError, match=message):
        read_guides(files, encoding)
