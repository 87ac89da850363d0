"""Buffers that a packing cannot use are refused in one sentence."""

import re

import numpy as np
import pytest

from stylit_ref import InputError
from stylit_ref.realtime.packing import PrincipalPacking, StagePacking, UnpackedStage, pack


def buffers(size=(3, 4), packing=StagePacking):
    return {name: np.zeros((*size, 3), np.uint8) for name in packing.names}


def refusal(packing, given):
    with pytest.raises(InputError) as refused:
        pack(packing, given)
    assert refused.value.parameter == "buffers"
    return str(refused.value)


@pytest.mark.parametrize("packing", [StagePacking(), UnpackedStage()])
def test_a_missing_buffer_is_named(packing):
    given = buffers()
    del given["LDDE"], given["FRESNEL"]
    message = "buffers lack LDDE, FRESNEL; give FULL, LDE, LDDE, LSE, IDMASK, FRESNEL, LIGHTMASK"
    assert refusal(packing, given) == message


@pytest.mark.parametrize("packing", [StagePacking(), UnpackedStage()])
def test_a_buffer_that_is_not_read_is_named(packing):
    message = refusal(packing, buffers() | {"DEPTH": np.zeros((3, 4), np.uint8)})
    assert message.startswith("buffers have 'DEPTH', which this packing does not read; give FULL")


def test_a_buffer_of_another_size_is_named_with_both_sizes():
    message = refusal(StagePacking(), buffers() | {"LSE": np.zeros((3, 5, 3), np.uint8)})
    assert message == "buffers differ in size: FULL is 4x3 and LSE is 5x3 pixels"


@pytest.mark.parametrize(
    "wrong",
    [np.zeros((3, 4, 3)), np.zeros((3, 4, 4), np.uint8), np.zeros(12, np.uint8)],
    ids=["float", "four channels", "flat"],
)
def test_a_buffer_that_is_no_image_is_named(wrong):
    message = refusal(StagePacking(), buffers() | {"LDE": wrong})
    assert f"buffers have {wrong.dtype} of the shape {wrong.shape} as LDE; it must be" in message


@pytest.mark.parametrize("name", ["IDMASK", "LIGHTMASK"])
def test_a_mask_must_have_colours(name):
    message = refusal(StagePacking(), buffers() | {name: np.zeros((3, 4), np.uint8)})
    assert message.startswith(f"buffers have {name} without colours; it must be")


def test_a_buffer_without_pixels_is_named():
    assert refusal(StagePacking(), buffers(size=(0, 4))) == "buffers have no pixel in FULL"


def test_a_list_of_buffers_is_no_mapping():
    out = np.zeros((3, 4, 10), np.uint8)
    with pytest.raises(InputError, match="buffers must map the names of buffers to arrays"):
        StagePacking().pack_into(list(buffers().values()), out)


@pytest.mark.parametrize(
    "out",
    [
        np.zeros((3, 4, 9), np.uint8),
        np.zeros((3, 4, 10)),
        np.zeros((3, 4, 20), np.uint8)[:, :, ::2],
    ],
    ids=["channels", "float", "bytes apart"],
)
def test_an_array_to_write_must_fit(out):
    with pytest.raises(InputError, match=r"^out is .* it must be uint8 of the shape \(3, 4, 10\)"):
        StagePacking().pack_into(buffers(), out)


def test_labels_to_write_must_fit():
    out, labels = np.zeros((3, 4, 10), np.uint8), np.zeros((4, 3), np.uint8)
    with pytest.raises(InputError, match=re.escape("they must be contiguous uint8 of the shape")):
        StagePacking().pack_into(buffers(), out, labels)


def test_a_target_with_other_channels_than_the_source_is_refused():
    source = {"IDMASK": np.zeros((3, 4, 3), np.uint8), "DEPTH": np.zeros((3, 4), np.uint8)}
    packing = PrincipalPacking.of_source(source)
    message = refusal(packing, source | {"DEPTH": np.zeros((3, 4, 3), np.uint8)})
    assert message == "buffers have 3 channels in DEPTH; the source has 1 there"


def test_a_source_needs_an_idmask_and_something_beside_it():
    depth = {"DEPTH": np.zeros((3, 4), np.uint8)}
    with pytest.raises(InputError, match=r"^buffers lack IDMASK; give IDMASK, DEPTH$"):
        PrincipalPacking.of_source(depth)
    with pytest.raises(InputError, match=r"^buffers have 0 channels beside IDMASK; give 1 to 32$"):
        PrincipalPacking.of_source({"IDMASK": np.zeros((3, 4, 3), np.uint8)})


def test_an_idmask_of_many_colours_tells_no_things_apart():
    idmask = np.arange(300 * 3, dtype=np.uint16).reshape(20, 15, 3).astype(np.uint8)
    idmask[..., 0] = np.arange(300).reshape(20, 15) // 256
    idmask[..., 1] = np.arange(300).reshape(20, 15) % 256
    given = {"IDMASK": idmask, "DEPTH": np.zeros((20, 15), np.uint8)}
    with pytest.raises(InputError, match=r"^buffers have \d+ colours in IDMASK; give each thing"):
        PrincipalPacking.of_source(given)
