"""The oracle's definitions on CasADi's symbols instead of numbers of thousands of bits.

The oracle states every equation over the functions of mpmath; here a module of that name stands in whose numbers are
expressions. Where a definition asks which of two expressions is less, it is run once for each answer, and the results
are joined by `if_else`. Two expressions are never taken as equal: what a formula says about such points (no direction,
a length of zero) is a convention at single points, which a program made by CasADi does without, and is faster for it.
"""

from __future__ import annotations

import math
import sys
from contextlib import nullcontext
from pathlib import Path
from types import ModuleType
from typing import Any, Callable

import casadi as ca

#: Formulas whose foot is found by iteration until nothing changes: there is no expression for it.
ITERATIVE = {
    f"slide_line.closest_{curve}" for curve in ("parabolic", "smoothed_linear", "smoothed_parabolic")
}


class Number:
    """An expression; CasADi's own class compares into expressions, which `if` cannot read."""

    def __init__(self, expression: Any):
        self.expression = expression

    def __add__(self, other):
        return Number(self.expression + plain(other))

    def __sub__(self, other):
        return Number(self.expression - plain(other))

    def __mul__(self, other):
        return Number(self.expression * plain(other))

    def __truediv__(self, other):
        return Number(self.expression / plain(other))

    def __rsub__(self, other):
        return Number(plain(other) - self.expression)

    def __rtruediv__(self, other):
        return Number(plain(other) / self.expression)

    __radd__, __rmul__ = __add__, __mul__

    def __pow__(self, power: int):
        return Number(self.expression**power)

    def __neg__(self):
        return Number(-self.expression)

    def __abs__(self):
        return Number(ca.fabs(self.expression))

    def __lt__(self, other):
        return RUN.is_less(self.expression, plain(other))

    def __gt__(self, other):
        return RUN.is_less(plain(other), self.expression)

    def __le__(self, other):
        return not self > other

    def __ge__(self, other):
        return not self < other

    def __eq__(self, other):
        return False

    def __bool__(self):
        return not (self.expression.is_constant() and float(self.expression) == 0)


def plain(x: Any) -> Any:
    return x.expression if isinstance(x, Number) else x


def number(x: Any) -> Any:
    return x if isinstance(x, Number) else float(x)


class Run:
    """The answers given so far in one run of a definition."""

    def __init__(self):
        self.given: list[bool] = []
        self.asked: list[tuple[ca.SX, ca.SX, bool]] = []

    def begin(self, given: list[bool]) -> None:
        self.given, self.asked = given, []

    def is_less(self, a: Any, b: Any) -> bool:
        a, b = ca.SX(a), ca.SX(b)
        if (a - b).is_constant():
            return float(a - b) < 0
        for x, y, answer in self.asked:
            if same(x, a) and same(y, b):
                return answer
            if same(x, b) and same(y, a):
                return not answer
        answer = self.given[len(self.asked)] if len(self.asked) < len(self.given) else True
        self.asked.append((a, b, answer))
        return answer


RUN = Run()


def same(a: ca.SX, b: ca.SX) -> bool:
    return ca.is_equal(a, b, 30)


def unary(ours: Callable, theirs: Callable) -> Callable:
    return lambda x: Number(ours(x.expression)) if isinstance(x, Number) else theirs(x)


def stand_in() -> ModuleType:
    """What the oracle imports as mpmath."""
    module, functions = ModuleType("mpmath"), ModuleType("mp")
    functions.sqrt, functions.exp = unary(ca.sqrt, math.sqrt), unary(ca.exp, math.exp)
    functions.asin = unary(ca.asin, math.asin)
    functions.sin, functions.cos = unary(ca.sin, math.sin), unary(ca.cos, math.cos)
    # More digits are for numbers.
    functions.dps, functions.workdps = 15, lambda digits: nullcontext()
    functions.atan2 = lambda y, x: Number(ca.atan2(plain(y), plain(x)))
    functions.pi, functions.e = math.pi, math.e
    module.mp, module.mpf, module.mag = functions, number, None
    return module


def oracle() -> ModuleType:
    """The package `oracle` on expressions. The process that calls this has none on mpmath."""
    assert "oracle" not in sys.modules
    kept = sys.modules.get("mpmath")
    sys.modules["mpmath"] = stand_in()
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
    try:
        import oracle
    finally:
        sys.path.pop(0)
        del sys.modules["mpmath"]
        if kept is not None:
            sys.modules["mpmath"] = kept
    return oracle


CATALOG = oracle().CATALOG
OutsideDomain = sys.modules["oracle.core"].OutsideDomain


def closest_linear(xs, x1, x2):
    """In the oracle this is one of the curves whose foot is searched for; between two points it is a quotient."""
    e, s = [b - a for a, b in zip(x1, x2)], [2 * x - a - b for x, a, b in zip(xs, x1, x2)]
    along = (s[0] * e[0] + s[1] * e[1]) / (e[0] * e[0] + e[1] * e[1])
    g = Number(ca.fmax(-1, ca.fmin(1, along.expression)))
    gap = [(s - g * e) / 2 for s, e in zip(s, e)]
    length = Number(ca.sqrt((e[0] * e[0] + e[1] * e[1]).expression))
    return dict(g=g, separation=(gap[1] * e[0] - gap[0] * e[1]) / length)


OWN = {"slide_line.closest_linear": closest_linear}


def function(id: str) -> ca.Function:
    """From all inputs in a row to all outputs and the dense Jacobian, output by output."""
    entry = CATALOG[id]
    x = ca.SX.sym("x", sum(length or 1 for length in entry.inputs.values()))
    arguments, first = {}, 0
    for name, length in entry.inputs.items():
        parts = [Number(x[first + k]) for k in range(length or 1)]
        arguments[name] = parts if length else parts[0]
        first += length or 1
    y = joined(entry, OWN.get(id, entry.function), arguments, [])
    if y is None:
        raise ValueError(f"{id} has no value anywhere")
    # Matrices of CasADi go column by column.
    results = ca.cse([y, ca.densify(ca.jacobian(y, x).T)])
    return ca.Function(id.replace(".", "_"), [x], results)


def joined(entry: Any, definition: Callable, arguments: dict[str, Any], given: list[bool]) -> ca.SX | None:
    """The outputs where these answers are given; None where there are none."""
    RUN.begin(given)
    try:
        found = definition(**arguments)
        outputs = ca.vertcat(*(plain(c) for out in entry.outputs for c in components(found[out])))
    except OutsideDomain:
        outputs = None
    asked = RUN.asked
    if len(asked) == len(given):
        return outputs
    a, b, _ = asked[len(given)]
    yes, no = (joined(entry, definition, arguments, given + [answer]) for answer in (True, False))
    if yes is None or no is None:
        return no if yes is None else yes
    pairs = ((yes[k], no[k]) for k in range(yes.numel()))
    return ca.vertcat(*(p if same(p, q) else ca.if_else(a < b, p, q) for p, q in pairs))


def components(value: Any) -> list[Any]:
    return value if isinstance(value, list) else [value]
