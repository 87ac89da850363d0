"""The random words of sixteen neighbouring pixels at once, with vector instructions."""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core.typing.context import BaseContext
from numba.core.typing.templates import Signature
from numba.extending import intrinsic

from stylit_ref.randomness import philox

LANES = 16

_I32, _I64 = ir.IntType(32), ir.IntType(64)
_WORDS, _PRODUCTS = ir.VectorType(_I32, LANES), ir.VectorType(_I64, LANES)


@intrinsic
def neighbouring_words(
    typing: BaseContext,
    words: types.Array,
    stream: types.UniTuple,
    position: types.Integer,
    draw: types.Integer,
) -> tuple[Signature, Callable[..., Any]]:
    """Write the draw of the pixels ``position``, ``position + 1``, ... into (4, 16) uint32 words.

    Pixel by pixel it is :func:`stylit_ref.randomness.random_stream.random_words`.
    """
    signature = types.void(words, stream, types.uint32, types.uint32)

    def codegen(context, builder, signature, args):
        words = context.make_array(signature.args[0])(context, builder, args[0]).data

        def everywhere(value):
            undefined = ir.Constant(_WORDS, ir.Undefined)
            first = builder.insert_element(undefined, value, _I32(0))
            return builder.shuffle_vector(first, undefined, ir.Constant(_WORDS, [0] * LANES))

        def halves(counter, multiplier):
            wide = ir.Constant(_PRODUCTS, [int(multiplier)] * LANES)
            product = builder.mul(builder.zext(counter, _PRODUCTS), wide)
            high = builder.lshr(product, ir.Constant(_PRODUCTS, [32] * LANES))
            return builder.trunc(high, _WORDS), builder.trunc(product, _WORDS)

        lanes = ir.Constant(_WORDS, list(range(LANES)))
        streams = [everywhere(builder.extract_value(args[1], n)) for n in range(4)]
        c0, c1 = builder.add(everywhere(args[2]), lanes), everywhere(args[3])
        c2, c3, k0, k1 = streams
        for _ in range(philox.ROUNDS):
            high_0, low_0 = halves(c0, philox.MULTIPLIER_0)
            high_1, low_1 = halves(c2, philox.MULTIPLIER_1)
            c0 = builder.xor(builder.xor(high_1, c1), k0)
            c2 = builder.xor(builder.xor(high_0, c3), k1)
            c1, c3 = low_1, low_0
            k0 = builder.add(k0, ir.Constant(_WORDS, [int(philox.WEYL_0)] * LANES))
            k1 = builder.add(k1, ir.Constant(_WORDS, [int(philox.WEYL_1)] * LANES))
        for n, word in enumerate((c0, c1, c2, c3)):
            place = builder.gep(words, [ir.Constant(_I64, n * LANES)])
            builder.store(word, builder.bitcast(place, _WORDS.as_pointer()), align=4)
        return context.get_dummy_value()

    return signature, codegen
