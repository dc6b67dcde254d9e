"""Small arrays on the stack: the control cycle must not allocate, and Numba's `np.empty` takes the heap."""

from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.core import cgutils
from numba.np.arrayobj import make_array, populate_array

intrinsic: Any = extending.intrinsic  # called without the typing context that its functions declare


@intrinsic
def floats(typingctx, count):
    """Array of `count` (a literal) uninitialised float64 on the calling function's stack.

    It dies with that function: use it there and in what it calls, and never return it.
    """
    if not isinstance(count, types.IntegerLiteral):
        return None
    size, kind = count.literal_value, types.Array(types.float64, 1, "C")

    def codegen(context, builder, signature, arguments):
        block = cgutils.alloca_once(builder, ir.ArrayType(ir.DoubleType(), size))
        block.align = 64
        array = make_array(kind)(context, builder)
        item = context.get_constant(types.intp, 8)
        extent = [context.get_constant(types.intp, size)]
        data = builder.bitcast(block, array.data.type)
        populate_array(array, data=data, shape=extent, strides=[item], itemsize=item, meminfo=None)
        return array._getvalue()

    return kind(count), codegen
