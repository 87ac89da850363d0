"""Patches of uint8 pixels with vector instructions: widen one, compare others with it, blend four.

A patch is ``rows`` rows of ``pixels`` pixels of ``lanes`` bytes. What is compared with many others
is widened to int16 once, into a buffer whose rows are :func:`row_lanes` long; the weights of its
lanes are as long as a row and 0 at its end. Vectors read up to 64 bytes beyond the last pixel, so
arrays end with :data:`SLACK` spare bytes. The code uses LLVM's portable vector operations, which
compile for any processor.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numpy.typing import NDArray

from stylit_ref.machine.inlined import inlined

SLACK = 64
"""Spare bytes at the end of every array that vectors are loaded from."""

STYLE_LANES = 4
"""Bytes of a pixel of the style: three colours and a zero."""

_I8, _I16, _I32, _I64 = (ir.IntType(bits) for bits in (8, 16, 32, 64))


def row_lanes(pixels: int, lanes: int) -> int:
    """Elements of a row of a widened patch: a multiple of 16."""
    return -(-pixels * lanes // 16) * 16


@inlined
def alike_in_pairs(weights: NDArray[np.int16]) -> bool:
    """Whether each weight of even number equals the one after it."""
    alike = True
    for pair in range(np.uint64(weights.size // 2)):
        alike &= weights[np.uint64(2) * pair] == weights[np.uint64(2) * pair + np.uint64(1)]
    return alike


def make_patch_ssd(rows: int, length: int) -> Callable[..., int]:
    """Build ``ssd(a, offset, stride, patch, patch_offset, weights, alike)``.

    Parameters
    ----------
    rows : int
        0 is allowed; the sum is 0 then.
    length : int
        Elements of a row, a multiple of 16.

    Returns
    -------
    intrinsic
        Called with C-contiguous (n,) uint8 pixels, the offset of a first pixel and the bytes from
        row to row; a widened patch (int16) and the offset of its first row; (length,) int16 weights
        of at most 128, and :func:`alike_in_pairs` of them. Returns the int32 sum of
        ``weight * (a - patch)**2``.
    """

    def codegen_sum(context, builder, signature, args, alike):
        row_a = builder.gep(data_of(context, builder, signature, args, 0), [args[1]])
        row_b = builder.gep(data_of(context, builder, signature, args, 3), [args[4]])
        weighed = data_of(context, builder, signature, args, 5)
        sums = {}
        for row in range(rows):
            for start, count in _vectors(length):
                wide = ir.VectorType(_I16, count)
                difference = builder.sub(
                    builder.zext(load(builder, row_a, start, _I8, count), wide),
                    load(builder, row_b, start, _I16, count),
                )
                other = difference
                if not alike:
                    other = builder.mul(difference, load(builder, weighed, start, _I16, count))
                pairs = _pair_sums(builder, difference, other)
                key = start if alike else count
                sums[key] = builder.add(sums[key], pairs) if key in sums else pairs
            if row + 1 < rows:
                row_a = builder.gep(row_a, [args[2]])
                row_b = builder.gep(row_b, [_I64(length)])
        if alike:
            for start, pairs in sums.items():
                even = list(range(0, 2 * pairs.type.count, 2))
                weight = load(builder, weighed, start, _I16, len(even) * 2)
                weight = builder.zext(shuffled(builder, weight, weight, even), pairs.type)
                sums[start] = builder.mul(pairs, weight)
        return _sum_all(builder, sums.values())

    @intrinsic
    def ssd(typing, a, offset, stride, patch, patch_offset, weights, alike):
        signature = types.int32(
            a, types.int64, types.int64, patch, types.int64, weights, types.boolean
        )

        def codegen(context, builder, signature, args):
            if rows < 2:
                return codegen_sum(context, builder, signature, args, False)
            # Multiplying by weights is a fifth of the work, so whole columns are weighed if pairs
            # of bytes allow it.
            total = cgutils.alloca_once(builder, _I32)
            with builder.if_else(args[6]) as branches:
                for branch, alike in zip(branches, (True, False), strict=True):
                    with branch:
                        builder.store(codegen_sum(context, builder, signature, args, alike), total)
            return builder.load(total)

        return signature, codegen

    return ssd


def make_widen(rows: int, pixels: int, lanes: int) -> Callable[..., None]:
    """Build ``widen(patch, *guides, *style)``.

    Parameters
    ----------
    rows, pixels : int
    lanes : int
        Bytes of a pixel of ``guides``, of which the last four make room for the style; only the
        style is read if there are no others.

    Returns
    -------
    intrinsic
        Called with the patch to fill (int16) and, of the guides and of the style each, C-contiguous
        (n,) uint8 pixels, the offset of the first pixel and the bytes from row to row.
    """
    length = row_lanes(pixels, lanes)
    together = max(1, 32 // lanes) if 32 % lanes == 0 else 1  # as many as a later load reads

    @intrinsic
    def widen(typing, patch, guides, guide_offset, guide_stride, style, style_offset, style_stride):
        signature = types.void(
            patch, guides, types.int64, types.int64, style, types.int64, types.int64
        )

        def codegen(context, builder, signature, args):
            target = data_of(context, builder, signature, args, 0)
            guide = builder.gep(data_of(context, builder, signature, args, 1), [args[2]])
            colour = builder.gep(data_of(context, builder, signature, args, 4), [args[5]])
            for row in range(rows):
                if lanes == STYLE_LANES:
                    for start, count in _vectors(length):
                        bytes_of = load(builder, colour, start, _I8, count)
                        _store_wide(builder, target, row * length + start, bytes_of)
                else:
                    for pixel in range(0, pixels, together):
                        count = min(together, pixels - pixel)
                        own = load(builder, guide, pixel * lanes, _I8, count * lanes)
                        painted = load(
                            builder, colour, pixel * STYLE_LANES, _I8, count * STYLE_LANES
                        )
                        merged = _beside(builder, own, painted, count, lanes)
                        _store_wide(builder, target, row * length + pixel * lanes, merged)
                if row + 1 < rows:
                    guide = builder.gep(guide, [args[3]])
                    colour = builder.gep(colour, [args[6]])
            return context.get_dummy_value()

        return signature, codegen

    return widen


def make_blend_cell(left: tuple[bool, ...], right: tuple[bool, ...], channels: int) -> Callable:
    """Build ``blend_cell(out, offset, style, above_left, above_right, below_left, below_right)``.

    It blends one row of a cell of the grid, whose pixels are covered by patches to the left and to
    the right: the mean of the two rows' patches, rounded half up. Where one patch covers a pixel it
    counts twice.

    Parameters
    ----------
    left, right : tuple of bool
        Which pixels of a cell the patch on the left covers, and that on the right.
    channels : {3, 4}
        Bytes that are written a pixel.

    Returns
    -------
    intrinsic
        Called with the (n,) uint8 array to fill and an offset; (n,) uint8 pixels of the style, 4
        bytes each, and the offset of the cell's first pixel in each patch. It writes
        :func:`cell_bytes` bytes, those after the cell's pixels without a meaning.
    """
    pixels = _cell_pixels(len(left))
    count = pixels * STYLE_LANES
    covered = list(zip(left, right, strict=True)) + [(True, False)] * (pixels - len(left))
    pick_left, pick_right = (
        [
            lane + (0 if first else count)
            for pixel, sides in enumerate(covered)
            for first in [sides[0] if side == 0 else not sides[1]]
            for lane in range(pixel * STYLE_LANES, (pixel + 1) * STYLE_LANES)
        ]
        for side in (0, 1)
    )
    kept = [pixel * STYLE_LANES + c for pixel in range(pixels) for c in range(channels)]
    kept += [0] * (count - len(kept))

    @intrinsic
    def blend_cell(typing, out, offset, style, above_left, above_right, below_left, below_right):
        signature = types.void(
            out, types.int64, style, types.int64, types.int64, types.int64, types.int64
        )

        def codegen(context, builder, signature, args):
            pixels_of = data_of(context, builder, signature, args, 2)
            wide = ir.VectorType(_I16, count)
            total = ir.Constant(wide, [2] * count)
            for one, two in ((args[3], args[4]), (args[5], args[6])):
                one = load(builder, builder.gep(pixels_of, [one]), 0, _I8, count)
                two = load(builder, builder.gep(pixels_of, [two]), 0, _I8, count)
                for pick in (pick_left, pick_right):
                    taken = shuffled(builder, one, two, pick)
                    total = builder.add(total, builder.zext(taken, wide))
            mean = builder.lshr(total, ir.Constant(wide, [2] * count))
            mean = builder.trunc(mean, ir.VectorType(_I8, count))
            if channels < STYLE_LANES:
                mean = shuffled(builder, mean, mean, kept)
            target = builder.gep(data_of(context, builder, signature, args, 0), [args[1]])
            stored = builder.store(mean, builder.bitcast(target, mean.type.as_pointer()))
            stored.align = 1
            return context.get_dummy_value()

        return signature, codegen

    return blend_cell


def cell_bytes(step: int) -> int:
    """Bytes that ``blend_cell`` writes for a cell of ``step`` pixels."""
    return _cell_pixels(step) * STYLE_LANES


def _cell_pixels(step):
    return 1 << (step - 1).bit_length()


def _vectors(length):
    """Where each vector of a row begins, and its elements: 32, and 16 at the end."""
    starts = range(0, length, 32)
    return [(start, min(32, length - start)) for start in starts]


def data_of(context: Any, builder: Any, signature: Any, args: Any, index: int) -> Any:
    """The address of an array argument's elements."""
    return context.make_array(signature.args[index])(context, builder, args[index]).data


def load(builder: Any, pointer: Any, offset: int, element: Any, count: int) -> Any:
    """A vector from ``offset`` elements on, wherever it lies."""
    pointer = builder.gep(pointer, [_I64(offset)])
    value = builder.load(builder.bitcast(pointer, ir.VectorType(element, count).as_pointer()))
    value.align = 1
    return value


def _beside(builder, guides, style, count, lanes):
    """Pixels whose last four bytes are replaced by the style's."""
    size = count * lanes
    painted = range(count * STYLE_LANES)
    spread = shuffled(builder, style, style, [*painted, *[0] * (size - len(painted))])
    picked = [
        size + lane // lanes * STYLE_LANES + lane % lanes - (lanes - STYLE_LANES)
        if lane % lanes >= lanes - STYLE_LANES
        else lane
        for lane in range(size)
    ]
    return shuffled(builder, guides, spread, picked)


def _store_wide(builder, pointer, offset, vector):
    wide = builder.zext(vector, ir.VectorType(_I16, vector.type.count))
    pointer = builder.bitcast(builder.gep(pointer, [_I64(offset)]), wide.type.as_pointer())
    builder.store(wide, pointer).align = 2


def shuffled(builder: Any, a: Any, b: Any, lanes: list[int]) -> Any:
    """The elements of two vectors that have these numbers."""
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(_I32, len(lanes)), lanes))


def _sum_all(builder, vectors):
    """The sum of all elements of vectors of pair sums: those of 16 first, then those of 8."""
    total = None
    for vector in vectors:
        if total is not None and total.type.count > vector.type.count:
            total = _folded(builder, total)
        total = vector if total is None else builder.add(total, vector)
    if total is None:
        return _I32(0)
    if total.type.count > 8:
        total = _folded(builder, total)
    reduce_add = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(_I32, [total.type]), "llvm.vector.reduce.add.v8i32"
    )
    return builder.call(reduce_add, [total])


def _folded(builder, vector):
    """The sum of the two halves of a vector of 16."""
    low, high = (
        shuffled(builder, vector, vector, list(range(first, first + 8))) for first in (0, 8)
    )
    return builder.add(low, high)


def _pair_sums(builder, a, b):
    """Sums of neighbouring products of int16 vectors; processors have an instruction for it."""
    count = a.type.count
    wide = ir.VectorType(_I32, count)
    product = builder.mul(builder.sext(a, wide), builder.sext(b, wide))
    undefined = ir.Constant(wide, ir.Undefined)
    even, odd = (list(range(first, count, 2)) for first in (0, 1))
    return builder.add(
        shuffled(builder, product, undefined, even), shuffled(builder, product, undefined, odd)
    )
