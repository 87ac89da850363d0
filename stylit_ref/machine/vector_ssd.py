"""Weighted sums of squared differences with vector instructions.

The result is that of the triple loop of :func:`stylit_ref.formulae.patch_similarity.delta`, several
times faster. A row of patch pixels is contiguous in memory, so its bytes are loaded as vectors that
stay aligned to pixels: lane ``k`` of an accumulator always holds channels ``2k`` and ``2k + 1`` of
the packed pixel (multiply-add adds neighbours). Weights are equal within a pair
(:mod:`stylit_ref.metric.packing`), so they are applied once, at the end. The code uses LLVM's
portable vector operations, which compile for any processor.
"""

from collections.abc import Callable

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

LANES = 16  # elements of a vector load: as many as AVX2 holds after widening to 16 bits
_I16, _I32, _I64 = ir.IntType(16), ir.IntType(32), ir.IntType(64)


def make_weighted_ssd(
    rows: int, pixels: int, channels: int, element_bits: int, first_channel: int = 0
) -> Callable[..., int]:
    """Build ``weighted_ssd(a, a_offset, a_stride, b, b_offset, b_stride, pair_weights)``.

    Parameters
    ----------
    rows, pixels : int
        Height and width of the compared blocks.
    channels : int
        Elements a pixel, a multiple of 16.
    element_bits : {8, 16}
        8 for uint8 pixels; 16 for int16 moments (differences must fit int16).
    first_channel : int
        Vectors that end before this element of a pixel are left out. A vector that contains it
        counts as a whole, so the elements before it must have weight 0.

    Returns
    -------
    intrinsic
        Called in an ``@njit`` function with two C-contiguous arrays, the element
        offset of each block's first element and the elements between its rows, and
        the ``(channels / 2,)`` uint32 weights; returns the int64 sum
        ``Σ weight * (a - b)**2``.
    """
    groups = range(first_channel // LANES, channels // LANES)
    pair_sums = ir.VectorType(_I32, LANES // 2)
    even = ir.Constant(ir.VectorType(_I32, LANES // 2), list(range(0, LANES, 2)))
    odd = ir.Constant(ir.VectorType(_I32, LANES // 2), list(range(1, LANES, 2)))

    def load(builder, pointer, offset, element, lanes):
        pointer = builder.gep(pointer, [ir.Constant(_I64, offset)])
        vector = ir.VectorType(element, lanes)
        value = builder.load(builder.bitcast(pointer, vector.as_pointer()))
        value.align = 1
        return value

    def squared_pairs(builder, a, b, offset):
        wide = ir.VectorType(_I16, LANES)
        element = ir.IntType(element_bits)
        lanes_a = load(builder, a, offset, element, LANES)
        lanes_b = load(builder, b, offset, element, LANES)
        if element_bits == 8:
            lanes_a, lanes_b = builder.zext(lanes_a, wide), builder.zext(lanes_b, wide)
        difference = builder.sext(builder.sub(lanes_a, lanes_b), ir.VectorType(_I32, LANES))
        squared = builder.mul(difference, difference)
        undefined = ir.Constant(squared.type, ir.Undefined)
        return builder.add(
            builder.shuffle_vector(squared, undefined, even),
            builder.shuffle_vector(squared, undefined, odd),
        )

    def weigh(builder, accumulators, pair_weights):
        wide = ir.VectorType(_I64, LANES // 2)
        total = ir.Constant(wide, None)
        for group, accumulator in zip(groups, accumulators, strict=True):
            weights = load(builder, pair_weights, group * LANES // 2, _I32, LANES // 2)
            weighted = builder.mul(builder.zext(accumulator, wide), builder.zext(weights, wide))
            total = builder.add(total, weighted)
        reduce_add = cgutils.get_or_insert_function(
            builder.module,
            ir.FunctionType(_I64, [wide]),
            f"llvm.vector.reduce.add.v{LANES // 2}i64",
        )
        return builder.call(reduce_add, [total])

    @intrinsic
    def weighted_ssd(typing, a, a_offset, a_stride, b, b_offset, b_stride, pair_weights):
        signature = types.int64(
            a, types.int64, types.int64, b, types.int64, types.int64, pair_weights
        )

        def codegen(context, builder, signature, args):
            def data(index):
                make = context.make_array(signature.args[index])
                return make(context, builder, args[index]).data

            a, b = builder.gep(data(0), [args[1]]), builder.gep(data(3), [args[4]])
            accumulators = [
                cgutils.alloca_once_value(builder, ir.Constant(pair_sums, None)) for _ in groups
            ]
            with cgutils.for_range(builder, ir.Constant(_I64, rows)) as row:
                row_a = builder.gep(a, [builder.mul(row.index, args[2])])
                row_b = builder.gep(b, [builder.mul(row.index, args[5])])
                for group, accumulator in zip(groups, accumulators, strict=True):
                    total = None
                    for pixel in range(pixels):
                        offset = pixel * channels + group * LANES
                        squared = squared_pairs(builder, row_a, row_b, offset)
                        total = squared if total is None else builder.add(total, squared)
                    builder.store(builder.add(builder.load(accumulator), total), accumulator)
            return weigh(builder, [builder.load(x) for x in accumulators], data(6))

        return signature, codegen

    return weighted_ssd
