"""Evaluates every formula at the points of points.bin, and writes found.bin."""

import numpy as np

from jointproof_numpy import FORMULAS

with open("points.bin", "rb") as points, open("found.bin", "wb") as found:
    for formula in FORMULAS:
        lengths = [length for _, length in formula.INPUTS]
        count = int(np.fromfile(points, dtype="<u8", count=1)[0])
        x = np.fromfile(points, dtype="<f8", count=count * sum(lengths)).reshape(count, -1).T
        inputs, at = [], 0
        for length in lengths:
            inputs.append(x[at] if length == 1 else x[at : at + length])
            at += length
        value = formula.value(*inputs)
        code = formula.refused(*inputs).astype(float)
        rows = [code[None], value]
        if hasattr(formula, "jacobian"):
            again, jacobian = formula.jacobian(*inputs)
            code[(code == 0) & ((again != value) & (value == value)).any(axis=0)] = -1.0
            rows.append(jacobian.reshape(-1, count))
        np.concatenate(rows).T.astype("<f8").tofile(found)
