"""Functions that kernels call become parts of the kernels' modules.

Numba compiles each of them as if a program called it: it optimizes it, makes machine code of it
and wraps it for Python. Then it links it into the kernel, inlines it and optimizes all of it again.
Parts are only optimized, once in a process, and machine code is made of whole kernels. A
function that a program calls by itself is compiled by Numba as ever.
"""

from typing import Any
from weakref import WeakKeyDictionary

from llvmlite.binding import Linkage
from numba import types
from numba.core import ir
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import CompilerBase, DefaultPassBuilder, Flags, compile_extra
from numba.core.compiler_machinery import FunctionPass, PassManager, register_pass
from numba.core.registry import CPUDispatcher, cpu_target
from numba.core.typed_passes import NopythonRewrites
from numba.core.untyped_passes import InlineClosureLikes, InlineInlinables

_NEEDLESS = InlineClosureLikes, NopythonRewrites
"""Passes for functions in functions and for array expressions, which kernels have not."""

_parts: WeakKeyDictionary[CPUDispatcher, "_Part"] = WeakKeyDictionary()


class KernelLibrary(JITCodeLibrary):
    """The code of a kernel."""

    def _optimize_final_module(self):
        """Keep all functions to the kernel but the one that is called.

        LLVM changes the arguments of a function that no other code can call. Its linker still finds
        it by its name, and would have the code of Numba's own functions call it in place of theirs.
        """
        for function in self._final_module.functions:
            if function.linkage == Linkage.linkonce_odr:
                function.linkage = Linkage.internal
        super()._optimize_final_module()
        for function in self._final_module.functions:
            if function.linkage == Linkage.internal:
                function.name = f"private.{function.name}"


class PartLibrary(JITCodeLibrary):
    """Code that is linked into the kernels that call it."""

    def finalize(self) -> None:
        """Take in what it calls itself; no machine code is made."""
        for library in dict.fromkeys(self._linking_libraries):
            self._reload_init.update(library._reload_init)
            self._final_module.link_in(library._get_module_for_linking(), preserve=True)
        self._finalized = True


def new_library(kind: type[JITCodeLibrary], name: str) -> JITCodeLibrary:
    """An empty library."""
    library = kind(cpu_target.target_context.codegen(), name)
    library.enable_object_caching()  # so that it can be kept on disk
    return library


def part_flags(flags: Flags) -> Flags:
    """The flags of a function, to lower it and to leave the rest to the kernels."""
    flags = flags.copy()
    flags.no_compile = flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
    return flags


class _Part(CPUDispatcher):
    """A function as kernels call it."""

    def compile(self, args: tuple[types.Type, ...]) -> None:
        """Lower the function for arguments of these types."""
        if args in self.overloads:
            return
        flags = Flags()
        self.targetdescr.options.parse_as_flags(flags, self.targetoptions)
        lowered = compile_extra(
            self.typingctx, self.targetctx, self.py_func, args, None, part_flags(flags),
            self.locals, new_library(PartLibrary, self.py_func.__qualname__), PartCompiler,
        )  # fmt: skip
        name = object()  # in place of the machine code by which Numba knows a function
        self.targetctx.insert_user_function(name, lowered.fndesc, [lowered.library])
        self.overloads[args] = lowered._replace(entry_point=name)


@register_pass(mutates_CFG=False, analysis_only=False)
class CallParts(FunctionPass):
    """Have a function call parts."""

    _name = "stylit_ref_call_parts"

    def __init__(self) -> None:  # abstract in Numba
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Replace the functions that have names in the code."""
        for block in state.func_ir.blocks.values():
            for assignment in block.find_insts(ir.Assign):
                named = assignment.value
                if isinstance(named, ir.Global | ir.FreeVar):
                    named.value = _as_part(named.value)
        return True


def _as_part(value):
    if type(value) is not CPUDispatcher:
        return value
    if value not in _parts:
        _parts[value] = _Part(value.py_func, value.locals, value.targetoptions)
    return _parts[value]


class PartCompiler(CompilerBase):
    """Numba's compiler for functions that call parts."""

    def define_pipelines(self) -> list[PassManager]:
        """Numba's passes, and :class:`CallParts` once small functions are inlined."""
        manager = DefaultPassBuilder.define_nopython_pipeline(self.state)
        manager.passes = [each for each in manager.passes if each[0] not in _NEEDLESS]
        manager.add_pass_after(CallParts, InlineInlinables)
        manager.finalize()
        return [manager]


class KernelCompiler(PartCompiler):
    """Numba's compiler for kernels, whose parts no other code can see."""

    def define_pipelines(self) -> list[PassManager]:
        """The passes of a part, into a library of its own kind."""
        self.state.library = new_library(KernelLibrary, self.state.func_id.func_qualname)
        return super().define_pipelines()
