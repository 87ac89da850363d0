"""What is told of a file that shows less, or something else, than it holds."""

import logging

import numpy as np
import OpenImageIO as oiio
import pytest
from exr_files import write_exr, write_named_parts, write_parts
from PIL import Image

from stylit_ref import read_image, write_image

REC2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
REC709 = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)


@pytest.fixture(autouse=True)
def every_note(caplog):
    caplog.set_level(logging.INFO, logger="stylit_ref")


def told(caplog):
    return [(record.levelno, record.getMessage()) for record in caplog.records]


def shifted(path, window):
    return write_exr(path, {"R": 0.5, "G": 0.5, "B": 0.5}, data_window=window)


@pytest.mark.parametrize(
    "window", [(12, 0, 12, 10), (0, 10, 12, 10), (-8, 0, 12, 10), (0, -6, 12, 10)]
)
def test_a_data_window_outside_the_display_window(tmp_path, caplog, window):
    file = shifted(tmp_path / "a.exr", window)
    assert not read_image(file).any()
    said = (
        f"{file}: its data window lies outside its display window, so nothing of it is seen; "
        f"make its display window the data window: oiiotool {file} --fullpixels -o whole.exr"
    )
    assert told(caplog) == [(logging.WARNING, said)]


def test_the_remedy_for_a_data_window_outside(tmp_path, caplog):
    image = oiio.ImageBuf(str(shifted(tmp_path / "a.exr", (20, 20, 12, 10))))
    image.roi_full = image.roi  # what --fullpixels does
    assert image.write(str(tmp_path / "whole.exr"))
    whole = read_image(tmp_path / "whole.exr")
    assert whole.shape == (6, 8, 3)
    assert (whole == 0.5).all()
    assert not caplog.records


def test_what_is_cut_off(tmp_path, caplog):
    file = shifted(tmp_path / "a.exr", (-3, -1, 12, 10))
    assert read_image(file).any()
    said = f"{file}: what lies outside its display window is left out"
    assert told(caplog) == [(logging.INFO, said)]


def test_a_data_window_inside_is_nothing_odd(tmp_path, caplog):
    read_image(shifted(tmp_path / "a.exr", (2, 1, 12, 10)))
    assert not caplog.records


@pytest.mark.parametrize(
    ("channels", "chromaticities", "odd"),
    [("RGB", REC2020, True), ("RGB", REC709, False), ("XYZ", REC2020, False)],
    ids=["other primaries", "those of sRGB", "data"],
)
def test_primaries(tmp_path, caplog, channels, chromaticities, odd):
    attributes = {"chromaticities": ("float[8]", chromaticities)}
    file = write_exr(tmp_path / "a.exr", dict.fromkeys(channels, 0.5), attributes=attributes)
    assert (read_image(file) == 0.5).all()
    said = (
        f"{file}: its colours have other primaries than sRGB and keep their values; convert it to "
        "the primaries of sRGB (Rec. 709) where other images have those"
    )
    assert told(caplog) == ([(logging.WARNING, said)] if odd else [])


@pytest.mark.parametrize("suffix", ["tif", "gif"])
def test_several_images_in_one_file(tmp_path, caplog, suffix):
    file = tmp_path / f"a.{suffix}"
    specs = [oiio.ImageSpec(8, 6, 3, "uint8")] * 3
    output = oiio.ImageOutput.create(str(file))
    assert output.open(str(file), tuple(specs)) or output.open(str(file), specs[0])
    for number, spec in enumerate(specs):
        if number:
            output.open(str(file), spec, "AppendSubimage")
        assert output.write_image(np.full((6, 8, 3), 60 * number, np.uint8))
    output.close()
    assert not read_image(file).any()
    assert told(caplog) == [(logging.INFO, f"{file}: holds several images; the first is read")]


def test_frames_of_a_png_file(tmp_path, caplog):
    frames = [Image.new("RGB", (8, 6), (60 * number,) * 3) for number in range(3)]
    frames[0].save(tmp_path / "a.png", save_all=True, append_images=frames[1:])
    assert not read_image(tmp_path / "a.png").any()
    said = f"{tmp_path / 'a.png'}: holds several images; the first is read"
    assert told(caplog) == [(logging.INFO, said)]


@pytest.mark.parametrize("orientation", range(1, 9))
def test_what_is_turned_upright(tmp_path, caplog, orientation):
    exif = Image.Exif()
    exif[274] = orientation
    Image.new("RGB", (8, 6)).save(tmp_path / "a.jpg", exif=exif)
    turned = orientation in (5, 6, 7, 8)
    assert read_image(tmp_path / "a.jpg").shape == ((8, 6, 3) if turned else (6, 8, 3))
    said = f"{tmp_path / 'a.jpg'}: is turned upright, as its header says that it was taken"
    assert told(caplog) == ([] if orientation == 1 else [(logging.INFO, said)])


@pytest.mark.parametrize("sizes", [(16, 48, 32), (48, 16), (16, 16, 48)])
def test_several_sizes_in_one_icon(tmp_path, caplog, sizes):
    file = tmp_path / "a.ico"
    specs = [oiio.ImageSpec(size, size, 4, "uint8") for size in sizes]
    output = oiio.ImageOutput.create(str(file))
    assert output.open(str(file), tuple(specs))
    for number, spec in enumerate(specs):
        if number:
            assert output.open(str(file), spec, "AppendSubimage")
        assert output.write_image(np.full((spec.height, spec.width, 4), 200 - number, np.uint8))
    output.close()
    image = read_image(file)
    assert image.shape == (48, 48, 4)
    assert (image[:, :, 3] == 200 - sizes.index(48)).all()
    assert told(caplog) == [(logging.INFO, f"{file}: holds several images; the largest is read")]


def test_parts_and_views_are_no_frames(tmp_path, caplog):
    read_image(write_parts(tmp_path / "a.exr", {"beauty": 0.25, "LDE": 0.5}))
    views = [({"name": name, "view": name}, {"R": 0.5}) for name in ("left", "right")]
    read_image(write_named_parts(tmp_path / "b.exr", views))
    write_image(tmp_path / "c.png", np.zeros((6, 8, 3), np.uint8))
    read_image(tmp_path / "c.png")
    assert not caplog.records


def test_layers_of_one_file_are_told_of_once(tmp_path, caplog):
    channels = {f"{layer}.{c}": 0.5 for layer in ("Combined", "DiffDir") for c in "RGB"}
    attributes = {"chromaticities": ("float[8]", REC2020)}
    window = (-3, -1, 12, 10)
    file = write_exr(tmp_path / "a.exr", channels, data_window=window, attributes=attributes)
    for layer in ("Combined", "DiffDir"):
        read_image(f"{file}:{layer}")
    assert len(told(caplog)) == 2
