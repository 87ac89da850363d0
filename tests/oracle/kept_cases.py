"""The cases of a version on disk against those that the library makes."""

import numpy as np

from oracle.cases import read_cases, write_input
from oracle.families import folder_of


def assert_made_again(cases, version, tmp_path):
    """Every case of a version is made again, byte for byte, and no other.

    Parameters
    ----------
    cases : iterable of Case
        As the library makes them.
    version : str
    """
    made = {case.title: case for case in cases}
    kept = {case.title: case for case in read_cases(version)}
    assert made.keys() == kept.keys()
    for title, case in made.items():
        write_input(case, tmp_path)
        description = folder_of(version) / title / "case.json"
        assert (tmp_path / "case.json").read_bytes() == description.read_bytes()
        for ours, theirs in (
            (case.arrays, kept[title].arrays),
            (case.expected, kept[title].expected),
        ):
            assert ours.keys() == theirs.keys()
            for name, array in ours.items():
                np.testing.assert_array_equal(array, theirs[name], err_msg=f"{title} {name}")
