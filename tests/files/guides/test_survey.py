"""A look at every frame gives what reading all of them at once would."""

import numpy as np
import pytest
from exr_files import write_exr

from stylit_ref import InputError, read_guides, write_image
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.guides.survey import look_at, read_source_guide
from stylit_ref.views.file_shot import FileShot

RAMP = np.linspace(0, 1, 48).reshape(6, 8)
COLOURS = np.random.default_rng(0).integers(0, 256, (6, 8, 3), np.uint8)
ALPHA = np.tile([0, 255], (6, 4)).astype(np.uint8)


def written(folder, name, content):
    """A PNG of an array, an EXR of channels."""
    if isinstance(content, dict):
        return str(write_exr(folder / f"{name}.exr", content, depth="float"))
    write_image(folder / f"{name}.png", content)
    return str(folder / f"{name}.png")


@pytest.mark.parametrize(
    "pictures",
    [
        [COLOURS, COLOURS, COLOURS[::-1]],
        [COLOURS[:, :, 0], COLOURS[:, :, 1], COLOURS],
        [COLOURS, COLOURS, np.dstack([COLOURS, ALPHA])],
        [COLOURS.astype(np.uint16) * 257, COLOURS, COLOURS],
        [dict.fromkeys("RGB", scale * RAMP) for scale in (0.5, 1, 4)],
        [{"Depth.Z": scale * RAMP} for scale in (3, 1, 7)],
        [{"IndexOB.X": np.floor(most * RAMP)} for most in (2, 4, 3)],
    ],
    ids=["plain", "grey", "alpha", "deep", "light", "depth", "labels"],
)
@pytest.mark.parametrize("encoding", ["auto", "none"])
def test_guides_are_those_of_reading_all_at_once(tmp_path, pictures, encoding):
    files = [written(tmp_path, name, each) for name, each in zip("sab", pictures, strict=True)]
    looks = [look_at(file, needs_values=encoding == "auto") for file in files]
    source, found = read_source_guide(*files[:2], looks, encoding, GuideRemarks())
    shot = FileShot(
        ("a", "b"), (6, 8), tuple((file,) for file in files[1:]), (found,), (source.shape[2],), {}
    )
    expected = read_guides([files], encoding)
    assert found == expected.encodings[0]
    np.testing.assert_array_equal(source, expected.source[0])
    for frame, (target,) in enumerate(expected.targets):
        np.testing.assert_array_equal(shot.guides(frame)[0], target)


def test_a_look_tells_the_size(tmp_path):
    file = write_exr(tmp_path / "a.exr", dict.fromkeys("RGB", RAMP), data_window=(0, 0, 9, 7))
    sizes = {look_at(file, needs_values=needs).size for needs in (True, False)}
    assert sizes == {(7, 9)}


def test_what_cannot_be_read_is_refused(tmp_path):
    (tmp_path / "a.png").write_bytes(b"no picture")
    with pytest.raises(InputError, match="cannot be read"):
        look_at(tmp_path / "a.png", needs_values=True)
