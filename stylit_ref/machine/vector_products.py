"""Eight sums of products of bytes with vector instructions: a small matrix times one pixel."""

from collections.abc import Callable

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

ROWS = 8

_I8, _I16, _I32, _I64 = (ir.IntType(bits) for bits in (8, 16, 32, 64))


def make_products(pairs: int) -> Callable[..., int]:
    """Build ``products(pixels, offset, matrix, offsets, shift)``.

    Parameters
    ----------
    pairs : int
        Half the number of a pixel's bytes.

    Returns
    -------
    intrinsic
        Called with a uint8 array and the offset of a pixel's first byte; the matrix, (pairs, 8, 2)
        int16; (8,) int32 offsets; and a shift (int32). Returns the eight bytes
        ``clip((matrix @ pixel + offsets) >> shift, 0, 255)``, the first the lowest, as uint64. Sums
        must fit int32.
    """

    @intrinsic
    def products(typing, pixels, offset, matrix, offsets, shift):
        signature = types.uint64(pixels, types.int64, matrix, offsets, types.int32)

        def codegen(context, builder, signature, args):
            def data(number):
                array = context.make_array(signature.args[number])(context, builder, args[number])
                return array.data

            def vector(pointer, element, count):
                kind = ir.VectorType(element, count).as_pointer()
                return builder.load(builder.bitcast(pointer, kind), align=1)

            def shuffled(value, lanes):
                mask = ir.Constant(ir.VectorType(_I32, len(lanes)), lanes)
                return builder.shuffle_vector(value, ir.Constant(value.type, ir.Undefined), mask)

            pixel = vector(builder.gep(data(0), [args[1]]), _I8, 2 * pairs)
            pixel = builder.zext(pixel, ir.VectorType(_I16, 2 * pairs))
            wide = ir.VectorType(_I32, 2 * ROWS)
            total = vector(data(3), _I32, ROWS)
            for pair in range(pairs):
                # A sum of neighbouring products of int16 is one instruction on most processors.
                both = shuffled(pixel, [2 * pair, 2 * pair + 1] * ROWS)
                row = builder.gep(data(2), [ir.Constant(_I64, 2 * ROWS * pair)])
                weights = vector(row, _I16, 2 * ROWS)
                product = builder.mul(builder.sext(both, wide), builder.sext(weights, wide))
                even = shuffled(product, list(range(0, 2 * ROWS, 2)))
                odd = shuffled(product, list(range(1, 2 * ROWS, 2)))
                total = builder.add(total, builder.add(even, odd))
            kind = total.type
            count = ir.Constant(kind, ir.Undefined)
            count = builder.insert_element(count, args[4], ir.Constant(_I32, 0))
            total = builder.ashr(total, shuffled(count, [0] * ROWS))
            for limit, beyond in ((0, "<"), (255, ">")):
                bound = ir.Constant(kind, [limit] * ROWS)
                total = builder.select(builder.icmp_signed(beyond, total, bound), bound, total)
            return builder.bitcast(builder.trunc(total, ir.VectorType(_I8, ROWS)), _I64)

        return signature, codegen

    return products
