"""Pixels of a few bytes with vector instructions: copy, halve and interpolate them.

Vectors read and write beyond a pixel. So arrays end with
:data:`~stylit_ref.machine.vector_patch.SLACK` spare bytes, and pixels are written from the left to
the right.
"""

from collections.abc import Callable

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from stylit_ref.machine.vector_patch import data_of, load, shuffled

_I8, _I16 = ir.IntType(8), ir.IntType(16)


def pixels_at_once(lanes: int) -> int:
    """How many pixels of ``lanes`` bytes ``halve_pixels`` makes."""
    return max(16 // lanes, 1)


def make_spread_pixel(channels: int, lanes: int) -> Callable[..., None]:
    """Build ``spread_pixel(out, offset, pixels, pixel_offset)``.

    It copies ``channels`` bytes and adds zeros up to ``lanes``; it reads ``lanes`` bytes.
    """

    @intrinsic
    def spread_pixel(typing, out, offset, pixels, pixel_offset):
        signature = types.void(out, types.int64, pixels, types.int64)

        def codegen(context, builder, signature, args):
            source = builder.gep(data_of(context, builder, signature, args, 2), [args[3]])
            pixel = load(builder, source, 0, _I8, lanes)
            nothing = ir.Constant(pixel.type, None)
            kept = [k if k < channels else lanes for k in range(lanes)]
            _store(context, builder, signature, args, shuffled(builder, pixel, nothing, kept))
            return context.get_dummy_value()

        return signature, codegen

    return spread_pixel


def make_halve_pixels(lanes: int) -> Callable[..., None]:
    """Build ``halve_pixels(out, offset, pixels, upper, lower)``.

    The means of 2x2 pixels, rounded half up; ``upper`` and ``lower`` are the offsets of the first
    pixel of both rows. It makes :func:`pixels_at_once` of them.
    """
    count = pixels_at_once(lanes) * lanes
    first = [lane // lanes * 2 * lanes + lane % lanes for lane in range(count)]
    second = [lane + lanes for lane in first]

    @intrinsic
    def halve_pixels(typing, out, offset, pixels, upper, lower):
        signature = types.void(out, types.int64, pixels, types.int64, types.int64)

        def codegen(context, builder, signature, args):
            data = data_of(context, builder, signature, args, 2)
            wide = ir.VectorType(_I16, count)
            total = ir.Constant(wide, [2] * count)
            for row in args[3:5]:
                pair = load(builder, builder.gep(data, [row]), 0, _I8, 2 * count)
                for side in (first, second):
                    total = builder.add(
                        total, builder.zext(shuffled(builder, pair, pair, side), wide)
                    )
            mean = builder.lshr(total, ir.Constant(wide, [2] * count))
            _store(
                context, builder, signature, args, builder.trunc(mean, ir.VectorType(_I8, count))
            )
            return context.get_dummy_value()

        return signature, codegen

    return halve_pixels


def make_double_pixel(lanes: int) -> Callable[..., None]:
    """Build ``double_pixel(out, offset, pixels, near, far)``.

    Two neighbours of the next finer level, interpolated with the weights 9, 3, 3 and 1 from the
    pixels before, at and after ``near``, and those of ``far``, the nearest other row.
    """

    @intrinsic
    def double_pixel(typing, out, offset, pixels, near, far):
        signature = types.void(out, types.int64, pixels, types.int64, types.int64)

        def codegen(context, builder, signature, args):
            data = data_of(context, builder, signature, args, 2)
            wide = ir.VectorType(_I16, lanes)

            def column(k):
                """Three parts of the near row and one of the far row."""
                a, b = (
                    builder.zext(
                        load(builder, builder.gep(data, [row]), k * lanes, _I8, lanes), wide
                    )
                    for row in args[3:5]
                )
                return builder.add(builder.mul(a, ir.Constant(wide, [3] * lanes)), b)

            before, here, after = (column(k) for k in (-1, 0, 1))
            here = builder.mul(here, ir.Constant(wide, [3] * lanes))
            halves = []
            for beside in (before, after):
                total = builder.add(builder.add(here, beside), ir.Constant(wide, [8] * lanes))
                mean = builder.lshr(total, ir.Constant(wide, [4] * lanes))
                halves.append(builder.trunc(mean, ir.VectorType(_I8, lanes)))
            _store(
                context, builder, signature, args,
                shuffled(builder, *halves, list(range(2 * lanes))),
            )  # fmt: skip
            return context.get_dummy_value()

        return signature, codegen

    return double_pixel


def _store(context, builder, signature, args, vector):
    target = builder.gep(data_of(context, builder, signature, args, 0), [args[1]])
    builder.store(vector, builder.bitcast(target, vector.type.as_pointer())).align = 1
