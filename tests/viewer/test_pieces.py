"""Pieces of a page hold exactly what went in; here they are taken apart slowly."""

import io
import zlib

import numpy as np
from PIL import Image
from small_views import SIZE, cameras, field, mesh

from stylit_ref.viewer.fields import colours_of, differences_of, of_field
from stylit_ref.viewer.pieces import of_bytes, of_colours
from stylit_ref.viewer.points import SKY, of_points
from stylit_ref.views.interpolation.positions_geometry import positions_of_mesh


def unpacked(piece):
    return zlib.decompress(piece.packed, -zlib.MAX_WBITS)


def test_colours_come_back_and_carry_no_profile():
    colours = np.random.default_rng(0).integers(0, 256, (7, 9, 3), dtype=np.uint8)
    piece = of_colours("style", colours)
    assert np.array_equal(np.asarray(Image.open(io.BytesIO(piece.packed))), colours)
    assert piece.packed[12:16] == b"VP8L"  # lossless, with no other chunk before it
    assert (piece.size, piece.sum) == (colours.size, zlib.crc32(colours.tobytes()))


def test_what_is_too_long_for_a_webp_is_packed_as_bytes():
    colours = np.zeros((1, 16384, 3), np.uint8)
    piece = of_colours("style", colours)
    assert piece.coding == "deflate"
    assert unpacked(piece) == colours.tobytes()


def test_bytes_come_back():
    piece = of_bytes("mesh", bytes(range(256)))
    assert (unpacked(piece), piece.size) == (bytes(range(256)), 256)


def test_fields_of_twelve_bits_are_colours():
    nnf = np.array([[[0x123, 0xABC], [0xFFF, 0]]], np.int32)
    assert colours_of(nnf).tolist() == [[[0x23, 0xBC, 0xA1], [0xFF, 0, 0x0F]]]
    assert of_field("view", nnf, (4096, 4096)).coding == "webp"


def test_fields_of_wider_styles_are_differences():
    nnf = field(np.random.default_rng(0), style_size=(300, 40000))
    assert of_field("view", nnf, (300, 40000)).coding == "deflate"
    planes = np.frombuffer(differences_of(nnf), np.uint8).reshape(2, 2, *SIZE).astype(int)
    for axis, (low, high) in enumerate(planes):
        for y in range(SIZE[0]):
            for x in range(SIZE[1]):
                if x:
                    expected = nnf[y, x - 1, axis] + axis
                elif y:
                    expected = nnf[y - 1, x, axis] + 1 - axis
                else:
                    expected = axis
                told = (expected + low[y, x] + 256 * high[y, x]) % 65536
                assert told == nnf[y, x, axis]


def test_within_a_patch_differences_are_nothing():
    patch = np.stack(np.mgrid[5:12, 3:9], axis=-1).astype(np.int32)
    planes = np.frombuffer(differences_of(patch), np.uint8).reshape(4, 7, 6)
    assert planes[:, 0, 0].tolist() == [5, 0, 2, 0]
    assert np.count_nonzero(planes) == 2


def test_points_come_back():
    camera = cameras(1, 1)[0]
    positions = positions_of_mesh(mesh(), camera, SIZE)
    matrix = camera.matrix(SIZE)
    planes = np.frombuffer(unpacked(of_points("points", positions, matrix)), np.uint8)
    planes = planes.reshape(6, *SIZE).astype(np.uint32)
    steps = planes[0] | planes[1] << 8
    labels = np.cumsum(steps, axis=1) % 65536
    bends = planes[2] | planes[3] << 8 | planes[4] << 16 | planes[5] << 24
    bits = np.cumsum(np.cumsum(bends, axis=1, dtype=np.uint32), axis=1, dtype=np.uint32)
    inverse = bits.view(np.float32)
    expected = np.where(positions.labels < 0, SKY, positions.labels)
    assert np.array_equal(labels, expected)
    depth = positions.points.astype(float) @ matrix[2, :3] + matrix[2, 3]
    shown = positions.labels >= 0
    assert np.array_equal(inverse[shown], np.float32(1 / depth[shown]))
    assert not inverse[~shown].any()
