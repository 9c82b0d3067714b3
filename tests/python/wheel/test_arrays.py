"""The printed formulas over arrays are the formulas, in NumPy and in JAX, in doubles and in single precision; what is derived from them
is right."""

import json

import numpy as np
import pytest
from conftest import points, wanted
from exact import GOLDEN, Golden, eta, rounded, second

import jointproof
from jointproof import arrays

jax = wanted("jax")
jnp = wanted("jax.numpy")
jax.config.update("jax_enable_x64", True)
operations = wanted("jointproof.jax")

THERE = [id for id in jointproof.formulas if not isinstance(arrays.find(id), arrays.Missing)]
CLOSED = [id for id in THERE if arrays.find(id).entries is not None]
#: Sizes whose squares, and the products of these, neither over- nor underflow.
DOUBLE, SINGLE = (1e-50, 1e50), (1e-6, 1e6)
#: Golden cases at which the bounds of a formula do not hold over arrays, by what they have in common: they are told in the chapter.
RIGHT_ANGLE = ("nearly-right-angle", "beta-1e-8", "beta+1e-8")
CANCELLING = ("off-axis-", "nearly-folded-f", "large-f2")


def is_told(formula, case):
    steep = formula.id.split(".")[0] in ("cardan", "align", "translator") and case.endswith(RIGHT_ANGLE)
    return steep or formula.id in ("ujoint.contact_moments", "ujoint.friction") and case.startswith(CANCELLING)


def judged(formula, golden, value, jacobian, unit, is_contracted=False):
    """Whether value and Jacobian are within the formula's own bounds at every case, angles but for whole turns. Where products and sums
    are contracted, a product is no longer taken back by an equal one: a number is judged beside the others of its vector if the
    formula's bounds are normwise."""
    off = {}
    found = np.concatenate([np.reshape(x, (len(golden.ids), -1)) for x in value], axis=-1)
    places = [field.places for field in formula.outputs if field.unit == "1" and formula.id.split(".")[0] in ("cardan", "align", "translator", "universal", "revolute")]
    for place in places:
        turns = np.abs(found[:, place] - golden.value[:, place]) > 6
        found[:, place] -= np.where(turns, 2 * np.pi * np.sign(found[:, place]), 0.0)
    results = [(found, golden.value, golden.scale, formula.eta, formula.outputs)]
    if jacobian is not None:
        results.append((np.asarray(jacobian), golden.jacobian, golden.jacobian_scale, formula.eta_jacobian, formula.inputs))
    for found, exact, scale, bound, fields in results:
        if is_contracted and "normwise" in formula.accuracy:
            scale = scale.copy()
            for field in fields:
                scale[..., field.places] = scale[..., field.places].max(axis=-1, keepdims=True)
        worst = eta(found, exact, scale, unit).reshape(len(golden.ids), -1).max(axis=1)
        off |= {case: w for case, w in zip(golden.ids, worst) if w > bound and not is_told(formula, case)}
    return off


def linearized(function):
    """Value and Jacobian, where it has one in closed form."""
    if function.entries is None:
        return lambda *x: (function(*x), None)
    return lambda *x: (lambda found: (found.value, found.jacobian.array))(function.linearize(*x))


@pytest.mark.parametrize("id", THERE)
def test_golden_cases_in_numpy(id):
    formula, function = jointproof.find(id), arrays.find(id)
    golden = Golden(formula, DOUBLE)
    assert len(golden.ids) > 3
    value, jacobian = linearized(function)(*golden.inputs)
    assert not judged(formula, golden, value, jacobian, 2.0**-53)


@pytest.mark.parametrize("id", THERE)
def test_single_precision_in_numpy(id):
    """Beside the formula in doubles, at the same numbers. What single precision does not hold is no number."""
    formula, function = jointproof.find(id), arrays.find(id)
    golden = Golden(formula, SINGLE, ("random", "hand"))
    inputs = [x.astype(np.float32) for x in golden.inputs]
    value = function(*inputs)
    assert all(y.dtype == np.float32 for y in value)
    exact, jacobian = formula.linearize(*inputs)
    packed = np.concatenate([x.reshape(len(x), -1) for x in inputs], axis=-1).astype(float)
    scale = np.einsum("rmn,rn->rm", np.abs(jacobian.array), np.abs(packed))
    found, exact = (np.concatenate([np.reshape(x, (len(x), -1)) for x in of], axis=-1).astype(float) for of in (value, exact))
    overflow = np.abs(exact) > np.finfo(np.float32).max
    assert not np.isfinite(found[overflow]).any()
    worst = np.where(overflow | (np.abs(found - exact) > 6), 0.0, eta(found, exact, scale, 2.0**-24)).max(axis=1)
    # A product that is rounded in single precision may be on the other side of a choice.
    assert np.mean(worst > formula.eta + 1.0) <= 0.05, worst.max()


#: A formula or two of every room.
SOME = [
    "slot.friction", "slot.stop", "coulomb.return_map_2d", "coulomb.response", "cardan.angles", "translator.contact_force", "join.constraint",
    "universal.angles", "ujoint.axial_factors", "ujoint.hinge_transverse", "revolute.angle", "hinge.friction", "slider.line",
    "slider.constraint", "slide_line.slip_increment_linear", "slide_line.torque_parabolic", "interaction.pressure_exponential",
    "interaction.damping",
]  # fmt: skip


@pytest.mark.parametrize("id", SOME)
def test_golden_cases_in_jax(id):
    """Compiled. Of the derivative of the Jacobian none is NaN where the formula has one, on kinks either."""
    formula, function = jointproof.find(id), arrays.find(id)
    golden = Golden(formula, DOUBLE)

    def all_of(*x):
        (value, jacobian), (_, change) = jax.jvp(linearized(function), x, tuple(jnp.ones_like(one) for one in x))
        return value, jacobian, change

    value, jacobian, change = jax.jit(all_of)(*map(jnp.asarray, golden.inputs))
    value = [np.asarray(y) for y in value]
    assert not judged(formula, golden, value, jacobian, 2.0**-53, is_contracted=True)
    told = np.array([is_told(formula, case) for case in golden.ids])
    assert not np.any(np.isnan(np.asarray(change)[~told]))


#: Formulas that bend, with a Jacobian in closed form and without.
BENT = [
    "slot.contact_force", "slot.friction", "coulomb.return_map_2d", "coulomb.response", "cardan.beta_two_argument",
    "translator.torque_force", "translator.radial_force", "translator.bending_force", "translator.contact_force", "translator.friction",
    "universal.constraint_moment", "ujoint.reaction", "ujoint.twist_factors", "ujoint.axial_factors", "ujoint.hinge_twist",
    "ujoint.hinge_axial", "ujoint.hinge_transverse", "ujoint.hinge_bending", "revolute.angle", "hinge.contact_moment", "hinge.friction",
    "slider.line", "slide_line.basis", "slide_line.torque_linear", "interaction.pressure_exponential", "slide_line.nodal_forces_linear",
]  # fmt: skip


def along(operation, formula):
    """The derivative of an operation's Jacobian along a direction, over packed inputs."""

    def value(x):
        parts = operation(**formula.unpack(x))
        return jnp.concatenate([jnp.reshape(y, (-1,)) for y in parts])

    return jax.jit(jax.vmap(lambda x, d: jax.jvp(jax.jacfwd(value), (x,), (d,))[1]))


def bent(formula, count=100):
    """Points away from kinks, directions, and the exact derivatives of the Jacobian along these."""
    drawn = rounded(points(formula, 12_000))
    usual = (np.abs(drawn) > 1e-2).all(axis=1) & (np.abs(drawn) < 1e2).all(axis=1)
    drawn = drawn[usual][-count - 10 :]
    ways = np.random.default_rng(1).integers(-8, 9, drawn.shape) / 8.0 * 2.0 ** np.floor(np.log2(np.abs(drawn)))
    known = [(x, d, s) for x, d, s in zip(drawn, ways, second(formula, drawn, ways)) if s is not None][:count]
    return tuple(map(np.array, zip(*known)))


def off_by(found, exact):
    """The largest error beside the largest derivative of each output."""
    scale = np.abs(exact).max(axis=2, keepdims=True)
    with np.errstate(all="ignore"):
        return np.where(found == exact, 0.0, np.abs(found - exact) / scale).max()


def off(id, function=None):
    """By how much second derivatives differ from the exact ones at most, and at how many points; of another function if one is given."""
    formula = jointproof.find(id)
    inputs, ways, exact = bent(formula)
    operation = operations.operation(id) if function is None else operations.ruled(function)
    return off_by(np.asarray(along(operation, formula)(inputs, ways)), exact), len(inputs)


@pytest.mark.parametrize("id", BENT)
def test_second_derivatives_are_exact(id):
    error, count = off(id)
    assert error < 1e-9 and count == 100


@pytest.mark.parametrize("place", [0, 1])
def test_a_wrong_sign_in_a_rule_is_noticed(place):
    """By second derivatives, and by golden cases."""
    right = arrays.slot.contact_force

    def planted(lib, *numbers):
        value, entries = right._linearized(lib, *numbers)
        return value, tuple(-entry if k == place else entry for k, entry in enumerate(entries))

    wrong = arrays.Function(right.id, right._value, planted, right._accepted, right.entries)
    assert off(right.id, wrong)[0] > 1e-2
    golden = Golden(right.formula, DOUBLE)
    assert judged(right.formula, golden, *linearized(wrong)(*golden.inputs), 2.0**-53)


def test_a_checked_call_raises_the_formulas_error():
    mu = np.array([0.25, 0.25, -1.0], np.float32)
    value = arrays.slot.friction(1.0, 3.0, 4.0, 0.0, mu)
    assert value.phi.dtype == np.float32 and np.isnan(value.phi).tolist() == [False, False, True]
    with pytest.raises(jointproof.InputError, match="row 2: mu is -1.0; allowed is a finite number ≥ 0"):
        arrays.slot.friction(1.0, 3.0, 4.0, 0.0, mu, checked=True)
    with pytest.raises(jointproof.ShapeError, match=r"e1a: shape \[2\]; allowed is \[…, 3\]"):
        arrays.slot.relative_position(np.ones(2), np.ones(3), np.ones(3), np.ones(3), np.ones(3))


@pytest.mark.parametrize("id", THERE)
def test_what_a_formula_refuses_is_nan(id):
    """But for a product that is above 1 by less than it is rounded by."""
    file = json.loads((GOLDEN / f"{id}.json").read_text(encoding="utf-8"))
    refused = [case for case in file["cases"] if "invalid" in case["flags"] and not case["id"].endswith("barely-above-1")]
    inputs = [np.array([case["in"][name] for case in refused], float) for name in refused[0]["in"]]
    found = np.concatenate([np.reshape(y, (len(refused), -1)) for y in arrays.find(id)(*inputs)], axis=-1)
    assert np.isnan(found).any(axis=1).all(), [case["id"] for case, row in zip(refused, found) if not np.isnan(row).any()]


def test_vectors_have_their_axes_last():
    formula = jointproof.slot.relative_position
    inputs = formula.unpack(points(formula, 12).reshape(3, 4, -1))
    value, jacobian = arrays.slot.relative_position.linearize(**inputs)
    expected, by = formula.linearize(**inputs)
    assert all(a.shape == b.shape and np.allclose(a, b) for a, b in zip(value, expected))
    assert jacobian.array.shape == by.array.shape and np.allclose(jacobian.array, by.array)
