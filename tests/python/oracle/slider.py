"""SLIDER, the sliding multi-point constraint (seed 002): node m stays on the line from x1 to xn.

Wherever the direction n enters only through ratios, d = xn - x1 is used instead, which is exact.
"""

from mpmath import mpf

from .core import OutsideDomain, add, branch, cross, dot, formula, norm, scale, sub, unit

I, K = [mpf(1), mpf(0), mpf(0)], [mpf(0), mpf(0), mpf(1)]
LINE = "x1:3 xn:3"


def tangent_axis(n):
    """The axis e of t1 = n x e / abs(n x e): i, or k where n lies along i exactly."""
    return branch(K if n[1] == 0 and n[2] == 0 else I)


def pivots(d):
    """(i, j, k), counted from 0: eliminate components i and j, keep k."""
    a1, a2, a3 = map(abs, d)
    if a2 == 0 and a3 == 0:
        return 1, 2, 0
    p, q = max(a2, a3), min(a2, a3)
    i = 1 if a3 >= a2 else 2
    j = 0 if p * p + q * q >= a1 * p else 3 - i  # p (1 + (q/p)^2) >= abs(d1), multiplied by p
    return i, j, 3 - i - j


def span_of(x1, xn):
    d = sub(xn, x1)
    if not any(d):
        raise OutsideDomain("the line has no length")
    return d


def blend(x1, xn, xm, dx1, dxn):
    """w = (1 - xi) dx1 + xi dxn with xi = (xm - x1) . n / l."""
    d = span_of(x1, xn)
    xi = dot(sub(xm, x1), d) / dot(d, d)
    return add(scale(1 - xi, dx1), scale(xi, dxn))


@formula("slider.line", LINE, "n:3 l")
def line(x1, xn):
    d = span_of(x1, xn)
    return dict(n=unit(d), l=norm(*d))


@formula("slider.basis", "n:3", "t1:3 t2:3")
def basis(n):
    t1 = unit(cross(n, tangent_axis(n)))
    return dict(t1=t1, t2=cross(n, t1))


@formula("slider.constraint", LINE + " xm:3", "g1 g2")
def constraint(x1, xn, xm):
    t1, t2 = basis(unit(span_of(x1, xn))).values()
    r = sub(xm, x1)
    return dict(g1=dot(r, t1), g2=dot(r, t2))


@formula("slider.eliminate", LINE + " xmk", "xmi xmj")
def eliminate(x1, xn, xmk):
    d = span_of(x1, xn)
    i, j, k = branch(pivots(d))
    return dict(xmi=x1[i] + d[i] / d[k] * (xmk - x1[k]), xmj=x1[j] + d[j] / d[k] * (xmk - x1[k]))


@formula("slider.direction_variation", LINE + " dx1:3 dxn:3", "dn:3 dl")
def direction_variation(x1, xn, dx1, dxn):
    d = span_of(x1, xn)
    n, l = unit(d), norm(*d)
    dd = sub(dxn, dx1)
    # n (n . dd) = d (d . dd)/(d . d): the same without a root
    dn = scale(1 / l, sub(dd, scale(dot(d, dd) / dot(d, d), d)))
    return dict(dn=dn, dl=dot(n, dd))


@formula("slider.basis_variation", "n:3 dn:3", "dt1:3 dt2:3")
def basis_variation(n, dn):
    """With a = n x e: t1 = a/abs(a), dt1 = (da - t1 (t1 . da))/abs(a), da = dn x e; dt2 = dn x t1 + n x dt1."""
    e = tangent_axis(n)
    a, da = cross(n, e), cross(dn, e)
    t1 = unit(a)
    dt1 = scale(1 / norm(*a), sub(da, scale(dot(a, da) / dot(a, a), a)))
    return dict(dt1=dt1, dt2=add(cross(dn, t1), cross(n, dt1)))


@formula("slider.incremental_constraint", LINE + " xm:3 dx1:3 dxn:3 dxm:3", "r1 r2")
def incremental_constraint(x1, xn, xm, dx1, dxn, dxm):
    t1, t2 = basis(unit(span_of(x1, xn))).values()
    r = sub(dxm, blend(x1, xn, xm, dx1, dxn))
    return dict(r1=dot(t1, r), r2=dot(t2, r))


@formula("slider.increment", LINE + " xm:3 dx1:3 dxn:3 dxmk", "dxmi dxmj")
def increment(x1, xn, xm, dx1, dxn, dxmk):
    d = span_of(x1, xn)
    i, j, k = branch(pivots(d))
    w = blend(x1, xn, xm, dx1, dxn)
    return dict(dxmi=w[i] + d[i] / d[k] * (dxmk - w[k]), dxmj=w[j] + d[j] / d[k] * (dxmk - w[k]))


@formula("slider.constraint_2d", "x1:2 xn:2 xm:2", "g")
def constraint_2d(x1, xn, xm):
    n = unit(span_of(x1, xn))
    return dict(g=dot(sub(xm, x1), [-n[1], n[0]]))


@formula("slider.eliminate_2d", "x1:2 xn:2 xmk", "xmi")
def eliminate_2d(x1, xn, xmk):
    d = span_of(x1, xn)
    k = branch(0 if abs(d[0]) >= abs(d[1]) else 1)
    i = 1 - k
    return dict(xmi=x1[i] + d[i] / d[k] * (xmk - x1[k]))


@formula("slider.incremental_constraint_2d", "x1:2 xn:2 xm:2 dx1:2 dxn:2 dxm:2", "r")
def incremental_constraint_2d(x1, xn, xm, dx1, dxn, dxm):
    n = unit(span_of(x1, xn))
    return dict(r=dot(sub(dxm, blend(x1, xn, xm, dx1, dxn)), [-n[1], n[0]]))


@formula("slider.increment_2d", "x1:2 xn:2 xm:2 dx1:2 dxn:2 dxmk", "dxmi")
def increment_2d(x1, xn, xm, dx1, dxn, dxmk):
    d = span_of(x1, xn)
    k = branch(0 if abs(d[0]) >= abs(d[1]) else 1)
    i = 1 - k
    w = blend(x1, xn, xm, dx1, dxn)
    return dict(dxmi=w[i] + d[i] / d[k] * (dxmk - w[k]))


# SLIDER as an element. Node m takes the force, nodes 1 and n its opposite by the rule of the lever. Matrices are lists of
# their components, row by row.


def lever(x1, xn, xm):
    d = span_of(x1, xn)
    xi = dot(sub(xm, x1), d) / dot(d, d)
    return {"1": xi - 1, "n": -xi, "m": mpf(1)}


def shared(x1, xn, xm, force, name):
    return {f"{name}{node}": scale(weight, force) for node, weight in lever(x1, xn, xm).items()}


@formula("slider.rows", LINE + " xm:3", "g1_u1:3 g1_un:3 g1_um:3 g2_u1:3 g2_un:3 g2_um:3")
def rows(x1, xn, xm):
    t1, t2 = basis(unit(span_of(x1, xn))).values()
    return shared(x1, xn, xm, t1, "g1_u") | shared(x1, xn, xm, t2, "g2_u")


@formula("slider.nodal_forces", LINE + " xm:3 lambda_1 lambda_2", "force_1:3 force_n:3 force_m:3")
def nodal_forces(x1, xn, xm, lambda_1, lambda_2):
    t1, t2 = basis(unit(span_of(x1, xn))).values()
    return shared(x1, xn, xm, add(scale(lambda_1, t1), scale(lambda_2, t2)), "force_")


@formula("slider.rows_2d", "x1:2 xn:2 xm:2", "g_u1:2 g_un:2 g_um:2")
def rows_2d(x1, xn, xm):
    n = unit(span_of(x1, xn))
    return shared(x1, xn, xm, [-n[1], n[0]], "g_u")


@formula("slider.nodal_forces_2d", "x1:2 xn:2 xm:2 lambda", "force_1:2 force_n:2 force_m:2")
def nodal_forces_2d(x1, xn, xm, **multiplier):
    n = unit(span_of(x1, xn))
    return shared(x1, xn, xm, scale(multiplier["lambda"], [-n[1], n[0]]), "force_")


BLOCKS = ("u1_u1", "u1_un", "un_un", "um_un")


def second_derivatives(x1, xn, xm, changes):
    """Sum lambda d2g on the line, from the changes of the force on m as node n moves along each axis.

    On the line xm - x1 is xi d, and the second derivative of d.f(d) = 0 by d is 0: d.d2f = -(P + P^T).
    """
    size = len(changes)
    p = [[changes[column][row] for column in range(size)] for row in range(size)]
    weight = lever(x1, xn, xm)

    def block(of_p, of_transposed):
        return [of_p * p[i][j] + of_transposed * p[j][i] for i in range(size) for j in range(size)]

    w1, wn = weight["1"], weight["n"]
    return dict(zip((f"k_{b}" for b in BLOCKS), (block(-w1, -w1), block(w1, -wn), block(wn, wn), block(1, 0)), strict=True))


def axes(size):
    return [[mpf(int(i == j)) for i in range(size)] for j in range(size)]


@formula("slider.geometric_stiffness", LINE + " xm:3 lambda_1 lambda_2", " ".join(f"k_{b}:9" for b in BLOCKS))
def geometric_stiffness(x1, xn, xm, lambda_1, lambda_2):
    n, still = unit(span_of(x1, xn)), [mpf(0)] * 3
    changes = []
    for axis in axes(3):
        dn = direction_variation(x1, xn, still, axis)["dn"]
        dt1, dt2 = basis_variation(n, dn).values()
        changes.append(add(scale(lambda_1, dt1), scale(lambda_2, dt2)))
    return second_derivatives(x1, xn, xm, changes)


@formula("slider.geometric_stiffness_2d", "x1:2 xn:2 xm:2 lambda", " ".join(f"k_{b}:4" for b in BLOCKS))
def geometric_stiffness_2d(x1, xn, xm, **multiplier):
    changes = []
    for axis in axes(2):
        dn = direction_variation(x1, xn, [mpf(0)] * 2, axis)["dn"]
        changes.append(scale(multiplier["lambda"], [-dn[1], dn[0]]))
    return second_derivatives(x1, xn, xm, changes)
