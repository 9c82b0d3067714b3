"""Contact along a slide line as an element: rows, nodal forces, stiffness and the response of ISL21A.

The stiffness is found by moving one node at a time: how the foot follows (the implicit function theorem on the condition that
the gap is perpendicular), and how normal and weights change with both.
"""

from mpmath import mpf

from .core import OutsideDomain, add, branch, dot, formula, norm, noteworthy, scale, sub, unit
from .interaction import pressure_linear
from .slide_line import (
    THREE,
    at,
    contact_area_linear,
    derivative,
    halves,
    linear,
    normal,
    parabolic,
    slip_increment_linear,
    value,
)
from .slot import return_map

WEIGHTS = {2: halves([1, -1], [1, 1]), 3: halves([0, -1, 1], [2, 0, -2], [0, 1, 1])}
CURVES = {2: linear, 3: parabolic}


def place(nodes, g):
    """Tangent, normal, and what every node weighs at a place."""
    t = unit(at(map(derivative, CURVES[len(nodes)](*nodes)), g))
    return t, normal(t), [value(w, g) for w in WEIGHTS[len(nodes)]]


def rows(nodes, g):
    t, n, weights = place(nodes, g)
    found = {}
    for name, direction in (("e11", n), ("e12", t)):
        found[f"{name}_us"] = direction
        for i, weight in enumerate(weights, 1):
            found[f"{name}_u{i}"] = scale(-weight, direction)
    return found


def outputs(prefix, size, count):
    return " ".join(f"{prefix}_u{i}:{size}" for i in ["s", *range(1, count + 1)])


@formula("slide_line.rows_linear", "x1:2 x2:2 g", outputs("e11", 2, 2) + " " + outputs("e12", 2, 2))
def rows_linear(x1, x2, g):
    return rows([x1, x2], g)


@formula("slide_line.rows_parabolic", THREE + " g", outputs("e11", 2, 3) + " " + outputs("e12", 2, 3))
def rows_parabolic(x1, x2, x3, g):
    return rows([x1, x2, x3], g)


def nodal_forces(nodes, g, area, s11, s12):
    t, n, weights = place(nodes, g)
    fs = sub(scale(area * s11, n), scale(area * s12, t))
    return dict(fs=fs, **{f"f{i}": scale(-weight, fs) for i, weight in enumerate(weights, 1)})


@formula("slide_line.nodal_forces_linear", "x1:2 x2:2 g area s11 s12", "fs:2 f1:2 f2:2")
def nodal_forces_linear(x1, x2, g, area, s11, s12):
    return nodal_forces([x1, x2], g, area, s11, s12)


@formula("slide_line.nodal_forces_parabolic", THREE + " g area s11 s12", "fs:2 f1:2 f2:2 f3:2")
def nodal_forces_parabolic(x1, x2, x3, g, area, s11, s12):
    return nodal_forces([x1, x2, x3], g, area, s11, s12)


def force_changes(nodes, g, separation, force):
    """The changes of the forces on the slave and on the nodes, a list of columns of vectors."""
    curve = CURVES[len(nodes)](*nodes)
    velocity = [derivative(p) for p in curve]
    rate, bend = at(velocity, g), at(map(derivative, velocity), g)
    t, n, weights = place(nodes, g)
    rates = [value(derivative(w), g) for w in WEIGHTS[len(nodes)]]
    gap = scale(separation, n)
    slope = dot(gap, bend) - dot(rate, rate)
    if slope >= 0:
        raise OutsideDomain("the slave point is on the centre of curvature or beyond it")
    columns = []
    for node in range(-1, len(nodes)):
        for axis in ([mpf(1), mpf(0)], [mpf(0), mpf(1)]):
            of_point, of_rate = (mpf(-1), mpf(0)) if node < 0 else (weights[node], rates[node])
            # 0 = d(gap . X') = (-of_point e) . X' + gap . (of_rate e) + slope dg
            dg = (of_point * dot(axis, rate) - of_rate * dot(axis, gap)) / slope
            change = add(scale(of_rate, axis), scale(dg, bend))
            across = sub(change, scale(dot(change, t), t))
            dn = scale(1 / norm(*rate), normal(across))
            column = [scale(force, dn)]
            for weight, by_g in zip(weights, rates, strict=True):
                column.append(scale(-force, add(scale(weight, dn), scale(by_g * dg, n))))
            columns.append(column)
    return columns


def stiffness(nodes, g, separation, force):
    columns = force_changes(nodes, g, separation, force)
    names = ["us", *(f"u{i}" for i in range(1, len(nodes) + 1))]
    found = {}
    for i, row in enumerate(names):
        for j, column in list(enumerate(names))[i:]:
            found[f"k_{row}_{column}"] = [columns[2 * j + b][i][a] for a in range(2) for b in range(2)]
    return found


LINEAR_BLOCKS = ["k_us_u1", "k_u1_u1", "k_u1_u2", "k_u2_u2"]


@formula(
    "slide_line.geometric_stiffness_linear",
    "x1:2 x2:2 g separation lambda",
    " ".join(f"{block}:4" for block in LINEAR_BLOCKS),
)
def geometric_stiffness_linear(x1, x2, g, separation, **force):
    found = stiffness([x1, x2], g, separation, force["lambda"])
    return {block: found[block] for block in LINEAR_BLOCKS}


PARABOLIC_BLOCKS = [f"k_u{i}_u{j}" for k, i in enumerate("s123") for j in "s123"[k:]]


@formula(
    "slide_line.geometric_stiffness_parabolic",
    THREE + " g separation lambda",
    " ".join(f"{block}:4" for block in PARABOLIC_BLOCKS),
)
def geometric_stiffness_parabolic(x1, x2, x3, g, separation, **force):
    return stiffness([x1, x2, x3], g, separation, force["lambda"])
