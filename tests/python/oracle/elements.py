"""Elements: what constraints and their forces are by translations u and spins theta (de = dtheta x e) of both nodes."""

from mpmath import mp, mpf

from .core import OutsideDomain, add, cross, dot, formula, scale, sub

PLACES = "e1a:3 e2a:3 e3a:3 xa:3 xb:3"
JOIN_ROWS = "g1_ua:3 g1_ta:3 g1_ub:3 g2_ua:3 g2_ta:3 g2_ub:3 g3_ua:3 g3_ta:3 g3_ub:3"


@formula("join.rows", PLACES, JOIN_ROWS)
def join_rows(e1a, e2a, e3a, xa, xb):
    rows = {}
    for k, e in enumerate((e1a, e2a, e3a), 1):
        rows |= {f"g{k}_ua": scale(-1, e), f"g{k}_ta": cross(e, sub(xb, xa)), f"g{k}_ub": list(e)}
    return rows


@formula("universal.rows", "e1a:3 e3b:3", "g_rot_ta:3 g_rot_tb:3")
def universal_rows(e1a, e3b):
    return dict(g_rot_ta=cross(e1a, e3b), g_rot_tb=cross(e3b, e1a))


def transposed(rows, multipliers, motion):
    """Rows^T lambda, of the rows by this motion."""
    return add(*(scale(multiplier, rows[f"{g}_{motion}"]) for g, multiplier in multipliers.items()))


@formula("join.nodal_forces", PLACES + " f1 f2 f3", "fa:3 ma:3 fb:3")
def join_nodal_forces(e1a, e2a, e3a, xa, xb, f1, f2, f3):
    found, multipliers = join_rows(e1a, e2a, e3a, xa, xb), dict(g1=f1, g2=f2, g3=f3)
    return {on: transposed(found, multipliers, by) for on, by in dict(fa="ua", ma="ta", fb="ub").items()}


@formula("universal.nodal_moments", "e1a:3 e3b:3 lambda_rot", "ma:3 mb:3")
def universal_nodal_moments(e1a, e3b, lambda_rot):
    found = universal_rows(e1a, e3b)
    return dict(ma=scale(lambda_rot, found["g_rot_ta"]), mb=scale(lambda_rot, found["g_rot_tb"]))


# The geometric stiffness: how Rows^T lambda changes with spins, multipliers held. A change of e by a spin about the k-th
# axis is i_k x e; matrices are lists of nine, row by row.

AXES = ([mpf(1), mpf(0), mpf(0)], [mpf(0), mpf(1), mpf(0)], [mpf(0), mpf(0), mpf(1)])


def by_columns(columns):
    return [columns[column][row] for row in range(3) for column in range(3)]


def transpose(m):
    return [m[3 * column + row] for row in range(3) for column in range(3)]


@formula("join.geometric_stiffness", PLACES + " f1 f2 f3", "k_ua_ta:9 k_ta_ta:9")
def join_stiffness(e1a, e2a, e3a, xa, xb, f1, f2, f3):
    d = sub(xb, xa)
    force = add(scale(f1, e1a), scale(f2, e2a), scale(f3, e3a))
    turned = [cross(axis, force) for axis in AXES]
    return dict(k_ua_ta=by_columns([scale(-1, f) for f in turned]), k_ta_ta=by_columns([cross(f, d) for f in turned]))


@formula("universal.geometric_stiffness", "e1a:3 e3b:3 lambda_rot", "k_ta_ta:9 k_ta_tb:9 k_tb_tb:9")
def universal_stiffness(e1a, e3b, lambda_rot):
    by_a = [scale(lambda_rot, cross(cross(axis, e1a), e3b)) for axis in AXES]
    by_b = [scale(lambda_rot, cross(e1a, cross(axis, e3b))) for axis in AXES]
    return dict(k_ta_ta=by_columns(by_a), k_ta_tb=by_columns(by_b), k_tb_tb=by_columns([scale(-1, m) for m in by_b]))


# Other unknowns than spins: along the axis of a turn a moment is felt as it is, across it turned by half the angle, and smaller.


@formula("element.rotation_vector", "psi:3 m:3", "m_psi:3")
def rotation_vector(psi, m):
    angle = mp.sqrt(dot(psi, psi))
    if angle == 0:
        return dict(m_psi=sub(m, scale(mpf(1) / 2, cross(psi, m))))
    with mp.workdps(3 * mp.dps):
        axis = scale(1 / angle, psi)
        along = scale(dot(axis, m), axis)
        across = sub(m, along)
        half, turned = angle / 2, cross(axis, across)
        felt = sub(scale(mp.cos(half), across), scale(mp.sin(half), turned))
        return dict(m_psi=add(along, scale(mp.sin(half) / half, felt)))


@formula("element.euler_parameters", "q0 q:3 m:3", "m_q0 m_q:3")
def euler_parameters(q0, q, m):
    # The product of the quaternions (0, m) and (q0, q), twice.
    return dict(m_q0=-2 * dot(m, q), m_q=scale(2, add(scale(q0, m), cross(m, q))))


# SLOT in the plane: a spin of a turns e2a by 90 degrees to the left.


@formula("slot.rows_2d", "e2a:2 xa:2 xb:2", "gy_ua:2 gy_ta gy_ub:2")
def slot_rows_2d(e2a, xa, xb):
    turned = [-e2a[1], e2a[0]]
    return dict(gy_ua=scale(-1, e2a), gy_ta=dot(turned, sub(xb, xa)), gy_ub=list(e2a))


@formula("slot.nodal_forces_2d", "e2a:2 xa:2 xb:2 f2", "fa:2 ma fb:2")
def slot_nodal_forces_2d(e2a, xa, xb, f2):
    row = slot_rows_2d(e2a, xa, xb)
    return dict(fa=scale(f2, row["gy_ua"]), ma=f2 * row["gy_ta"], fb=scale(f2, row["gy_ub"]))


@formula("slot.geometric_stiffness_2d", "e2a:2 xa:2 xb:2 f2", "k_ua_ta:2 k_ta_ta")
def slot_stiffness_2d(e2a, xa, xb, f2):
    turned = slot_nodal_forces_2d([-e2a[1], e2a[0]], xa, xb, f2)
    return dict(k_ua_ta=turned["fa"], k_ta_ta=turned["ma"])


# ALIGN: derivatives of the three angles by the spin of b, by the rule for quotients.

TRIADS = "e1a:3 e2a:3 e3a:3 e1b:3 e2b:3 e3b:3"
LAMBDAS = " lambda_r1 lambda_r2 lambda_r3"


def products(a, b):
    """a.b and its three derivatives as b turns."""
    return dot(a, b), [dot(a, cross(axis, b)) for axis in AXES]


def turn_derivatives(sine, cosine):
    """Of -atan2(sine, cosine)."""
    (s, s1), (c, c1) = sine, cosine
    return [(s * c1[k] - c * s1[k]) / (s * s + c * c) for k in range(3)]


def arc_sine_derivatives(sine):
    x, x1 = sine
    if x * x >= 1:
        raise OutsideDomain("the arc sine has no derivative at its ends")
    return [y / mp.sqrt(1 - x * x) for y in x1]


def angle_derivatives(e1a, e2a, e3a, e1b, e2b, e3b):
    if not (dot(e2a, e3b) or dot(e3a, e3b)) or not (dot(e1a, e1b) or dot(e1a, e2b)):
        raise OutsideDomain("gimbal lock")
    return [
        turn_derivatives(products(e2a, e3b), products(e3a, e3b)),
        arc_sine_derivatives(products(e1a, e3b)),
        turn_derivatives(products(e1a, e2b), products(e1a, e1b)),
    ]


@formula("align.rows", TRIADS, "ur1_tb:3 ur2_tb:3 ur3_tb:3")
def align_rows(**triads):
    return {f"ur{k}_tb": row for k, row in enumerate(angle_derivatives(**triads), 1)}


@formula("align.nodal_moments", TRIADS + LAMBDAS, "ma:3 mb:3")
def align_nodal_moments(lambda_r1, lambda_r2, lambda_r3, **triads):
    mb = transposed(align_rows(**triads), dict(ur1=lambda_r1, ur2=lambda_r2, ur3=lambda_r3), "tb")
    return dict(ma=scale(-1, mb), mb=mb)


# Its stiffness: the same derivatives, as b turns once more.


def turned_products(a, b):
    """What `products` gives, and how its derivatives change as b turns."""
    return *products(a, b), [[dot(a, cross(one, cross(other, b))) for other in AXES] for one in AXES]


def turn_stiffness(sine, cosine):
    (s, s1, s2), (c, c1, c2) = sine, cosine
    square, row = s * s + c * c, turn_derivatives((s, s1), (c, c1))
    return [
        (s1[j] * c1[k] + s * c2[k][j] - c1[j] * s1[k] - c * s2[k][j] - 2 * row[k] * (s * s1[j] + c * c1[j])) / square
        for k in range(3)
        for j in range(3)
    ]


def arc_sine_stiffness(sine):
    x, x1, x2 = sine
    root = mp.sqrt(1 - x * x)
    return [x2[k][j] / root + x * x1[k] * x1[j] / root**3 for k in range(3) for j in range(3)]


@formula("align.geometric_stiffness", TRIADS + LAMBDAS, "k_tb_tb:9")
def align_stiffness(e1a, e2a, e3a, e1b, e2b, e3b, lambda_r1, lambda_r2, lambda_r3):
    angle_derivatives(e1a, e2a, e3a, e1b, e2b, e3b)  # where they are not defined, nor is this
    first = turn_stiffness(turned_products(e2a, e3b), turned_products(e3a, e3b))
    second = arc_sine_stiffness(turned_products(e1a, e3b))
    third = turn_stiffness(turned_products(e1a, e2b), turned_products(e1a, e1b))
    return dict(k_tb_tb=add(scale(lambda_r1, first), scale(lambda_r2, second), scale(lambda_r3, third)))


# A rigid arm from a node to a connector.


@formula("element.arm", "r:3 f:3 m:3", "m_node:3 k_arm:9")
def arm(r, f, m):
    turned = [cross(cross(axis, r), f) for axis in AXES]
    return dict(m_node=add(m, cross(r, f)), k_arm=by_columns(turned))
