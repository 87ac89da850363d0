"""What can be set is what the parameters' classes take; the rest is refused in a sentence."""

from dataclasses import fields

import pytest

from stylit_ref.errors import InputError
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.studio.engine.parameters import DENSE, FIELDS, Settings
from stylit_ref.stylization.params import Params

BUFFERS = "FULL", "LDE", "IDMASK"


def field(name):
    (found,) = (each for each in FIELDS if each.name == name)
    return found


def test_every_parameter_of_the_live_frames_has_a_field():
    names = [each.name for each in fields(RealtimeParams)]
    assert [each.name for each in FIELDS] == [*names, *DENSE]
    assert Settings().values.keys() == {each.name for each in FIELDS}


@pytest.mark.parametrize(
    ("name", "kind", "least", "most"),
    [
        ("patch_width", "integer", 3, 13),
        ("mu", "several", 0, 16),
        ("iterations", "several", 0, 32),
        ("spacing", "integer", 2, 13),
        ("labels", "flag", None, None),
        ("uniformity", "number", 0, 50000),
    ],
)
def test_fields_say_what_a_slider_needs(name, kind, least, most):
    found = field(name)
    assert (found.kind, found.least, found.most) == (kind, least, most)
    assert found.of == ("dense" if name in DENSE else "live")
    assert found.help


def test_fields_say_what_is_odd_optional_or_chosen():
    assert field("patch_width").is_odd
    assert field("spacing").is_optional
    assert field("terms").choices == ("sums", "means")


def test_values_of_json_are_taken():
    values = {"mu": [0, 16], "patch_width": 7, "labels": False, "uniformity": 5000, "spacing": None}
    settings = Settings().with_parameters(values)
    assert settings.live == RealtimeParams(mu=(0, 16), patch_width=7, labels=False)
    assert settings.values["uniformity"] == 5000


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"mu": [4, 17]}, "mu of level 2 is 17; it must be an integer from 0 to 16"),
        ({"mu": []}, "mu is empty"),
        ({"mu": 4}, "mu is 4; it must be a list of numbers"),
        ({"mu": [[1], [2, 3]]}, "mu is .*; it must be a list of numbers"),
        ({"patch_width": 4}, "patch_width is 4; it must be an odd integer from 3 to 13"),
        ({"patch_width": "5"}, "patch_width is '5'; it must be an odd integer"),
        ({"labels": 1}, "labels is 1; it must be True or False"),
        ({"packing": {}}, "packing is {}; it must be"),
        ({"uniformity": float("nan")}, "uniformity is nan; it must be a number"),
        ({"uniformiti": 1}, "no parameter is called 'uniformiti'; did you mean uniformity?"),
        ({"method": "stylit"}, "no parameter is called 'method'"),
        ({"dense_finish": True, "scale_space": True}, "dense_finish compares patches"),
    ],
)
def test_bad_values_are_refused_in_a_sentence(values, sentence):
    with pytest.raises(InputError, match=sentence):
        Settings().with_parameters(values)


@pytest.mark.parametrize(
    ("weights", "sentence"),
    [
        ({"FULL": 9}, "the weight of FULL is 9; it must be an integer from 0 to 8"),
        ({"FULL": 0.5}, "the weight of FULL is 0.5; it must be an integer from 0 to 8"),
        ({"LD": 1}, "no buffer is called 'LD'; did you mean LDE?"),
    ],
)
def test_bad_weights_are_refused_in_a_sentence(weights, sentence):
    with pytest.raises(InputError, match=sentence):
        Settings().with_weights(weights, BUFFERS)


def test_the_dense_method_takes_the_patch_width_the_weights_and_its_own():
    settings = Settings().with_parameters({"patch_width": 7, "uniformity": 1, "levels": 2})
    settings = settings.with_weights({"LDE": 3}, BUFFERS)
    own = {"patch_width": 7, "uniformity": 1, "guide_weights": (1, 3, 1)}
    assert settings.dense_params("fast", BUFFERS) == Params(
        levels=7, votes=(1, 4, 6), patchmatch_iterations=1, **own
    )
    assert settings.dense_params("full", BUFFERS) == Params(levels="all", **own)
