"""Mattes from Cryptomatte layers, which the tests write as a renderer does."""

import json
import logging

import numpy as np
import pytest
from exr_files import write_exr

from stylit_ref import InputError, read_image, read_uint8
from stylit_ref.files.layers.cryptomatte import id_of
from stylit_ref.files.read_image import read_mask

NAMES = "Suzanne", "Plane.001", "ns:cube/left"


@pytest.mark.parametrize(
    ("name", "as_float"),
    [
        ("hello", 6.0705627102400005616e-17),
        ("cube", -4.08461912519e15),
        ("sphere", 2.79018604383e15),
        ("plane", 3.66557617593e-11),
        ("равнина", -1.3192631212399999468e-25),
        ("mädchen", 6.2361298211599995797e25),
    ],
)
def test_the_specifications_values(name, as_float):
    assert np.uint32(id_of(name)).view(np.float32) == np.float32(as_float)


@pytest.mark.parametrize(
    ("name", "number"), [("Plane", "4159b52a"), ("Plane.001", "8e5d0412"), ("Sphere", "e5e9b0db")]
)
def test_the_ids_that_blender_writes(name, number):
    assert f"{id_of(name):08x}" == number


def test_an_id_is_an_ordinary_float():
    """Of 20000 names some hundred have a hash that is none."""
    ids = np.uint32([id_of(str(n)) for n in range(20000)])
    floats = np.abs(ids.view(np.float32))
    assert ((floats >= np.finfo(np.float32).tiny) & np.isfinite(floats)).all()


@pytest.fixture
def coverage():
    """How much each object covers, of every pixel."""
    shares = np.random.default_rng(0).dirichlet((1, 1, 1), (6, 8)).astype(np.float32)
    shares[2, 3] = 1, 0, 0
    return dict(zip(NAMES, np.moveaxis(shares, 2, 0), strict=True))


@pytest.fixture
def write_scene(tmp_path, coverage):
    """Writes the coverages in ranks, the most covering object first in each pixel."""

    def write(manifest, layer="ViewLayer.CryptoObject", name="scene.exr"):
        ids = np.uint32([id_of(name) for name in coverage]).view(np.float32)
        shares = np.stack(list(coverage.values()), axis=2)
        order = np.argsort(-shares, axis=2)
        pairs = np.stack([ids[order], np.take_along_axis(shares, order, axis=2)], axis=3)
        flat = np.dstack([pairs.reshape(6, 8, 6), np.zeros((6, 8, 2), np.float32)])
        channels = {f"{layer}{k // 4:02}.{'rgba'[k % 4]}": flat[:, :, k] for k in range(8)}
        attributes = {"cryptomatte/542cafa/name": layer}
        if isinstance(manifest, str):
            attributes["cryptomatte/542cafa/manif_file"] = manifest
        elif manifest:
            listed = {name: f"{id_of(name):08x}" for name in manifest}
            attributes["cryptomatte/542cafa/manifest"] = json.dumps(listed)
        channels |= {f"ViewLayer.Combined.{c}": 0.5 for c in "RGB"}
        return write_exr(tmp_path / name, channels, depth="float", attributes=attributes)

    return write


@pytest.mark.parametrize("manifest", [NAMES, ()], ids=["manifest", "hash"])
@pytest.mark.parametrize("name", NAMES)
def test_a_matte_is_the_coverage_of_its_object(write_scene, coverage, manifest, name):
    matte = read_image(f"{write_scene(manifest)}:CryptoObject/{name}")
    assert matte.dtype == np.float32
    np.testing.assert_allclose(matte[:, :, 0], coverage[name], rtol=1e-6)


@pytest.mark.parametrize(
    "layer", ["ViewLayer.CryptoObject", "CryptoObject", "cryptoobject", "CryptoObject00"]
)
def test_the_layer_goes_by_its_name_or_its_end(write_scene, coverage, layer):
    matte = read_image(f"{write_scene(NAMES)}:{layer}/Suzanne")
    np.testing.assert_allclose(matte[:, :, 0], coverage["Suzanne"], rtol=1e-6)


def test_a_layer_that_only_the_header_tells_is_one(write_scene, coverage):
    matte = read_image(f"{write_scene(NAMES, layer='Objects')}:Objects/Suzanne")
    np.testing.assert_allclose(matte[:, :, 0], coverage["Suzanne"], rtol=1e-6)


def test_a_matte_is_data(write_scene, coverage):
    path = f"{write_scene(NAMES)}:CryptoObject/Suzanne"
    expected = np.floor(coverage["Suzanne"].astype(np.float64) * 255 + 0.5)
    np.testing.assert_allclose(read_uint8(path)[:, :, 0], expected, atol=1)
    np.testing.assert_array_equal(read_mask(path), coverage["Suzanne"] >= 0.5)


@pytest.mark.parametrize("what", ["CryptoObject", "ViewLayer.CryptoObject01", "CryptoObject00.r"])
def test_hashes_are_no_picture(write_scene, what):
    file = write_scene(NAMES)
    with pytest.raises(InputError) as refusal:
        read_image(f"{file}:{what}")
    assert refusal.value.sentence == (
        f"{file}:{what}: is a Cryptomatte, which holds hashes of names; write "
        f"{file}:ViewLayer.CryptoObject/Suzanne for the matte of one; its names are: "
        "Suzanne, Plane.001, ns:cube/left"
    )


def test_an_unknown_name_lists_those_there_are(write_scene):
    with pytest.raises(InputError, match=r"has no 'Susan'; its names are: Suzanne, Plane\.001"):
        read_image(f"{write_scene(NAMES)}:CryptoObject/Susan")


def test_an_unknown_name_where_none_is_listed(write_scene):
    said = "no pixel of ViewLayer.CryptoObject is of 'Susan', and the file does not list its names"
    with pytest.raises(InputError, match=said):
        read_image(f"{write_scene(())}:CryptoObject/Susan")


def test_a_long_list_of_names_is_cut(write_scene):
    file = write_scene([f"leaf{n}" for n in range(5000)])
    with pytest.raises(InputError, match=r"names are: leaf0, .*, leaf29 and 4970 more$"):
        read_image(f"{file}:CryptoObject/Susan")


def test_an_object_out_of_sight_is_noted(write_scene, caplog):
    path = f"{write_scene((*NAMES, 'Camera'))}:CryptoObject/Camera"
    assert not read_image(path).any()
    assert caplog.record_tuples == [("stylit_ref", logging.WARNING, f"{path}: covers no pixel")]


@pytest.mark.parametrize("manifest", ["{", "[]", '{"a": 1}', '{"a": "xyz"}', "{}"])
def test_a_broken_list_of_names_is_none(tmp_path, manifest):
    channels = {f"Crypto00.{c}": 0.0 for c in "rgba"} | {"R": 0.5}
    said = {"cryptomatte/1/name": "Crypto", "cryptomatte/1/manifest": manifest}
    file = write_exr(tmp_path / "a.exr", channels, depth="float", attributes=said)
    with pytest.raises(InputError, match="and the file does not list its names"):
        read_image(f"{file}:Crypto/a")


class TestNamesBesideTheFile:
    LISTED = json.dumps({name: f"{id_of(name):08x}" for name in (*NAMES, "Camera")})

    def test_they_are_read(self, write_scene, coverage, tmp_path):
        (tmp_path / "names.json").write_text(self.LISTED)
        path = f"{write_scene('names.json')}:CryptoObject"
        matte = read_image(f"{path}/Suzanne")
        np.testing.assert_allclose(matte[:, :, 0], coverage["Suzanne"], rtol=1e-6)
        with pytest.raises(InputError, match=r"its names are: Suzanne, .*, Camera$"):
            read_image(f"{path}/Susan")

    def test_in_a_folder_below(self, write_scene, tmp_path):
        (tmp_path / "names").mkdir()
        (tmp_path / "names" / "a.json").write_text(self.LISTED)
        with pytest.raises(InputError, match=r"its names are: Suzanne, .*, Camera$"):
            read_image(f"{write_scene('names/a.json')}:CryptoObject/Susan")

    @pytest.mark.parametrize("sidecar", ["../names.json", "{}/names.json", "link.json"])
    def test_not_from_outside_its_folder(self, write_scene, tmp_path, sidecar):
        (tmp_path / "names.json").write_text(self.LISTED)
        (tmp_path / "scene").mkdir()
        (tmp_path / "scene" / "link.json").symlink_to("../names.json")
        sidecar = sidecar.format(tmp_path)
        file = write_scene(sidecar, name="scene/scene.exr")
        said = f"{sidecar} with its names lies outside its folder"
        assert self.sentence(file).endswith(said)

    @pytest.mark.parametrize(
        ("content", "said"),
        [
            (None, "there is no names.json with its names beside it"),
            (b"{", "names.json beside it does not list its names"),
            (b"\xff\xfe", "names.json beside it does not list its names"),
            (b"[" * 100_000, "names.json beside it does not list its names"),
        ],
        ids=["missing", "broken", "no text", "deep"],
    )
    def test_not_where_there_are_none(self, write_scene, tmp_path, content, said):
        if content is not None:
            (tmp_path / "names.json").write_bytes(content)
        assert self.sentence(write_scene("names.json")).endswith(said)

    def sentence(self, file):
        assert read_image(f"{file}:Combined").size, "other layers need no names"
        with pytest.raises(InputError) as refused:
            read_image(f"{file}:CryptoObject/Susan")
        return refused.value.sentence
