"""Running sums with vector instructions, which no compiler finds by itself."""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core.typing.context import BaseContext
from numba.core.typing.templates import Signature
from numba.extending import intrinsic

LANES = 8

_I32 = ir.IntType(32)
_VECTOR = ir.VectorType(_I32, LANES)


@intrinsic
def add_up(
    typing: BaseContext, array: types.Array, first: types.Integer, total: types.Integer
) -> tuple[Signature, Callable[..., Any]]:
    """Replace 8 elements by their running sums on top of ``total``; returns the last.

    The elements of a C-contiguous int32 array, from the flat index ``first`` (int64). Sums of 2, 4
    and 8 neighbours are made of those of 1, 2 and 4, so one total waits only for the one before.
    """
    signature = types.int32(array, types.int64, types.int32)

    def codegen(context, builder, signature, args):
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        place = builder.bitcast(builder.gep(data, [args[1]]), _VECTOR.as_pointer())
        sums = builder.load(place, align=4)
        zeros = ir.Constant(_VECTOR, None)
        for distance in (1, 2, 4):
            # Lanes of `zeros` come first, those of `sums` behind.
            lanes = [LANES - distance + lane for lane in range(LANES)]
            moved = builder.shuffle_vector(zeros, sums, _lanes(lanes))
            sums = builder.add(sums, moved)
        everywhere = builder.insert_element(ir.Constant(_VECTOR, ir.Undefined), args[2], _I32(0))
        everywhere = builder.shuffle_vector(everywhere, zeros, _lanes([0] * LANES))
        builder.store(builder.add(sums, everywhere), place, align=4)
        return builder.add(builder.extract_element(sums, _I32(LANES - 1)), args[2])

    return signature, codegen


def _lanes(numbers):
    return ir.Constant(_VECTOR, numbers)
