"""Images out, and in again."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import OpenImageIO as oiio
import pytest

from stylit_ref import InputError, read_image, read_uint8, write_image
from stylit_ref.files.disk.whole_file import whole_file
from stylit_ref.files.write_image import check_image_writable


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


@pytest.mark.parametrize("dtype", [np.float64, np.int32, bool])
def test_other_depths_are_not_written(tmp_path, image, dtype):
    with pytest.raises(InputError, match=f"a.png: the image has dtype {np.dtype(dtype)}"):
        write_image(tmp_path / "a.png", image.astype(dtype))
    assert not list(tmp_path.iterdir())


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


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("a_file/a.png", "a_file: is a file; name a folder"),
        ("a.xyz", "no image format has the suffix '.xyz'"),
        ("a", "suffix ''"),
        ("a.gif", "256 colours"),
        ("taken.png", "is a folder"),
    ],
)
def test_unwritable_outputs(tmp_path, image, name, message):
    (tmp_path / "taken.png").mkdir()
    (tmp_path / "a_file").touch()
    with pytest.raises(InputError, match=message):
        write_image(tmp_path / name, image)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a_file", "taken.png"]


def test_folders_are_made(tmp_path, image):
    file = tmp_path / "new" / "deep" / "a.png"
    check_image_writable(file, 1)
    assert not list(tmp_path.iterdir())
    write_image(file, image)
    assert read_image(file).shape[:2] == image.shape[:2]


def test_processes_write_into_one_new_folder(tmp_path):
    """None sees a folder of another one that is about to vanish."""
    for number in range(10):
        folder = tmp_path / f"{number}" / "deep"
        with ThreadPoolExecutor(8) as pool:
            files = [folder / f"{k}.png" for k in range(8)]
            list(pool.map(write_image, files, [np.zeros((2, 2, 3), np.uint8)] * 8))
        assert sorted(folder.iterdir()) == files


def test_a_folder_made_for_a_file_that_fails_is_removed(tmp_path):
    with pytest.raises(InputError, match="may need"), whole_file(tmp_path / "a" / "b", 1 << 60):
        pass
    assert not list(tmp_path.iterdir())


def test_jpeg_has_no_alpha(tmp_path, image):
    with pytest.raises(InputError, match="jpeg files cannot store the image's transparency"):
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
    monkeypatch.setattr(oiio.ImageOutput, "create", lambda path: Interrupted(create(path)))
    with pytest.raises(KeyboardInterrupt):
        write_image(file, 255 - image)
    assert file.read_bytes() == before
    assert list(tmp_path.iterdir()) == [file]


@pytest.fixture
def strokes():
    """Red dots of one pixel on blue, which coarser colours lose."""
    image = np.full((64, 80, 3), [20, 40, 200], np.uint8)
    image[::3, ::3] = [220, 20, 20]
    return image


@pytest.mark.parametrize("suffix", ["jpg", "jpeg", "JPG"])
def test_jpeg_keeps_thin_strokes(tmp_path, strokes, suffix):
    write_image(tmp_path / f"a.{suffix}", strokes)
    difference = np.abs(read_image(tmp_path / f"a.{suffix}").astype(int) - strokes)
    assert difference.mean() < 2
    assert difference.max() < 20


@pytest.mark.parametrize(
    ("suffix", "channels"),
    [("webp", 3), ("webp", 4), ("jp2", 3), ("j2c", 3), ("jxl", 3), ("jxl", 4)],
)
def test_formats_that_can_keep_every_value_do(tmp_path, strokes, suffix, channels):
    if channels == 4:
        strokes = np.dstack([strokes, np.full(strokes.shape[:2], 255, np.uint8)])
        strokes[10:20, 10:20] = 0
        strokes[30:40] = strokes[30:40] // 2
    write_image(tmp_path / f"a.{suffix}", strokes)
    np.testing.assert_array_equal(read_image(tmp_path / f"a.{suffix}"), strokes)


@pytest.mark.parametrize(
    ("suffix", "depth", "stored"),
    [
        ("png", "uint8", "uint8"),
        ("png", "uint16", "uint16"),
        ("jp2", "uint16", "uint16"),
        ("jxl", "uint16", "uint16"),
        ("jpg", "uint16", "uint8"),
        ("bmp", "uint16", "uint8"),
        ("exr", "float", "float"),
    ],
)
def test_the_depth_of_a_format_is_known_before_the_work(tmp_path, suffix, depth, stored):
    assert check_image_writable(tmp_path / f"a.{suffix}", 3, depth) == stored
    assert not list(tmp_path.iterdir())
