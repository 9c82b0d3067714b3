"""Slide lines and the ISL elements on them (seed 004), in the plane (r, z).

The closest point of a curve X(u), u in [a, b], to a slave point xs: every place in (a, b) where (xs - X) . X' changes
sign, and both ends, are compared, and the nearest is taken. A curve is a list of two polynomials, a polynomial the
list of its coefficients, lowest power first.
"""

from mpmath import mag, mp, mpf

from .core import Ambiguous, OutsideDomain, add, at_a_neighbour, branch, dot, formula, norm, scale, sub, unit

THREE, FIVE = "x1:2 x2:2 x3:2", "x1:2 x2:2 x3:2 x4:2 x5:2"


# ------------------------------------------------------------------------------------------------------ polynomials


def value(p, u):
    total = mpf(0)
    for c in reversed(p):
        total = total * u + c
    return total


def derivative(p):
    return [k * c for k, c in enumerate(p)][1:]


def poly_add(p, q):
    size = max(len(p), len(q))
    p, q = p + [mpf(0)] * (size - len(p)), q + [mpf(0)] * (size - len(q))
    return [a + b for a, b in zip(p, q)]


def poly_mul(p, q):
    product = [mpf(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            product[i + j] += a * b
    return product


def at(curve, u):
    return [value(p, u) for p in curve]


def combine(points, weights):
    """The curve sum_i weights_i(u) points_i, from points and the polynomials that weigh them."""
    curve = []
    for axis in range(2):
        total = [mpf(0)]
        for x, w in zip(points, weights, strict=True):
            total = poly_add(total, [x[axis] * c for c in w])
        curve.append(total)
    return curve


# ----------------------------------------------------------------------------------------------------------- curves


def halves(*rows):
    return [[mpf(c) / 2 for c in row] for row in rows]


def linear(x1, x2):
    return combine([x1, x2], halves([1, -1], [1, 1]))


def parabolic(x1, x2, x3):
    return combine([x1, x2, x3], halves([0, -1, 1], [2, 0, -2], [0, 1, 1]))


def check_fraction(f):
    if not 0 < f < mpf(1) / 2:
        raise OutsideDomain("the smoothing fraction lies between 0 and 1/2")


def smoothed_linear(x1, x2, x3, f):
    """Quadratic Bezier (x2 + f (x1 - x2), x2, x2 + f (x3 - x2))."""
    start, end = add(x2, scale(f, sub(x1, x2))), add(x2, scale(f, sub(x3, x2)))
    weights = [[1, -2, 1], [0, 2, -2], [0, 0, 1]]
    return combine([start, x2, end], weights)


def smoothed_parabolic(x1, x2, x3, x4, x5, f):
    """Cubic Bezier from A on the first segment to B on the second, tangent to both."""
    before, after = parabolic(x1, x2, x3), parabolic(x3, x4, x5)
    a, da = at(before, 1 - 2 * f), at(map(derivative, before), 1 - 2 * f)
    b, db = at(after, -1 + 2 * f), at(map(derivative, after), -1 + 2 * f)
    controls = [a, add(a, scale(4 * f / 3, da)), sub(b, scale(4 * f / 3, db)), b]
    weights = [[1, -3, 3, -1], [0, 3, -6, 3], [0, 0, 3, -3], [0, 0, 0, 1]]
    return combine(controls, weights)


def point(curve, u):
    return dict(x=at(curve, u), dx=at(map(derivative, curve), u))


def normal(t):
    """n = s x t with s = (0, 0, 1)."""
    return [-t[1], t[0]]


# ---------------------------------------------------------------------------------------------------- closest point


def crossings(p, a, b):
    """Where p changes sign between a and b: between neighbouring extrema there is at most one such place."""
    while p and p[-1] == 0:
        p = p[:-1]
    if len(p) < 2:
        return []
    edges = [a] + crossings(derivative(p), a, b) + [b]
    return [crossing(p, lo, hi) for lo, hi in zip(edges, edges[1:]) if value(p, lo) * value(p, hi) < 0] + [
        e for e in edges[1:-1] if value(p, e) == 0  # a double or triple root, met exactly
    ]


def crossing(p, lo, hi):
    """Bisection, and as soon as Newton's method stays inside the bracket and settles, its limit."""
    dp, rising = derivative(p), value(p, hi) > 0
    for step in range(2 * mp.prec):
        u = (lo + hi) / 2
        v = value(p, u)
        if v == 0:
            return u
        lo, hi = (lo, u) if (v > 0) == rising else (u, hi)
        if step % 40 == 39:
            u = newton(p, dp, u)
            if u is not None and lo <= u <= hi:
                return tidy(p, u)
    return tidy(p, (lo + hi) / 2)


def newton(p, dp, u):
    """The root that Newton's method settles on, quadratically, from u; None if it does not."""
    for _ in range(16):
        slope = value(dp, u)
        if slope == 0:
            return None
        change = value(p, u) / slope
        u -= change
        if change == 0 or mag(change) < 16 + max(mag(u), -300) - mp.prec // 2:
            return u - value(p, u) / value(dp, u)  # half of the digits were right, the last step gives the rest
    return None


def tidy(p, u):
    """A short binary fraction beside u, if that is exactly a root."""
    with mp.workprec(120):
        short = mpf(mp.nint(mp.ldexp(u, 110)))
    short = mp.ldexp(short, -110)
    return short if abs(short - u) < mp.ldexp(mpf(1), -130) and value(p, short) == 0 else u


def closest(xs, curve, a, b):
    """(u, separation) of the nearest point, the end itself where the foot lies outside."""
    gap = [[x - curve[k][0]] + [-c for c in curve[k][1:]] for k, x in enumerate(xs)]
    velocity = [derivative(p) for p in curve]
    p = poly_add(poly_mul(gap[0], velocity[0]), poly_mul(gap[1], velocity[1]))
    if not at_a_neighbour():
        a, b = mpf(a), mpf(b)
        inside = crossings(p, a, b)
        candidates = [(u, True) for u in inside] + [(u, False) for u in (a, b) if u not in inside]
        # on a tie the smaller coordinate
        u, interior = min(candidates, key=lambda c: (dot(at(gap, c[0]), at(gap, c[0])), c[0]))
    else:
        u = interior = None
    u, interior = branch((u, interior))
    if at_a_neighbour() and interior:  # the root of the neighbouring polynomial that grew out of this one
        u = newton(p, derivative(p), u)
        if u is None:
            raise Ambiguous("a multiple root has no derivative")
    return u, dot(at(gap, u), normal(unit(at(velocity, u))))


# --------------------------------------------------------------------------------------------------------- formulas


@formula("slide_line.basis", "dx:2", "t:2 n:2")
def basis(dx):
    t = unit(dx)
    return dict(t=t, n=normal(t))


@formula("slide_line.linear_point", "x1:2 x2:2 g", "x:2 dx:2")
def linear_point(x1, x2, g):
    return point(linear(x1, x2), g)


@formula("slide_line.parabolic_point", THREE + " g", "x:2 dx:2")
def parabolic_point(x1, x2, x3, g):
    return point(parabolic(x1, x2, x3), g)


@formula("slide_line.smoothed_linear_point", THREE + " f t", "x:2 dx:2")
def smoothed_linear_point(x1, x2, x3, f, t):
    check_fraction(f)
    return point(smoothed_linear(x1, x2, x3, f), t)


@formula("slide_line.smoothed_parabolic_point", FIVE + " f t", "x:2 dx:2")
def smoothed_parabolic_point(x1, x2, x3, x4, x5, f, t):
    check_fraction(f)
    return point(smoothed_parabolic(x1, x2, x3, x4, x5, f), t)


@formula("slide_line.closest_linear", "xs:2 x1:2 x2:2", "g separation")
def closest_linear(xs, x1, x2):
    g, separation = closest(xs, linear(x1, x2), -1, 1)
    return dict(g=g, separation=separation)


@formula("slide_line.closest_parabolic", "xs:2 " + THREE, "g separation")
def closest_parabolic(xs, x1, x2, x3):
    g, separation = closest(xs, parabolic(x1, x2, x3), -1, 1)
    return dict(g=g, separation=separation)


@formula("slide_line.closest_smoothed_linear", "xs:2 " + THREE + " f", "t separation")
def closest_smoothed_linear(xs, x1, x2, x3, f):
    check_fraction(f)
    t, separation = closest(xs, smoothed_linear(x1, x2, x3, f), 0, 1)
    return dict(t=t, separation=separation)


@formula("slide_line.closest_smoothed_parabolic", "xs:2 " + FIVE + " f", "t separation")
def closest_smoothed_parabolic(xs, x1, x2, x3, x4, x5, f):
    check_fraction(f)
    t, separation = closest(xs, smoothed_parabolic(x1, x2, x3, x4, x5, f), 0, 1)
    return dict(t=t, separation=separation)


def slip_increment(curve, shape_curve, g, dxs):
    """t . (dxs - sum_i N_i dx_i): the sum is the same interpolation applied to the increments."""
    return dict(dslip=dot(unit(at(map(derivative, curve), g)), sub(dxs, at(shape_curve, g))))


@formula("slide_line.slip_increment_linear", "x1:2 x2:2 g dxs:2 dx1:2 dx2:2", "dslip")
def slip_increment_linear(x1, x2, g, dxs, dx1, dx2):
    return slip_increment(linear(x1, x2), linear(dx1, dx2), g, dxs)


@formula("slide_line.slip_increment_parabolic", THREE + " g dxs:2 dx1:2 dx2:2 dx3:2", "dslip")
def slip_increment_parabolic(x1, x2, x3, g, dxs, dx1, dx2, dx3):
    return slip_increment(parabolic(x1, x2, x3), parabolic(dx1, dx2, dx3), g, dxs)


@formula("slide_line.contact_area_linear", "x1:2 x2:2", "a1 a2")
def contact_area_linear(x1, x2):
    length = norm(*sub(x2, x1))
    return dict(a1=mp.pi * length * x1[0], a2=mp.pi * length * x2[0])


@formula("slide_line.contact_area_parabolic", THREE, "a1 a2 a3")
def contact_area_parabolic(x1, x2, x3):
    velocity = [derivative(p) for p in parabolic(x1, x2, x3)]

    def area(x, third_parts, g):
        return 2 * mp.pi * x[0] * third_parts / 3 * norm(*at(velocity, mpf(g)))

    return dict(a1=area(x1, 1, -1), a2=area(x2, 4, 0), a3=area(x3, 1, 1))


@formula("slide_line.torque_linear", "x1:2 x2:2 p1 p2", "t")
def torque_linear(x1, x2, p1, p2):
    r1, r2, length = x1[0], x2[0], norm(*sub(x2, x1))
    first = r1**2 / 4 + r1 * r2 / 6 + r2**2 / 12
    second = r1**2 / 12 + r1 * r2 / 6 + r2**2 / 4
    return dict(t=2 * mp.pi * length * (p1 * first + p2 * second))


def gauss_legendre_5():
    """Abscissae and weights in closed form."""
    inner = mp.sqrt(5 - 2 * mp.sqrt(mpf(10) / 7)) / 3
    outer = mp.sqrt(5 + 2 * mp.sqrt(mpf(10) / 7)) / 3
    heavy, light = (322 + 13 * mp.sqrt(70)) / 900, (322 - 13 * mp.sqrt(70)) / 900
    return [(mpf(0), mpf(128) / 225), (inner, heavy), (-inner, heavy), (outer, light), (-outer, light)]


@formula("slide_line.torque_parabolic", THREE + " p1 p2 p3", "t")
def torque_parabolic(x1, x2, x3, p1, p2, p3):
    curve = parabolic(x1, x2, x3)
    velocity = [derivative(p) for p in curve]
    pressure = parabolic([p1, mpf(0)], [p2, mpf(0)], [p3, mpf(0)])[0]
    terms = (w * value(curve[0], g) ** 2 * value(pressure, g) * norm(*at(velocity, g)) for g, w in gauss_legendre_5())
    return dict(t=2 * mp.pi * sum(terms))
