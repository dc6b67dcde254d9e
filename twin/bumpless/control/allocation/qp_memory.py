"""Fixed-size scratch memory and foreign calls for compiled code.

The control cycle must not allocate: numba's `np.empty` takes the heap each time, so the small
work arrays of a solve live on the stack of the function that asks for them. The same file turns
addresses kept in int64 arrays into arrays and calls, so that compiled code which uses a C library
stays cacheable (an address baked into machine code would not survive the process).
"""

from typing import Any

from llvmlite import ir
from numba import extending, types
from numba.core import cgutils
from numba.np.arrayobj import make_array, populate_array

intrinsic: Any = extending.intrinsic  # called without the typing context that its functions declare

FLOAT_P = types.CPointer(types.float64)
INT_P = types.CPointer(types.int64)


@intrinsic
def stack_floats(typingctx, count):
    """Pointer to `count` (a literal) uninitialised float64 on the calling function's stack.

    It dies with that function: use it there and in what it calls, and never return it.
    """
    if not isinstance(count, types.IntegerLiteral):
        return None
    size = count.literal_value

    def codegen(context, builder, signature, arguments):
        block = cgutils.alloca_once(builder, ir.ArrayType(ir.DoubleType(), size))
        block.align = 64
        return builder.bitcast(block, ir.DoubleType().as_pointer())

    return FLOAT_P(count), codegen


@intrinsic
def stack_ints(typingctx, count):
    """Pointer to `count` (a literal) uninitialised int64 on the calling function's stack."""
    if not isinstance(count, types.IntegerLiteral):
        return None
    size = count.literal_value

    def codegen(context, builder, signature, arguments):
        block = cgutils.alloca_once(builder, ir.ArrayType(ir.IntType(64), size))
        block.align = 64
        return builder.bitcast(block, ir.IntType(64).as_pointer())

    return INT_P(count), codegen


@intrinsic
def carray(typingctx, pointer, shape):
    """Array over the memory at `pointer`, of a shape (tuple of integers) and in C order.

    As numba.carray, but also where no references are counted (see `bumpless.jit.decorator.jit`).
    """
    if not isinstance(pointer, types.CPointer) or not isinstance(shape, types.BaseTuple):
        return None
    kind = types.Array(pointer.dtype, len(shape), "C")

    def codegen(context, builder, signature, arguments):
        array = make_array(kind)(context, builder)
        sizes = zip(cgutils.unpack_tuple(builder, arguments[1]), signature.args[1], strict=True)
        extent = [context.cast(builder, size, given, types.intp) for size, given in sizes]
        item = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(kind.dtype)))
        strides = [item]
        for size in reversed(extent[1:]):
            strides.insert(0, builder.mul(strides[0], size))
        data = builder.bitcast(arguments[0], array.data.type)
        populate_array(array, data=data, shape=extent, strides=strides, itemsize=item, meminfo=None)
        return array._getvalue()

    return kind(pointer, shape), codegen


@intrinsic
def floats_at(typingctx, address):
    """Pointer to float64 from an integer address."""

    def codegen(context, builder, signature, arguments):
        return builder.inttoptr(arguments[0], ir.DoubleType().as_pointer())

    return FLOAT_P(types.int64), codegen


@intrinsic
def address_of(typingctx, pointer):
    """Integer address of a float64 or int64 pointer."""
    if not isinstance(pointer, types.CPointer):
        return None

    def codegen(context, builder, signature, arguments):
        return builder.ptrtoint(arguments[0], ir.IntType(64))

    return types.int64(pointer), codegen


@intrinsic
def ints_at(typingctx, address):
    """Pointer to int64 from an integer address."""

    def codegen(context, builder, signature, arguments):
        return builder.inttoptr(arguments[0], ir.IntType(64).as_pointer())

    return INT_P(types.int64), codegen


def _foreign_call(integer_arguments):
    """Intrinsic that calls `int f(a1, ..., ak)` at an address; every argument is a 64-bit integer
    or a pointer given as one (the same registers in the calling conventions of 64-bit machines)."""

    def make(typingctx, function, *arguments):
        word = ir.IntType(64)

        def codegen(context, builder, signature, values):
            kind = ir.FunctionType(ir.IntType(32), [word] * integer_arguments)
            target = builder.inttoptr(values[0], kind.as_pointer())
            return builder.sext(builder.call(target, list(values[1:])), word)

        return types.int64(*([types.int64] * (integer_arguments + 1))), codegen

    return make


@intrinsic
def call_1(typingctx, function, a):
    """int f(a)."""
    return _foreign_call(1)(typingctx, function, a)


@intrinsic
def call_2(typingctx, function, a, b):
    """int f(a, b)."""
    return _foreign_call(2)(typingctx, function, a, b)


@intrinsic
def call_3(typingctx, function, a, b, c):
    """int f(a, b, c)."""
    return _foreign_call(3)(typingctx, function, a, b, c)


@intrinsic
def call_4(typingctx, function, a, b, c, d):
    """int f(a, b, c, d)."""
    return _foreign_call(4)(typingctx, function, a, b, c, d)


@intrinsic
def call_7(typingctx, function, a, b, c, d, e, f, g):
    """int f(a, b, c, d, e, f, g): the seventh goes on the stack as a full word."""
    return _foreign_call(7)(typingctx, function, a, b, c, d, e, f, g)
