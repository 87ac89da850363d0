"""What is refused or noted before memory is taken."""

import logging

import pytest
from small_textures import identity, quick, spots

from stylit_ref import InputError, TextureParams, TextureSession, complete_texture
from stylit_ref.texture.checks import check_memory
from stylit_ref.texture.synthesize import synthesize_texture

LARGE = 4096, 4096


@pytest.fixture
def memory(monkeypatch):
    """A machine with 1 GiB."""
    monkeypatch.setattr("stylit_ref.texture.checks.physical_memory", lambda: 2**30)


@pytest.mark.usefixtures("memory")
def test_small_patches_take_more_memory_than_large_ones():
    check_memory(LARGE, TextureParams(radius=8))
    with pytest.raises(InputError, match=r"size is 4096 x 4096 .* larger than a radius of 1$"):
        check_memory(LARGE, TextureParams(radius=1))


@pytest.mark.usefixtures("memory")
def test_the_smallest_radius_counts():
    falling = TextureParams(radius=8, radius_step=1, radius_end=1, iterations=24)
    with pytest.raises(InputError, match="larger than a radius of 1"):
        check_memory(LARGE, falling)


def test_memory_is_checked_when_parameters_change(monkeypatch):
    session = TextureSession([spots()], (48, 48), quick())
    monkeypatch.setattr("stylit_ref.texture.checks.physical_memory", lambda: 2**17)
    with pytest.raises(InputError, match="larger than a radius of 1"):
        session.step(quick(radius=1))


@pytest.mark.parametrize(
    ("params", "said"),
    [
        ({"radius": 3}, r"is a dict; write TextureParams\(\*\*params\)"),
        ("paper", r"is 'paper'; write TextureParams.preset\('paper'\)"),
        (3, "is of type int; it must be a TextureParams"),
    ],
)
def test_parameters_of_another_kind_are_refused(params, said):
    with pytest.raises(InputError, match=f"params {said}"):
        synthesize_texture(spots(), (48, 48), params)
    with pytest.raises(InputError, match=f"params {said}"):
        TextureSession([spots()], (48, 48), quick()).step(params)


def test_a_grey_image_is_not_completed_from_one_in_colour():
    grey = spots(channels=1)
    with pytest.raises(InputError, match="exemplar 1 and the image have 3 and 1 channels; make"):
        complete_texture(grey, grey[:, :, 0] > 200, quick(), exemplars=[spots(1)])


def test_an_exemplar_that_has_gone_is_noted(caplog):
    caplog.set_level(logging.INFO, "stylit_ref")
    shown, options = quick(iterations=0), {"start": identity(48, 48)}
    synthesize_texture([spots(1), spots(2)], (48, 48), shown, **options)
    assert "exemplar 2 has less than 1 % of the texture; shares, labels or a guide" in caplog.text
    caplog.clear()
    synthesize_texture([spots(1), spots(2)], (48, 48), shown, shares=(1, 1), **options)
    assert "exemplar 2" not in caplog.text
