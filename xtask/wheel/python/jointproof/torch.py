"""Formulas as operations of PyTorch, with their own derivatives::

    friction = jointproof.torch.operation("slot.friction")
    friction(f2=f2, …).fc.sum().backward()

A formula is that of :mod:`jointproof.arrays`, on the device and in the precision of its tensors. Its first derivative is the Jacobian
in closed form, which is proved, and what is derived from that is PyTorch's. An automatic Jacobian is PyTorch's altogether.
"""

from functools import lru_cache

import torch

from . import arrays


def operation(formula, *, checked=False):
    """The formula as a function of tensors, called as the formula is. What is not allowed gives NaN, or with ``checked`` the formula's
    error."""
    return _operation(arrays.find(formula).id, checked)


@lru_cache
def _operation(id, checked):
    function = arrays.find(id)
    value = function.value if function.entries is None else _ruled(function)

    def called(*args, **kwargs):
        args, kwargs = [_tensor(x) for x in args], {name: _tensor(x) for name, x in kwargs.items()}
        lib, numbers, shape = function.components(args, kwargs, checked)
        return function.packed(lib, value(lib, *numbers), shape)

    called.__name__, called.__doc__, called.__signature__ = function.__name__, function.__doc__, function.__signature__
    return called


def _tensor(x):
    """A number becomes a tensor where the precision of the others is known; without others it is a double."""
    return x if isinstance(x, (torch.Tensor, float, int)) else torch.as_tensor(x, dtype=torch.float64)


def _ruled(function):
    """The value, with the Jacobian of the formula as its derivative."""

    class Operation(torch.autograd.Function):
        generate_vmap_rule = True

        @staticmethod
        def forward(lib, *numbers):
            # A result may not be an input itself.
            return tuple(y.clone() for y in function.value(lib, *numbers))

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
            _, entries = function.linearized(ctx.lib, *ctx.saved_tensors)
            changes = [torch.zeros_like(ctx.saved_tensors[0]) for _ in range(function.formula.m)]
            for (i, j), entry in zip(function.entries, entries):
                if tangents[j] is not None:
                    changes[i] = changes[i] + entry * tangents[j]
            return tuple(changes)

    return Operation.apply
