"""JOIN, UNIVERSAL and UJOINT (seed 001). UJOINT = JOIN + UNIVERSAL.

The arm factors are the formulary's model: phi = (7 + 6 nu)/lambda^2 with nu = 3/10, so the constant is exactly 44/5.
"""

from mpmath import mpf

from .core import OutsideDomain, add, branch, cross, dot, formula, magnitude, norm, noteworthy, scale, sub
from .translator import TRIADS, alpha_of, gamma_of, per_length

CROSS_AXES = "e1a:3 e2a:3 e3a:3 e3b:3"


@formula("join.constraint", "e1a:3 e2a:3 e3a:3 xa:3 xb:3 d0:3", "g:3")
def join_constraint(e1a, e2a, e3a, xa, xb, d0):
    d = sub(xb, xa)
    return dict(g=[dot(e, d) - c for e, c in zip((e1a, e2a, e3a), d0)])


@formula("universal.constraint", "e1a:3 e3b:3 c0", "g")
def universal_constraint(e1a, e3b, c0):
    return dict(g=dot(e1a, e3b) - c0)


@formula("universal.angles", TRIADS, "alpha gamma", angles="alpha gamma")
def universal_angles(e1a, e2a, e3a, e1b, e2b, e3b):
    return dict(alpha=alpha_of(e2a, e3a, e3b), gamma=gamma_of(e1a, e1b, e2b))


@formula("universal.relative_motion", "alpha gamma alpha0 gamma0 theta1_ref theta3_ref", "ur1 ur3 ur1_mat ur3_mat")
def relative_motion(alpha, gamma, alpha0, gamma0, theta1_ref, theta3_ref):
    return dict(ur1=alpha - alpha0, ur3=gamma - gamma0, ur1_mat=alpha - theta1_ref, ur3_mat=gamma - theta3_ref)


@formula("universal.constraint_moment", "e2a:3 e3a:3 e3b:3 m2", "m:3")
def constraint_moment(e2a, e3a, e3b, m2):
    """m2 (cos alpha e2a + sin alpha e3a) with alpha = -atan2(s, c): cos alpha = c/hypot, sin alpha = -s/hypot."""
    s, c = dot(e2a, e3b), dot(e3a, e3b)
    hypot = norm(s, c)
    if hypot == 0:
        raise OutsideDomain("gimbal lock: alpha has no value")
    return dict(m=scale(m2 / hypot, sub(scale(c, e2a), scale(s, e3a))))


@formula("universal.kinetic_moment", "e1a:3 e3b:3 m1 m3", "m:3")
def kinetic_moment(e1a, e3b, m1, m3):
    return dict(m=add(scale(m1, e1a), scale(m3, e3b)))


@formula("ujoint.constraint", CROSS_AXES + " xa:3 xb:3 d0:3 c0", "g:3 g_rot")
def constraint(e1a, e2a, e3a, e3b, xa, xb, d0, c0):
    return dict(g=join_constraint(e1a, e2a, e3a, xa, xb, d0)["g"], g_rot=dot(e1a, e3b) - c0)


@formula("ujoint.reaction", "f1 f2 f3", "fr")
def reaction(f1, f2, f3):
    return dict(fr=norm(f1, f2, f3))


@formula("ujoint.cross_direction", "e1a:3 e3b:3", "e_cross:3")
def cross_direction(e1a, e3b):
    return dict(e_cross=cross(e1a, e3b))


def slenderness(la, rp):
    if la <= 0 or rp <= 0:
        raise OutsideDomain("La and Rp must be positive")
    return la / rp


@formula("ujoint.twist_factors", "la rp", "alpha_twist beta_twist")
def twist_factors(la, rp):
    phi = mpf(44) / 5 / slenderness(la, rp) ** 2
    alpha = 1 / (8 + 6 * phi)
    return dict(alpha_twist=alpha, beta_twist=alpha + mpf(1) / 4)


@formula("ujoint.axial_factors", "la rp", "alpha_axial beta_axial")
def axial_factors(la, rp):
    squared = slenderness(la, rp) ** 2
    return dict(alpha_axial=(squared + 3) / (2 * (squared + 6)), beta_axial=3 / (2 * (squared + 6)))


@formula("ujoint.decomposition", CROSS_AXES + " f1 f2 f3", "f_axial1 f_axial3 f_bend")
def decomposition(e1a, e2a, e3a, e3b, f1, f2, f3):
    force = add(scale(f1, e1a), scale(f2, e2a), scale(f3, e3a))
    return dict(f_axial1=dot(force, e1a), f_axial3=dot(force, e3b), f_bend=dot(force, cross(e1a, e3b)))


@formula("ujoint.hinge_twist", "m2 la rp", "m_twist_hinge f_twist_hinge")
def hinge_twist(m2, la, rp):
    alpha, beta = twist_factors(la, rp).values()
    return dict(m_twist_hinge=alpha * magnitude(m2), f_twist_hinge=beta * magnitude(m2) / la)


@formula(
    "ujoint.hinge_axial",
    "f_axial1 f_axial3 la rp",
    "f_axial_hinge1 f_axial_hinge3 f_transv_hinge1 f_transv_hinge3",
)
def hinge_axial(f_axial1, f_axial3, la, rp):
    alpha, beta = axial_factors(la, rp).values()
    return dict(
        f_axial_hinge1=alpha * magnitude(f_axial1),
        f_axial_hinge3=alpha * magnitude(f_axial3),
        f_transv_hinge1=beta * magnitude(f_axial3),
        f_transv_hinge3=beta * magnitude(f_axial1),
    )


@formula("ujoint.hinge_transverse", "f_axial1 f_axial3 f_bend m2 la rp", "f_total_hinge1 f_total_hinge3")
def hinge_transverse(f_axial1, f_axial3, f_bend, m2, la, rp):
    twist = hinge_twist(m2, la, rp)["f_twist_hinge"]
    axial = hinge_axial(f_axial1, f_axial3, la, rp)
    return dict(
        f_total_hinge1=norm(f_bend / 4, twist, axial["f_transv_hinge1"]),
        f_total_hinge3=norm(f_bend / 4, twist, axial["f_transv_hinge3"]),
    )


@formula("ujoint.hinge_bending", "f_bend m2 la rp ls", "m_bend_hinge m_total_hinge f_total_bend")
def hinge_bending(f_bend, m2, la, rp, ls):
    bend = magnitude(f_bend) * la / 8
    total = norm(bend, hinge_twist(m2, la, rp)["m_twist_hinge"])
    return dict(m_bend_hinge=bend, m_total_hinge=total, f_total_bend=per_length(2 * total, ls))


@formula("ujoint.contact_moments", CROSS_AXES + " f1 f2 f3 m2 rp la ra ls", "mc1 mc3")
def contact_moments(e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls):
    axial1, axial3, bend = decomposition(e1a, e2a, e3a, e3b, f1, f2, f3).values()
    along = hinge_axial(axial1, axial3, la, rp)
    across = hinge_transverse(axial1, axial3, bend, m2, la, rp)
    bending = hinge_bending(bend, m2, la, rp, ls)["f_total_bend"]

    def moment(axial_hinge, total_hinge):
        return axial_hinge * ra + (total_hinge + bending) * rp

    return dict(
        mc1=moment(along["f_axial_hinge1"], across["f_total_hinge1"]),
        mc3=moment(along["f_axial_hinge3"], across["f_total_hinge3"]),
    )


@formula("ujoint.normal_moments", "mc1 mc3 mc1_int mc3_int", "mn1 mn3")
def normal_moments(mc1, mc3, mc1_int, mc3_int):
    return dict(mn1=2 * magnitude(mc1) + magnitude(mc1_int), mn3=2 * magnitude(mc3) + magnitude(mc3_int))


@formula(
    "ujoint.friction",
    CROSS_AXES + " f1 f2 f3 m2 rp la ra ls m1 m3 mc1_int mc3_int mu",
    "phi1 phi3",
)
def friction(e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls, m1, m3, mc1_int, mc3_int, mu):
    mc1, mc3 = contact_moments(e1a, e2a, e3a, e3b, f1, f2, f3, m2, rp, la, ra, ls).values()
    mn1, mn3 = normal_moments(mc1, mc3, mc1_int, mc3_int).values()
    return dict(phi1=magnitude(m1) - mu * mn1, phi3=magnitude(m3) - mu * mn3)


@formula(
    "ujoint.stop",
    "alpha gamma theta1_min theta1_max theta3_min theta3_max",
    "gap1_min gap1_max gap3_min gap3_max",
)
def stop(alpha, gamma, theta1_min, theta1_max, theta3_min, theta3_max):
    return dict(
        gap1_min=alpha - theta1_min,
        gap1_max=theta1_max - alpha,
        gap3_min=gamma - theta3_min,
        gap3_max=theta3_max - gamma,
    )
