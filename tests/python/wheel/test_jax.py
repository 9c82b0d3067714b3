"""A formula is an operation of JAX, with its own derivative, in every transformation and at every order."""

import numpy as np
import pytest
from conftest import points, wanted

import jointproof
from jointproof import arrays

jax = wanted("jax")
jnp = wanted("jax.numpy")
jax.config.update("jax_enable_x64", True)
operations = wanted("jointproof.jax")

IDS = ["slot.friction", "slot.relative_position", "element.arm", "universal.angles"]


def near(one, other):
    return np.allclose(one, other, rtol=1e-13, atol=1e-15 * np.abs(other).max(initial=0.0))


@pytest.mark.parametrize("id", IDS)
def test_values_and_derivatives_are_the_formulas(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = list(formula.unpack(points(formula, 1)[0]).values())
    value, jacobian = formula.linearize(*inputs)
    for derive in (jax.jacfwd, jax.jacrev):
        by = jax.jit(derive(lambda *x: tuple(operation(*x)), argnums=tuple(range(len(inputs)))))(*inputs)
        for output, row in zip(formula.outputs, by):
            for field, block in zip(formula.inputs, row):
                assert near(block, jacobian[output.name][field.name]), (output, field)


@pytest.mark.parametrize("id", IDS)
def test_it_is_compiled_and_mapped(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = list(map(jnp.asarray, formula.unpack(points(formula, 7)).values()))
    expected, jacobian = formula.linearize(*map(np.asarray, inputs))
    for mapped in (jax.jit(operation), jax.vmap(operation), jax.jit(jax.vmap(operation))):
        assert all(near(a, b) for a, b in zip(mapped(*inputs), expected))

    def first(*x):
        return jnp.sum(operation(*x)[0])

    gradients = jax.jit(jax.vmap(jax.grad(first, argnums=tuple(range(len(inputs))))))(*inputs)
    rows = jacobian.array[:, formula.outputs[0].places, :].sum(axis=1)
    for field, gradient in zip(formula.inputs, gradients):
        assert near(np.reshape(gradient, (7, field.size)), rows[:, field.places])


def test_a_hessian_is_the_same_in_every_way():
    operation = operations.operation("slot.contact_force")
    x = jnp.array([3.0, 5.0])
    expected = np.diag(16.0 / (x**2 + 16.0) ** 1.5)

    def total(x):
        return operation(x, 4.0).fc.sum()

    ways = [jax.hessian, *(lambda f, a=a, b=b: a(b(f)) for a in (jax.jacfwd, jax.jacrev) for b in (jax.jacfwd, jax.jacrev))]
    for way in ways:
        assert near(jax.jit(way(total))(x), expected)
    third = jax.jit(jax.jacfwd(jax.jacfwd(jax.jacfwd(lambda x: operation(x, 4.0).fc))))(3.0)
    assert near(third, -48.0 * 3.0 / 25.0**2.5)


def test_it_runs_in_a_loop_and_is_exported():
    friction = operations.operation("coulomb.response")

    def step(f, du):
        response = friction(du, f, 100.0, 0.3, 5.0)
        return response.f, response.f

    increments = jnp.sin(jnp.linspace(0, 20, 200)) * 0.01
    _, forces = jax.jit(lambda du: jax.lax.scan(step, 0.0, du))(increments)
    f = 0.0
    for du, force in zip(np.asarray(increments), forces):
        f = jointproof.coulomb.response(float(du), f, 100.0, 0.3, 5.0).f
        assert near(force, f)
    exported = jax.export.export(jax.jit(lambda x: friction(x, 1.0, 100.0, 0.3, 5.0).f))(jax.ShapeDtypeStruct((3,), jnp.float64))
    assert near(exported.call(increments[:3]), friction(increments[:3], 1.0, 100.0, 0.3, 5.0).f)


def test_inputs_broadcast_and_keep_their_precision():
    operation = operations.operation("slot.contact_force")
    assert operation(f3=4.0, f2=jnp.ones((2, 3))).fc.shape == (2, 3)
    total = jax.grad(lambda f3: operation(jnp.array([3.0, 0.0]), f3).fc.sum())(4.0)
    assert near(total, 0.8 + 1.0)
    single = jnp.array([3.0, 0.0], jnp.float32)
    assert operation(single, 4.0).fc.dtype == jax.grad(lambda x: operation(x, 4.0).fc.sum())(single).dtype == jnp.float32


def test_what_is_not_allowed_is_nan_and_checked_an_error():
    operation, checked = (operations.operation("slot.friction", checked=of) for of in (False, True))
    f1 = jnp.array([1.0, jnp.nan, 2.0])
    inputs = (f1, 3.0, 4.0, 0.0, jnp.array([0.25, 0.25, -1.0]))
    for run in (operation, jax.jit(operation)):
        value = run(*inputs)
        assert np.isnan(value.phi).tolist() == [False, True, True]
        # What depends on neither of them is a number.
        assert np.isnan(value.fn).tolist() == [False, False, False]
    slopes = jax.jit(jax.vmap(jax.grad(lambda f2, mu: operation(1.0, f2, 4.0, 0.0, mu).phi)))(jnp.full(3, 3.0), inputs[-1])
    assert np.isnan(slopes).tolist() == [False, False, True]
    with pytest.raises(jointproof.InputError, match="row 1, the first of 2 that are refused: f1 is NaN"):
        checked(*inputs)
    from jax.experimental import checkify

    error, _ = jax.jit(checkify.checkify(lambda *x: checked(*x).phi))(*inputs)
    with pytest.raises(Exception, match="slot.friction: an input is not allowed; allowed are .*mu: a finite number ≥ 0"):
        error.throw()


def test_what_is_not_there_says_why():
    with pytest.raises(NotImplementedError, match="slide_line.closest_parabolic over arrays: it looks for the closest point"):
        arrays.slide_line.closest_parabolic(1.0)
    with pytest.raises(NotImplementedError, match="closest_parabolic"):
        operations.operation("slide_line.closest_parabolic")
    with pytest.raises(AttributeError, match="has no attribute 'slott'"):
        arrays.slott
