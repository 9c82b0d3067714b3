"""Points in general position, and results as doubles, for the tests."""

from __future__ import annotations

import math
import random

from oracle import CATALOG, evaluate, jacobian
from oracle.core import to_double

def triad(rng: random.Random) -> list[list[float]]:
    """A random right-handed orthonormal triad, rounded to doubles: a unit quaternion's matrix."""
    q = [rng.gauss(0, 1) for _ in range(4)]
    w, x, y, z = (c / math.hypot(*q) for c in q)
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


POSITIVE = {"la", "rp", "ra", "ls", "rr", "l", "c0", "p0", "k", "mu", "mu0", "fn", "h"}


def sample(id: str, rng: random.Random) -> dict:
    """A point in general position."""
    a, b = triad(rng), triad(rng)
    given = {f"e{k + 1}a": a[k] for k in range(3)} | {f"e{k + 1}b": b[k] for k in range(3)}
    special = {"g": (-0.9, 0.9), "t": (0.1, 0.9), "f": (0.05, 0.45), "eta": (0.1, 0.9)}
    point = {}
    for name, length in CATALOG[id].inputs.items():
        if length == 3 and name in given:
            point[name] = given[name]
        elif id == "slide_line.closest_linear" and name in ("x1", "x2"):
            point[name] = [rng.uniform(-3, -2) if name == "x1" else rng.uniform(2, 3), rng.uniform(-1, 1)]
        elif length:
            point[name] = [rng.uniform(-2, 2) for _ in range(length)]
        else:
            low, high = special.get(name, (0.1, 2.0) if name in POSITIVE else (-2.0, 2.0))
            point[name] = rng.uniform(low, high)
    return point


def leaves(nested) -> list:
    if isinstance(nested, dict):
        return [x for v in nested.values() for x in leaves(v)]
    return [x for v in nested for x in leaves(v)] if isinstance(nested, list) else [nested]


def doubles(nested, rounded=to_double):
    if isinstance(nested, dict):
        return {k: doubles(v, rounded) for k, v in nested.items()}
    return [doubles(v, rounded) for v in nested] if isinstance(nested, list) else rounded(nested)


def values(id: str, **inputs) -> dict:
    return doubles(evaluate(id, inputs))


def derivatives(id: str, **inputs) -> dict:
    return doubles(jacobian(id, inputs))
