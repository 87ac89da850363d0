"""B' is the mean of the patches over a pixel."""

import numpy as np
import pytest

from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.passes import make_blend, make_extend
from stylit_ref.realtime.passes.image import interior, make_image, whole
from stylit_ref.realtime.passes.moving import ALL

BORDER = 8


def blended(nnf, style, size, width, step):
    """Equation 17, pixel by pixel."""
    radius = width // 2
    out = np.zeros((*size, 3), np.uint8)
    for y, x in np.ndindex(size):
        colours = []
        for a, b in np.ndindex(nnf.shape):
            dy, dx = y - a * step, x - b * step
            # The last entries also serve what lies beyond them.
            last_row, last_column = a == nnf.shape[0] - 1, b == nnf.shape[1] - 1
            covers_y = abs(dy) <= radius or (last_row and dy > 0)
            covers_x = abs(dx) <= radius or (last_column and dx > 0)
            if covers_y and covers_x:
                sy, sx = (nnf[a, b] >> 16) + dy, (nnf[a, b] & 0xFFFF) + dx
                sy, sx = np.clip((sy, sx), 0, (style.shape[0] - 1, style.shape[1] - 1))
                colours.append(style[sy, sx].astype(int))
        assert len(colours) in (1, 2, 4)
        out[y, x] = (sum(colours) * (4 // len(colours)) + 2) >> 2
    return out


@pytest.mark.parametrize(
    ("width", "step", "size"),
    [(5, 3, (13, 17)), (5, 3, (1, 1)), (5, 3, (1, 9)), (3, 2, (8, 7)), (5, 5, (14, 9)),
     (7, 4, (12, 10)), (5, 4, (11, 11)), (13, 7, (20, 23))],
)  # fmt: skip
@pytest.mark.parametrize("channels", [3, 4])
def test_against_pixels_one_by_one(width, step, size, channels):
    random = np.random.default_rng(3)
    style = random.integers(0, 256, (19, 21, 3), np.uint8)
    image = make_image(19, 21, BORDER, STYLE_LANES)
    interior(image, STYLE_LANES)[..., :3] = style
    make_extend(STYLE_LANES)(image)
    grid = -(-size[0] // step), -(-size[1] // step)
    radius = width // 2
    y = random.integers(radius, 19 - radius, grid)
    x = random.integers(radius, 21 - radius, grid)
    nnf = (y << 16 | x).astype(np.int32)
    out = make_image(*size, BORDER if channels == 4 else 0, channels)
    make_blend(width, step, channels)(nnf, image, out, ALL)
    expected = blended(nnf, style, size, width, step)
    assert np.array_equal(interior(out, channels)[..., :3], expected)
    if channels == 4:
        padded = np.pad(expected, ((BORDER, BORDER), (BORDER, BORDER), (0, 0)), "edge")
        assert np.array_equal(whole(out, channels)[..., :3], padded)


@pytest.mark.parametrize(("width", "step"), [(3, 2), (5, 3), (5, 5), (7, 4), (13, 7)])
@pytest.mark.parametrize("size", [(20, 23), (19, 24), (1, 30), (30, 1)])
def test_what_does_not_move_is_left(width, step, size):
    """A blend of what moves, on top of one before, is that of everything."""
    random = np.random.default_rng(sum(size) + width)
    style = make_image(30, 31, 2 * BORDER, STYLE_LANES)
    interior(style, STYLE_LANES)[:] = random.integers(0, 256, (30, 31, 4))
    make_extend(STYLE_LANES)(style)
    grid = tuple(-(-side // step) for side in size)

    def entries():
        return (random.integers(6, 24, grid) << 16 | random.integers(6, 25, grid)).astype(np.int32)

    blend = make_blend(width, step, STYLE_LANES)
    whole_anew, in_part = (make_image(*size, BORDER, STYLE_LANES) for _ in range(2))
    before, after = entries(), entries()
    moving = np.uint8(random.random(grid) < 0.2)
    after[moving == 0] = before[moving == 0]
    blend(before, style, in_part, ALL)
    blend(after, style, in_part, moving)
    blend(after, style, whole_anew, ALL)
    assert np.array_equal(whole(in_part, STYLE_LANES), whole(whole_anew, STYLE_LANES))


def test_pixels_of_what_does_not_move_are_not_written():
    style = make_image(20, 20, BORDER, STYLE_LANES)
    out = make_image(12, 12, BORDER, STYLE_LANES)
    interior(out, STYLE_LANES)[:] = 7
    moving = np.zeros((4, 4), np.uint8)
    moving[1, 1] = 1
    make_blend(5, 3, STYLE_LANES)(np.full((4, 4), 9 << 16 | 9, np.int32), style, out, moving)
    written = (interior(out, STYLE_LANES) == 0).all(axis=-1)
    assert written[1:6, 0:6].all()
    assert written.sum() == 30
