"""slider.nodal_forces_2d: forces and stiffness with the projector δ − n nᵀ, as elements are written."""

import math
import sys


def element(x1, xn, xm, lam):
    d = [xn[k] - x1[k] for k in range(2)]
    length = math.sqrt(d[0] ** 2 + d[1] ** 2)
    n = [d[k] / length for k in range(2)]
    t = [-n[1], n[0]]
    r = [xm[k] - x1[k] for k in range(2)]
    xi = (r[0] * n[0] + r[1] * n[1]) / length
    force_m = [lam * t[k] for k in range(2)]
    force_1 = [-(1 - xi) * f for f in force_m]
    force_n = [-xi * f for f in force_m]
    projector = [[(i == j) - n[i] * n[j] for j in range(2)] for i in range(2)]
    dn = [[projector[i][j] / length for j in range(2)] for i in range(2)]  # by x_n
    dt = [[-dn[1][j] for j in range(2)], [dn[0][j] for j in range(2)]]
    # xi = r·n/l: by x_n, by x_1, by x_m
    xi_n = [sum(r[i] * dn[i][j] for i in range(2)) / length - xi * n[j] / length for j in range(2)]
    xi_m = [n[j] / length for j in range(2)]
    xi_1 = [-xi_n[j] - xi_m[j] for j in range(2)]
    df_m = [[-lam * dt[i][j] for j in range(2)] + [lam * dt[i][j] for j in range(2)] + [0.0, 0.0, t[i]] for i in range(2)]
    dxi = xi_1 + xi_n + xi_m + [0.0]
    df_1 = [[dxi[j] * force_m[i] - (1 - xi) * df_m[i][j] for j in range(7)] for i in range(2)]
    df_n = [[-dxi[j] * force_m[i] - xi * df_m[i][j] for j in range(7)] for i in range(2)]
    return force_1 + force_n + force_m, df_1 + df_n + df_m


for line in sys.stdin:
    x = [float(number) for number in line.split()]
    if not all(map(math.isfinite, x)) or x[0:2] == x[2:4]:
        print("refuse", flush=True)
        continue
    try:
        forces, rows = element(x[0:2], x[2:4], x[4:6], x[6])
        print(*map(repr, forces), *(repr(entry) for row in rows for entry in row), flush=True)
    except (ZeroDivisionError, OverflowError):
        print("nan " * 48, flush=True)
