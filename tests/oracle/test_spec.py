"""SPEC.md is right about files and random numbers."""

import re

import numpy as np

from oracle.families import NEWEST, folder_of, spec_of
from stylit_ref.randomness.philox import philox4x32
from stylit_ref.randomness.random_stream import RANDOM_SEARCH, random_stream

SPEC = spec_of(NEWEST).read_text(encoding="utf-8")


def test_types_of_files_are_those_that_occur():
    told = set(re.findall(r"^- `([|<]\w\d)`: ", SPEC, re.MULTILINE))
    found = set()
    for file in folder_of(NEWEST).rglob("*.npy"):
        with file.open("rb") as stream:
            assert np.lib.format.read_magic(stream) == (1, 0)
            _, fortran_order, dtype = np.lib.format.read_array_header_1_0(stream)
            assert stream.tell() % 64 == 0
        assert not fortran_order
        found.add(np.lib.format.dtype_to_descr(dtype))
    assert told == found


def test_the_header_that_is_shown_is_a_files():
    shown = " ".join(re.search(r"`(\{'descr'.+?\})`", SPEC, re.DOTALL)[1].split())
    headers = {file.read_bytes()[10:128].rstrip() for file in folder_of(NEWEST).rglob("nnf.npy")}
    assert shown.encode() in headers


def test_the_worked_example_of_philox_is_what_it_gives():
    example = SPEC[SPEC.index("For example, pixel 5") :].partition("\n\n")[0]
    seed, *numbers = (int(number, 16) for number in re.findall(r"0x([0-9A-F]+)", example))
    counter, key, words = numbers[:4], numbers[4:6], numbers[6:]
    assert random_stream(seed, RANDOM_SEARCH, 3, 2, 5) == (*counter[2:], *key)
    assert counter[:2] == [5, 1]
    assert [int(word) for word in philox4x32(*counter, *key)] == words
