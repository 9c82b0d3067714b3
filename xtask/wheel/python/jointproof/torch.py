"""Formulas as operations of PyTorch, with their own derivatives::

    friction = jointproof.torch.operation("slot.friction")
    friction(f2=f2, …).fc.sum().backward()

A formula is that of :mod:`jointproof.arrays`, on the device and in the precision of its tensors. Its first derivative is the Jacobian
in closed form, which is proved, and what is derived from that is PyTorch's. An automatic Jacobian is PyTorch's altogether, and so is every
derivative of what ``torch.compile`` compiles.
"""

from collections.abc import Callable
from functools import lru_cache, reduce
from typing import TYPE_CHECKING, Any

import array_api_compat.torch
import numpy as np
import torch
from torch.autograd import forward_ad

from . import arrays
from .arrays._function import Library

if TYPE_CHECKING:
    from .formula import Formula


def operation(formula: "str | Formula", *, checked: bool = False) -> Callable[..., Any]:
    """The formula as a function of tensors, called as the formula is. What is not allowed gives NaN, or with ``checked`` the formula's
    error."""
    return _operation(arrays.there(formula).id, checked)


@lru_cache
def _operation(id, checked):
    return ruled(arrays.there(id), checked)


def ruled(function, checked=False):
    """A function over arrays with its own Jacobian as its derivative."""
    value = function.value if function.entries is None else _with_rule(function)
    # A compiler that traces the first call cannot make this type.
    function.formula.Value  # noqa: B018

    def called(*args, **kwargs):
        names = function.formula._input_names
        lib, inputs = _tensors(names, function.formula._bound(args, kwargs))
        numbers, shape = function.components(lib, inputs, checked)
        return function.packed(lib, value(lib, *numbers), shape)

    called.__name__, called.__doc__, called.__signature__ = function.__name__, function.__doc__, function.__signature__
    return called


# One for each precision, made beforehand: what a compiler traces makes none.
_LIBRARIES = {dtype: Library(array_api_compat.torch, dtype) for dtype in (torch.float64, torch.float32, torch.bfloat16, torch.float16)}


def _tensors(names, given):
    """The library of inputs of these names, and these as tensors in one precision on one device; without tensors they are doubles."""
    tensors = [x for x in given if isinstance(x, torch.Tensor)]
    dtype, device = torch.float64, tensors[0].device if tensors else None
    floating = [x.dtype for x in tensors if x.dtype.is_floating_point]
    if floating:
        dtype = reduce(torch.promote_types, floating)
    return _LIBRARIES[dtype], [_real(name, x, dtype, device) for name, x in zip(names, given)]


def _real(name, x, dtype, device):
    if getattr(x, "dtype", dtype) in (torch.complex64, torch.complex128, np.complex64, np.complex128):
        raise TypeError(f"{name}: numbers of type {x.dtype} are not real")
    try:
        return torch.as_tensor(x, dtype=dtype, device=device)
    except (TypeError, ValueError) as why:
        raise TypeError(f"{name}: {why}") from None


def _with_rule(function):
    """The value, with the Jacobian of the formula as its derivative."""

    class Operation(torch.autograd.Function):
        generate_vmap_rule = True

        @staticmethod
        def forward(lib, *numbers):
            # A result may not be an input itself.
            return tuple(y.clone() for y in function.value(lib.plain, *numbers))

        @staticmethod
        def setup_context(ctx, inputs, output):
            ctx.lib, *numbers = inputs
            ctx.save_for_backward(*numbers)
            ctx.save_for_forward(*numbers)

        @staticmethod
        def backward(ctx, *gradients):
            _, entries = function.linearized(ctx.lib, *ctx.saved_tensors)
            backs = [None] * len(ctx.saved_tensors)
            for (i, j), entry in zip(function.entries, entries):
                term = entry * gradients[i]
                backs[j] = term if backs[j] is None else backs[j] + term
            return None, *backs

        @staticmethod
        def jvp(ctx, _, *tangents):
            # PyTorch turns forward derivatives off in here; what a forward derivative of this one needs are the primal numbers.
            with forward_ad._set_fwd_grad_enabled(True):
                numbers = [forward_ad.unpack_dual(x).primal for x in ctx.saved_tensors]
                _, entries = function.linearized(ctx.lib, *numbers)
                changes = [torch.zeros_like(numbers[0]) for _ in range(function.formula.m)]
                for (i, j), entry in zip(function.entries, entries):
                    if tangents[j] is not None:
                        changes[i] = changes[i] + entry * tangents[j]
                return tuple(changes)

    def value(lib, *numbers):
        # The compiler knows no rules for derivatives forward; it derives the value itself.
        return (function.value if torch.compiler.is_compiling() else Operation.apply)(lib, *numbers)

    return value
