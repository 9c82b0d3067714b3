"""The scales of golden files: by how much a number changes with its inputs.

The scale of y is the sum of |dy/dx x| over all inputs x, plus |y|. That of an entry J of the Jacobian needs the second
derivatives, which are differences of differences, again with a step so small that a hundred bits are right:

    (f(x + h e_i + h e_j) - f(x + h e_i) - f(x + h e_j) + f(x)) / h^2,  h = 2^(lo - 150 - span)

with `lo` and `span` as in `core`, in 6 span + 700 bits.
"""

from __future__ import annotations

import math
from typing import Any

from mpmath import mp, mpf

from .core import CATALOG, Formula, Number, _call, _exact, precision_for, sign, to_double

Place = tuple[str, int]


def four_digits_up(x: Number) -> float:
    """The least number of four digits that is not below x by more than a part in 2^40."""
    nearest = to_double(x)
    if not math.isfinite(nearest):
        return nearest
    digits, exponent = f"{nearest:.3e}".split("e")
    rounded = float(f"{digits}e{exponent}")
    if rounded >= nearest * (1 - 2**-40):
        return rounded
    return float(f"{int(digits.replace('.', '')) + 1}e{int(exponent) - 3}")


def _places(entry: Formula) -> list[Place]:
    return [(name, k) for name, length in entry.inputs.items() for k in range(length or 1)]


def _moved(entry: Formula, point: dict[str, Any], steps: list[Place], h: Number) -> dict[str, Any]:
    moved = {name: list(x) if entry.inputs[name] else x for name, x in point.items()}
    for name, k in steps:
        if entry.inputs[name]:
            moved[name][k] += h
        else:
            moved[name] += h
    return moved


def _components(fields: dict[str, int], values: dict[str, Any]) -> list[Number]:
    return [x for name, length in fields.items() for x in (values[name] if length else [values[name]])]


def _named(fields: dict[str, int], components: list[Any]) -> dict[str, Any]:
    rest = iter(components)
    return {name: [next(rest) for _ in range(length)] if length else next(rest) for name, length in fields.items()}


def out_scales(id: str, inputs: dict[str, Any], value: dict[str, Any], jacobian: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """By output, from the exact value and Jacobian."""
    entry = CATALOG[id]
    with mp.workprec(precision_for(inputs).working):
        point = _exact(entry, inputs)

        def scale(y: Number, gradient: dict[str, Any]) -> Number:
            terms = zip(_components(entry.inputs, gradient), _components(entry.inputs, point), strict=True)
            return abs(y) + sum((abs(d * x) for d, x in terms), mpf(0))

        result: dict[str, Any] = {}
        for out, length in entry.outputs.items():
            if length:
                rows = ({name: d[row] for name, d in jacobian[out].items()} for row in range(length))
                result[out] = [scale(y, row) for y, row in zip(value[out], rows, strict=True)]
            else:
                result[out] = scale(value[out], jacobian[out])
        return result


def jacobian_scales(id: str, inputs: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """By output and input, nested as the Jacobian is."""
    entry, rows = CATALOG[id], _jacobian_scales(id, inputs, 0)
    small = max(mp.ldexp(max(map(max, rows)), -100), mp.ldexp(mpf(1), -100))
    if any(0 < scale < small for row in rows for scale in row):
        # A small scale does not care about the step, the remainder of a vanishing one does.
        again = _jacobian_scales(id, inputs, 64)
        rows = [[x if y > x / 2 else mpf(0) for x, y in zip(*pair, strict=True)] for pair in zip(rows, again, strict=True)]
    result: dict[str, dict[str, Any]] = {}
    rest = iter(rows)
    for out, length in entry.outputs.items():
        of_out = [_named(entry.inputs, next(rest)) for _ in range(length or 1)]
        result[out] = {name: [row[name] for row in of_out] if length else of_out[0][name] for name in entry.inputs}
    return result


def _jacobian_scales(id: str, inputs: dict[str, Any], more: int) -> list[list[Number]]:
    """A row per component of the outputs, over the components of the inputs."""
    entry, p = CATALOG[id], precision_for(inputs)
    with mp.workprec(p.working - 1100 + 4 * more):
        h = mp.ldexp(mpf(1), p.step + 350 - more)
        point, places = _exact(entry, inputs), _places(entry)
        x = _components(entry.inputs, point)
        value, decisions = _call(entry, point, None)
        here = _components(entry.outputs, value)
        angles = [name in entry.angles for name, length in entry.outputs.items() for _ in range(length or 1)]

        def change(steps: list[Place]) -> list[Number]:
            there = _components(entry.outputs, _call(entry, _moved(entry, point, steps, h), decisions)[0])
            changes = [b - a for a, b in zip(here, there, strict=True)]
            # Across the cut at +-180 degrees.
            return [c - sign(c) * 2 * mp.pi if angle and abs(c) > mp.pi else c for c, angle in zip(changes, angles)]

        alone = [change([place]) for place in places]
        scales = [[abs(alone[j][out] / h) for j in range(len(places))] for out in range(len(here))]
        for i, first in enumerate(places):
            for j in range(i, len(places)):
                if x[i] == 0 == x[j]:
                    continue
                both = change([first, places[j]])
                for out, c in enumerate(both):
                    bend = abs((c - alone[i][out] - alone[j][out]) / (h * h))
                    scales[out][j] += bend * abs(x[i])
                    if i != j:
                        scales[out][i] += bend * abs(x[j])
        return scales
