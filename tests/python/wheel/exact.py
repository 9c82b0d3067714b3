"""What arrays are compared with: golden cases, and second derivatives in 237 bits."""

import json
import pathlib

import mpmath
import numpy as np

from jointproof.formula import named

GOLDEN = pathlib.Path(__file__).resolve().parents[3] / "golden"
#: The step of central differences: their error is its square, and in 237 bits they lose nothing.
STEP = 2.0**-26


class Golden:
    """Valid golden cases of a formula, whose inputs are 0 or within these sizes: inputs, results and the scales of their errors, a row for each case."""

    def __init__(self, formula, sizes, flags=()):
        file = json.loads((GOLDEN / f"{formula.id}.json").read_text(encoding="utf-8"))
        cases = [case for case in file["cases"] if "out" in case and "jac" in case] or [case for case in file["cases"] if "out" in case]
        self.formula = formula
        self.cases = [case for case in cases if self._fits(case, sizes) and (not flags or set(flags) & set(case["flags"]))]
        self.ids = np.array([case["id"] for case in self.cases])
        self.inputs = self._fields("in", formula.inputs)
        self.value, self.scale = (self._packed(self._fields(of, formula.outputs)) for of in ("out", "out_scale"))
        has_jacobian = all("jac" in case for case in self.cases)
        self.jacobian, self.jacobian_scale = (self._matrix(of) if has_jacobian else None for of in ("jac", "jac_scale"))

    @staticmethod
    def _fits(case, sizes):
        numbers = np.abs(np.concatenate([np.ravel(np.asarray(x, float)) for x in case["in"].values()]))
        return np.all((numbers == 0) | ((numbers >= sizes[0]) & (numbers <= sizes[1])))

    def _fields(self, part, fields):
        by_name = [{named(name): x for name, x in case[part].items()} for case in self.cases]
        return [np.array([case[field.name] for case in by_name], float).reshape(-1, *field.shape) for field in fields]

    def _packed(self, arrays):
        return np.concatenate([x.reshape(len(self.cases), -1) for x in arrays], axis=-1)

    def _matrix(self, part):
        rows = []
        for case in self.cases:
            blocks = [
                [np.reshape(np.asarray(x, float), (output.size, field.size)) for x, field in zip(by.values(), self.formula.inputs, strict=True)]
                for by, output in zip(case[part].values(), self.formula.outputs, strict=True)
            ]
            rows.append(np.block(blocks))
        return np.array(rows)


def eta(found, exact, scale, unit=2.0**-53):
    """The backward error in units of rounding, as formulas state it; infinite where nothing is found."""
    with np.errstate(all="ignore"):
        error = np.abs(found - exact) / (unit * (scale + np.abs(exact)))
    error = np.where(np.asarray(found, float) == exact, 0.0, error)
    return np.where(np.isnan(error), np.inf, error)


def rounded(x, bits=24):
    """Numbers of so few bits that steps from them are doubles."""
    mantissa, exponent = np.frexp(x)
    return np.ldexp(np.round(np.ldexp(mantissa, bits)), exponent - bits)


def second(formula, points, directions):
    """The derivative of the Jacobian along a direction at each point, by differences of the exact Jacobian in 237 bits. None where that
    has none."""
    found = []
    with mpmath.workprec(237):
        for x, d in zip(points, directions):
            exact = (formula.exact_linearize(**formula.unpack(x + step * d), number=mpmath.mpf).jacobian for step in (STEP, -STEP))
            ahead, behind = (None if jacobian is None else jacobian.array for jacobian in exact)
            found.append(None if ahead is None or behind is None else ((ahead - behind) / (2 * STEP)).astype(float))
    return found
