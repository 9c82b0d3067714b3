"""A formula of every room, as their equations are printed in the book, for JAX and for CasADi.

A definition takes the functions of a library and the components of the inputs in order, and returns those of the outputs.
What the equations say about single points where a length is zero is left out, which is faster.
"""

from __future__ import annotations

from math import e, pi

import numpy as np


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def slot_friction(lib, f1, f2, f3, fc_int, mu):
    p = lib.abs(f1)
    fn = lib.abs(lib.sqrt(f2 * f2 + f3 * f3) + fc_int)
    return [p, fn, p - mu * fn]


def coulomb_response(lib, du, f_before, k_stick, mu, fn):
    trial = f_before + k_stick * du
    f = lib.where(lib.abs(trial) < mu * fn, trial, mu * fn * lib.sign(trial))
    return [f, du - (f - f_before) / k_stick]


def cardan_angles(lib, *components):
    e1a, e2a, e3a, e1b, e2b, e3b = (components[k : k + 3] for k in range(0, 18, 3))
    alpha = -lib.arctan2(dot(e2a, e3b), dot(e3a, e3b))
    return [alpha, lib.arcsin(dot(e1a, e3b)), -lib.arctan2(dot(e1a, e2b), dot(e1a, e1b))]


def align_constraint_moment(lib, *components):
    e1a, e2a, e3a, m = (components[k : k + 3] for k in range(0, 12, 3))
    return [dot(m, axes) for axes in zip(e1a, e2a, e3a)]


def translator_bending_force(lib, m2, m3, length):
    m_bend = lib.sqrt(m2 * m2 + m3 * m3)
    return [m_bend, 2 * m_bend / length]


def join_constraint(lib, *components):
    e1a, e2a, e3a, xa, xb, d0 = (components[k : k + 3] for k in range(0, 18, 3))
    return [dot(axis, minus(xb, xa)) - d for axis, d in zip((e1a, e2a, e3a), d0)]


def universal_kinetic_moment(lib, *components):
    e1a, e3b = components[:3], components[3:6]
    m1, m3 = components[6:]
    return [m1 * x + m3 * y for x, y in zip(e1a, e3b)]


def ujoint_decomposition(lib, *components):
    e1a, e2a, e3a, e3b, f = (components[k : k + 3] for k in range(0, 15, 3))
    force = [dot(f, axes) for axes in zip(e1a, e2a, e3a)]
    return [dot(force, e1a), dot(force, e3b), dot(force, cross(e1a, e3b))]


def slider_constraint(lib, *components):
    x1, xn, xm = (components[k : k + 3] for k in range(0, 9, 3))
    d, v = minus(xn, x1), minus(xm, x1)
    length = lib.sqrt(dot(d, d))
    n = [x / length for x in d]
    across = lib.sqrt(n[1] * n[1] + n[2] * n[2])
    t1 = [0.0, n[2] / across, -n[1] / across]
    return [dot(v, t1), dot(v, cross(n, t1))]


def slide_line_torque_linear(lib, r1, z1, r2, z2, p1, p2):
    length = lib.sqrt((r2 - r1) * (r2 - r1) + (z2 - z1) * (z2 - z1))
    first = r1 * r1 / 4 + r1 * r2 / 6 + r2 * r2 / 12
    second = r1 * r1 / 12 + r1 * r2 / 6 + r2 * r2 / 4
    return [2 * pi * length * (p1 * first + p2 * second)]


def interaction_pressure_exponential(lib, h, c0, p0):
    # Of s near 0 the difference of exp(s) and 1 keeps no digit, nor does that of h/c0 and -1.
    s = (h + c0) / c0
    return [lib.where(s > 0, p0 / (e - 1) * s * lib.expm1(s), 0.0)]


def element_arm(lib, *components):
    r, f, m = (components[k : k + 3] for k in range(0, 9, 3))
    along = dot(r, f)
    stiffness = [r[i] * f[j] - (along if i == j else 0.0) for i in range(3) for j in range(3)]
    return [*(x + y for x, y in zip(m, cross(r, f))), *stiffness]


def slot_2d(lib, unknowns, *components):
    """The residual of SLOT in the plane with friction, over displacements and rotations of a and b and the force that keeps the residual at 0."""
    ua_x, ua_y, turn, ub_x, ub_y, _, f2 = unknowns
    e2a, xa, xb = (components[k : k + 2] for k in range(0, 6, 2))
    _, x0, y0, k_stick, fc_int, mu, u1, f1 = components[6:]
    cos, sin = lib.cos(turn), lib.sin(turn)
    e2 = [cos * e2a[0] - sin * e2a[1], sin * e2a[0] + cos * e2a[1]]
    e1 = [e2[1], -e2[0]]
    d = [xb[0] + ub_x - xa[0] - ua_x, xb[1] + ub_y - xa[1] - ua_y]
    trial = f1 + k_stick * (dot(e1, d) - x0 - u1)
    limit = mu * lib.abs(lib.abs(f2) + fc_int)
    f = lib.where(lib.abs(trial) < limit, trial, limit * lib.sign(trial))
    on_b = [f2 * e2[k] - f * e1[k] for k in range(2)]
    return [-on_b[0], -on_b[1], d[1] * on_b[0] - d[0] * on_b[1], *on_b, 0.0 * turn, dot(e2, d) - y0]


def slot_2d_points(draw, count):
    """Inputs of that: some stick, and some slip."""
    turn = draw.uniform(-3.0, 3.0, count)
    some = [draw.uniform(-2.0, 2.0, count) for _ in range(7)]
    k_stick, fc_int, mu = draw.uniform(1.0, 3.0, count), draw.uniform(0.0, 0.1, count), draw.uniform(0.2, 2.0, count)
    return [-np.sin(turn), np.cos(turn), *some, k_stick, fc_int, mu, *(draw.uniform(-0.5, 0.5, count) for _ in range(2))]


def slider_2d(lib, unknowns, *components):
    """The residual of SLIDER in the plane, over displacements of nodes 1, n and m and the force along t."""
    x1, xn, xm = ([x + u for x, u in zip(components[k : k + 2], unknowns[k : k + 2])] for k in range(0, 6, 2))
    force = unknowns[6]
    d, v = minus(xn, x1), minus(xm, x1)
    length = lib.sqrt(dot(d, d))
    n = [x / length for x in d]
    t = [-n[1], n[0]]
    part = dot(v, n) / length
    on_m = [force * x for x in t]
    return [*((part - 1.0) * x for x in on_m), *(-part * x for x in on_m), *on_m, dot(v, t)]


def slider_2d_points(draw, count):
    return [draw.uniform(-2.0, 2.0, count) for _ in range(7)]


def join(lib, unknowns, *components):
    """The residual of JOIN, over displacements and rotations of a and b and the three forces."""
    ua, turn, ub = unknowns[:3], unknowns[3:6], unknowns[6:9]
    axes = [components[k : k + 3] for k in range(0, 9, 3)]
    xa, xb = components[18:21], components[21:24]
    axes = [[x + y for x, y in zip(axis, cross(turn, axis))] for axis in axes]
    d = [b + v - a - u for b, v, a, u in zip(xb, ub, xa, ua)]
    on_b = [dot(unknowns[12:15], axis) for axis in zip(*axes)]
    held = [dot(axis, d) - d0 for axis, d0 in zip(axes, components[27:])]
    return [*(-x for x in on_b), *cross(on_b, d), *on_b, *(0.0 * x for x in unknowns[9:12]), *held]


def join_points(draw, count):
    return [draw.uniform(-2.0, 2.0, count) for _ in range(30)]


DEFINITIONS = {
    "slot.friction": slot_friction,
    "coulomb.response": coulomb_response,
    "cardan.angles": cardan_angles,
    "align.constraint_moment": align_constraint_moment,
    "translator.bending_force": translator_bending_force,
    "join.constraint": join_constraint,
    "universal.kinetic_moment": universal_kinetic_moment,
    "ujoint.decomposition": ujoint_decomposition,
    "slider.constraint": slider_constraint,
    "slide_line.torque_linear": slide_line_torque_linear,
    "interaction.pressure_exponential": interaction_pressure_exponential,
    "element.arm": element_arm,
}
#: Elements, SLOT with friction: their residual over the unknowns, these from the inputs, and inputs of theirs.
ELEMENTS = {
    "slot_2d": (slot_2d, lambda x: [*(0.0 * x[0] for _ in range(6)), x[6]], slot_2d_points),
    "join": (join, lambda x: [*(0.0 * x[0] for _ in range(12)), *x[24:27]], join_points),
    "slider_2d": (slider_2d, lambda x: [*(0.0 * x[0] for _ in range(6)), x[6]], slider_2d_points),
}
