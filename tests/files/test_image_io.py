"""Files in and out, written and read by OpenImageIO itself."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import OpenImageIO as oiio
import pytest
from exr_files import write_exr, write_parts

from stylit_ref import InputError, read_image, read_uint8, to_uint8, write_image
from stylit_ref.files.bit_depth import to_linear
from stylit_ref.files.image_io import check_image_writable, read_guides


@pytest.fixture
def image():
    return np.random.default_rng(0).integers(0, 256, (6, 8, 3), dtype=np.uint8)


@pytest.mark.parametrize("suffix", ["png", "tif", "exr"])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_eight_bits_come_back(tmp_path, suffix, channels):
    rng = np.random.default_rng(0)
    image = rng.integers(0, 256, (6, 8, channels), dtype=np.uint8)
    if channels in (2, 4):  # premultiplied, with whole transparency or none: PNG rounds others
        image[..., -1:] = 255 * (rng.random((6, 8, 1)) < 0.5)
        image[..., :-1] *= image[..., -1:] // 255
    write_image(tmp_path / f"a.{suffix}", image)
    np.testing.assert_array_equal(read_uint8(tmp_path / f"a.{suffix}"), image)


def test_threads_write_into_one_folder(tmp_path):
    def write(value):
        write_image(tmp_path / f"{value}.png", np.full((40, 50, 3), value, np.uint8))

    with ThreadPoolExecutor(8) as threads:
        list(threads.map(write, range(80)))
    assert len(list(tmp_path.iterdir())) == 80
    for value in range(80):
        assert (read_image(tmp_path / f"{value}.png") == value).all()


@pytest.mark.parametrize("suffix", ["png", "tif"])
def test_sixteen_bits_come_back(tmp_path, suffix):
    image = np.random.default_rng(0).integers(0, 65536, (6, 8, 3), dtype=np.uint16)
    write_image(tmp_path / f"a.{suffix}", image)
    again = read_image(tmp_path / f"a.{suffix}")
    assert again.dtype == np.uint16
    np.testing.assert_array_equal(again, image)
    expected = np.floor(image / 257 + 0.5)
    np.testing.assert_array_equal(read_uint8(tmp_path / f"a.{suffix}"), expected)


def test_float_comes_back(tmp_path):
    image = np.random.default_rng(0).uniform(-1, 9, (6, 8, 3)).astype(np.float32)
    write_image(tmp_path / "a.exr", image)
    np.testing.assert_array_equal(read_image(tmp_path / "a.exr"), image)


def test_two_dimensional_and_strided_images(tmp_path, image):
    write_image(tmp_path / "a.png", image[:, ::2, 1])
    np.testing.assert_array_equal(read_image(tmp_path / "a.png")[:, :, 0], image[:, ::2, 1])


def test_float_is_scene_linear():
    linear = np.array([-1, 0, 0.0031308, 0.18, 0.5, 1, 7], np.float32)
    np.testing.assert_array_equal(to_uint8(linear), [0, 0, 10, 118, 188, 255, 255])


def test_linear_and_display_are_inverse():
    every = np.arange(256, dtype=np.uint8)
    np.testing.assert_array_equal(to_uint8(to_linear(every)), every)


def test_alpha_stays_linear(tmp_path):
    write_exr(tmp_path / "a.exr", {"R": 0.5, "G": 0.5, "B": 0.5, "A": 0.5})
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.exr")[0, 0], [188, 188, 188, 128])


def test_opaque_alpha_is_dropped(tmp_path, image):
    write_image(tmp_path / "a.png", np.dstack([image, np.full((6, 8), 255, np.uint8)]))
    np.testing.assert_array_equal(read_uint8(tmp_path / "a.png"), image)


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


def test_layers_as_parts(tmp_path):
    file = write_parts(tmp_path / "a.exr", {"beauty": 0.25, "LDE": 0.5, "LSE": 0.75})
    assert read_image(f"{file}:LSE")[0, 0, 0] == 0.75
    assert read_image(f"{file}:beauty")[0, 0, 0] == 0.25
    assert read_image(file)[0, 0, 0] == 0.25


def test_the_only_layer_needs_no_name(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"V.R": 0.1, "V.G": 0.2, "V.B": 0.3})
    np.testing.assert_allclose(read_image(file)[0, 0], [0.1, 0.2, 0.3], atol=1e-3)


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


def test_a_colon_in_a_file_name(tmp_path, image):
    write_image(tmp_path / "a:b.png", image)
    np.testing.assert_array_equal(read_image(tmp_path / "a:b.png"), image)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_not_finite(tmp_path, value):
    plane = np.zeros((6, 8), np.float32)
    plane[2, 5] = value
    file = write_exr(tmp_path / "a.exr", {"R": plane, "G": 0, "B": 0})
    with pytest.raises(InputError, match=r"a.exr: 1 pixels are NaN or infinite.*\(2, 5\)"):
        read_uint8(file)


@pytest.mark.parametrize("dtype", [np.float64, np.int32, bool])
def test_other_depths_are_not_written(tmp_path, image, dtype):
    with pytest.raises(InputError, match=f"a.png: the image has dtype {np.dtype(dtype)}"):
        write_image(tmp_path / "a.png", image.astype(dtype))
    assert not list(tmp_path.iterdir())


def test_integer_layers_are_refused(tmp_path):
    spec = oiio.ImageSpec(8, 6, 1, "uint")
    spec.channelnames = ("ID.Y",)
    output = oiio.ImageOutput.create(str(tmp_path / "a.exr"))
    output.open(str(tmp_path / "a.exr"), spec)
    output.write_image(np.full((6, 8, 1), 3, np.uint32))
    output.close()
    with pytest.raises(InputError, match="holds uint"):
        read_image(tmp_path / "a.exr")


def test_clipping_is_said(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"N.X": -1.0, "N.Y": 0.5, "N.Z": 0.5})
    with pytest.warns(UserWarning, match="33% of the values lie outside"):
        read_uint8(file)


def test_luminance_and_chroma_give_the_luminance(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"BY": 0.1, "RY": 0.2, "Y": 0.5})
    np.testing.assert_array_equal(read_image(file)[0, 0], [0.5])


def test_alpha_alone_is_not_the_image(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"A": 1, "LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match="no unnamed layer"):
        read_image(file)


def test_a_link_stays_a_link(tmp_path, image):
    write_image(tmp_path / "real.png", image)
    (tmp_path / "link.png").symlink_to(tmp_path / "real.png")
    write_image(tmp_path / "link.png", 255 - image)
    assert (tmp_path / "link.png").is_symlink()
    np.testing.assert_array_equal(read_image(tmp_path / "real.png"), 255 - image)


def test_a_format_that_cannot_hold_the_image_is_refused_early(tmp_path, image):
    with pytest.raises(InputError, match=r"a\.hdr: cannot be written"):
        check_image_writable(tmp_path / "a.hdr", 1)
    check_image_writable(tmp_path / "a.png", 1)
    assert not list(tmp_path.iterdir())


class TestGuides:
    def read(self, tmp_path, source, target):
        write_image(tmp_path / "s.png", source)
        write_image(tmp_path / "t.png", target)
        return read_guides(tmp_path / "s.png", tmp_path / "t.png")

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


def test_missing_layer_lists_what_there_is(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match="no layer 'LDDE'; its named layers are: LDE, LSE"):
        read_image(f"{file}:LDDE")
    with pytest.raises(InputError, match="no unnamed layer; its named layers are: LDE, LSE"):
        read_image(file)


def test_unreadable_inputs(tmp_path):
    (tmp_path / "text.png").write_text("no image")
    for path, message in (
        (tmp_path / "none.png", "none.png: no such file"),
        (f"{tmp_path / 'none.exr'}:LDE", "none.exr: no such file"),
        (tmp_path, "is a folder"),
        (tmp_path / "text.png", "text.png: cannot be read"),
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
    ("name", "message"),
    [
        ("none/a.png", "folder .*none does not exist"),
        ("a.xyz", "no image format is known by the suffix '.xyz'"),
        ("a", "suffix ''"),
        ("a.gif", "256 colours"),
        ("taken.png", "is a folder"),
    ],
)
def test_unwritable_outputs(tmp_path, image, name, message):
    (tmp_path / "taken.png").mkdir()
    with pytest.raises(InputError, match=message):
        write_image(tmp_path / name, image)
    assert [file.name for file in tmp_path.iterdir()] == ["taken.png"]


def test_jpeg_has_no_alpha(tmp_path, image):
    with pytest.raises(InputError, match="jpeg files have no transparency"):
        write_image(tmp_path / "a.jpg", np.dstack([image, image[:, :, 0]]))


def test_an_interrupted_write_leaves_the_old_file(tmp_path, image, monkeypatch):
    file = tmp_path / "a.png"
    write_image(file, image)
    before = file.read_bytes()

    class Interrupted:
        def __init__(self, output):
            self.output = output

        def __getattr__(self, name):
            return getattr(self.output, name)

        def write_image(self, pixels):
            raise KeyboardInterrupt

    create = oiio.ImageOutput.create
    monkeypatch.setattr(
        "stylit_ref.files.image_io.oiio.ImageOutput.create", lambda path: Interrupted(create(path))
    )
    with pytest.raises(KeyboardInterrupt):
        write_image(file, 255 - image)
    assert file.read_bytes() == before
    assert list(tmp_path.iterdir()) == [file]
