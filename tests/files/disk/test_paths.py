"""Names of files, with layers."""

import pytest

from stylit_ref import InputError
from stylit_ref.files.disk.paths import check_distinct, split_layer

LAYERS = ["", ":Combined", ":CryptoObject/ns:cube", ":a:b:c"]


@pytest.fixture
def file(tmp_path):
    (tmp_path / "a.exr").touch()
    return tmp_path / "a.exr"


@pytest.mark.parametrize("layer", LAYERS)
def test_a_layer_may_have_colons(file, layer):
    assert split_layer(f"{file}{layer}") == (file, layer[1:] or None)


def test_a_whole_name_goes_before_a_layer(file):
    (file.parent / "a.exr:b").touch()
    assert split_layer(f"{file}:b") == (file.parent / "a.exr:b", None)


@pytest.mark.parametrize("layer", LAYERS)
def test_no_output_in_place_of_an_input(file, layer):
    with pytest.raises(InputError, match=r"a\.exr: the output would overwrite this input"):
        check_distinct([file], [f"{file}{layer}"])
    check_distinct([file.with_name("b.exr")], [f"{file}{layer}", None])
