"""universal.angles: angles of a universal joint with their derivatives with respect to the vectors."""

import math
import sys


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def scaled(factor, a):
    return [factor * x for x in a]


def angles(e1a, e2a, e3a, e1b, e2b, e3b):
    s, c = dot(e2a, e3b), dot(e3a, e3b)
    alpha = -math.atan2(s, c)
    q = s * s + c * c
    zero = [0.0, 0.0, 0.0]
    by_s, by_c = -c / q, s / q
    row_alpha = zero + scaled(by_s, e3b) + scaled(by_c, e3b) + zero + zero
    row_alpha += [by_s * e2a[k] + by_c * e3a[k] for k in range(3)]
    s, c = dot(e1a, e2b), dot(e1a, e1b)
    gamma = -math.atan2(s, c)
    q = s * s + c * c
    by_s, by_c = -c / q, s / q
    row_gamma = [by_s * e2b[k] + by_c * e1b[k] for k in range(3)] + zero + zero
    row_gamma += scaled(by_c, e1a) + scaled(by_s, e1a) + zero
    return [alpha, gamma], [row_alpha, row_gamma]


for line in sys.stdin:
    x = [float(number) for number in line.split()]
    try:
        values, rows = angles(*(x[k : k + 3] for k in range(0, 18, 3)))
        print(*map(repr, values), *(repr(entry) for row in rows for entry in row), flush=True)
    except ZeroDivisionError:
        print("refuse", flush=True)
