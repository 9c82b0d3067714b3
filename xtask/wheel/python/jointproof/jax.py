"""Formulas as operations of JAX, with their own derivatives::

    friction = jointproof.jax.operation("slot.friction")
    jax.jit(jax.vmap(jax.grad(lambda f2: friction(f2=f2, …).fc)))

A formula is that of :mod:`jointproof.arrays`, on the device and in the precision of its inputs. Its first derivative is the Jacobian
in closed form, which is proved, and what is derived from that is JAX's. An automatic Jacobian is JAX's altogether.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import jax
from jax.experimental import checkify

from . import arrays
from .arrays._function import full, in_one_library
from .formula import Gradient, Jacobian

if TYPE_CHECKING:
    from .formula import Formula


def operation(formula: "str | Formula", *, checked: bool = False) -> Callable[..., Any]:
    """The formula as a function of JAX, called as the formula is. What is not allowed gives NaN, or with ``checked`` an error, which a
    compiled function returns by :func:`jax.experimental.checkify.checkify`."""
    return _operation(arrays.there(formula).id, checked)


@lru_cache
def _operation(id, checked):
    return ruled(arrays.there(id), checked)


def ruled(function, checked=False):
    """A function over arrays with its own Jacobian as its derivative."""
    value = function.value if function.entries is None else _with_rule(function)

    def called(*args, **kwargs):
        names = function.formula._input_names
        lib, inputs = in_one_library(names, _arrays(names, function.formula._bound(args, kwargs)))
        numbers, shape = function.components(lib, inputs, checked)
        return function.packed(lib, value(lib, *numbers), shape)

    called.__name__, called.__doc__, called.__signature__ = function.__name__, function.__doc__, function.__signature__
    return called


def _with_rule(function):
    """The value, with the Jacobian of the formula as its derivative."""

    value = jax.custom_jvp(function.value, nondiff_argnums=(0,))

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


@lru_cache
def plain_until_derived(printed):
    """What is printed, without what only its derivatives need, which are those of the whole."""

    value = jax.custom_jvp(lambda lib, *numbers: full(lib, printed(lib.plain, *numbers), numbers), nondiff_argnums=(0,))

    def rule(lib, primals, tangents):
        numbers = list(primals)
        moved = [j for j, tangent in enumerate(tangents) if type(tangent) is not jax.custom_derivatives.SymbolicZero]

        def of(*some):
            for j, x in zip(moved, some):
                numbers[j] = x
            return full(lib, printed(lib, *numbers), numbers)

        return jax.jvp(of, [primals[j] for j in moved], [tangents[j] for j in moved])

    value.defjvp(rule, symbolic_zeros=True)
    return value


def _arrays(names, given):
    """Arrays of JAX; numbers take the precision of the others."""
    found = []
    for name, x in zip(names, given):
        try:
            found.append(x if isinstance(x, (jax.Array, float, int)) else jax.numpy.asarray(x))
        except (TypeError, ValueError) as why:
            raise TypeError(f"{name}: {why}") from None
    return found if any(isinstance(x, jax.Array) for x in found) else [jax.numpy.asarray(x) for x in found]


def check_traced(function, holds):
    """Hands what is not allowed to checkify, if it is not known yet whether all inputs are."""
    if not isinstance(holds, jax.core.Tracer):
        return False
    allowed = "; ".join(f"{field.name}: {field.allowed}" for field in function.formula.inputs)
    checkify.check(holds, f"{function.id}: an input is not allowed; allowed are {allowed}")
    return True


# Jacobians go in and out of what is compiled and mapped.
jax.tree_util.register_pytree_node(
    Jacobian,
    lambda of: ((of.array,), (tuple(of._outputs.items()), tuple(of._inputs.items()))),
    lambda fields, parts: Jacobian(*parts, *map(dict, fields)),
)
jax.tree_util.register_pytree_node(
    Gradient,
    lambda of: ((of._rows,), (of._output, tuple(of._inputs.items()))),
    lambda fields, parts: Gradient(*parts, fields[0], dict(fields[1])),
)
