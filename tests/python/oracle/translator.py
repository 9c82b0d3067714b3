"""Cardan angles, ALIGN and TRANSLATOR (seed 003). TRANSLATOR = SLOT + ALIGN.

R_ij = ei_a . ej_b and R = R1(alpha) R2(beta) R3(gamma), hence R13 = sin beta, R23 = -sin alpha cos beta,
R33 = cos alpha cos beta, R12 = -cos beta sin gamma, R11 = cos beta cos gamma.
"""

from mpmath import mp, mpf

from .core import OutsideDomain, add, branch, dot, formula, magnitude, norm, noteworthy, scale, sub

TRIADS = "e1a:3 e2a:3 e3a:3 e1b:3 e2b:3 e3b:3"


def angle(sine, cosine):
    """atan2, without a value where both arguments vanish."""
    if sine == 0 and cosine == 0:
        raise OutsideDomain("gimbal lock: both arguments of atan2 are zero")
    return mp.atan2(sine, cosine)


def alpha_of(e2a, e3a, e3b):
    return -angle(dot(e2a, e3b), dot(e3a, e3b))


def beta_of(e1a, e3b):
    sine = dot(e1a, e3b)
    if abs(sine) > 1:
        raise OutsideDomain("abs(e1a . e3b) > 1 has no arc sine")
    return mp.asin(sine)


def gamma_of(e1a, e1b, e2b):
    return -angle(dot(e1a, e2b), dot(e1a, e1b))


@formula("cardan.angles", TRIADS, "alpha beta gamma", angles="alpha gamma")
def angles(e1a, e2a, e3a, e1b, e2b, e3b):
    return dict(alpha=alpha_of(e2a, e3a, e3b), beta=beta_of(e1a, e3b), gamma=gamma_of(e1a, e1b, e2b))


@formula("cardan.beta_two_argument", "e1a:3 e1b:3 e2b:3 e3b:3", "beta")
def beta_two_argument(e1a, e1b, e2b, e3b):
    return dict(beta=angle(dot(e1a, e3b), norm(dot(e1a, e1b), dot(e1a, e2b))))


@formula("align.constraint", TRIADS + " alpha0 beta0 gamma0", "ur1 ur2 ur3", angles="ur1 ur3")
def align_constraint(e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0):
    return dict(
        ur1=alpha_of(e2a, e3a, e3b) - alpha0,
        ur2=beta_of(e1a, e3b) - beta0,
        ur3=gamma_of(e1a, e1b, e2b) - gamma0,
    )


@formula("align.constraint_moment", "e1a:3 e2a:3 e3a:3 m1 m2 m3", "m:3")
def align_constraint_moment(e1a, e2a, e3a, m1, m2, m3):
    return dict(m=add(scale(m1, e1a), scale(m2, e2a), scale(m3, e3a)))


@formula(
    "translator.constraint",
    TRIADS + " xa:3 xb:3 y0 z0 alpha0 beta0 gamma0",
    "gy gz ur1 ur2 ur3",
    angles="ur1 ur3",
)
def constraint(e1a, e2a, e3a, e1b, e2b, e3b, xa, xb, y0, z0, alpha0, beta0, gamma0):
    d = sub(xb, xa)
    aligned = align_constraint(e1a, e2a, e3a, e1b, e2b, e3b, alpha0, beta0, gamma0)
    return dict(gy=dot(e2a, d) - y0, gz=dot(e3a, d) - z0, **aligned)


def per_length(moment, length):
    """moment / length, where a length of exactly 0 drops the term."""
    noteworthy("switch", length == 0)
    return mpf(0) if branch(length == 0) else moment / length


@formula("translator.torque_force", "m1 rr", "m_torq f_torq")
def torque_force(m1, rr):
    return dict(m_torq=magnitude(m1), f_torq=per_length(magnitude(m1), rr))


@formula("translator.radial_force", "f2 f3", "fr")
def radial_force(f2, f3):
    return dict(fr=norm(f2, f3))


@formula("translator.bending_force", "m2 m3 l", "m_bend f_bend")
def bending_force(m2, m3, l):
    return dict(m_bend=norm(m2, m3), f_bend=per_length(2 * norm(m2, m3), l))


@formula("translator.contact_force", "f2 f3 m1 m2 m3 rr l", "fc")
def contact_force(f2, f3, m1, m2, m3, rr, l):
    return dict(fc=per_length(magnitude(m1), rr) + norm(f2, f3) + per_length(2 * norm(m2, m3), l))


@formula("translator.friction", "f1 f2 f3 m1 m2 m3 rr l fc_int mu", "p fn phi")
def friction(f1, f2, f3, m1, m2, m3, rr, l, fc_int, mu):
    p = magnitude(f1)
    fn = magnitude(contact_force(f2, f3, m1, m2, m3, rr, l)["fc"] + fc_int)
    return dict(p=p, fn=fn, phi=p - mu * fn)
