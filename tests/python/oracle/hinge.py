"""REVOLUTE and HINGE, as their pages say it in words."""

from __future__ import annotations

from mpmath import mpf

from .core import OutsideDomain, add, branch, dot, formula, magnitude, norm, scale, sub
from .translator import alpha_of, per_length


@formula("revolute.constraint", "e1a:3 e2b:3 e3b:3 c2 c3", "g2 g3")
def tilt(e1a, e2b, e3b, c2, c3):
    return dict(g2=dot(e1a, e2b) - c2, g3=dot(e1a, e3b) - c3)


@formula("revolute.angle", "e2a:3 e3a:3 e3b:3", "alpha", angles="alpha")
def angle(e2a, e3a, e3b):
    return dict(alpha=alpha_of(e2a, e3a, e3b))


@formula("revolute.relative_motion", "alpha alpha0 theta1_ref", "ur1 ur1_mat")
def relative_motion(alpha, alpha0, theta1_ref):
    return dict(ur1=alpha - alpha0, ur1_mat=alpha - theta1_ref)


@formula("revolute.constraint_moment", "e2a:3 e3a:3 m2 m3", "m:3")
def constraint_moment(e2a, e3a, m2, m3):
    return dict(m=add(scale(m2, e2a), scale(m3, e3a)))


@formula("revolute.kinetic_moment", "e1a:3 m1", "m:3")
def kinetic_moment(e1a, m1):
    return dict(m=scale(m1, e1a))


@formula(
    "hinge.constraint",
    "e1a:3 e2a:3 e3a:3 e2b:3 e3b:3 xa:3 xb:3 d0:3 c2 c3",
    "g:3 g2 g3",
)
def constraint(e1a, e2a, e3a, e2b, e3b, xa, xb, d0, c2, c3):
    g = [dot(e, sub(xb, xa)) - start for e, start in zip((e1a, e2a, e3a), d0, strict=True)]
    return dict(g=g, **tilt(e1a, e2b, e3b, c2, c3))


@formula("hinge.stop", "alpha theta1_min theta1_max", "gap_min gap_max")
def stop(alpha, theta1_min, theta1_max):
    if branch(theta1_min > theta1_max):
        raise OutsideDomain("stops out of order")
    return dict(gap_min=alpha - theta1_min, gap_max=theta1_max - alpha)


@formula("hinge.contact_moment", "f1 f2 f3 m2 m3 rp ra ls", "mc")
def contact_moment(f1, f2, f3, m2, m3, rp, ra, ls):
    """Along the pin, across it, and a couple at both ends of the sleeve."""
    return dict(mc=magnitude(f1) * ra + rp * norm(f2, f3) + per_length(2 * rp * norm(m2, m3), ls))


@formula("hinge.friction", "m1 f1 f2 f3 m2 m3 rp ra ls mc_int mu", "p mn phi")
def friction(m1, mc_int, mu, **loads):
    p, mn = magnitude(m1), contact_moment(**loads)["mc"] + magnitude(mc_int)
    return dict(p=p, mn=mn, phi=p - mu * mn)
