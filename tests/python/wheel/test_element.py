"""Elements give residual and matrix, over arrays of any library."""

import json

import numpy as np
import pytest
from conftest import wanted
from exact import GOLDEN

import jointproof
from jointproof.formula import named

IDS = sorted(path.stem for path in (GOLDEN / "elements").glob("*.json") if path.stem != "schema")
THERE = [id for id in IDS if not isinstance(getattr(jointproof.element, id), jointproof.arrays.Missing)]


def cases(id):
    """Valid golden cases, without and with friction, each together."""
    file = json.loads((GOLDEN / "elements" / f"{id}.json").read_text(encoding="utf-8"))
    for rubs in (False, True):
        some = [case for case in file["cases"] if "out" in case and ("after" in case["out"]) == rubs]
        if some:
            inputs = {named(name): np.array([case["in"][name] for case in some], float) for name in some[0]["in"]}
            yield some, inputs


def test_all_but_those_that_search_in_a_loop_are_there():
    assert set(IDS) - set(THERE) == {"isl22a_linear", "isl22a_exponential"}
    with pytest.raises(NotImplementedError, match="element isl22a_linear over arrays: it looks for the closest point of a curve"):
        jointproof.element.isl22a_linear()
    assert "Inputs:\n    e1a: " in jointproof.element.ujoint.__doc__ and "With friction also:" in jointproof.element.ujoint.__doc__


@pytest.mark.parametrize("id", THERE)
def test_golden_cases(id):
    element = getattr(jointproof.element, id)
    for some, inputs in cases(id):
        found = element(**inputs)
        for name in some[0]["out"]:
            exact = [case["out"][name] for case in some]
            exact = [[x for y in one.values() for x in np.ravel(y)] if isinstance(one, dict) else one for one in exact]
            exact = np.array(exact, float).reshape(getattr(found, name).shape)
            # Beside the largest number of each case, and where all are small what lengths and forces are.
            size = np.abs(exact).reshape(len(some), -1).max(axis=1, initial=1.0)
            error = np.abs(getattr(found, name) - exact).reshape(len(some), -1).max(axis=1, initial=0.0)
            assert np.all(error <= 1e-12 * size), (name, [case["id"] for case in some if error.max() > 1e-12])


def test_residual_and_matrix_are_those_of_newtons_method():
    jax = wanted("jax")
    jax.config.update("jax_enable_x64", True)
    _, inputs = next(cases("slot_2d"))
    one = {name: jax.numpy.asarray(x[-1]) for name, x in inputs.items()}
    found = jax.jit(jointproof.element.slot_2d)(**one)
    n, m = found.forces.shape[-1], found.residuals.shape[-1]
    assert found.residual.shape == (n + m,) and found.matrix.shape == (n + m, n + m)
    # By translations of b: those of the forces are in its columns, and the row is that of the residual.
    by_xb = jax.jacfwd(lambda xb: jointproof.element.slot_2d(**one | {"xb": xb}).residual)(one["xb"])
    assert np.allclose(found.matrix[:, 3:5], by_xb, atol=1e-12)
    assert np.array_equal(found.matrix[:n, n:], found.by_multipliers) and not np.any(found.matrix[n:, n:])


def test_many_elements_are_computed_at_once_and_what_is_not_allowed_is_nan():
    _, inputs = list(cases("ujoint"))[1]
    inputs = {name: np.broadcast_to(x[0], (3, *x.shape[1:])).copy() for name, x in inputs.items()}
    inputs["mu"][1] = -1.0
    found = jointproof.element.ujoint(**inputs)
    assert found.matrix.shape == (3, 16, 16) and np.isnan(found.forces).any(axis=-1).tolist() == [False, True, False]
    with pytest.raises(TypeError, match="element ujoint has no input 'nu'"):
        jointproof.element.ujoint(**inputs, nu=1.0)
