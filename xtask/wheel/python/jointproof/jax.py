"""Formulas as operations of JAX, with their own derivatives::

    friction = jointproof.jax.operation("slot.friction")
    jax.jit(jax.vmap(jax.grad(lambda f2: friction(f2=f2, …).fc)))

A formula is that of :mod:`jointproof.arrays`, on the device and in the precision of its inputs. Its first derivative is the Jacobian
in closed form, which is proved, and what is derived from that is JAX's. An automatic Jacobian is JAX's altogether.
"""

from functools import lru_cache

import jax
from jax.experimental import checkify

from . import arrays


def operation(formula, *, checked=False):
    """The formula as a function of JAX, called as the formula is. What is not allowed gives NaN, or with ``checked`` an error, which a
    compiled function returns by :func:`jax.experimental.checkify.checkify`."""
    return _operation(arrays.find(formula).id, checked)


@lru_cache
def _operation(id, checked):
    function = arrays.find(id)
    value = function.value if function.entries is None else _ruled(function)

    def called(*args, **kwargs):
        lib, numbers, shape = function.components(*_in_jax(args, kwargs))
        if checked:
            _check(function, lib, numbers)
        return function.packed(lib, value(lib, *numbers), shape)

    called.__name__, called.__doc__, called.__signature__ = function.__name__, function.__doc__, function.__signature__
    return called


def _ruled(function):
    """The value, with the Jacobian of the formula as its derivative."""

    @lambda value: jax.custom_jvp(value, nondiff_argnums=(0,))
    def value(lib, *numbers):
        return function.value(lib, *numbers)

    def rule(lib, primals, tangents):
        values, entries = function.linearized(lib, *primals)
        changes = [None] * len(values)
        for (i, j), entry in zip(function.entries, entries):
            if type(tangents[j]) is not jax.custom_derivatives.SymbolicZero:
                term = entry * tangents[j]
                changes[i] = term if changes[i] is None else changes[i] + term
        return values, tuple(lib.xp.zeros_like(y) if change is None else change for y, change in zip(values, changes))

    value.defjvp(rule, symbolic_zeros=True)
    return value


def _in_jax(args, kwargs):
    """Numbers and arrays of NumPy as arrays of JAX; a number takes the precision of the others."""
    return [_array(x) for x in args], {name: _array(x) for name, x in kwargs.items()}


def _array(x):
    return x if isinstance(x, (jax.Array, float, int)) else jax.numpy.asarray(x)


def _check(function, lib, numbers):
    if isinstance(numbers[0], jax.core.Tracer):
        allowed = "; ".join(f"{field.name}: {field.allowed}" for field in function.formula.inputs)
        checkify.check(lib.xp.all(function._accepted(lib, *numbers)), f"{function.id}: an input is not allowed; allowed are {allowed}")
    else:
        function.check(lib, numbers)
