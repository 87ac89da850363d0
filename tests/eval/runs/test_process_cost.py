"""What a program takes."""

import sys

import pytest

from eval.runs.process_cost import process_cost
from stylit_ref import InputError


def test_timed_accounts_for_the_process_itself():
    held_here = bytearray(200 << 20)
    small = process_cost([sys.executable, "-S", "-c", "sum(range(10**6))"])
    assert small.mebibytes < 100
    assert 0 < small.processor_seconds < 60
    large = process_cost([sys.executable, "-S", "-c", "x = bytearray(200 << 20)"])
    assert large.mebibytes > len(held_here) / 2**20
    with pytest.raises(InputError, match="failed with code 3: no"):
        process_cost([sys.executable, "-c", "print('no'); raise SystemExit(3)"])
