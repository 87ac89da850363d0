"""Ask the memory for bytes that are read soon, so that several requests are under way at once."""

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

from stylit_ref.machine.vector_patch import data_of

_TO_READ, _OFTEN, _DATA = 0, 3, 1


@intrinsic
def prefetch(typing: Any, array: Any, index: Any) -> Any:
    """Ask for the cache line of ``array[index]``, of a C-contiguous (n,) array; no value returns.

    An index that is not in the array does no harm.
    """
    signature = types.void(array, types.int64)

    def codegen(context, builder, signature, args):
        address = builder.gep(data_of(context, builder, signature, args, 0), [args[1]])
        number = ir.IntType(32)
        request = cgutils.get_or_insert_function(
            builder.module,
            ir.FunctionType(ir.VoidType(), [address.type, number, number, number]),
            "llvm.prefetch.p0",
        )
        builder.call(request, [address, number(_TO_READ), number(_OFTEN), number(_DATA)])
        return context.get_dummy_value()

    return signature, codegen
