"""Ask for memory before it is read. Changes no result."""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typing.context import BaseContext
from numba.core.typing.templates import Signature
from numba.extending import intrinsic

_I32 = ir.IntType(32)
_READ, _KEEP, _DATA = _I32(0), _I32(3), _I32(1)


@intrinsic
def prefetch(
    typing: BaseContext, array: types.Array, element: types.Integer
) -> tuple[Signature, Callable[..., Any]]:
    """Fetch the cache line of a C-contiguous array's flat ``element`` (int64)."""
    signature = types.void(array, types.int64)

    def codegen(context, builder, signature, args):
        data = context.make_array(signature.args[0])(context, builder, args[0]).data
        address = builder.bitcast(builder.gep(data, [args[1]]), cgutils.voidptr_t)
        function = cgutils.get_or_insert_function(
            builder.module,
            ir.FunctionType(ir.VoidType(), [address.type, _I32, _I32, _I32]),
            "llvm.prefetch.p0",
        )
        builder.call(function, [address, _READ, _KEEP, _DATA])
        return context.get_dummy_value()

    return signature, codegen
