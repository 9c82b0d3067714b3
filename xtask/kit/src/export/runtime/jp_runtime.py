"""What the formulas call: lengths that neither overflow nor underflow, sums of products that lose
nothing, the closest place of a curve, a product and a sum rounded once.
Printed by jointproof; free of conditions (CC0-1.0)."""

import functools
import math
from fractions import Fraction

import numpy as np


def over_arrays(function):
    """Without warnings: both sides of every choice are computed, also where they are not taken."""

    @functools.wraps(function)
    def quiet(*arguments, **named):
        with np.errstate(all="ignore"):
            return function(*arguments, **named)

    return quiet


def arrays(fields, given):
    """Inputs as arrays of doubles, a list of components for a vector."""
    inputs = []
    for (name, length), x in zip(fields, given, strict=True):
        x = np.asarray(x, dtype=float)
        if length > 1 and (x.ndim == 0 or x.shape[0] != length):
            raise ValueError(f"{name} has the shape {x.shape}; its first axis must be of length {length}")
        inputs.append([x] if length == 1 else list(x))
    return inputs


def shape_of(given):
    return np.broadcast_shapes(*(x.shape for components in given for x in components))


def stacked(given, results, rows=None):
    """Results along the first axis, or along two if there are so many rows."""
    shape = shape_of(given)
    if shape:
        all_results = np.stack([np.broadcast_to(x, shape) for x in results])
    else:
        all_results = np.array(results, dtype=float)  # one point, which arrays are slow for
    return all_results if rows is None else all_results.reshape(rows, -1, *shape)


def code(given, bounds, together):
    """0, or the position from 1 of the input that is not finite or not in its domain, or what `together` says."""
    shape = shape_of(given)
    found = np.where(np.broadcast_to(together, shape) > 0, len(given) + np.broadcast_to(together, shape), 0)
    for position in range(len(given), 0, -1):
        for x in given[position - 1]:
            allowed = np.isfinite(x)
            for holds in bounds[position - 1]:
                allowed = allowed & holds(x)
            found = np.where(allowed, found, position)
    return found.astype(int)


def accepted(codes, given, required):
    """Raises ValueError where inputs are refused."""
    if not np.any(codes):
        return
    place = np.unravel_index(np.argmax(codes != 0), np.shape(codes))
    code = int(codes[place])
    values = given[code - 1] if code <= len(given) else []
    values = [float(np.broadcast_to(x, np.shape(codes))[place]) for x in values]
    found = ", which is " + ", ".join(map(repr, values)) if values else ""
    at = f" at {tuple(map(int, place))}" if place else ""
    raise ValueError(f"required is {required[code - 1]}{found}{at}")


def norm(*x):
    """The square root of a sum of squares that is rescaled where it would leave the range of doubles."""
    plain = functools.reduce(lambda total, part: total + part * part, x, 0.0)
    large = functools.reduce(lambda any_large, part: any_large | (np.abs(part) > 1.0), x, False)
    factor = np.where(large, 2.0**-600, 2.0**600)
    scaled = functools.reduce(lambda total, part: total + (part * factor) * (part * factor), x, 0.0)
    ordinary = (plain > 2.0**-900) & (plain < 2.0**1000)
    return np.where(ordinary, np.sqrt(plain), np.sqrt(scaled) / factor)


norm2 = norm3 = norm4 = norm


ARC_TANGENT = (
    -0.3333333333333333, 0.19999999999999804, -0.1428571428565978,
    0.11111111105150588, -0.09090908753259112, 0.07692296368042296,
    -0.0666642476020052, 0.05878927554473807, -0.05230443640686948,
    0.045515447340221615, -0.03456931506332609, 0.016284375050043393,
)


def beyond(p, z):
    """z P(z), in parts that do not wait for each other."""
    z2 = z * z
    z4 = z2 * z2
    p0, p4, p8 = ((p[k] + p[k + 1] * z) + (p[k + 2] + p[k + 3] * z) * z2 for k in (0, 4, 8))
    return z * ((p0 + p4 * z4) + p8 * (z4 * z4))


def angle(y, x):
    """The angle of (x, y): beside the nearest sixteenth of a turn the arc tangent is a polynomial."""
    across, along = np.abs(y), np.abs(x)
    large = np.where(across > along, across, along)
    small = np.where(along < across, along, across)
    steep, back, wide = (
        np.where(holds, 1.0, 0.0) for holds in (across > along, x < 0.0, small > 0.41421356237309503 * large)
    )
    t = (small - large * wide) / (large + small * wide)
    rest = t * beyond(ARC_TANGENT, t * t)
    way = (1.0 - 2.0 * steep) * (1.0 - 2.0 * back)
    eighths = (2.0 * steep + (4.0 * back) * (1.0 - steep)) + way * wide
    low = (way * eighths) * 3.061616997868383e-17
    turn = np.copysign(eighths * 0.7853981633974483 + way * (t + (rest + low)), y)
    return np.where((large > 0.0) & (large < 1e300), turn, np.arctan2(y, x))


ARC_SINE = (
    0.16666666666665653, 0.0750000000029469, 0.04464285685604654,
    0.030381958187905646, 0.022371777525770062, 0.017359447897278054,
    0.013887491270956195, 0.012155871500411723, 0.006580488107098665,
    0.01939632260033307, -0.016032766254421116, 0.03179011988382487,
)


def asin(x):
    """The arc sine: up to 1/2 a polynomial, beyond what twice another one leaves of a quarter turn."""
    size = np.abs(x)
    missing = (1.0 - size) * 0.5
    wide = size > 0.5
    z, s = np.where(wide, missing, size * size), np.where(wide, np.sqrt(missing), size)
    turn, low = np.where(wide, 1.5707963267948966, 0.0), np.where(wide, 3.061616997868383e-17, 0.0)
    way = np.where(wide, -2.0, 1.0)
    rest = s * beyond(ARC_SINE, z) - low
    total = turn + way * s
    lost = (turn - total) + way * s
    return np.copysign(total + (lost + way * rest), x)


EXPONENTIAL = (
    0.5, 0.16666666666666666, 0.04166666666666667, 0.008333333333333333,
    0.0013888888888883748, 0.00019841269841266415, 2.4801587325547743e-05,
    2.7557319239957097e-06, 2.75572736431103e-07, 2.5052078002329456e-08,
    2.0914686968086876e-09, 1.6084327883952603e-10,
)


def expm1(x):
    """e^x - 1: with x = k ln 2 + r it is 2^k (e^r - 1) + (2^k - 1), and e^r - 1 is r and a polynomial."""
    usual = (np.abs(x) > 1e-300) & (np.abs(x) < 700.0)
    shifted = np.where(usual, x, 0.0) * 1.4426950408889634 + 6755399441055744.0
    k = shifted - 6755399441055744.0
    above, below = x - k * 0.6931471803691238, k * 1.9082149292705877e-10
    r = above - below
    power = np.ldexp(1.0, k.astype(int))
    more, most = power * r, power - 1.0
    total = most + more
    lost = power * ((above - r) - below) + ((most - total) + more)
    return np.where(usual, total + (more * beyond(EXPONENTIAL, r) + lost), np.expm1(x))


def nearest_integer(x):
    """The nearest integer; of two that are equally near, the one farther from 0."""
    whole = np.trunc(x)
    return np.where(np.abs(x - whole) < 0.5, whole, whole + np.sign(x))


def power_of_two(x):
    """The largest power of two that is not above a positive number, within 2^-1022 and 2^1022."""
    bits = np.ascontiguousarray(x, dtype=float).view(np.int64) & 0x7FF0000000000000
    return np.minimum(bits, 0x7FD0000000000000).view(float).reshape(np.shape(x))


def elementwise(function):
    """A function of numbers, over arrays or of numbers."""
    return lambda *x: np.asarray(np.frompyfunc(function, len(x), 1)(*x), dtype=float)


@elementwise
def multiply_add(x, y, z):
    if not math.isfinite(x * y + z):
        return x * y + z
    exact = Fraction(x) * Fraction(y) + Fraction(z)
    return float(exact) if exact else x * y + z


def two_sum(a, b):
    high = a + b
    part = high - a
    return high, (a - (high - part)) + (b - part)


def halves(x):
    large = x * 134217728.0 + x
    high = large - (large - x)
    return high, x - high


def two_product(a, b):
    high = a * b
    (a1, a2), (b1, b2) = halves(a), halves(b)
    return high, a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2)


def grown(parts, x):
    """An exact sum, kept as parts that do not overlap, smaller ones first, none of them 0 (Shewchuk)."""
    kept = []
    if x == 0.0:
        return parts
    for part in parts:
        x, low = two_sum(x, part)
        if low != 0.0:
            kept.append(low)
    return kept + [x] if x != 0.0 else kept


def with_product(parts, a, b):
    if a == 0.0 or b == 0.0:
        return parts
    high, low = two_product(a, b)
    return grown(grown(parts, low), high)


@elementwise
def exact_sum(*factors):
    """A sum of products of four numbers each: nothing is rounded but the sum in the end."""
    parts = []
    for a, b, c, d in zip(*[iter(factors)] * 4, strict=True):
        three = []
        for part in with_product([], a, b):
            three = with_product(three, part, c)
        for part in three:
            parts = with_product(parts, part, d)
    return functools.reduce(lambda total, part: total + part, parts, 0.0)


def polynomial(p, u):
    """A polynomial, its constant term first, and its slope: Horner's scheme."""
    value = slope = 0.0
    for c in reversed(p):
        value, slope = value * u + c, slope * u + value
    return value, slope


def trimmed(p):
    n = len(p)
    while n > 0 and p[n - 1] == 0.0:
        n -= 1
    return p[:n]


def over(x, y):
    return x / y if y != 0.0 else x * math.inf if x == x and x != 0.0 else math.nan


def crossing(p, start, to, low, high):
    """The place between two others where a polynomial without an extremum there changes sign: by Newton's
    method where that halves the step, else by halving the interval."""
    if high == 0.0:
        return to
    u, step, looked_for_short = start + (to - start) * 0.5, to - start, False
    for _ in range(1200):
        value, slope = polynomial(p, u)
        if value == 0.0:
            return u
        if (value > 0.0) == (low > 0.0):
            start = u
        else:
            to = u
        newton = u - over(value, slope)
        halves_step = abs(newton - u) <= abs(step) * 0.5
        following = newton if start < newton < to and halves_step else start + (to - start) * 0.5
        step = following - u
        if step == 0.0 or following in (start, to):
            return following
        u = following
        if not looked_for_short and abs(step) < 2.0**-40:
            looked_for_short = True
            shorter = math.copysign(math.floor(abs(u) * 2.0**20 + 0.5), u) / 2.0**20
            if polynomial(p, shorter)[0] == 0.0:
                return shorter
    return u


def crossings(p, ends, values, falls):
    """The places between two others where a polynomial falls through zero, or changes sign either way; those
    of its derivative part them. Its values at the two are given."""
    p, inner = trimmed(p), []
    if len(p) > 2:
        rate = trimmed([c * (k + 1) for k, c in enumerate(p[1:])])
        inner = crossings(rate, ends, [polynomial(rate, u)[0] for u in ends], falls=False)
    places, start, low = [], ends[0], values[0]
    for k in range(len(inner) + 1):
        is_last = k == len(inner)
        to, high = (ends[1], values[1]) if is_last else (inner[k], polynomial(p, inner[k])[0])
        sinks = low > 0.0 and (high < 0.0 if is_last else high <= 0.0)
        if sinks if falls else (low < 0.0) != (high < 0.0):
            places.append(crossing(p, start, to, low, high))
        start, low = to, high
    return places


@elementwise
def nearest_place(gx, gy, factor, x1, y1, x2, y2, x3, y3, start, to, low, high):
    """The closest place of a curve X(0) + c Y(u) between two coordinates, given the gap xs - X(0) and the
    residuals (xs - X).Y' at the two, by which either one of them counts or a root between them is found. A
    number before the first coordinate stands for that end, one behind the last for the other."""
    p = [
        gx * x1 + gy * y1,
        (gx * x2 + gy * y2) * 2.0 - factor * (x1 * x1 + y1 * y1),
        ((gx * x3 + gy * y3) - factor * (x1 * x2 + y1 * y2)) * 3.0,
        -((factor * ((x1 * x3 + y1 * y3) * 2.0 + (x2 * x2 + y2 * y2))) * 2.0),
        -((factor * (x2 * x3 + y2 * y3)) * 5.0),
        -((factor * (x3 * x3 + y3 * y3)) * 3.0),
    ]
    places = [(u, None) for u in crossings(p, [start, to], [low, high], falls=True)]
    if low <= 0.0:
        places.insert(0, (start, start - 1.0))
    if high >= 0.0 or not places:
        places.append((to, to + 1.0))

    def reach(a, b, c, u):
        return (((c * u + b) * u + a) * u) * factor

    best = places[0]
    for place in places[1:]:
        # |G_u|^2 - |G_v|^2 = (G_u - G_v).(G_u + G_v), against what rounding does to it.
        ux, uy = reach(x1, x2, x3, place[0]), reach(y1, y2, y3, place[0])
        vx, vy = reach(x1, x2, x3, best[0]), reach(y1, y2, y3, best[0])
        step_x, step_y, twice_x, twice_y = vx - ux, vy - uy, gx * 2.0, gy * 2.0
        excess = step_x * (twice_x - (ux + vx)) + step_y * (twice_y - (uy + vy))
        size_x = (abs(twice_x) + abs(ux)) + abs(vx)
        size_y = (abs(twice_y) + abs(uy)) + abs(vy)
        blur = (abs(step_x) * size_x + abs(step_y) * size_y) * 2.0**-48
        if excess < -blur:
            best = place
    return best[0] if best[1] is None else best[1]
