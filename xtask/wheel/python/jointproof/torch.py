"""Formulas as operations of PyTorch, with their own derivatives::

    friction = jointproof.torch.operation("slot.friction")
    friction(f2=f2, …).fc.sum().backward()

Tensors are of doubles, in memory. First derivatives are those of the formula.
"""

from functools import lru_cache

import torch


def operation(formula):
    """The formula as a function of tensors, called as the formula is; derivatives go through its own Jacobian."""
    from . import find

    return _operation(find(formula).id)


@lru_cache
def _operation(id):
    from . import find

    formula = find(id)

    class Operation(torch.autograd.Function):
        @staticmethod
        def forward(ctx, *inputs):
            value, jacobian = formula.linearize(*(x.detach().numpy() for x in inputs))
            ctx.save_for_backward(torch.as_tensor(jacobian.array))
            ctx.shapes = [x.shape for x in inputs]
            return tuple(torch.as_tensor(y, dtype=torch.float64) for y in value)

        @staticmethod
        @torch.autograd.function.once_differentiable
        def backward(ctx, *gradients):
            (jacobian,) = ctx.saved_tensors
            shape = jacobian.shape[:-2]
            parts = [g.reshape(*shape, field.size) for field, g in zip(formula.outputs, gradients)]
            packed = torch.einsum("...mn,...m->...n", jacobian, torch.cat(parts, dim=-1))
            backs = (packed[..., field.places].reshape(*shape, *field.shape) for field in formula.inputs)
            return tuple(_summed(back, wanted) for back, wanted in zip(backs, ctx.shapes))

    def called(*args, **kwargs):
        inputs = [torch.as_tensor(x, dtype=torch.float64) for x in formula._bound(args, kwargs)]
        return formula.Value(*Operation.apply(*inputs))

    called.__name__, called.__doc__, called.__signature__ = formula.__name__, formula.__doc__, formula.__signature__
    return called


def _summed(gradient, shape):
    """Summed over what was broadcast."""
    return gradient.sum_to_size(shape)
