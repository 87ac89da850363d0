"""Which convention explains pictures, on vectors of our own, of Blender, and made up."""

import numpy as np
import pytest
from views.motion.blender_shot import FOLDER, sample
from views.motion.moving_square import SIZE, motion, picture

from eval.projection import vectors_off
from stylit_ref import InputError
from stylit_ref.files.motion_file import Vectors
from stylit_ref.views.motion.check import check_motion
from stylit_ref.views.motion.conventions import CONVENTIONS
from stylit_ref.views.motion.samples import Sample

STILL = (
    "the pictures do not move; name frames of the same program in which things move by several "
    "pixels, or frames further apart and the vectors from one to the other"
)


def stored(convention, field, *, backward=None, dialect="other", visible=None):
    """Vectors as a program of a convention would write them."""
    pairs = []
    for lead in convention.leads:
        pair = (field if lead.step == 1 else backward) * np.float32([lead.right, lead.down])
        pairs.append(pair[:, :, ::-1] if convention.is_swapped else pair)
    return Vectors(tuple(pairs), (np.ones(SIZE, bool),) * len(pairs), visible, dialect)


def bright(frame):
    return picture(frame).mean(axis=2, dtype=np.float32)


def square(vectors):
    """The vectors of a frame, with pictures of one beside it and of one farther before.

    So all slows down: with even motion, the opposite of the way on is the way back.
    """
    here, after, before = (bright(frame) for frame in (1, 2, -1))
    return [Sample("a.exr", vectors, {1: (here, after), -1: (here, before)})]


FORWARD, BACKWARD = motion(1, 2).field, motion(1, -1).field


@pytest.mark.parametrize("name", [name for name in CONVENTIONS if not name.startswith("own")])
def test_each_convention_is_found_by_the_pictures(name):
    dialect = "other" if name.startswith("flo") else "blender"
    vectors = stored(CONVENTIONS[name], FORWARD, backward=BACKWARD, dialect=dialect)
    verdict = check_motion(square(vectors))
    assert verdict.convention.name == name
    assert len(verdict.trials) == 16 * len(vectors.pairs)


def test_vectors_of_blender_are_found_by_the_pictures():
    frames = (1, 2, 3)
    verdict = check_motion([sample("perspective", frame, frames) for frame in frames])
    assert verdict.convention.name == "blender"
    assert verdict.trials[0].error < verdict.still / 2


def test_blenders_vectors_with_another_sign_are_found_too():
    middle = sample("perspective", 2, (1, 2, 3))
    pairs = tuple(pair * np.float32([1, -1]) for pair in middle.vectors.pairs)
    turned = middle._replace(vectors=middle.vectors._replace(pairs=pairs))
    verdict = check_motion([turned])
    assert verdict.convention.name == "blender-flip-y"
    assert "blender-flip-x-reverse would lead to the same places" in verdict.why


def test_what_the_names_tell_is_preferred_where_several_explain_the_pictures_alike():
    vectors = stored(CONVENTIONS["own"], FORWARD, dialect="own", visible=motion(1, 2).visible)
    verdict = check_motion(square(vectors))
    assert verdict.convention.name == "own"


def test_a_still_shot_is_undecided():
    middle = sample("perspective", 2, (1, 2, 3))
    here = middle.pictures[1][0]
    verdict = check_motion([middle._replace(pictures={1: (here, here), -1: (here, here)})])
    assert (verdict.convention, verdict.why) == (None, STILL)


def test_noise_is_no_motion():
    rng = np.random.default_rng(0)
    shown = [100 + rng.normal(0, 3, SIZE).astype(np.float32) for _ in range(2)]
    still = stored(CONVENTIONS["flo"], np.zeros((*SIZE, 2), np.float32))
    verdict = check_motion([Sample("a.flo", still, {1: tuple(shown)})])
    assert (verdict.convention, verdict.why) == (None, STILL)


def test_a_small_thing_that_moves_is_enough():
    before, after = np.zeros((2, 60, 90), np.float32)
    field = np.zeros((60, 90, 2), np.float32)
    texture = np.random.default_rng(0).random((4, 4)) * 255
    before[20:24, 30:34], after[21:25, 33:37] = texture, texture
    field[20:24, 30:34] = 3, 1
    vectors = Vectors((field,), (np.ones((60, 90), bool),), None, "flo")
    verdict = check_motion([Sample("a.flo", vectors, {1: (before, after), -1: (after, before)})])
    assert verdict.convention.name == "flo"


def test_short_vectors_are_undecided():
    vectors = stored(CONVENTIONS["flo"], np.full((*SIZE, 2), 0.4, np.float32))
    verdict = check_motion(square(vectors))
    assert verdict.convention is None
    assert verdict.why.startswith(
        "all vectors are shorter than half a pixel, or lead outside; name"
    )


def test_vectors_that_have_nothing_to_do_with_the_pictures_are_undecided():
    field = np.random.default_rng(0).normal(0, 3, (*SIZE, 2)).astype(np.float32)
    verdict = check_motion(square(stored(CONVENTIONS["flo"], field)))
    assert verdict.convention is None
    assert verdict.why.startswith("no convention explains the pictures")
    assert "If the shot is slow, name frames of the same program in which things" in verdict.why


def test_vectors_of_blender_with_motion_blur_are_refused():
    with pytest.raises(InputError, match="all vectors are 0 although the pictures move"):
        check_motion([sample("blurred", 1, (1, 2))])


def test_vectors_of_blenders_moving_orthographic_camera_are_refused():
    with pytest.raises(InputError, match=r"same direction, by 8.6 pixels.*perspective"):
        check_motion([sample("orthographic", frame, (1, 2)) for frame in (1, 2)])


def test_pictures_of_another_size_are_refused():
    middle = sample("perspective", 2, (1, 2, 3))
    small = middle.pictures[1][0][1:]
    with pytest.raises(InputError, match="has vectors of 64x48 pixels, and a picture is 64x47"):
        check_motion([middle._replace(pictures={1: (small, small)})])


def test_vectors_of_blender_are_those_of_projected_points():
    """But where the samples of a pixel straddle an outline."""
    inside, beside = vectors_off(FOLDER)
    assert inside.max() < 0.05
    assert np.mean(beside > 0.05) < 0.02


def test_files_of_several_kinds_are_refused():
    flo = stored(CONVENTIONS["flo"], FORWARD, dialect="flo")
    blender = stored(CONVENTIONS["blender"], FORWARD, backward=BACKWARD, dialect="blender")
    for first, second, said in ((flo, blender, "4 channels"), (blender, flo, "2 channels")):
        samples = [*square(first), square(second)[0]._replace(name="b.exr")]
        with pytest.raises(InputError, match=f"b.exr: has vectors of {said}, and a.exr of"):
            check_motion(samples)
