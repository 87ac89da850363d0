"""What stored vectors become, convention by convention."""

import numpy as np
import pytest

from stylit_ref import InputError
from stylit_ref.files.motion_file import Vectors
from stylit_ref.views.motion.conventions import (
    CONVENTIONS,
    PROGRAMS,
    convention_named,
    convention_of,
)


def stored(*values, dialect="other", visible=None):
    """Vectors of one pixel."""
    pairs = tuple(np.float32([[pair]]) for pair in values)
    return Vectors(pairs, (np.ones((1, 1), bool),) * len(pairs), visible, dialect)


def ways(name, *values):
    found = CONVENTIONS[name].fields(stored(*values))
    return tuple(m and tuple(map(float, m.field[0, 0])) for m in (found.forward, found.backward))


@pytest.mark.parametrize(
    ("name", "values", "forward", "backward"),
    [
        # Measured in Blender 5.0.1: the object comes from (8, 4 up) and goes on by (16, 2 up).
        ("blender", [(-8, -4), (-16, -2)], (16, -2), (-8, 4)),
        ("nuke", [(16, 2), (-8, -4)], (16, -2), (-8, 4)),
        ("flo", [(16, -2)], (16, -2), None),
        ("own", [(16, -2)], (16, -2), None),
        ("flo-reverse", [(-8, 4)], None, (-8, 4)),
        ("flo-flip-y", [(16, 2)], (16, -2), None),
        ("flo-swap", [(-2, 16)], (16, -2), None),
        ("flo-flip-x-flip-y-reverse", [(8, -4)], None, (-8, 4)),
        ("blender-reverse", [(-8, -4), (-16, -2)], (-8, 4), (16, -2)),
    ],
)
def test_canonical_fields(name, values, forward, backward):
    assert ways(name, *values) == (forward, backward)


def test_every_program_has_sixteen_different_variants():
    assert len(CONVENTIONS) == 16 * len(PROGRAMS)
    pairs = {"blender": 2, "nuke": 2, "flo": 1, "own": 1}
    for program, count in pairs.items():
        values = [(1, 2), (3, 5)][:count]
        results = {ways(name, *values) for name in CONVENTIONS if name.startswith(program)}
        assert len(results) == 16


def test_pixels_without_a_vector_and_hidden_ones_are_hidden():
    pair, known = np.zeros((1, 3, 2), np.float32), np.array([[True, False, True]])
    visible = np.array([[True, True, False]])
    found = CONVENTIONS["own"].fields(Vectors((pair,), (known,), visible, "own"))
    assert found.forward.visible.tolist() == [[True, False, False]]
    assert found.tells_visible
    assert not CONVENTIONS["own"].fields(Vectors((pair,), (known,), None, "own")).tells_visible


def test_a_missing_pair_is_a_missing_direction():
    pairs, known = (None, np.zeros((1, 1, 2), np.float32)), (None, np.ones((1, 1), bool))
    found = CONVENTIONS["nuke"].fields(Vectors(pairs, known, None, "nuke"))
    assert found.forward is None
    assert found.backward is not None


def test_names_of_channels_tell_the_convention():
    assert convention_of(stored((0, 0), dialect="flo"), "a.flo").name == "flo"
    with pytest.raises(InputError, match=r"a.exr: the names of its channels do not tell"):
        convention_of(stored((0, 0)), "a.exr")


def test_an_unknown_name_is_refused_with_the_nearest():
    with pytest.raises(InputError, match="did you mean blender-flip-y"):
        convention_named("blender-flipy")


def test_another_number_of_channels_is_refused():
    with pytest.raises(InputError, match="is for vectors of 4 channels, and the file has 2"):
        CONVENTIONS["blender"].fields(stored((0, 0)))
