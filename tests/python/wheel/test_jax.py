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


def test_transformations_nest():
    """Maps of maps, derivatives of maps, batches without rows, buffers that are given away."""
    operation = operations.operation("slot.contact_force")
    f2, f3 = jnp.array([3.0, 5.0]), jnp.array([4.0, 12.0, 0.0])
    outer = jax.vmap(jax.vmap(lambda a, b: operation(a, b).fc, (None, 0)), (0, None))(f2, f3)
    assert near(outer, np.hypot.outer(np.asarray(f2), np.asarray(f3)))
    slopes = jax.jacrev(jax.vmap(lambda a: operation(a, 4.0).fc))(f2)
    assert near(slopes, np.diag(f2 / np.hypot(f2, 4.0)))
    assert jax.vmap(jax.grad(lambda a: operation(a, 4.0).fc))(jnp.zeros(0)).shape == (0,)
    assert jointproof.element.slot_2d(*[jnp.zeros((0, 2))] * 3, *[jnp.zeros(0)] * 3).matrix.shape == (0, 7, 7)
    assert near(jax.jit(lambda a: operation(a, 4.0).fc, donate_argnums=0)(f2 + 0.0), np.hypot(f2, 4.0))
    assert isinstance(operation(3, 4).fc, jax.Array) and near(operation(jnp.array([3, 5]), [4, 12]).fc, [5.0, 13.0])


def test_a_jacobian_goes_through_what_is_compiled_and_mapped():
    f2 = np.array([3.0, 5.0])
    expected = jointproof.slot.contact_force.linearize(f2, 4.0)
    for run in (jax.jit, jax.vmap, lambda f: jax.jit(jax.vmap(f))):
        value, jacobian = run(lambda a: arrays.slot.contact_force.linearize(a, 4.0))(jnp.asarray(f2))
        assert near(value.fc, expected.value.fc) and near(jacobian.fc.f2, expected.jacobian.fc.f2)
    row = jax.jit(lambda a: arrays.slot.contact_force.linearize(a, 4.0).jacobian.fc)(3.0)
    assert near(row.f3, 0.8)
    changed = jax.jacfwd(lambda a: arrays.slot.contact_force.linearize(a, 4.0).jacobian)(3.0)
    assert near(changed.fc.f2, 16.0 / 125.0)


def test_what_nothing_is_derived_from_is_chosen_without_guards():
    """What a choice leaves out may be NaN in a value, and in no derivative at any order, at the kink either."""
    operation = operations.operation("slot.contact_force")
    lib = arrays._function.library(jnp, np.dtype("float64"))
    text = str(jax.make_jaxpr(lambda a: operation(a, 0.0).fc)(0.0))
    assert lib.derived and "select_n" not in text and "sqrt" in text
    total = lambda x: operation(x[0], x[1]).fc  # noqa: E731
    zero = jnp.zeros(2)
    for derive in (jax.grad, jax.hessian, lambda f: jax.jacfwd(jax.hessian(f))):
        assert not np.any(np.asarray(derive(total)(zero))) and not np.any(np.asarray(jax.jit(derive(total))(zero)))


def test_errors_name_the_input():
    operation = operations.operation("slot.contact_force")
    for call in (operation, arrays.slot.contact_force):
        for wrong in (np.array([1j]), "a", None):
            with pytest.raises(TypeError, match="^f3: "):
                call(3.0, wrong)
    with pytest.raises(TypeError, match="f2: .* jointproof.jax.operation has the formula for that"):
        jax.jit(jointproof.slot.contact_force)(3.0, 4.0)
    with pytest.raises(KeyError, match="no formula 'contact_force'; there is slot.contact_force and translator"):
        operations.operation("contact_force")
    checked = operations.operation("slot.friction", checked=True)
    with pytest.raises(jointproof.InputError, match="mu is -1.0"):
        jax.grad(lambda mu: checked(1.0, 3.0, 4.0, 0.0, mu).phi)(-1.0)
    with pytest.raises(Exception, match="slot.friction: an input is not allowed"):
        jax.vmap(lambda mu: checked(1.0, 3.0, 4.0, 0.0, mu).phi)(jnp.array([0.25, -1.0]))


@pytest.mark.parametrize("id", ["slot.friction", "cardan.angles", "interaction.pressure_exponential", "slide_line.torque_linear"])
def test_what_is_infinite_is_nan_in_what_depends_on_it(id):
    """Wherever a comparison, a quotient or a sign would hide it."""
    formula, function = jointproof.find(id), arrays.find(id)
    inputs = np.repeat(points(formula, 1), 2 * formula.n, axis=0)
    for k in range(2 * formula.n):
        inputs[k, k // 2] = -np.inf if k % 2 else np.inf
    depends = np.zeros((formula.m, formula.n), bool)
    depends[tuple(np.array(formula.entries).T)] = True
    for xp in (np, jnp):
        found = function(**{name: xp.asarray(x) for name, x in formula.unpack(inputs).items()})
        packed = np.concatenate([np.reshape(y, (len(inputs), -1)) for y in found], axis=-1)
        assert np.isnan(packed[::2].T[depends]).all() and np.isnan(packed[1::2].T[depends]).all()


def test_what_is_not_there_says_why():
    with pytest.raises(NotImplementedError, match="slide_line.closest_parabolic over arrays: it looks for the closest point"):
        arrays.slide_line.closest_parabolic(1.0)
    with pytest.raises(NotImplementedError, match="closest_parabolic"):
        operations.operation("slide_line.closest_parabolic")
    with pytest.raises(AttributeError, match="has no attribute 'slott'"):
        arrays.slott
