"""Pieces of a page hold exactly what went in; here they are taken apart slowly."""

import io
import zlib

import numpy as np
import pytest
from PIL import Image
from small_views import SIZE, cameras, field, mesh

from stylit_ref.viewer.embedding import ascii_text, embedded
from stylit_ref.viewer.fields import BEFORE, NEW, field_bytes, of_field, origins_of
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


def test_bytes_are_packed_as_it_is_best():
    content = bytes(1000)
    strategies = zlib.Z_HUFFMAN_ONLY, zlib.Z_RLE
    piece = of_bytes("field", content, strategies)
    assert unpacked(piece) == content
    sizes = [len(of_bytes("field", content, (strategy,)).packed) for strategy in strategies]
    assert len(piece.packed) == min(sizes) < max(sizes)


def taken_apart(content, size):
    """A field from its bytes, pixel by pixel."""
    pixels = size[0] * size[1]
    origins, planes = content[:pixels], content[pixels:]
    count = origins.count(NEW)
    low, middle_y, middle_x = (planes[k * count : (k + 1) * count] for k in range(3))
    high = planes[3 * count :] or bytes(count)
    nnf, new, last = np.zeros((*size, 2), int), iter(range(count)), (0, 0)
    for p, origin in enumerate(origins):
        y, x = divmod(p, size[1])
        if origin == NEW:
            n = next(new)
            folded = (
                low[n] & 15 | middle_y[n] << 4 | (high[n] & 15) << 12,
                low[n] >> 4 | middle_x[n] << 4 | high[n] >> 4 << 12,
            )
            steps = [-(each + 1) // 2 if each % 2 else each // 2 for each in folded]
            last = np.add(last, steps) % 65536
        else:
            down, right = BEFORE[origin]
            last = nnf[y + down, x + right] - (down, right)
        nnf[y, x] = last
    return nnf


@pytest.mark.parametrize("style_size", [(50, 40), (300, 40000), (65536, 65536)])
def test_fields_come_back(style_size):
    nnf = field(np.random.default_rng(0), style_size=style_size)
    piece = of_field("view", nnf)
    assert np.array_equal(taken_apart(unpacked(piece), SIZE), nnf)
    has_high = piece.size - nnf[..., 0].size == 4 * np.count_nonzero(origins_of(nnf) == NEW)
    assert has_high == (max(style_size) > 4096)


def test_a_patch_goes_on_from_the_closest_pixel():
    patch = np.stack(np.mgrid[5:12, 3:9], axis=-1).astype(np.int32)
    origins = origins_of(patch)
    assert origins[0, 0] == NEW
    assert not origins[:, 1:].any()
    assert (origins[1:, 0] == BEFORE.index((-1, 0))).all()
    assert field_bytes(patch)[patch[..., 0].size :] == bytes([10 | 6 << 4, 0, 0])


@pytest.mark.parametrize("origin", range(NEW))
def test_every_pixel_before_may_be_gone_on_from(origin):
    nnf = np.random.default_rng(origin).permutation(2 * 25).reshape(5, 5, 2).astype(np.int32) * 99
    down, right = BEFORE[origin]
    nnf[2, 2] = nnf[2 + down, 2 + right] - (down, right)
    assert origins_of(nnf)[2, 2] == origin
    assert np.array_equal(taken_apart(field_bytes(nnf), (5, 5)), nnf)


def test_every_byte_is_embedded_as_itself_or_behind_an_escape():
    content = bytes(range(256)) * 2
    page = embedded(content).encode("latin-1")
    assert not set(page) & set(b"\0\r<")
    assert len(page) == len(content) + 2 * 4
    rest = iter(page)
    taken = bytes(next(rest) - 64 if byte == ord("=") else byte for byte in rest)
    assert taken == content


def test_titles_are_told_in_ascii():
    assert ascii_text("Haus – 家") == "Haus &#8211; &#23478;"


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
