"""Compile a function that only compiled code calls as a part of its callers, and nowhere else.

Numba makes machine code of every function on its own, with all that it calls optimised once more at each
level: a control cycle of ten levels is optimised ten times. A function made here has two faces. To Python
it is Numba's dispatcher, compiled and cached as ever. To compiled callers it is a part: typed and
translated to LLVM's language once, and optimised only within the function that Python calls.

This file relies on Numba's internals (0.61 to 0.68). Importing it raises ImportError where they look
different; `jit.decorator` then uses Numba's own decorator, which gives the same results after a longer
compilation.
"""

import inspect
from typing import Any

from llvmlite.binding import Linkage
from numba.core import compiler, dispatcher, sigutils, types
from numba.core.codegen import JITCodeLibrary
from numba.core.imputils import lower_cast
from numba.core.registry import CPUDispatcher

from bumpless.jit.collector import uncollected

_Compiler: Any = getattr(dispatcher, "_FunctionCompiler", None)
_USED = {
    CPUDispatcher: ("add_overload", "get_overload", "get_call_template", "enable_caching"),
    _Compiler: ("_compile_core", "_customize_flags"),
    JITCodeLibrary: ("finalize", "_ensure_finalized", "_get_module_for_linking", "_finalize_dynamic_globals"),
    compiler.Flags: ("no_compile", "no_cpython_wrapper", "no_cfunc_wrapper"),
}
if not (
    all(hasattr(owner, name) for owner, names in _USED.items() for name in names)
    and "library" in inspect.signature(compiler.compile_extra).parameters
):
    raise ImportError("this version of Numba compiles in another way")


class _PartLibrary(JITCodeLibrary):
    """The code of one part, not yet optimised; whoever links it links what it calls as well."""

    def finalize(self) -> None:
        self._raise_if_finalized()
        self._finalize_dynamic_globals()
        self._finalized = True

    def _optimize_functions(self, ll_module: Any) -> None:
        ll_module.data_layout = self._codegen._data_layout

    @classmethod
    def new(cls, context: Any, name: str) -> JITCodeLibrary:
        return cls(context.codegen(), name)


class _WholeLibrary(JITCodeLibrary):
    """The code of a function that Python calls: each part below it is linked once, however many call it."""

    def finalize(self) -> None:
        linked: dict[Any, None] = {}
        waiting = self._linking_libraries[::-1]
        while waiting:
            library = waiting.pop()
            if library not in linked:
                linked[library] = None
                if isinstance(library, _PartLibrary):
                    waiting += library._linking_libraries[::-1]
        self._linking_libraries = list(linked)
        super().finalize()

    def _optimize_final_module(self) -> None:
        # nobody else calls the parts: with one caller each becomes a piece of it, and none is kept twice
        for function in self._final_module.functions:
            if not function.is_declaration and function.linkage == Linkage.linkonce_odr:
                function.linkage = Linkage.internal
        super()._optimize_final_module()

    @classmethod
    def new(cls, context: Any, name: str) -> JITCodeLibrary:
        library = cls(context.codegen(), name)
        library.enable_object_caching()
        return library


class _WholeCompiler(_Compiler):
    """Numba's compiler into a library of the given kind."""

    library: Any = _WholeLibrary

    def _compile_core(self, args: Any, return_type: Any) -> Any:
        flags = compiler.Flags()
        self.targetdescr.options.parse_as_flags(flags, self.targetoptions)
        context = self.targetdescr.target_context
        return compiler.compile_extra(
            self.targetdescr.typing_context, context, self.py_func, args=args, return_type=return_type,
            flags=self._customize_flags(flags), locals=self.locals, pipeline_class=self.pipeline_class,
            library=self.library.new(context, self.py_func.__qualname__),
        )  # fmt: skip


class _PartCompiler(_WholeCompiler):
    """Numba's compiler up to LLVM's language, without a way in from Python."""

    library = _PartLibrary

    def _customize_flags(self, flags: Any) -> Any:
        flags.no_compile = flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True
        return flags


@lower_cast(types.NestedArray, types.Array)
def _field_as_array(context: Any, builder: Any, fromty: Any, toty: Any, val: Any) -> Any:
    return val  # both are the same structure in memory


def _plain(kind: Any) -> Any:
    """An argument's type without its value or its record, so that a part is made once and not per caller."""
    if isinstance(kind, types.NestedArray):
        return types.Array(kind.dtype, kind.ndim, "C")
    return types.unliteral(kind)


class _Part(CPUDispatcher):
    """What compiled callers see of a function."""

    def __init__(self, py_func: Any, targetoptions: dict[str, Any]) -> None:
        super().__init__(py_func, targetoptions=targetoptions)
        self._compiler = _PartCompiler(py_func, self.targetdescr, targetoptions, {}, compiler.Compiler)
        self._keys: dict[Any, object] = {}

    def get_call_template(self, args: Any, kws: Any) -> Any:
        return super().get_call_template(tuple(_plain(a) for a in args), kws)

    def add_overload(self, cres: Any) -> None:
        arguments = tuple(cres.signature.args)
        self._keys[arguments] = key = object()
        self.targetctx.insert_user_function(key, cres.fndesc, [cres.library])
        self.overloads[arguments] = cres

    def get_overload(self, sig: Any) -> object:
        return self._keys[tuple(sigutils.normalize_signature(sig)[0])]


class Function(CPUDispatcher):
    """A compiled function: Numba's dispatcher to Python, a part to compiled callers."""

    def __init__(self, py_func: Any, targetoptions: dict[str, Any]) -> None:
        super().__init__(py_func, targetoptions={**targetoptions, "no_cfunc_wrapper": True})
        self._compiler = _WholeCompiler(py_func, self.targetdescr, self.targetoptions, {}, compiler.Compiler)
        self.part = _Part(py_func, targetoptions)
        self.enable_caching()

    def compile(self, sig: Any) -> Any:
        with uncollected():
            return super().compile(sig)

    @property
    def _numba_type_(self) -> types.Dispatcher:
        return types.Dispatcher(self.part)
