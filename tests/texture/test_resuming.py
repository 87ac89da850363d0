"""A synthesis that is saved and goes on gives what one run gives."""

from dataclasses import replace

import numpy as np
import pytest
from small_textures import quick, spots

from stylit_ref import (
    InputError,
    TextureSession,
    read_texture_field,
    synthesize_texture,
    write_texture_field,
)

EXEMPLARS = [spots(1), spots(2, 40)]
SIZE = 50, 64


def in_two(tmp_path, params, stop, **named):
    """A run that is saved after some iterations, and one that goes on with what was saved."""
    first = synthesize_texture(
        EXEMPLARS, SIZE, params, progress=lambda done: done.number == stop, **named
    )
    write_texture_field(tmp_path / "s.npy", first.field)
    field = read_texture_field(tmp_path / "s.npy")
    return field, synthesize_texture(EXEMPLARS, SIZE, params, start=field, **named)


@pytest.mark.parametrize(
    "changes",
    [{}, {"max_deformation": 12, "predicate": "after"}, {"radius_step": 1, "radius_end": 3}],
)
@pytest.mark.parametrize("named", [{"seed": 4}, {"shares": (1, 2)}])
def test_both_parts_give_what_one_run_gives(tmp_path, changes, named):
    params = quick(**changes)
    whole = synthesize_texture(EXEMPLARS, SIZE, params, **named)
    field, resumed = in_two(tmp_path, params, 4, **named)
    assert field.iterations == 4
    assert np.array_equal(resumed.coordinates, whole.coordinates)
    assert resumed.history == whole.history[4:]
    assert resumed.iterations == whole.iterations == 10


def test_patience_goes_on_where_it_was(tmp_path):
    params = quick(iterations=200, patience=5, candidates=1)
    whole = synthesize_texture(EXEMPLARS, SIZE, params)
    assert 5 < whole.iterations < 200
    field, resumed = in_two(tmp_path, params, whole.iterations - 2)
    assert field.idle == 3
    assert len(resumed.history) == 2
    assert resumed.history == whole.history[-2:]


def test_coordinates_begin_anew():
    field = synthesize_texture(EXEMPLARS, SIZE, quick()).field
    assert TextureSession(EXEMPLARS, SIZE, quick(), start=field).iteration == 10
    assert TextureSession(EXEMPLARS, SIZE, quick(), start=field.coordinates).iteration == 0


def test_there_may_be_more_exemplars_than_before():
    field = synthesize_texture(EXEMPLARS[0], SIZE, quick()).field
    session = TextureSession(EXEMPLARS, SIZE, quick(), start=field)
    assert np.array_equal(session.coordinates, field.coordinates)


def test_other_exemplars_are_refused():
    field = synthesize_texture(EXEMPLARS, SIZE, quick(iterations=1)).field
    with pytest.raises(InputError, match="start was made from an exemplar 1 of 48 x 48 pixels, "):
        synthesize_texture(EXEMPLARS[::-1], SIZE, quick(), start=field)
    with pytest.raises(InputError, match="start was made from 2 exemplars, but got 1"):
        synthesize_texture(EXEMPLARS[:1], SIZE, quick(), start=field)


def test_a_count_that_is_none_is_refused(tmp_path):
    field = synthesize_texture(EXEMPLARS, SIZE, quick(iterations=1)).field
    write_texture_field(tmp_path / "s.npy", replace(field, iterations=-1))
    with pytest.raises(InputError, match=r"the iterations done, .* are \[-1, 0\]"):
        read_texture_field(tmp_path / "s.npy")
