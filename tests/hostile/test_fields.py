"""Hostile nearest-neighbour fields for ``replay``."""

import io
import os
import pickle
from pathlib import Path

import numpy as np
import pytest
from hostile.command_line import accepted, refused, replay

from stylit_ref import read_image

pytestmark = pytest.mark.usefixtures("folder")


def saved(array, **options):
    """The bytes of an array's .npy."""
    file = io.BytesIO()
    np.save(file, array, **options)
    return file.getvalue()


def packed(**arrays):
    """The bytes of an .npz."""
    file = io.BytesIO()
    np.savez(file, **arrays)
    return file.getvalue()


class Trap:
    """Unpickling it would make a file."""

    def __reduce__(self):
        return open, ("trapped", "w")


FIELD = saved(np.zeros((4, 4, 2), np.int32))
DAMAGED = {
    "with pickled objects": saved(np.array([Trap()], object), allow_pickle=True),
    "a bare pickle": pickle.dumps(Trap()),
    "an .npz": packed(nnf=np.zeros((4, 4, 2), np.int32)),
    "cut off in the middle": FIELD[:200],
    "a header that declares 8 TB": FIELD.replace(
        b"(4, 4, 2), }            ", b"(1000000, 1000000, 2), }"
    ),
}


@pytest.mark.parametrize("content", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_field(content):
    refused(replay(content), "hostile.npy: is not a readable .npy file: …")


def test_a_field_that_is_a_pipe():
    arguments = replay(b"")
    Path("hostile.npy").unlink()
    os.mkfifo("hostile.npy")
    refused(arguments, "hostile.npy: is a device or a pipe; name an ordinary file")


@pytest.mark.parametrize("dtype", ["float64", ">i4"])
def test_a_field_of_another_type(dtype):
    refused(
        replay(saved(np.full((4, 4, 2), 3, dtype))),
        f"the NNF is {dtype} of shape (4, 4, 2); it must be int32 of shape (H, W, 2)",
    )


def test_a_field_that_points_outside_the_style():
    refused(
        replay(saved(np.full((4, 4, 2), 99, np.int32))),
        "the NNF points to source pixels (y, x) from [99, 99] to [99, 99], but a style of 13x12 at "
        "scale 1 has patches of width 5 only from [2, 2] to [9, 10]",
    )


def test_a_field_in_fortran_order_is_replayed_as_any_other():
    accepted(replay(saved(np.asfortranarray(np.load("nnf.npy")))))
    ours = read_image("out.png")
    accepted(replay(Path("nnf.npy").read_bytes()))
    np.testing.assert_array_equal(ours, read_image("out.png"))
