"""Load and store a few neighbouring bytes of an array at once, wherever they lie."""

from collections.abc import Callable

from llvmlite import ir
from numba import types
from numba.extending import intrinsic


def make_load(bits: int) -> Callable[..., int]:
    """Build ``load(array, offset)``.

    Parameters
    ----------
    bits : {8, 16, 32}

    Returns
    -------
    intrinsic
        The bytes at an offset (int64) from the first byte of a uint8 array, the lowest first, as
        uint64.
    """

    @intrinsic
    def load(typing, array, offset):
        def codegen(context, builder, signature, args):
            value = builder.load(_pointer(context, builder, signature, args, bits), align=1)
            return builder.zext(value, ir.IntType(64))

        return types.uint64(array, types.int64), codegen

    return load


def make_store(bits: int) -> Callable[..., None]:
    """Build ``store(array, offset, value)``: the counterpart of :func:`make_load`.

    Parameters
    ----------
    bits : {8, 16, 32, 64}
        What is above them in the value (uint64) is dropped.
    """

    @intrinsic
    def store(typing, array, offset, value):
        def codegen(context, builder, signature, args):
            low = args[2] if bits == 64 else builder.trunc(args[2], ir.IntType(bits))
            builder.store(low, _pointer(context, builder, signature, args, bits), align=1)
            return context.get_dummy_value()

        return types.void(array, types.int64, types.uint64), codegen

    return store


def _pointer(context, builder, signature, args, bits):
    data = context.make_array(signature.args[0])(context, builder, args[0]).data
    return builder.bitcast(builder.gep(data, [args[1]]), ir.IntType(bits).as_pointer())
