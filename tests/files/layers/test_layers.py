"""Layers by name, in files that OpenImageIO itself wrote."""

import re

import numpy as np
import OpenImageIO as oiio
import pytest
from exr_files import write_exr, write_named_parts, write_parts

from stylit_ref import InputError, read_image, read_uint8, write_image
from stylit_ref.files.disk import image_file
from stylit_ref.files.layers.channels import choose


def test_layers_are_found_by_name(tmp_path):
    """Channels are stored in alphabetical order, whatever order they were written in."""
    file = write_exr(
        tmp_path / "a.exr",
        {"LDE.R": 0.1, "LDE.G": 0.2, "LDE.B": 0.3, "B": 0.6, "G": 0.5, "R": 0.4, "Z": 9.0}
        | {"N.X": -1.0, "N.Y": 0.0, "N.Z": 1.0, "ID.Y": 0.25},
    )
    for layer, expected in (
        ("", [0.4, 0.5, 0.6]),
        (":LDE", [0.1, 0.2, 0.3]),
        (":N", [-1, 0, 1]),
        (":ID", [0.25]),
    ):
        np.testing.assert_allclose(read_image(f"{file}{layer}")[2, 3], expected, atol=1e-3)


@pytest.mark.parametrize(
    ("typed", "there"),
    [
        ("DiffDir", "ViewLayer.Diffuse Direct"),
        ("ViewLayer.DiffDir", "ViewLayer.Diffuse Direct"),
        ("diffuse direct", "View Layer.DiffDir"),
        ("Object Index", "RenderLayer.IndexOB"),
        ("object_index", "RenderLayer.IndexOB"),
        ("ObjectIndex", "ViewLayer.Object Index"),
        ("IndexOB.R", "ViewLayer.Object Index"),
        ("IndexMA", "ViewLayer.Material Index"),
        ("Emission", "ViewLayer.Emit"),
    ],
)
def test_blenders_short_and_long_names_are_the_same(tmp_path, typed, there):
    file = write_exr(tmp_path / "a.exr", {f"{there}.R": 0.25, "ViewLayer.Combined.R": 0.5})
    assert read_image(f"{file}:{typed}")[0, 0] == 0.25


def test_a_layers_own_name_goes_before_that_of_another_version(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"V.AO.R": 0.25, "V.Ambient Occlusion.R": 0.5})
    assert read_image(f"{file}:AO")[0, 0] == 0.25
    assert read_image(f"{file}:Ambient Occlusion")[0, 0] == 0.5


def test_layers_as_parts(tmp_path):
    file = write_parts(tmp_path / "a.exr", {"beauty": 0.25, "LDE": 0.5, "LSE": 0.75})
    assert read_image(f"{file}:LSE")[0, 0, 0] == 0.75
    assert read_image(f"{file}:beauty")[0, 0, 0] == 0.25
    assert read_image(file)[0, 0, 0] == 0.25


def test_the_only_layer_needs_no_name(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"V.R": 0.1, "V.G": 0.2, "V.B": 0.3})
    np.testing.assert_allclose(read_image(file)[0, 0], [0.1, 0.2, 0.3], atol=1e-3)


def test_a_colon_in_a_file_name(tmp_path, image):
    write_image(tmp_path / "a:b.png", image)
    np.testing.assert_array_equal(read_image(tmp_path / "a:b.png"), image)


def test_luminance_and_chroma_give_colours(tmp_path):
    """As OpenEXR defines them: RY = (R - Y) / Y, BY = (B - Y) / Y."""
    red, green, blue = 0.6, 0.3, 0.1
    y = 0.2126 * red + 0.7152 * green + 0.0722 * blue
    channels = {"BY": (blue - y) / y, "RY": (red - y) / y, "Y": y}
    opaque = write_exr(tmp_path / "a.exr", channels, depth="float")
    assert read_image(opaque)[0, 0] == pytest.approx([red, green, blue], 1e-5)
    clear = write_exr(tmp_path / "b.exr", channels | {"A": 0.5}, depth="float")
    assert read_image(clear)[0, 0] == pytest.approx([red, green, blue, 0.5], 1e-5)


def test_colours_go_by_what_their_channels_are_called(tmp_path):
    names = ["paint.red", "paint.GREEN", "paint.Blue", "paint.alpha", "paint.depth"]
    names += ["Key_R", "Key_G", "Key_B", "fillR", "fillG", "fillB", "AOR", "AOG", "AOB"]
    file = write_exr(tmp_path / "a.exr", {name: n / 16 for n, name in enumerate(names)})
    for layer, expected in (
        ("paint", [0, 1, 2, 3]),
        ("Key", [5, 6, 7]),
        ("fill", [8, 9, 10]),
        ("AO", [11, 12, 13]),
    ):
        np.testing.assert_array_equal(read_image(f"{file}:{layer}")[0, 0] * 16, expected)


def test_names_that_say_nothing_keep_the_order_of_the_file():
    assert choose(["ZINC", "IRON", "A", "GOLD", "LEAD"]) == ([0, 1, 3, 4, 2], False)


@pytest.mark.parametrize(
    ("channels", "value"),
    [
        (("N.X", "N.Y", "N.Z"), 64),
        (("UV.U", "UV.V"), 64),
        (("ViewLayer.Depth.Z",), 64),
        (("ViewLayer.Object Index.X",), 64),
        (("ViewLayer.Normal.R", "ViewLayer.Normal.G", "ViewLayer.Normal.B"), 64),
        (("ObjectID.R", "ObjectID.G", "ObjectID.B"), 64),
        (("Combined.A",), 64),
        (("Combined.R", "Combined.G", "Combined.B"), 137),
        (("AO.Y",), 137),
    ],
)
def test_light_goes_through_the_curve_and_data_does_not(tmp_path, channels, value):
    file = write_exr(tmp_path / "a.exr", dict.fromkeys(channels, 0.25))
    assert (read_uint8(file) == value).all()


class TestNames:
    @pytest.fixture
    def blender(self, tmp_path):
        channels = {
            f"ViewLayer.Combined.{c}": v for c, v in zip("RGBA", (4, 5, 6, 0.5), strict=True)
        }
        channels |= {f"ViewLayer.DiffDir.{c}": 7 for c in "RGB"} | {"Other.DiffDir.R": 8}
        return write_exr(tmp_path / "a.exr", channels | {"ViewLayer.Mask.A": 1})

    @pytest.mark.parametrize(
        ("name", "expected"),
        [
            ("ViewLayer.Combined", [4, 5, 6, 0.5]),
            ("Combined", [4, 5, 6, 0.5]),
            ("combined", [4, 5, 6, 0.5]),
            ("ViewLayer.Combined.A", [0.5]),
            ("Combined.G", [5]),
            ("Mask", [1]),
            ("Other.DiffDir", [8]),
        ],
    )
    def test_an_end_or_a_channel_will_do(self, blender, name, expected):
        np.testing.assert_array_equal(read_image(f"{blender}:{name}")[0, 0], expected)

    def test_an_end_that_fits_two_layers(self, blender):
        both = f"{blender}:Other.DiffDir, {blender}:ViewLayer.DiffDir"
        said = f"'DiffDir' fits several layers; write one of these: {both}"
        with pytest.raises(InputError, match=re.escape(said)):
            read_image(f"{blender}:DiffDir")

    def test_a_part_of_a_word_fits_nothing(self, blender):
        with pytest.raises(InputError, match="no layer 'Dir'"):
            read_image(f"{blender}:Dir")

    def test_the_picture_that_shows_everything_is_offered(self, blender):
        with pytest.raises(
            InputError, match=f"several layers; write {blender}:ViewLayer.Combined;"
        ):
            read_image(blender)

    def test_a_channel_beside_the_colours(self, tmp_path):
        file = write_exr(tmp_path / "a.exr", {"R": 1, "G": 1, "B": 1, "Z": 9, "matte": 0.5})
        assert read_image(f"{file}:Z")[0, 0] == [9]
        assert read_image(f"{file}:matte")[0, 0] == [0.5]

    def test_views_of_one_part(self, tmp_path):
        file = write_exr(
            tmp_path / "a.exr",
            {"R": 1, "left.R": 2, "AO.R": 3, "AO.left.R": 4},
            attributes={"multiView": ("string[2]", ("right", "left"))},
        )
        for name, value in (("right", 1), ("left", 2), ("AO", 3), ("AO.right", 3), ("AO.left", 4)):
            assert read_image(f"{file}:{name}")[0, 0] == [value]
        assert read_image(file)[0, 0] == [1]

    def test_views_as_parts(self, tmp_path):
        """The same names of channels in each, and none of them the file's first part alone."""
        file = write_named_parts(
            tmp_path / "a.exr",
            [
                ({"name": "rgba_right", "view": "right"}, {"R": 1}),
                ({"name": "ao_right", "view": "right"}, {"AO.R": 2}),
                ({"name": "rgba_left", "view": "left"}, {"R": 3}),
                ({"name": "ao_left", "view": "left"}, {"AO.R": 4}),
            ],
        )
        names = {
            "right": 1,
            "AO.right": 2,
            "ao_right.AO": 2,
            "left": 3,
            "rgba_left": 3,
            "AO.left": 4,
        }
        for name, value in names.items():
            assert read_image(f"{file}:{name}")[0, 0] == [value], name
        assert read_image(f"{file}:left.R")[0, 0] == [3]
        assert read_image(file)[0, 0] == [1]

    def test_parts_that_are_called_like_views(self, tmp_path):
        """Without a word in the header that they are views."""
        parts = {"rgba.left": "R", "rgba.right": "R", "AO.left": "AO.R", "AO.right": "AO.R"}
        file = write_named_parts(
            tmp_path / "a.exr",
            [({"name": name}, {channel: n}) for n, (name, channel) in enumerate(parts.items())],
        )
        for n, name in enumerate(parts):
            assert read_image(f"{file}:{name}")[0, 0] == [n], name
        assert read_image(f"{file}:AO")[0, 0] == [2]
        assert read_image(f"{file}:AO.right.R")[0, 0] == [3]


def test_only_data_without_a_name_is_not_the_image(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"A": 1, "LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match=r"has several layers; write .*:LDE; .* are: LDE, LSE"):
        read_image(file)


def test_missing_layer_lists_what_there_is(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match="no layer 'LDDE'; its layers are: LDE, LSE"):
        read_image(f"{file}:LDDE")


def test_chroma_at_a_lower_resolution_is_refused(tmp_path, monkeypatch):
    """OpenImageIO neither reads such files nor writes them."""
    file = write_exr(tmp_path / "a.exr", {"Y": 0.5})
    said = 'Subsampled channels are not supported (channel "BY" has sampling 2,2).'
    monkeypatch.setattr(oiio.ImageInput, "open", lambda *_: None)
    monkeypatch.setattr(oiio, "geterror", lambda: said)
    with pytest.raises(
        InputError, match="stores luminance, and colour at a lower resolution; open"
    ):
        read_image(file)


def test_only_the_channels_of_a_layer_are_read(tmp_path, monkeypatch):
    """What is counted against the largest image is what is read."""
    channels = {f"{layer}.{c}": 0.5 for layer in ("A", "B", "C") for c in "RGB"}
    file = write_exr(tmp_path / "a.exr", channels)
    monkeypatch.setattr(image_file, "LARGEST_IMAGE", 6 * 8 * 3)
    assert read_image(f"{file}:B").shape == (6, 8, 3)
    monkeypatch.setattr(image_file, "LARGEST_IMAGE", 6 * 8 * 3 - 1)
    with pytest.raises(InputError, match="declares 8x6 pixels with 3 channels"):
        read_image(f"{file}:B")


@pytest.mark.parametrize("names", [(0,), (3, 4, 5), (5, 4, 3), (0, 2, 3, 6), (6, 0, 3), range(7)])
def test_channels_come_in_the_order_wanted(tmp_path, names):
    file = write_exr(tmp_path / "a.exr", {f"c{n}": n for n in range(7)})
    pixels = image_file.read_pixels(oiio.ImageInput.open(str(file)), 0, names, "float")
    np.testing.assert_array_equal(pixels, np.broadcast_to(names, (6, 8, len(names))))
