"""SLOT and Coulomb friction (seed 000): node b stays on the line along e1a."""

from mpmath import mp

from .core import add, branch, dot, formula, magnitude, norm, noteworthy, scale, sign, sub


@formula("slot.relative_position", "e1a:3 e2a:3 e3a:3 xa:3 xb:3", "x y z")
def relative_position(e1a, e2a, e3a, xa, xb):
    d = sub(xb, xa)
    return dict(x=dot(e1a, d), y=dot(e2a, d), z=dot(e3a, d))


@formula("slot.constraint", "e2a:3 e3a:3 xa:3 xb:3 y0 z0", "gy gz")
def constraint(e2a, e3a, xa, xb, y0, z0):
    d = sub(xb, xa)
    return dict(gy=dot(e2a, d) - y0, gz=dot(e3a, d) - z0)


@formula("slot.constraint_2d", "e2a:2 xa:2 xb:2 y0", "gy")
def constraint_2d(e2a, xa, xb, y0):
    return dict(gy=dot(e2a, sub(xb, xa)) - y0)


@formula("slot.constraint_force", "e2a:3 e3a:3 f2 f3", "f:3")
def constraint_force(e2a, e3a, f2, f3):
    return dict(f=add(scale(f2, e2a), scale(f3, e3a)))


@formula("slot.relative_motion", "x x0 l1_ref", "u1 u1_mat")
def relative_motion(x, x0, l1_ref):
    return dict(u1=x - x0, u1_mat=x - l1_ref)


@formula("slot.kinetic_force", "e1a:3 f1", "f:3")
def kinetic_force(e1a, f1):
    return dict(f=scale(f1, e1a))


@formula("slot.contact_force", "f2 f3", "fc")
def contact_force(f2, f3):
    return dict(fc=norm(f2, f3))


@formula("slot.normal_force", "fc fc_int", "fn")
def normal_force(fc, fc_int):
    return dict(fn=magnitude(fc + fc_int))


@formula("slot.friction", "f1 f2 f3 fc_int mu", "p fn phi")
def friction(f1, f2, f3, fc_int, mu):
    p = magnitude(f1)
    fn = magnitude(norm(f2, f3) + fc_int)
    return dict(p=p, fn=fn, phi=p - mu * fn)


@formula("slot.stop", "x l1_min l1_max", "gap_min gap_max")
def stop(x, l1_min, l1_max):
    return dict(gap_min=x - l1_min, gap_max=l1_max - x)


@formula("coulomb.yield", "p mu fn", "phi")
def coulomb_yield(p, mu, fn):
    return dict(phi=p - mu * fn)


@formula("coulomb.return_map", "f_trial mu fn", "f")
def return_map(f_trial, mu, fn):
    noteworthy("switch", abs(f_trial) == mu * fn)
    if branch(abs(f_trial) < mu * fn):
        return dict(f=f_trial)
    return dict(f=mu * fn * branch(sign(f_trial)))


@formula("coulomb.return_map_2d", "f_trial:2 mu fn", "f:2")
def return_map_2d(f_trial, mu, fn):
    size = mp.sqrt(dot(f_trial, f_trial))
    noteworthy("switch", size == mu * fn)
    if branch(size < mu * fn or size == 0):
        return dict(f=list(f_trial))
    return dict(f=scale(mu * fn / size, f_trial))


@formula("coulomb.response", "du f_before k_stick mu fn", "f slip")
def response(du, f_before, k_stick, mu, fn):
    f = return_map(f_before + k_stick * du, mu, fn)["f"]
    return dict(f=f, slip=du - (f - f_before) / k_stick)
