"""Kinds of parameters: which values they accept, convert and refuse."""

from fractions import Fraction

import numpy as np
import pytest

from stylit_ref import InputError
from stylit_ref.parameters import (
    Choice,
    Integer,
    Number,
    OneOrSeveral,
    Optional,
    OrWord,
    Several,
    Share,
)

ODD = Integer(3, 63, odd=True)


@pytest.mark.parametrize(
    ("kind", "value", "made"),
    [
        (ODD, np.uint8(5), 5),
        (Integer(1, 16, remark=", at most"), 16, 16),
        (Number(0, 1e12), Fraction(1, 2), 0.5),
        (Number(0, 1e12), np.float32(0.5), 0.5),
        (Share(), 1, 1.0),
        (OrWord("hyperbola", Share()), "hyperbola", "hyperbola"),
        (Choice(("ref", "stylit")), "stylit", "stylit"),
        (OneOrSeveral(Integer(1, 9)), 4, 4),
        (OneOrSeveral(Integer(1, 9)), np.array([1, 4]), (1, 4)),
        (Several(Number(0, 9), "weight"), [1, 2], (1.0, 2.0)),
        (Optional(Number(1, 9)), None, None),
        (Optional(Number(1, 9)), 5, 5.0),
    ],
    ids=repr,
)
def test_a_value_becomes_pythons_own(kind, value, made):
    found = kind.check("name", value)
    assert found == made
    assert type(found) is type(made)


@pytest.mark.parametrize(
    ("kind", "value", "sentence"),
    [
        (ODD, 4, "name is 4; it must be an odd integer from 3 to 63"),
        (ODD, 5.0, "name is 5.0; it must be an odd"),
        (Integer(0, 24, remark=", for patches of width 5"), 25, "0 to 24, for patches of width 5"),
        (Number(0, 1e12), float("nan"), "name is nan; it must be a number from 0 to 1e.12"),
        (Number(0, 1e12), "1", "name is '1'; it must be a number"),
        (Share(), 0, "name is 0; it must be a number above 0 and up to 1"),
        (OrWord("all", Integer(1, 16)), "most", "must be an integer from 1 to 16, or 'all'"),
        (Choice(("a", "b", "c")), "d", "name is 'd'; it must be 'a', 'b' or 'c'"),
        (Choice(("ref", "stylit")), "stlyit", "'ref' or 'stylit'; did you mean stylit?"),
        (OneOrSeveral(Integer(1, 9)), (1, 0), "name is 0; it must be an integer from 1 to 9"),
        (OneOrSeveral(Integer(1, 9)), (), r"name is \(\); it must be an integer"),
        (Several(Number(0, 9), "weight"), [1, -2], "weight 2 is -2; it must be a number"),
        (Several(Number(0, 9), "weight"), 3, "name is 3; it must be a list of numbers"),
        (Several(Number(0, 9), "weight"), [[1], [2, 3]], "it must be a list of numbers"),
        (Optional(Number(1, 9)), 0, "name is 0; it must be a number from 1 to 9"),
    ],
    ids=repr,
)
def test_what_does_not_fit_is_one_sentence(kind, value, sentence):
    with pytest.raises(InputError, match=sentence) as refusal:
        kind.check("name", value)
    assert str(refusal.value) == f"{refusal.value.parameter} {refusal.value.sentence}"


@pytest.mark.parametrize(
    ("kind", "text", "value"),
    [
        (ODD, "5", 5),
        (Number(0, 9), "1e3", 1000.0),  # its range is for check to judge
        (OrWord("hyperbola", Share()), "0.9", 0.9),
        (OrWord("hyperbola", Share()), "hyperbola", "hyperbola"),
        (OneOrSeveral(Integer(1, 9)), "1,2,4", (1, 2, 4)),
        (OneOrSeveral(Integer(1, 9)), "6", 6),
        (Optional(Number(1, 9)), "5", 5.0),
        (Choice(("a",)), "b", "b"),
    ],
    ids=repr,
)
def test_text_becomes_a_value(kind, text, value):
    assert kind.parse(text) == value


@pytest.mark.parametrize(
    "kind", [ODD, OrWord("word", Share()), OneOrSeveral(ODD), Optional(Number(1, 9))]
)
def test_other_text_is_a_value_error(kind):
    with pytest.raises(ValueError, match="x"):
        kind.parse("x")
    assert kind.described
