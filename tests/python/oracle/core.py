"""What every family needs: the catalog, precision, branches, central differences and correct rounding.

Precision. The inputs are doubles, hence integers times a common power of two. With `lo` the exponent of the lowest set
bit among them, `hi` that of the highest, and span = hi - lo:

    step of the differences   h = 2^(lo - 500 - span)
    working precision         6 span + 1800 bits
    bits that are kept        2 span + 500

so a polynomial of moderate degree is exact, the truncation error of a central difference is about 2^-1000, and its
rounding error is smaller still. What lies beyond the kept bits is rounded away, so that a result which is exactly a
double, or exactly halfway between two, is seen as such.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass
from typing import Any, Callable

from mpmath import mag, mp, mpf

Number = mpf
Vector = list  # of Number


class OutsideDomain(ValueError):
    """The formula has no value at these inputs."""


class Ambiguous(ValueError):
    """The value is there, but it has no derivative."""


# ---------------------------------------------------------------------------------------------------------- catalog


@dataclass(frozen=True)
class Formula:
    """One formula: names with the length of each vector (0 for a scalar), and the outputs that are angles."""

    id: str
    inputs: dict[str, int]
    outputs: dict[str, int]
    angles: frozenset[str]
    function: Callable[..., dict[str, Any]]


CATALOG: dict[str, Formula] = {}


def fields(text: str) -> dict[str, int]:
    """'e1a:3 f2' -> {'e1a': 3, 'f2': 0}."""
    pairs = (word.partition(":") for word in text.split())
    return {name: int(length or 0) for name, _, length in pairs}


def formula(id: str, inputs: str, outputs: str, angles: str = ""):
    """Enter the decorated function into the catalog."""

    def enter(function):
        assert id not in CATALOG, id
        CATALOG[id] = Formula(id, fields(inputs), fields(outputs), frozenset(angles.split()), function)
        return function

    return enter


# ---------------------------------------------------------------------------------------------------------- vectors


def dot(a: Vector, b: Vector) -> Number:
    return sum((x * y for x, y in zip(a, b, strict=True)), mpf(0))


def add(*vectors: Vector) -> Vector:
    return [sum(c, mpf(0)) for c in zip(*vectors, strict=True)]


def sub(a: Vector, b: Vector) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def scale(s: Number, a: Vector) -> Vector:
    return [s * x for x in a]


def cross(a: Vector, b: Vector) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(*components: Number) -> Number:
    noteworthy("kink", not any(components))
    return mp.sqrt(sum(c * c for c in components))


def magnitude(x: Number) -> Number:
    noteworthy("kink", x == 0)
    return abs(x)


def unit(a: Vector) -> Vector:
    length = norm(*a)
    if length == 0:
        raise OutsideDomain("a zero vector has no direction")
    return [x / length for x in a]


def sign(x: Number) -> int:
    return (x > 0) - (x < 0)


# --------------------------------------------------------------------------------------------------------- branches
# A decision (a pivot, stick or slip, which root) is taken at the given point and kept while its neighbours are
# evaluated for the difference quotient. A formula passes every decision through `branch`.

_recorded: list[Any] = []
_replayed: list[Any] | None = None


def branch(decision: Any) -> Any:
    """The decision itself at the given point; the decision taken there when a neighbour is evaluated."""
    if _replayed is not None:
        return _replayed.pop(0)
    _recorded.append(decision)
    return decision


def at_a_neighbour() -> bool:
    return _replayed is not None


# Kinks: `norm` and `magnitude` note that they stand at zero ("kink": derivative 0 by convention, if the formula as a
# whole has a corner there), formulas that they stand on a corner between two branches ("switch": no derivative).

_noted: set[str] = set()


def noteworthy(kind: str, condition: bool) -> None:
    if condition and not at_a_neighbour():
        _noted.add(kind)


def kinks(id: str, inputs: dict[str, Any]) -> set[str]:
    """Which of 'kink' and 'switch' these inputs are. A zero magnitude inside a norm that is not zero is neither."""
    entry, p = CATALOG[id], precision_for(inputs)
    with mp.workprec(p.working):
        point = _exact(entry, inputs)
        value, decisions = _call(entry, point, None)
        found = set(_noted)
        if "kink" in found and not _has_corner(entry, point, value, decisions, p):
            found.remove("kink")
    return found


def _has_corner(entry, point, value, decisions, p: Precision) -> bool:
    """Whether the slopes ahead and behind differ in some direction: along an input, or across all of them.

    f(x + h) + f(x - h) - 2 f(x) goes with h at a corner and with h^2 where f is smooth. Where f is linear, rounding is
    all that is left of it; a corner is far above that.
    """
    noise = [mag(v) - p.working + 64 for v in _flat(entry, value)]
    places = [(name, k) for name, length in entry.inputs.items() for k in range(length or 1)]
    askew = {place: mpf(1) + mpf(k * k) / 7 for k, place in enumerate(places)}

    def bends(direction: dict[tuple[str, int], Number], step: int) -> list[Number]:
        ends = []
        for h in (mp.ldexp(mpf(1), step), -mp.ldexp(mpf(1), step)):
            moved = {}
            for name, length in entry.inputs.items():
                by = [h * direction.get((name, k), 0) for k in range(length or 1)]
                moved[name] = add(point[name], by) if length else point[name] + by[0]
            ends.append(_flat(entry, _call(entry, moved, decisions)[0]))
        return [a + b - 2 * v for a, b, v in zip(*ends, _flat(entry, value), strict=True)]

    for direction in [{place: mpf(1)} for place in places] + [askew]:
        for long, short, least in zip(bends(direction, p.step), bends(direction, p.step - 64), noise, strict=True):
            if short != 0 and mag(short) > least and mag(long) - mag(short) < 96:  # 64 at a corner, 128 where smooth
                return True
    return False


def _flat(entry: Formula, outputs: dict[str, Any]) -> list[Number]:
    """The components of the outputs that are not angles: those jump by a whole turn, and have no corners."""
    listed = (outputs[name] if length else [outputs[name]] for name, length in entry.outputs.items())
    return [x for name, xs in zip(entry.outputs, listed, strict=True) if name not in entry.angles for x in xs]


def _call(entry: Formula, inputs: dict[str, Any], decisions: list[Any] | None) -> tuple[dict[str, Any], list[Any]]:
    global _recorded, _replayed
    _recorded, _replayed = [], None if decisions is None else list(decisions)
    if decisions is None:
        _noted.clear()
    try:
        return entry.function(**inputs), _recorded
    finally:
        _recorded, _replayed = [], None


# -------------------------------------------------------------------------------------------------------- precision


@dataclass(frozen=True)
class Precision:
    working: int  # bits
    kept: int  # bits
    step: int  # h = 2^step


def precision_for(inputs: dict[str, Any], more: int = 0) -> Precision:
    """Enough for these doubles; `more` raises everything, to confirm that it was enough."""
    lo = hi = 0
    for value in inputs.values():
        for x in value if isinstance(value, (list, tuple)) else [value]:
            if x != 0:
                numerator, denominator = float(x).as_integer_ratio()
                trailing = (numerator & -numerator).bit_length() - 1
                lo = min(lo, trailing - denominator.bit_length() + 1)
                hi = max(hi, abs(numerator).bit_length() - denominator.bit_length() + 1)
    span = hi - lo
    return Precision(6 * span + 1800 + 4 * more, 2 * span + 500, lo - 500 - span - more)


def _keep(x: Number, bits: int) -> Number:
    with mp.workprec(bits):
        return +x


# ------------------------------------------------------------------------------------------------------- evaluation


def _exact(entry: Formula, inputs: dict[str, Any]) -> dict[str, Any]:
    if set(inputs) != set(entry.inputs):
        raise KeyError(f"{entry.id}: inputs {sorted(inputs)}, expected {sorted(entry.inputs)}")
    exact = {}
    for name, length in entry.inputs.items():
        value = inputs[name]
        if length and len(value) != length:
            raise ValueError(f"{entry.id}: {name} has {len(value)} components, expected {length}")
        exact[name] = [mpf(float(x)) for x in value] if length else mpf(float(value))
        if not all(map(mp.isfinite, exact[name] if length else [exact[name]])):
            raise OutsideDomain(f"{entry.id}: {name} is not finite")
    return exact


def _map(f, value, *more):
    return [f(x, *rest) for x, *rest in zip(value, *more)] if isinstance(value, list) else f(value, *more)


def evaluate(id: str, inputs: dict[str, Any], more: int = 0) -> dict[str, Any]:
    """The outputs, as mpmath numbers good to hundreds of digits."""
    entry, p = CATALOG[id], precision_for(inputs, more)
    with mp.workprec(p.working):
        outputs, _ = _call(entry, _exact(entry, inputs), None)
        return {name: _map(lambda x: _keep(x, p.kept), outputs[name]) for name in entry.outputs}


def jacobian(id: str, inputs: dict[str, Any], more: int = 0) -> dict[str, dict[str, Any]]:
    """d out / d in by central differences: a number, a list, or a list of rows (one per output component)."""
    entry, p = CATALOG[id], precision_for(inputs, more)
    with mp.workprec(p.working):
        point = _exact(entry, inputs)
        value, decisions = _call(entry, point, None)
        result: dict[str, dict[str, Any]] = {out: {} for out in entry.outputs}
        for name, length in entry.inputs.items():
            columns = [_column(entry, point, value, decisions, name, k, p) for k in range(length or 1)]
            for out, out_length in entry.outputs.items():
                if length and out_length:
                    result[out][name] = [[c[out][row] for c in columns] for row in range(out_length)]
                else:
                    result[out][name] = [c[out] for c in columns] if length else columns[0][out]
        return result


def _column(entry, point, value, decisions, name, k, p: Precision) -> dict[str, Any]:
    """d outputs / d (component k of input `name`)."""

    def difference(step: int) -> dict[str, Any]:
        h = mp.ldexp(mpf(1), step)
        ends = []
        for signed in (h, -h):
            moved = dict(point)
            if entry.inputs[name]:
                moved[name] = list(point[name])
                moved[name][k] += signed
            else:
                moved[name] = point[name] + signed
            ends.append(_call(entry, moved, decisions)[0])

        def quotient(plus, minus, is_angle):
            change = plus - minus
            if is_angle and abs(change) > mp.pi:  # across the cut at +-180 degrees
                change -= sign(change) * 2 * mp.pi
            return change / (2 * h)

        return {
            out: _map(lambda a, b, out=out: quotient(a, b, out in entry.angles), ends[0][out], ends[1][out])
            for out in entry.outputs
        }

    first, second = difference(p.step), None
    for out, length in entry.outputs.items():
        for row in range(length or 1):
            d = first[out][row] if length else first[out]
            v = value[out][row] if length else value[out]
            if d != 0 and (mag(d) < -150 or mag(d) < mag(v) - 150):
                # Very small: a derivative does not care about the step, the remainder of a vanishing one does.
                second = second or difference(p.step - 64)
                d2 = second[out][row] if length else second[out]
                if abs(d - d2) > mp.ldexp(abs(d), -60):
                    d = mpf(0)
            d = _keep(d, p.kept)
            if length:
                first[out][row] = d
            else:
                first[out] = d
    return first


# --------------------------------------------------------------------------------------------------------- rounding


def to_double(x: Number) -> float:
    """The double nearest to x, ties to even, with subnormals and overflow; exact integer arithmetic."""
    if not mp.isfinite(x):
        return float(x)
    negative, mantissa, exponent, bits = x._mpf_
    mantissa = int(mantissa)
    if mantissa == 0:
        return 0.0
    drop = max(bits - 53, -1074 - exponent)  # bits below the last one of the double
    if drop > 0:
        mantissa, rest = mantissa >> drop, mantissa & ((1 << drop) - 1)
        half = 1 << (drop - 1)
        if rest > half or (rest == half and mantissa & 1):
            mantissa += 1
        exponent += drop
    try:
        magnitude = math.ldexp(mantissa, exponent)
    except OverflowError:
        magnitude = math.inf
    return -magnitude if negative else magnitude


def bits_of(x: float) -> int:
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def ulps_between(a: float, b: float) -> float:
    """How many doubles apart, counting through zero; infinite if either is NaN."""
    if math.isnan(a) or math.isnan(b):
        return math.inf

    def place(x: float) -> int:
        bits = bits_of(x)
        return -(bits & ~(1 << 63)) if bits >> 63 else bits

    return abs(place(a) - place(b))
