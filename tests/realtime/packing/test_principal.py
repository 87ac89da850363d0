"""Principal components: exact integers, and distances that stay what they were."""

import numpy as np
import pytest

from data_gen.manifest import Manifest
from eval.documents.heidrich.house import BUFFERS, all_channels, rank_correlations
from eval.scenes import BUNDLED
from stylit_ref import read_uint8
from stylit_ref.realtime.packing import PrincipalPacking, StagePacking, UnpackedStage, pack
from stylit_ref.realtime.packing.principal import SHIFT, principal_axes

HOUSE = (*BUFFERS, "IDMASK")


def random_buffers(size, seed=0):
    rng = np.random.default_rng(seed)
    buffers = {name: rng.integers(0, 256, (*size, 3), dtype=np.uint8) for name in ("LDE", "NORMAL")}
    buffers["DEPTH"] = rng.integers(0, 256, size, dtype=np.uint8)
    buffers["IDMASK"] = 85 * rng.integers(0, 2, (*size, 3), dtype=np.uint8)
    return buffers


def read(view, names):
    manifest = Manifest.read(BUNDLED)
    return {name: read_uint8(manifest.path(f"{view}/{name}.png")).squeeze() for name in names}


def projected(packing, buffers, y, x):
    """The formula of the class, one pixel, in Python's integers."""
    pixel = [int(v) for name, _ in packing.buffers for v in np.atleast_1d(buffers[name][y, x])]
    sums = (
        sum(int(a) * v for a, v in zip(axis, pixel, strict=True)) + int(offset)
        for axis, offset in zip(packing.axes, packing.offsets, strict=True)
    )
    return [min(max(total >> SHIFT, 0), 255) for total in sums]


@pytest.mark.parametrize("size", [(1, 1), (1, 9), (7, 1), (11, 8)])
def test_a_frame_is_projected_in_integers(size):
    packing = PrincipalPacking.of_source(random_buffers((20, 20)))
    target = random_buffers(size, seed=1)
    image = np.full((*size, 16), 77, np.uint8)
    packing.pack_into(target, image[:, :, :8])
    for y, x in np.ndindex(size):
        assert image[y, x, :8].tolist() == projected(packing, target, y, x)
    assert (image[:, :, 8:] == 77).all()


@pytest.mark.parametrize("shapes", [((5, 6),), ((5, 6, 3),) * 3, ((5, 6, 3),) * 10 + ((5, 6),) * 2])
def test_any_number_of_channels_is_projected(shapes):
    rng = np.random.default_rng(len(shapes))
    buffers = {
        f"B{number}": rng.integers(0, 256, shape, dtype=np.uint8)
        for number, shape in enumerate(shapes)
    } | {"IDMASK": np.zeros((5, 6, 3), np.uint8)}
    packing = PrincipalPacking.of_source(buffers)
    features, _ = pack(packing, buffers)
    assert features[4, 5].tolist() == projected(packing, buffers, 4, 5)


def test_labels_are_the_numbers_of_the_sources_colours():
    source = random_buffers((4, 6))
    source["IDMASK"][:] = 0
    source["IDMASK"][0, 0], source["IDMASK"][1, 1] = (0, 0, 9), (200, 0, 0)
    packing = PrincipalPacking.of_source(source)
    target = random_buffers((4, 6), seed=1)
    target["IDMASK"][:] = 7
    target["IDMASK"][2, 3:], target["IDMASK"][3, :2] = (0, 0, 9), (200, 0, 0)
    target["IDMASK"][0, 5] = 0
    expected = np.zeros((4, 6), np.uint8)
    expected[0, 5], expected[3, :2], expected[2, 3:] = 1, 2, 3
    np.testing.assert_array_equal(pack(packing, target)[1], expected)


def test_axes_of_a_known_cloud():
    """Two channels that move together, one that moves less, one that stands still."""
    steps = np.arange(101)
    along, across = np.meshgrid(steps, steps[:21], indexing="ij")
    still = np.full(along.size, 40)
    pixels = np.stack([along.ravel(), 200 - along.ravel(), 4 * across.ravel(), still], axis=-1)
    axes, offsets = principal_axes(pixels.astype(np.uint8))
    one, half = 1 << SHIFT, round((1 << SHIFT) / np.sqrt(2))
    assert axes.tolist()[:2] == [[half, -half, 0, 0], [0, 0, one, 0]]
    assert not axes[2:].any()
    assert (offsets[2:] == 128 * one).all()
    middle = [(axes[k].astype(int) @ (50, 150, 40, 40) + offsets[k]) / one for k in (0, 1)]
    assert middle == pytest.approx([128, 128], abs=0.01)  # 127.5 and the half that rounds


def test_the_widest_component_fits_eight_bits():
    pixels = np.zeros((2, 9), np.uint8)
    pixels[1] = 255
    axes, offsets = principal_axes(pixels)
    ends = (pixels.astype(int) @ axes.T.astype(int) + offsets) >> SHIFT
    assert sorted(ends[:, 0].tolist()) == [0, 255]


def test_signs_do_not_depend_on_the_solver(monkeypatch):
    pixels = np.random.default_rng(0).integers(0, 256, (500, 6), dtype=np.uint8)
    eigh = np.linalg.eigh

    def mirrored(matrix):
        values, vectors = eigh(matrix)
        return values, -vectors

    expected = principal_axes(pixels)
    monkeypatch.setattr(np.linalg, "eigh", mirrored)
    for ours, theirs in zip(expected, principal_axes(pixels), strict=True):
        np.testing.assert_array_equal(ours, theirs)


def test_a_source_of_one_colour_has_no_components():
    flat = {"LDE": np.full((3, 3, 3), 9, np.uint8), "IDMASK": np.zeros((3, 3, 3), np.uint8)}
    packing = PrincipalPacking.of_source(flat)
    assert not packing.axes.any()
    assert (pack(packing, flat)[0] == 128).all()


def test_distances_in_the_house_keep_their_order():
    views = [read(view, HOUSE) for view in ("house/source", "house/1_1")]
    packing = PrincipalPacking.of_source(views[0])
    packed = (pack(packing, view)[0] for view in views)
    every, nearest = rank_correlations(*map(all_channels, views), *packed)
    assert every > 0.999
    assert nearest > 0.985


def test_distances_on_the_stage_keep_their_order():
    views = [read(view, StagePacking.names) for view in ("source", "golem")]
    whole, packed = (
        [pack(packing, view)[0] for view in views] for packing in (UnpackedStage(), StagePacking())
    )
    every, nearest = rank_correlations(*whole, *packed)
    assert every > 0.98
    assert nearest > 0.98
