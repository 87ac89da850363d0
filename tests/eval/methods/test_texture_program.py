"""Programs for texture synthesis, which scripts stand in for."""

import numpy as np
import pytest

from eval.methods.texture_program import TextureProgram, embark, gmic, img2texture
from eval.textures import Texture
from stylit_ref import InputError, read_uint8, write_image


@pytest.fixture
def texture():
    image = np.random.default_rng(1).integers(0, 256, (9, 7, 3), dtype=np.uint8)
    return Texture("noise", image, (18, 14))


def script(folder, text):
    file = folder / "program"
    file.write_text(f"#!/bin/sh\n{text}\n")
    file.chmod(0o755)
    return str(file)


def test_a_program_gets_the_files_and_its_picture_is_read(texture, tmp_path):
    wanted = np.random.default_rng(2).integers(0, 256, (18, 14, 3), dtype=np.uint8)
    write_image(tmp_path / "wanted.png", wanted)
    program = script(
        tmp_path,
        f'echo "$@" > {tmp_path}/said; cp "$1" {tmp_path}/given.png; cp {tmp_path}/wanted.png "$2"',
    )
    arguments = "{exemplar}", "{output}", "{width}x{height}", "{seed}"
    outcome = TextureProgram("copy", program, arguments).run(texture, 5)
    np.testing.assert_array_equal(outcome.image, wanted)
    np.testing.assert_array_equal(read_uint8(tmp_path / "given.png"), texture.exemplar)
    assert (tmp_path / "said").read_text().split()[2:] == ["14x18", "5"]
    assert outcome.coordinates is None


def test_a_failing_program_says_why(texture, tmp_path):
    program = script(tmp_path, "echo no such thing; exit 3")
    with pytest.raises(InputError, match="failed with code 3: no such thing"):
        TextureProgram("broken", program, ()).run(texture, 0)


def test_a_program_that_writes_nothing_has_failed(texture, tmp_path):
    with pytest.raises(InputError, match="failed with code 0"):
        TextureProgram("idle", script(tmp_path, "true"), ()).run(texture, 0)


@pytest.mark.parametrize("rival", [gmic, img2texture, embark])
def test_a_program_that_is_not_there_is_named(rival):
    with pytest.raises(InputError, match="nowhere: is not a program that can be started; give the"):
        rival("nowhere").code  # noqa: B018
