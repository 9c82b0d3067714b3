"""Evaluates every formula and every element at the points of points.bin, and writes found.bin."""

import numpy as np

from jointproof_numpy import FORMULAS


def all_of(found):
    return found if isinstance(found, tuple) else (found,)


with open("points.bin", "rb") as points, open("found.bin", "wb") as found:
    for formula in FORMULAS:
        lengths = [length for _, length in formula.INPUTS]
        count = int(np.fromfile(points, dtype="<u8", count=1)[0])
        x = np.fromfile(points, dtype="<f8", count=count * sum(lengths)).reshape(count, -1).T
        starts = np.cumsum([0, *lengths[:-1]])

        def inputs_at(x):
            return [x[at] if n == 1 else x[at : at + n] for at, n in zip(starts, lengths)]

        code = formula.refused(*inputs_at(x)).astype(float)
        valid = code == 0
        inputs = inputs_at(x[:, valid])
        functions = [getattr(formula, name) for name in ("value", "jacobian", "step") if hasattr(formula, name)]
        results = all_of(functions[-1](*inputs))
        if len(functions) > 1:
            differ = np.zeros(valid.sum(), dtype=bool)
            for again, value in zip(results, all_of(functions[0](*inputs))):
                differ |= ((again != value) & (value == value)).any(axis=0)
            code[np.flatnonzero(valid)[differ]] = -1.0
        numbers = np.concatenate([result.reshape(-1, valid.sum()) for result in results])
        rows = np.zeros((1 + len(numbers), count))
        rows[0] = code
        rows[1:, valid] = numbers
        rows.T.astype("<f8").tofile(found)
