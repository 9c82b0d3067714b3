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
        inputs, at = [], 0
        for length in lengths:
            inputs.append(x[at] if length == 1 else x[at : at + length])
            at += length
        code = formula.refused(*inputs).astype(float)
        results = values = all_of(formula.value(*inputs))
        largest = getattr(formula, "step", None) or getattr(formula, "jacobian", None)
        if largest:
            results = all_of(largest(*inputs))
            for again, value in zip(results, values):
                code[(code == 0) & ((again != value) & (value == value)).any(axis=0)] = -1.0
        rows = [code[None], *(result.reshape(-1, count) for result in results)]
        np.concatenate(rows).T.astype("<f8").tofile(found)
