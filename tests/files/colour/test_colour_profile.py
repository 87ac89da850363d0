"""What a file says of its colours, from the style to the picture."""

import io
import logging
import struct

import numpy as np
import OpenImageIO as oiio
import pytest
from icc_profile import icc_profile
from PIL import Image, ImageCms

from stylit_ref import read_image, write_image
from stylit_ref.files.colour.profile import ColourProfile, note_another_profile, read_colour_profile
from stylit_ref.files.disk.png_chunks import read_chunks, replace_chunks

ICC = icc_profile()
WIDE = 0.735, 0.265, 0.115, 0.826, 0.157, 0.018, 0.3127, 0.329
OF_ICC = ColourProfile(of_light=False, icc=ICC, icc_name="Red is green")
OF_CICP = ColourProfile(of_light=False, cicp=(12, 13, 0, 1))
OF_GAMMA = ColourProfile(of_light=False, gamma=1.8, primaries=WIDE)
OF_LIGHT = ColourProfile(of_light=True, primaries=WIDE)
PROFILES = {"ICC": OF_ICC, "CICP": OF_CICP, "gamma": OF_GAMMA, "light": OF_LIGHT}


def assert_same(profile, other):
    assert profile[:4] == other[:4]
    for a, b in zip(profile[4:], other[4:], strict=True):
        assert (a is None) == (b is None)
        if a is not None:
            np.testing.assert_allclose(a, b, atol=1e-4)


@pytest.mark.parametrize("suffix", ["png", "tif", "jpg", "jpeg", "webp", "jp2", "jxl"])
def test_an_icc_profile_goes_into_every_format_that_has_one(tmp_path, suffix, caplog):
    image = np.random.default_rng(0).integers(0, 256, (40, 50, 3), dtype=np.uint8)
    write_image(tmp_path / f"a.{suffix}", image, profile=OF_ICC)
    write_image(tmp_path / f"plain.{suffix}", image)
    assert read_colour_profile(tmp_path / f"a.{suffix}") == OF_ICC
    plain = read_image(tmp_path / f"plain.{suffix}")
    np.testing.assert_array_equal(read_image(tmp_path / f"a.{suffix}"), plain)
    assert not caplog.records


def test_viewers_apply_it(tmp_path, image):
    write_image(tmp_path / "a.png", image, profile=OF_ICC)
    opened = Image.open(tmp_path / "a.png")
    profile = io.BytesIO(opened.info["icc_profile"])
    seen = ImageCms.profileToProfile(opened, profile, ImageCms.createProfile("sRGB"))
    swapped = image[:, :, [1, 0, 2]].astype(int)
    assert np.abs(np.asarray(seen) - swapped).mean() < 5 < np.abs(image - swapped).mean()


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_a_png_file_says_it_in_chunks(tmp_path, image, profile, caplog):
    values = image.astype(np.float32) / 255 if profile.of_light else image
    write_image(tmp_path / "a.png", values, profile=profile, curve="srgb")
    assert_same(read_colour_profile(tmp_path / "a.png"), profile._replace(of_light=False))
    assert b"sRGB" not in read_chunks(tmp_path / "a.png")
    Image.open(tmp_path / "a.png").load()
    assert not caplog.records


def test_pillow_sees_the_gamma_and_the_primaries(tmp_path, image):
    write_image(tmp_path / "a.png", image, profile=OF_GAMMA)
    said = Image.open(tmp_path / "a.png").info
    assert said["gamma"] == pytest.approx(1 / 1.8, abs=1e-5)
    np.testing.assert_allclose(said["chromaticity"], [*WIDE[6:], *WIDE[:6]], atol=1e-5)
    np.testing.assert_array_equal(read_image(tmp_path / "a.png"), image)


@pytest.mark.parametrize("profile", [OF_LIGHT, OF_GAMMA._replace(gamma=None)], ids=str)
def test_primaries_go_into_exr(tmp_path, image, profile, caplog):
    values = image.astype(np.float32) if profile.of_light else image
    write_image(tmp_path / "a.exr", values, profile=profile)
    assert_same(read_colour_profile(tmp_path / "a.exr"), OF_LIGHT)
    assert not caplog.records


@pytest.mark.parametrize(
    ("profile", "suffix", "lost"),
    [
        (OF_ICC, "exr", "ICC profile 'Red is green'"),
        (OF_ICC, "bmp", "ICC profile 'Red is green'"),
        (OF_CICP, "tif", "CICP code points"),
        (OF_GAMMA, "exr", "gamma of 1.8"),
        (OF_GAMMA, "jpg", "gamma of 1.8 and primaries"),
        (OF_LIGHT, "tif", "primaries"),
        (
            OF_LIGHT._replace(primaries=(0.7347, 0.2653, 0, 1, 0.0001, -0.077, 0.3217, 0.3377)),
            "png",
            "primaries",
        ),
        (OF_LIGHT._replace(icc=ICC, icc_name="X"), "png", "ICC profile 'X'"),
    ],
)
def test_what_a_format_cannot_say_is_told(tmp_path, image, profile, suffix, lost, caplog):
    write_image(tmp_path / f"a.{suffix}", image, profile=profile)
    keeps = "an .exr" if profile.of_light else "a .png"
    said = (
        f"{tmp_path}/a.{suffix}: cannot hold the {lost} of the picture, so its colours are taken "
        f"as sRGB; {keeps} file can"
    )
    assert caplog.record_tuples == [("stylit_ref", logging.WARNING, said)]


def test_nothing_is_lost_of_srgb(tmp_path, image, caplog):
    profile = ColourProfile(False, icc_profile(primaries="rgb"), "sRGB IEC61966-2.1")
    write_image(tmp_path / "a.bmp", image, profile=profile)
    assert not caplog.records


@pytest.mark.parametrize("suffix", ["png", "tif", "jpg", "exr"])
def test_a_file_that_says_nothing_new_has_no_profile(tmp_path, image, suffix):
    write_image(tmp_path / f"a.{suffix}", image)
    assert read_colour_profile(tmp_path / f"a.{suffix}") == ColourProfile(suffix == "exr")


def test_the_chunk_of_srgb_overrules_a_gamma(tmp_path, image):
    write_image(tmp_path / "a.png", image)
    replace_chunks(tmp_path / "a.png", [b"gAMA"], {b"gAMA": struct.pack(">I", 100000)})
    assert read_colour_profile(tmp_path / "a.png").gamma is None


@pytest.mark.parametrize(
    ("channels", "icc"),
    [
        (3, ICC[:-4]),
        (3, b"no profile"),
        (3, icc_profile(b"CMYK")),
        (3, icc_profile(b"GRAY")),
        (1, ICC),
    ],
)
def test_a_profile_that_does_not_fit_is_left_out(tmp_path, channels, icc, caplog):
    spec = oiio.ImageSpec(8, 6, channels, "uint8")
    values = np.frombuffer(icc, np.uint8)
    spec.attribute("ICCProfile", oiio.TypeDesc(f"uint8[{values.size}]"), values)
    output = oiio.ImageOutput.create(str(tmp_path / "a.tif"))
    output.open(str(tmp_path / "a.tif"), spec)
    output.write_image(np.zeros((6, 8, channels), np.uint8))
    output.close()
    with caplog.at_level("INFO", "stylit_ref"):
        assert read_colour_profile(tmp_path / "a.tif") == ColourProfile(of_light=False)
    (said,) = caplog.messages
    assert said.endswith("a.tif: its ICC profile is damaged or not one for its channels; it is "
                         "left out")  # fmt: skip


def test_a_grey_profile_stays_with_a_grey_image(tmp_path, image, caplog):
    grey = ColourProfile(False, icc_profile(b"GRAY", name=b"Dark"), "Dark")
    write_image(tmp_path / "a.png", image[:, :, :1], profile=grey)
    assert read_colour_profile(tmp_path / "a.png") == grey
    assert not caplog.records
    write_image(tmp_path / "colour.png", image, profile=grey)
    assert "cannot hold the ICC profile 'Dark'" in caplog.text
    np.testing.assert_array_equal(read_image(tmp_path / "colour.png"), image)


def test_a_fill_with_other_colours_is_noticed(tmp_path, image, caplog):
    write_image(tmp_path / "fill.png", image)
    note_another_profile(tmp_path / "fill.png", ColourProfile(of_light=False))
    note_another_profile(tmp_path / "fill.png", ColourProfile(of_light=True))
    assert not caplog.records
    note_another_profile(tmp_path / "fill.png", OF_ICC)
    assert (
        "fill.png: does not agree with the style in its ICC profile 'Red is green'" in caplog.text
    )


@pytest.mark.parametrize("cut", [4, 20, 40, 90])
def test_a_damaged_png_file_is_read_as_far_as_it_goes(tmp_path, image, cut):
    write_image(tmp_path / "a.png", image, profile=OF_GAMMA)
    whole = (tmp_path / "a.png").read_bytes()
    (tmp_path / "a.png").write_bytes(whole[:cut])
    assert set(read_chunks(tmp_path / "a.png")) <= {b"IHDR", b"gAMA", b"cHRM"}
