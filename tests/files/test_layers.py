"""Layers by name, in files that OpenImageIO itself wrote."""

import numpy as np
import pytest
from exr_files import write_exr, write_parts

from stylit_ref import InputError, read_image, write_image


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


def test_a_colon_in_a_file_name(tmp_path, image):
    write_image(tmp_path / "a:b.png", image)
    np.testing.assert_array_equal(read_image(tmp_path / "a:b.png"), image)


def test_luminance_and_chroma_give_the_luminance(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"BY": 0.1, "RY": 0.2, "Y": 0.5})
    np.testing.assert_array_equal(read_image(file)[0, 0], [0.5])


def test_alpha_alone_is_not_the_image(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"A": 1, "LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match="all its layers have names"):
        read_image(file)


def test_missing_layer_lists_what_there_is(tmp_path):
    file = write_exr(tmp_path / "a.exr", {"LDE.R": 0.1, "LSE.R": 0.2})
    with pytest.raises(InputError, match="no layer 'LDDE'; its layers are: LDE, LSE"):
        read_image(f"{file}:LDDE")
    with pytest.raises(InputError, match=r"all its layers have names; add one as .*: LDE, LSE"):
        read_image(file)
