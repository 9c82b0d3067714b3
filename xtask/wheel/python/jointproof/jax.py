"""Formulas as operations of JAX, with their own derivatives::

    friction = jointproof.jax.operation("slot.friction")
    jax.jit(jax.vmap(jax.grad(lambda f2: friction(f2=f2, …).fc)))

The values and derivatives are those of the formula in doubles, bit for bit, computed on the processor by a callback; so
``jax_enable_x64`` must be set. Forward and reverse derivatives of first order are there. What the formula refuses is an error.
"""

from functools import lru_cache

import jax
import jax.numpy as jnp
import numpy as np


def operation(formula):
    """The formula as a function of JAX, called as the formula is; derivatives go through its own Jacobian."""
    from . import find

    return _operation(find(formula).id)


@lru_cache
def _operation(id):
    from . import find

    formula = find(id)

    def linearized(*inputs):
        value, jacobian = formula.linearize(*map(np.asarray, inputs))
        return (*map(np.asarray, value), jacobian.array)

    def value_of(*inputs):
        return tuple(map(np.asarray, formula(*map(np.asarray, inputs))))

    def values_and_shape(inputs):
        if not jax.config.jax_enable_x64:
            raise ValueError(f"{id}: JAX computes in single precision; set jax_enable_x64")
        inputs = tuple(jnp.asarray(x, jnp.float64) for x in inputs)
        leading = (x.shape[: x.ndim - len(field.shape)] for field, x in zip(formula.inputs, inputs))
        return inputs, jnp.broadcast_shapes(*leading)

    def results(shape):
        return tuple(jax.ShapeDtypeStruct(shape + field.shape, jnp.float64) for field in formula.outputs)

    @jax.custom_jvp
    def operation(*inputs):
        inputs, shape = values_and_shape(inputs)
        return jax.pure_callback(value_of, results(shape), *inputs, vmap_method="broadcast_all")

    @operation.defjvp
    def _(primals, tangents):
        inputs, shape = values_and_shape(primals)
        wanted = (*results(shape), jax.ShapeDtypeStruct((*shape, formula.m, formula.n), jnp.float64))
        *value, jacobian = jax.pure_callback(linearized, wanted, *inputs, vmap_method="broadcast_all")
        tangents = [_broadcast(t, shape + field.shape) for field, t in zip(formula.inputs, tangents)]
        packed = jnp.concatenate([t.reshape(*shape, field.size) for field, t in zip(formula.inputs, tangents)], axis=-1)
        change = jnp.einsum("...mn,...n->...m", jacobian, packed)
        changes = (change[..., field.places].reshape(shape + field.shape) for field in formula.outputs)
        return tuple(value), tuple(changes)

    def called(*args, **kwargs):
        return formula.Value(*operation(*formula._bound(args, kwargs)))

    called.__name__, called.__doc__, called.__signature__ = formula.__name__, formula.__doc__, formula.__signature__
    return called


def _broadcast(tangent, shape):
    """A tangent of the shape of the call; a field's own axes are its last ones."""
    return jnp.broadcast_to(jnp.asarray(tangent, jnp.float64), shape)
