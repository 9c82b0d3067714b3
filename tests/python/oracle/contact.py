"""Contact along a slide line as an element: nodal forces."""

from .core import formula, scale, sub, unit
from .slide_line import THREE, at, derivative, halves, linear, normal, parabolic, value

WEIGHTS = {2: halves([1, -1], [1, 1]), 3: halves([0, -1, 1], [2, 0, -2], [0, 1, 1])}
CURVES = {2: linear, 3: parabolic}


def place(nodes, g):
    """Tangent, normal, and what every node weighs at a place."""
    t = unit(at(map(derivative, CURVES[len(nodes)](*nodes)), g))
    return t, normal(t), [value(w, g) for w in WEIGHTS[len(nodes)]]


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
