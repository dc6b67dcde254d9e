"""The monotonic clock, readable from compiled code."""

import sys
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

_CLOCK_MONOTONIC = 1 if sys.platform.startswith("linux") else 6


@intrinsic
def monotonic(typingctx: Any) -> Any:
    """Seconds of the system's monotonic clock, as a float: `clock_gettime` of the C library."""

    def codegen(context, builder, signature, args):
        i64, i32 = ir.IntType(64), ir.IntType(32)
        spec = cgutils.alloca_once(builder, ir.ArrayType(i64, 2))
        function_type = ir.FunctionType(i32, [i32, spec.type])
        function = cgutils.get_or_insert_function(builder.module, function_type, "clock_gettime")
        builder.call(function, [ir.Constant(i32, _CLOCK_MONOTONIC), spec])
        seconds = builder.load(cgutils.gep_inbounds(builder, spec, 0, 0))
        nanos = builder.load(cgutils.gep_inbounds(builder, spec, 0, 1))
        f64 = ir.DoubleType()
        return builder.fadd(
            builder.sitofp(seconds, f64),
            builder.fmul(builder.sitofp(nanos, f64), ir.Constant(f64, 1e-9)),
        )

    return types.float64(), codegen
