"""Images in, from files that OpenImageIO itself wrote."""

import logging
import struct

import numpy as np
import OpenImageIO as oiio
import pytest
import tifffile
from exr_files import write_exr

from stylit_ref import InputError, read_guides, read_image, read_uint8, write_image
from stylit_ref.files.read_image import read_mask


def test_half_transparent_white_stays_white(tmp_path):
    write_exr(tmp_path / "a.exr", {"R": 0.5, "G": 0.5, "B": 0.5, "A": 0.5})
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.exr")[0, 0], [128, 128, 128, 128])


def test_soft_edges_are_the_same_in_png_and_exr(tmp_path):
    """Straight colours 200, 100, 50 with alpha 128, as each of the two stores them."""
    png = np.broadcast_to(np.uint8([100, 50, 25, 128]), (6, 8, 4))
    write_image(tmp_path / "a.png", png)
    write_exr(tmp_path / "a.exr", {"R": 0.2899, "G": 0.0640, "B": 0.0160, "A": 0.502})
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.png"), png)
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.exr"), png)
    write_image(tmp_path / "b.exr", png)
    assert read_image(tmp_path / "b.exr")[0, 0] == pytest.approx(
        [0.2899, 0.064, 0.016, 0.502], 0.01
    )


class TestAlphaThatIsZeroEverywhere:
    """It is left out, and the colours are those beside it in the file."""

    def check(self, path, colours, caplog):
        image = read_image(path)
        assert image.shape == (6, 8, 3)
        np.testing.assert_array_equal(image, np.broadcast_to(colours, image.shape))
        said = f"{path}: is transparent everywhere; its alpha is left out"
        assert caplog.record_tuples == [("stylit_ref", logging.WARNING, said)]

    @pytest.mark.parametrize("suffix", ["png", "tif", "tga"])
    def test_straight_colours(self, tmp_path, caplog, suffix):
        spec = oiio.ImageSpec(8, 6, 4, "uint8")
        spec.attribute("oiio:UnassociatedAlpha", 1)
        output = oiio.ImageOutput.create(str(tmp_path / f"a.{suffix}"))
        assert output.open(str(tmp_path / f"a.{suffix}"), spec)
        assert output.write_image(np.broadcast_to(np.uint8([200, 100, 50, 0]), (6, 8, 4)).copy())
        output.close()
        self.check(tmp_path / f"a.{suffix}", (200, 100, 50), caplog)

    def test_premultiplied_colours(self, tmp_path, caplog):
        file = write_exr(tmp_path / "a.exr", {"R": 0.5, "G": 0.25, "B": 0.125, "A": 0})
        self.check(file, (0.5, 0.25, 0.125), caplog)

    @pytest.mark.parametrize(
        ("name", "layout", "header"),
        [
            ("a.bmp", "<2s4I2i2H2I2i2I", (b"BM", 246, 0, 54, 40, 8, 6, 1, 32, *[0] * 6)),
            ("a.tga", "<3B2HB4H2B", (0, 0, 2, 0, 0, 0, 0, 0, 8, 6, 32, 0)),
        ],
    )
    def test_a_fourth_byte_that_is_no_alpha(self, tmp_path, caplog, name, layout, header):
        (tmp_path / name).write_bytes(struct.pack(layout, *header) + bytes([50, 100, 200, 0]) * 48)
        self.check(tmp_path / name, (200, 100, 50), caplog)


class TestMask:
    @pytest.mark.parametrize(
        ("image", "white"),
        [
            (np.uint8([127]), False),
            (np.uint8([128]), True),
            (np.uint8([127, 128, 128]), False),
            (np.uint8([90, 90, 90, 200]), False),
            (np.uint8([128, 128, 128, 200]), True),
            (np.uint8([1, 254]), False),
            (np.uint8([200, 201]), True),
            (np.uint16([32767]), False),
            (np.uint16([32768]), True),
            (np.uint16([100, 60000]), False),
        ],
    )
    def test_half_the_range_is_white_and_alpha_is_no_colour(self, tmp_path, image, white):
        pixels = np.broadcast_to(image, (6, 8, image.size)).copy()
        if image.size in (2, 4):  # an alpha that is opaque everywhere would be dropped
            pixels[0, 0] = np.iinfo(image.dtype).max
        write_image(tmp_path / "a.png", pixels)
        mask = read_mask(tmp_path / "a.png")
        assert mask.dtype == bool
        assert mask.shape == (6, 8)
        assert (mask[1:] == white).all()

    @pytest.mark.parametrize(("value", "white"), [(0.4998, False), (0.5, True), (7, True)])
    def test_floating_point_has_no_curve(self, tmp_path, value, white):
        file = write_exr(tmp_path / "a.exr", {"Y": value})
        assert (read_mask(file) == white).all()

    def test_what_is_transparent_shows_as_black(self, tmp_path):
        file = write_exr(tmp_path / "a.exr", {"R": 0.25, "G": 0.25, "B": 0.25, "A": 0.25})
        assert not read_mask(file).any()


def test_opaque_alpha_is_dropped(tmp_path, image):
    write_image(tmp_path / "a.png", np.dstack([image, np.full((6, 8), 255, np.uint8)]))
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.png"), image)


def test_display_window_is_what_is_read(tmp_path):
    """A crop in the file lies where it belongs, with zeros around it."""
    file = write_exr(tmp_path / "a.exr", {"R": 1, "G": 1, "B": 1}, data_window=(2, 1, 12, 10))
    image = read_image(file)
    assert image.shape == (10, 12, 3)
    expected = np.zeros((10, 12))
    expected[1:7, 2:10] = 1
    np.testing.assert_array_equal(image[:, :, 0], expected)


@pytest.mark.parametrize("place", [(0, 0), (2, 1), (-3, -1), (4, -2), (9, 9)])
@pytest.mark.parametrize("orientation", range(9))
def test_images_are_upright_in_their_display_window(tmp_path, orientation, place):
    """As by OpenImageIO's own operations."""
    spec = oiio.ImageSpec(6, 4, 3, "float")
    spec.full_width, spec.full_height = 7, 5
    spec.x, spec.y = place
    spec.attribute("Orientation", orientation)
    image = oiio.ImageBuf(spec)
    image.set_pixels(image.roi, np.random.default_rng(0).random((4, 6, 3), np.float32))
    image.write(str(tmp_path / "a.exr"))
    expected = oiio.ImageBufAlgo.crop(image, roi=image.roi_full)
    if orientation:  # 0 is what some files have that do not know
        expected = oiio.ImageBufAlgo.reorient(expected)
    np.testing.assert_array_equal(read_image(tmp_path / "a.exr"), expected.get_pixels("float"))


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_not_finite(tmp_path, value):
    plane = np.zeros((6, 8), np.float32)
    plane[2, 5] = value
    file = write_exr(tmp_path / "a.exr", {"R": plane, "G": 0, "B": 0})
    with pytest.raises(InputError, match=r"a.exr: 1 pixels are NaN or infinite.*\(2, 5\)"):
        read_uint8(file)


@pytest.mark.parametrize("channel", ["ID.Y", "Y", "rank"])
def test_whole_numbers_are_labels_and_no_picture(tmp_path, channel):
    """Those of 32 bits, exactly; floats would make one of the last two."""
    numbers = np.uint32([3, 16777216, 16777217])
    spec = oiio.ImageSpec(3, 1, 1, "uint")
    spec.channelnames = (channel,)
    output = oiio.ImageOutput.create(str(tmp_path / "a.exr"))
    output.open(str(tmp_path / "a.exr"), spec)
    output.write_image(numbers.reshape(1, 3, 1))
    output.close()
    with pytest.raises(InputError, match="holds whole numbers of 32 bits, which can be labels"):
        read_image(tmp_path / "a.exr")
    (encoding,) = read_guides([[tmp_path / "a.exr"] * 2]).encodings
    assert [label for label, _ in encoding.labels] == numbers.tolist()


@pytest.mark.parametrize("depth", ["uint", "int16"])
def test_other_types_of_values_are_refused(tmp_path, depth):
    image = oiio.ImageBuf(oiio.ImageSpec(8, 6, 3, depth))
    assert image.write(str(tmp_path / "a.tif"))
    with pytest.raises(InputError, match=f"holds {depth} values; save it with 8-bit or 16-bit"):
        read_image(tmp_path / "a.tif")


def test_inks_are_refused(tmp_path):
    """CMYK alone becomes RGB; with an alpha it has five inks."""
    tifffile.imwrite(
        tmp_path / "a.tif",
        np.zeros((6, 8, 5), np.uint8),
        photometric="separated",
        extrasamples=["unassalpha"],
    )
    with pytest.raises(InputError, match="holds inks for printing; save it with R, G and B"):
        read_image(tmp_path / "a.tif")


def test_alpha_is_not_clipped(tmp_path, caplog):
    write_exr(tmp_path / "a.exr", {"R": 0.5, "A": np.linspace(0, 9, 8)})
    read_uint8(tmp_path / "a.exr")
    assert not caplog.records


def test_clipping_is_said(tmp_path, caplog):
    file = write_exr(tmp_path / "a.exr", {"N.X": -1.0, "N.Y": 0.5, "N.Z": 0.5})
    read_uint8(file)
    said = f"{file}: 33% of the values lie outside [0, 1] and are clipped"
    assert caplog.record_tuples == [("stylit_ref", logging.WARNING, said)]


def test_unreadable_inputs(tmp_path):
    (tmp_path / "text.png").write_text("no image")
    (tmp_path / "text.heic").write_text("no image")
    for path, message in (
        (tmp_path / "none.png", "none.png: no such file"),
        (f"{tmp_path / 'none.exr'}:LDE", "none.exr: no such file"),
        (tmp_path, "is a folder"),
        (tmp_path / "text.png", "text.png: cannot be read"),
        (tmp_path / "text.heic", "is no image of a kind that can be read; save it as .png"),
    ):
        with pytest.raises(InputError, match=message):
            read_image(path)


def test_truncated_file(tmp_path, image):
    write_image(tmp_path / "a.png", image)
    whole = (tmp_path / "a.png").read_bytes()
    (tmp_path / "a.png").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(InputError, match="cannot be read"):
        read_image(tmp_path / "a.png")


@pytest.mark.parametrize(
    ("rows", "level", "share"),
    [(0, None, ""), (1, logging.INFO, "1%"), (8, logging.WARNING, "8%")],
)
def test_what_is_clipped_is_noted(tmp_path, caplog, rows, level, share):
    caplog.set_level(logging.INFO, logger="stylit_ref")
    red = np.full((100, 8), 0.5)
    red[:rows] = 1.5
    red[rows:50] = 1.005  # rounds to white
    file = write_exr(tmp_path / "a.exr", {"R": red}, size=(100, 8))
    read_uint8(file)
    said = f"{file}: {share} of the values lie outside [0, 1] and are clipped"
    assert caplog.record_tuples == ([("stylit_ref", level, said)] if rows else [])


def test_little_that_is_clipped(tmp_path, caplog):
    caplog.set_level(logging.INFO, logger="stylit_ref")
    red = np.zeros((100, 8))
    red[0, 0] = -1
    read_uint8(write_exr(tmp_path / "a.exr", {"R": red}, size=(100, 8)))
    assert "less than 1% of the values" in caplog.text
