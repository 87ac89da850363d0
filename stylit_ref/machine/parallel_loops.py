"""Share the turns of ``prange`` loops among threads.

As with Numba's ``parallel=True``, the loop becomes a function, which each thread calls with an
equal share of consecutive turns. Numba also looks for array expressions to share and to fuse, and
its function takes arrays with any strides. That takes longer than the rest of the compilation.
"""

from typing import Any

from llvmlite import ir as llvm
from numba import prange, types
from numba.core import ir
from numba.core.analysis import compute_cfg_from_blocks, compute_use_defs
from numba.core.cgutils import (
    alloca_once_value,
    for_range,
    get_or_insert_function,
    pack_struct,
    unpack_tuple,
    voidptr_t,
)
from numba.core.compiler import compile_ir
from numba.core.compiler_machinery import FunctionPass, PassManager, register_pass
from numba.core.ir_utils import fill_callee_prologue
from numba.core.postproc import PostProcessor
from numba.core.typed_passes import _reload_parfors
from numba.core.untyped_passes import WithLifting
from numba.extending import intrinsic

from stylit_ref.machine.parts import (
    KernelCompiler,
    PartCompiler,
    PartLibrary,
    new_library,
    part_flags,
)

_I64 = llvm.IntType(64)
_POINTER = _I64.as_pointer()
_ANY = voidptr_t
_RUN = llvm.FunctionType(llvm.VoidType(), [_ANY.as_pointer(), _POINTER, _POINTER, _ANY])
"""What Numba's threads call: the first of each argument's array, the numbers of turns, the steps
from turn to turn, and a pointer to anything."""


@register_pass(mutates_CFG=True, analysis_only=False)
class ShareLoops(FunctionPass):
    """Make functions of the ``prange`` loops, and have the threads call them.

    The arrays that a loop uses must not overlap where it writes; it raises nothing, and leaves no
    variables to the code behind it. A loop inside another is not shared again.
    """

    _name = "stylit_ref_share_loops"

    def __init__(self) -> None:  # abstract in Numba
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Take the loops out of a function."""
        func_ir = state.func_ir
        loops = compute_cfg_from_blocks(func_ir.blocks).loops().values()
        taken = set()
        for loop in sorted(loops, key=lambda loop: -len(loop.body)):
            [entry] = loop.entries
            call = None if entry in taken else _call_of_prange(func_ir.blocks[entry])
            if call:
                taken |= loop.body
                _take_out(state, loop, entry, call)
        if taken:
            PostProcessor(func_ir).run()
            state.typingctx.refresh()  # it gets to know the new intrinsics
            state.reload_init.append(_reload_parfors)
        return bool(taken)


def _call_of_prange(block):
    """The last statement of a block that calls ``prange``."""
    names, found = set(), None
    for assignment in block.find_insts(ir.Assign):
        value = assignment.value
        if isinstance(value, ir.Global | ir.FreeVar) and value.value is prange:
            names.add(assignment.target.name)
        elif isinstance(value, ir.Expr) and value.op == "call" and value.func.name in names:
            found = assignment
    return found


def _take_out(state, loop, entry, call):
    func_ir, blocks = state.func_ir, state.func_ir.blocks
    block, [after] = blocks[entry], loop.exits
    scope, loc = block.scope, block.loc
    place = block.body.index(call)
    before, start = block.body[:place], block.body[place + 1 :]
    body = {label: blocks.pop(label) for label in loop.body}
    flow = compute_use_defs(body)
    used = set().union(*flow.usemap.values(), *flow.defmap.values())
    made = {each.target.name for each in [call, *start] if isinstance(each, ir.Assign)}
    inputs = sorted(func_ir.variable_lifetime.livemap[loop.header] & used - made)

    def variable(name):
        return scope.redefine(f"$share_{name}", loc)

    first, last, counting, nothing = map(variable, ("first", "last", "range", "none"))
    counted = ir.Expr.call(counting, [first, last], (), loc)
    block_of_loop = ir.Block(scope, loc)
    block_of_loop.body = [
        ir.Assign(ir.Global("range", range, loc), counting, loc),
        ir.Assign(counted, call.target, loc),
        *start,
    ]
    end = ir.Block(scope, loc)
    end.body = [ir.Assign(ir.Const(None, loc), nothing, loc), ir.Return(nothing, loc)]
    names = (first.name, last.name, *inputs)
    begin = fill_callee_prologue(ir.Block(scope, loc), names, entry)
    share = func_ir.derive(
        {min(blocks) - 1: begin, entry: block_of_loop, **body, after: end},
        arg_count=len(names),
        arg_names=names,
    )
    PostProcessor(share).run()

    sharing, done = variable("all"), variable("done")
    values = [*call.value.args, *map(scope.get_exact, inputs)]
    block.body = [
        *before,
        ir.Assign(ir.Global("share", _make_share(share, state.flags), loc), sharing, loc),
        ir.Assign(ir.Expr.call(sharing, values, (), loc), done, loc),
        ir.Jump(after, loc),
    ]


def _make_share(func_ir, flags):
    """Build ``share(count, *inputs)``: have the threads call a loop's function."""

    @intrinsic
    def share(typing, count, *inputs):
        def codegen(context, builder, signature, values):
            count, inputs = values
            loop = _lowered(typing, context, func_ir, signature.args[1], flags)
            context.active_code_library.add_linking_library(loop.library)
            threads = _call(builder, "get_num_threads", _I64)
            parts = builder.select(builder.icmp_signed("<", count, threads), count, threads)
            shared = alloca_once_value(builder, pack_struct(builder, [count, parts, inputs]))
            run = _make_run(context, builder.module, loop, shared.type)
            # Argument 0 is no array: steps of 1 from address 0 give the number of the part.
            number = alloca_once_value(builder, llvm.Constant(_ANY, None))
            arguments = [
                number,
                alloca_once_value(builder, parts),
                alloca_once_value(builder, _I64(1)),
                builder.bitcast(shared, _ANY),
            ]
            with builder.if_else(builder.icmp_signed(">", parts, _I64(1))) as (several, one):
                with several:
                    function = builder.bitcast(run, _ANY)
                    arguments += [_I64(0), _I64(1), threads]
                    _call(builder, "numba_parallel_for", llvm.VoidType(), function, *arguments)
                with one:
                    builder.call(run, arguments[:4])
            return context.get_dummy_value()

        inputs = types.Tuple([types.unliteral(each) for each in inputs])
        return types.void(types.int64, inputs), codegen

    return share


def _lowered(typing, target, func_ir, inputs, flags):
    flags = part_flags(flags)
    flags.noalias = True
    return compile_ir(
        typing, target, func_ir, (types.int64, types.int64, *inputs), types.none, flags, {},
        library=new_library(PartLibrary, func_ir.func_id.func_qualname),
        pipeline_class=PartCompiler,
    )  # fmt: skip


def _make_run(context, module, loop, pointer):
    """Build the function that Numba's threads call for one part, or several."""
    run = llvm.Function(module, _RUN, module.get_unique_name("run"))
    run.linkage = "internal"
    builder = llvm.IRBuilder(run.append_basic_block())
    arguments, dimensions, _, data = run.args
    shared = builder.load(builder.bitcast(data, pointer))
    count, parts, inputs = unpack_tuple(builder, shared)
    inputs = [
        _without_count(context, builder, kind, value)
        for kind, value in zip(loop.signature.args[2:], unpack_tuple(builder, inputs), strict=True)
    ]
    number = builder.ptrtoint(builder.load(arguments), _I64)
    with for_range(builder, builder.load(dimensions)) as each:
        part = builder.add(number, each.index)
        bounds = [
            builder.sdiv(builder.mul(count, end), parts)
            for end in (part, builder.add(part, _I64(1)))
        ]
        context.call_internal_no_propagate(builder, loop.fndesc, loop.signature, [*bounds, *inputs])
    builder.ret_void()
    return run


def _without_count(context, builder, kind, value):
    """Arrays as no one counts who uses them: threads would wait for each other at the counts."""
    if isinstance(kind, types.Array):
        array = context.make_array(kind)(context, builder, value)
        array.meminfo, array.parent = (
            llvm.Constant(part.type, None) for part in (array.meminfo, array.parent)
        )
        return array._getvalue()
    if isinstance(kind, types.BaseTuple):
        for number, element in enumerate(kind):
            part = builder.extract_value(value, number)
            part = _without_count(context, builder, element, part)
            value = builder.insert_value(value, part, number)
    return value


def _call(builder, name, result, *values):
    kind = llvm.FunctionType(result, [value.type for value in values])
    return builder.call(get_or_insert_function(builder.module, kind, name), values)


class ParallelKernelCompiler(KernelCompiler):
    """Numba's compiler for kernels whose loops are shared among threads."""

    def define_pipelines(self) -> list[PassManager]:
        """The passes of a kernel, and :class:`ShareLoops` before its functions are looked up."""
        _reload_parfors()  # starts the threads, whose functions the code calls
        [manager] = super().define_pipelines()
        manager.add_pass_after(ShareLoops, WithLifting)
        manager.finalize()
        return [manager]
