"""A formula is an operation of JAX, with its own derivative."""

import numpy as np
import pytest
from conftest import points, same, wanted

import jointproof

jax = wanted("jax")
jnp = wanted("jax.numpy")
jax.config.update("jax_enable_x64", True)
operations = wanted("jointproof.jax")

IDS = ["slot.friction", "slot.relative_position", "element.arm", "universal.angles"]


@pytest.mark.parametrize("id", IDS)
def test_values_and_derivatives_are_the_formulas(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = list(formula.unpack(points(formula, 1)[0]).values())
    value, jacobian = formula.linearize(*inputs)
    assert all(same(a, b) for a, b in zip(operation(*inputs), value))
    for derive in (jax.jacfwd, jax.jacrev):
        by = derive(lambda *x: tuple(operation(*x)), argnums=tuple(range(len(inputs))))(*inputs)
        for output, row in zip(formula.outputs, by):
            for field, block in zip(formula.inputs, row):
                # A product with a direction may turn −0 into 0.
                assert np.array_equal(block, jacobian[output.name][field.name]), (output, field)


@pytest.mark.parametrize("id", IDS)
def test_it_is_compiled_and_mapped(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = list(formula.unpack(points(formula, 7)).values())
    expected, jacobian = formula.linearize(*inputs)
    for mapped in (jax.jit(operation), jax.vmap(operation), jax.jit(jax.vmap(operation))):
        assert all(same(a, b) for a, b in zip(mapped(*inputs), expected))

    def first(*x):
        return jnp.sum(operation(*x)[0])

    gradients = jax.jit(jax.vmap(jax.grad(first, argnums=tuple(range(len(inputs))))))(*inputs)
    rows = jacobian.array[:, formula.outputs[0].places, :].sum(axis=1)
    for field, gradient in zip(formula.inputs, gradients):
        assert np.allclose(np.reshape(gradient, (7, field.size)), rows[:, field.places], rtol=1e-14, atol=1e-300)


def test_inputs_broadcast():
    operation = operations.operation("slot.contact_force")
    assert operation(f3=4.0, f2=jnp.ones((2, 3))).fc.shape == (2, 3)
    total = jax.grad(lambda f3: operation(jnp.array([3.0, 0.0]), f3).fc.sum())(4.0)
    assert float(total) == 0.8 + 1.0


def test_what_is_refused_is_an_error():
    operation = operations.operation("slot.contact_force")
    with pytest.raises(Exception, match="f2 is NaN; allowed is a finite number"):
        jax.block_until_ready(operation(jnp.array([1.0, jnp.nan]), 1.0))


def test_many_points_do_not_stop():
    operation = jax.jit(operations.operation("slot.contact_force"))
    f2 = jnp.linspace(1, 2, 1_000_000)
    assert same(operation(f2, 1.0).fc, jointproof.slot.contact_force(np.asarray(f2), 1.0).fc)
