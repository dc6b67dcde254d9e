"""CPU time of the calling thread, read from compiled code, without the other processes' share."""

from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.core import cgutils

_CLOCK_THREAD_CPUTIME_ID = 3  # Linux

intrinsic: Any = extending.intrinsic


@intrinsic
def thread_time(typingctx: Any) -> Any:
    """Seconds of CPU time of this thread, as a float."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        i64, i32, f64 = ir.IntType(64), ir.IntType(32), ir.DoubleType()
        spec = cgutils.alloca_once(builder, ir.ArrayType(i64, 2))
        kind = ir.FunctionType(i32, [i32, spec.type])
        function = cgutils.get_or_insert_function(builder.module, kind, "clock_gettime")
        builder.call(function, [ir.Constant(i32, _CLOCK_THREAD_CPUTIME_ID), spec])
        seconds, nanos = (builder.load(cgutils.gep_inbounds(builder, spec, 0, k)) for k in (0, 1))
        whole = builder.sitofp(seconds, f64)
        return builder.fadd(whole, builder.fmul(builder.sitofp(nanos, f64), ir.Constant(f64, 1e-9)))

    return types.float64(), codegen
