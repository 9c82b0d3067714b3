"""Formulas as operations of PyTorch, with their own derivatives::

    friction = jointproof.torch.operation("slot.friction")
    friction(f2=f2, …).fc.sum().backward()

Tensors are of doubles, in memory. First derivatives are those of the formula; a second derivative is refused.
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
            ctx.save_for_backward(torch.as_tensor(jacobian.array), *inputs)
            return tuple(torch.as_tensor(y, dtype=torch.float64) for y in value)

        @staticmethod
        def backward(ctx, *gradients):
            return Pulled.apply(*ctx.saved_tensors, *gradients)

    class Pulled(torch.autograd.Function):
        """Gradients by the results, pulled back to the inputs by the Jacobian. It is linear in these gradients; to differentiate it
        by the inputs would take the second derivative of the formula."""

        @staticmethod
        def forward(ctx, jacobian, *both):
            inputs, gradients = both[: len(formula.inputs)], both[len(formula.inputs) :]
            ctx.save_for_backward(jacobian)
            shape = jacobian.shape[:-2]
            parts = [g.reshape(*shape, field.size) for field, g in zip(formula.outputs, gradients)]
            packed = torch.einsum("...mn,...m->...n", jacobian, torch.cat(parts, dim=-1))
            backs = (packed[..., field.places].reshape(*shape, *field.shape) for field in formula.inputs)
            # Summed over what was broadcast.
            return tuple(back.sum_to_size(x.shape) for back, x in zip(backs, inputs))

        @staticmethod
        def backward(ctx, *changes):
            raise NotImplementedError(
                f"{id}: its second derivative is wanted, and as an operation of PyTorch it has the first alone"
            )

    def called(*args, **kwargs):
        inputs = [torch.as_tensor(x, dtype=torch.float64) for x in formula._bound(args, kwargs)]
        return formula.Value(*Operation.apply(*inputs))

    called.__name__, called.__doc__, called.__signature__ = formula.__name__, formula.__doc__, formula.__signature__
    return called
