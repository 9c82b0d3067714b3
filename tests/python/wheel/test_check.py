"""Functions of Python, NumPy and JAX are judged as programs are: right ones pass, and of wrong ones the mistake is named."""

import math

import numpy as np
from conftest import wanted

import jointproof


def right(f2, f3):
    return math.hypot(f2, f3)


def by_both(f2, f3):
    fc = math.hypot(f2, f3)
    return (f2 / fc, f3 / fc) if fc else (0.0, 0.0)


def refusing(function):
    def refused(f2, f3):
        if not (math.isfinite(f2) and math.isfinite(f3)):
            raise ValueError("not finite")
        return function(f2, f3)

    return refused


def grades(checked):
    return {number.name: number.grade for number in checked.numbers}


def test_a_right_function_passes():
    checked = jointproof.check("slot.contact_force", refusing(right), refusing(by_both))
    assert checked and checked.is_well, checked
    assert grades(checked) == {"fc": "right", "∂fc/∂f2": "right", "∂fc/∂f3": "right"}
    assert checked.causes == []
    assert [part.conclusion for part in checked.parts] == ["right"] * 5, checked


def test_a_wrong_derivative_is_named():
    swapped = lambda f2, f3: by_both(f2, f3)[::-1]  # noqa: E731
    checked = jointproof.check("slot.contact_force", refusing(right), refusing(swapped))
    assert not checked
    assert grades(checked) == {"fc": "right", "∂fc/∂f2": "wrong", "∂fc/∂f3": "wrong"}
    assert checked.causes and "slot.contact_force" in str(checked)
    worst = checked.numbers[1]
    assert worst.off > 0 and worst.worst[1] != worst.worst[2] and '"f2"' in worst.inputs
    doubled = jointproof.check("slot.contact_force", refusing(right), refusing(lambda a, b: [2 * x for x in by_both(a, b)]))
    assert any("2" in cause for cause in doubled.causes), doubled.causes


def test_an_inaccurate_value_is_inaccurate():
    def nearly(f2, f3):
        return math.hypot(f2, f3) * (1 + 1e-9)

    assert grades(jointproof.check("slot.contact_force", refusing(nearly)))["fc"] == "inaccurate"


def test_a_limit_is_listed_and_only_strictly_wrong():
    squared = refusing(lambda f2, f3: np.sqrt(np.float64(f2) ** 2 + np.float64(f3) ** 2))
    checked = jointproof.check("slot.contact_force", squared)
    assert checked and checked.parts[2].conclusion == "limited" and "overflows" in checked.parts[2].says, checked
    assert not jointproof.check("slot.contact_force", squared, strict=True)


def test_numpy_is_asked_for_all_points_at_once():
    calls = []

    def vectors(f2, f3):
        calls.append(len(f2))
        return np.hypot(f2, f3)

    def derivatives(f2, f3):
        fc = np.hypot(f2, f3)
        over = np.where(fc > 0, fc, 1.0)
        return f2 / over, f3 / over

    checked = jointproof.check("slot.contact_force", vectors, derivatives, vectorized=True)
    assert len(calls) == 2 and calls[0] > 100
    # Infinite inputs give infinity or NaN, which refuses them.
    assert checked, checked


def test_our_own_functions_pass():
    for id in ("universal.angles", "slot.relative_position", "coulomb.return_map_2d", "element.rotation_vector"):
        formula = jointproof.find(id)
        checked = jointproof.check(formula, formula.linearize, True, samples=200)
        assert checked, checked


def test_vectors_by_names():
    position = jointproof.slot.relative_position

    def mine(e1a, e2a, e3a, xa, xb):
        d = xb - xa
        return {"z": e3a @ d, "x": e1a @ d, "y": e2a @ d}

    assert {n.grade for n in jointproof.check(position, mine, invalid=False).numbers} == {"right"}
    twisted = lambda e1a, e2a, e3a, xa, xb: (e1a @ (xb - xa), e3a @ (xb - xa), e2a @ (xb - xa))  # noqa: E731
    assert grades(jointproof.check(position, twisted, invalid=False)) == {"x": "right", "y": "wrong", "z": "wrong"}


def test_what_is_no_answer_is_said():
    def broken(f2, f3):
        raise RuntimeError("out of order")

    assert "out of order" in jointproof.check("slot.contact_force", broken).text
    short = jointproof.check("slot.relative_position", lambda *inputs: (1.0, 2.0))
    assert "2 outputs instead of 3" in short.text
    state = []

    def forgetful(f2, f3):
        state.append(f2)
        return math.hypot(f2, f3) + len(state) * 1e-3

    assert not jointproof.check("slot.contact_force", forgetful)


def test_a_notebook_sees_the_map():
    checked = jointproof.check("slot.contact_force", refusing(right), refusing(lambda f2, f3: (1.0, 0.0)))
    shown = checked._repr_html_()
    assert shown.count('<td style="background') == 3 and "∂fc/∂f2" in shown and "#f0b4ae" in shown and "#cfe8cf" in shown
    assert "<pre>" in shown


def test_jax_is_derived():
    jax = wanted("jax")
    jnp = wanted("jax.numpy")
    jax.config.update("jax_enable_x64", True)

    def smooth(f2, f3):
        return jnp.hypot(f2, f3)

    def naive(f2, f3):
        return jnp.sqrt(f2**2 + f3**2)

    checked = jointproof.check("slot.contact_force", naive, "jax", samples=100, invalid=False)
    assert not checked
    # Squares overflow and vanish, and at zero the derivative is NaN.
    assert set(grades(checked).values()) != {"right"}
    also = jointproof.check("slot.relative_motion", lambda x, x0, l1_ref: (x - x0, x - l1_ref), "jax", samples=50, invalid=False)
    assert also, also


def test_jax_is_mapped_and_what_cannot_be_mapped_is_asked_point_by_point():
    jax = wanted("jax")
    jnp = wanted("jax.numpy")
    jax.config.update("jax_enable_x64", True)
    calls = []

    def mapped(x, x0, l1_ref):
        calls.append(1)
        return x - x0, x - l1_ref

    assert jointproof.check("slot.relative_motion", mapped, "jax", samples=200, invalid=False)
    assert len(calls) <= 4, "it is traced, not called at every point"

    def branching(f2, f3):
        return jnp.hypot(f2, f3) if f2 != 0 or f3 != 0 else jnp.abs(f2)

    wrong = lambda f2, f3: -branching(f2, f3)  # noqa: E731
    assert grades(jointproof.check("slot.contact_force", branching, "jax", samples=20, invalid=False))["fc"] != "wrong"
    assert grades(jointproof.check("slot.contact_force", wrong, "jax", samples=20, invalid=False))["fc"] == "wrong"
    rows = lambda x, x0, l1_ref: (x - x0, x - l1_ref)  # noqa: E731
    assert jointproof.check("slot.relative_motion", rows, "jax", samples=50, invalid=False, vectorized=True)


def test_jax_in_single_precision_is_found():
    jax = wanted("jax")
    jnp = wanted("jax.numpy")
    jax.config.update("jax_enable_x64", False)
    try:
        checked = jointproof.check("slot.contact_force", lambda f2, f3: jnp.hypot(f2, f3), "jax", samples=50, invalid=False)
    finally:
        jax.config.update("jax_enable_x64", True)
    assert not checked
    assert "jax_enable_x64" in checked.text and "jax_enable_x64" in checked.noticed[0], checked
    assert any("32 bits" in cause for cause in checked.causes), checked.causes
    assert "jax_enable_x64" in checked._repr_html_()
