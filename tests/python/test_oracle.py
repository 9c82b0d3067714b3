#!/usr/bin/env python3
"""Self-checks of the oracle: python -m unittest test_oracle, or run this file."""

from __future__ import annotations

import math
import random
import unittest
from fractions import Fraction

from mpmath import mp, mpf

from check_golden import GOLDEN, is_schema
from oracle import CATALOG, OutsideDomain, evaluate, jacobian, kinks
from oracle.core import to_double, ulps_between
from oracle.slide_line import gauss_legendre_5, parabolic, smoothed_linear, smoothed_parabolic, value
from oracle.slider import pivots
from points import derivatives, doubles, leaves, sample, values

PI = math.pi


# --------------------------------------------------------------------------------------------------- the machinery


class Rounding(unittest.TestCase):
    def exactly(self, fraction: Fraction) -> float:
        with mp.workprec(5000):
            return to_double(mpf(fraction.numerator) / fraction.denominator)

    def test_midpoints_go_to_even(self):
        for numerator, want in [
            (2**53 + 1, 2.0**53),
            (2**53 + 3, 2.0**53 + 4),
            (-(2**53) - 1, -(2.0**53)),
            (2**54 - 1, 2.0**54),
        ]:
            self.assertEqual(self.exactly(Fraction(numerator)), want)
        self.assertEqual(self.exactly(2**53 + 1 + Fraction(1, 2**1000)), 2.0**53 + 2)
        self.assertEqual(self.exactly(2**53 + 1 - Fraction(1, 2**1000)), 2.0**53)

    def test_subnormals(self):
        tiny = Fraction(1, 2**1074)
        for multiple, want in [
            (Fraction(1, 2), 0.0),
            (Fraction(1, 2) + Fraction(1, 2**500), 5e-324),
            (Fraction(3, 2), 1e-323),
            (Fraction(5, 2), 1e-323),
            (Fraction(1, 3), 0.0),
            (Fraction(2**52) - Fraction(1, 2), 2.0**-1022),
            (Fraction(2**53) - Fraction(1, 2), 2.0**-1021),
        ]:
            self.assertEqual(self.exactly(tiny * multiple), want, multiple)
            self.assertEqual(self.exactly(-tiny * multiple), -want, multiple)

    def test_overflow(self):
        limit = Fraction(2) ** 1024 - Fraction(2) ** 970
        self.assertEqual(self.exactly(limit), math.inf)
        self.assertEqual(self.exactly(-limit), -math.inf)
        self.assertEqual(self.exactly(limit - Fraction(1, 2**100)), math.nextafter(math.inf, 0))
        self.assertEqual(self.exactly(Fraction(10) ** 400), math.inf)

    def test_against_integer_division(self):
        """Python divides integers with one correct rounding."""
        rng = random.Random(20240501)
        for _ in range(3000):
            n = rng.getrandbits(rng.randint(1, 200)) + 1
            d = (rng.getrandbits(rng.randint(1, 200)) + 1) << rng.choice([0, 0, 0, 900, 1000, 1060, 1074])
            self.assertEqual(self.exactly(Fraction(n, d)), n / d, (n, d))

    def test_ulps(self):
        self.assertEqual(ulps_between(1.0, math.nextafter(1.0, 2)), 1)
        self.assertEqual(ulps_between(-5e-324, 5e-324), 2)
        self.assertEqual(ulps_between(0.0, -0.0), 0)
        self.assertEqual(ulps_between(math.nan, 1.0), math.inf)


def allowed(id, rng):
    """A random point at which the formula is defined."""
    while True:
        point = sample(id, rng)
        try:
            evaluate(id, point)
        except OutsideDomain:
            continue
        return point


class Precision(unittest.TestCase):
    def test_more_precision_changes_nothing(self):
        """Every formula, at random points: value and Jacobian round to the same doubles with far more bits."""
        rng = random.Random(7)
        for id in CATALOG:
            for _ in range(4):
                point = allowed(id, rng)
                self.assertEqual(doubles(evaluate(id, point)), doubles(evaluate(id, point, more=333)), (id, point))
                self.assertEqual(doubles(jacobian(id, point)), doubles(jacobian(id, point, more=333)), (id, point))

    def test_more_precision_changes_nothing_at_hard_points(self):
        """Closest points on almost straight parabolas and near a centre of curvature, offsets, gimbal lock."""
        hard = []
        for sagitta in (1e-4, 1e-8, 1e-14, 0.0):
            for xs in ([0.3, 0.7], [1e-17, -1e12], [0.999999999999, 1e-9]):
                hard.append(("slide_line.closest_parabolic",
                             dict(xs=xs, x1=[-1.0, 0.0], x2=[0.0, sagitta], x3=[1.0, 0.0])))  # fmt: skip
        for off in (1e-4, 1e-8, 1e-15):
            hard.append(("slide_line.closest_parabolic",
                         dict(xs=[off, 0.5 - off], x1=[-1.0, 1.0], x2=[0.0, 0.0], x3=[1.0, 1.0])))  # fmt: skip
            hard.append(("slide_line.closest_smoothed_linear",
                         dict(xs=[off, 2.0], x1=[-1.0, 1.0], x2=[0.0, 0.0], x3=[1.0, 1.0], f=off)))  # fmt: skip
        rng = random.Random(5)
        p = sample("slide_line.closest_smoothed_parabolic", rng)
        hard += [("slide_line.closest_smoothed_parabolic", p | {"f": f}) for f in (1e-12, 0.5 - 1e-12)]
        far = sample("translator.constraint", rng)
        far["xa"] = [c + 1e12 for c in far["xa"]]
        far["xb"] = [c + 1e12 for c in far["xb"]]
        hard.append(("translator.constraint", far))
        for tilt in (1e-4, 1e-7):
            s, c = math.sin(PI / 2 - tilt), math.cos(PI / 2 - tilt)
            hard.append(("cardan.angles", dict(e1a=[1.0, 0.0, 0.0], e2a=[0.0, 1.0, 0.0], e3a=[0.0, 0.0, 1.0],
                                               e1b=[c, 0.0, -s], e2b=[0.0, 1.0, 0.0], e3b=[s, 0.0, c])))  # fmt: skip
        for tilt in (1e-16, 1e-12, 1e-8, 1e-4):
            hard.append(("slider.constraint", dict(x1=[1e8, 0.0, 0.0], xn=[1e8 + 1, tilt, -tilt / 3], xm=[0, 1e6, 1])))
            hard.append(("slider.basis_variation", dict(n=[1.0, tilt, 0.0], dn=[0.1, 0.2, 0.3])))
        big = dict(m2=1e200, la=1e-12, rp=1.0, f_bend=1e-200, ls=1e-3)
        hard.append(("ujoint.hinge_bending", big))
        hard.append(("translator.contact_force", dict(f2=1e200, f3=1e-200, m1=0.0, m2=5e-324, m3=0.0, rr=1.0, l=1e-12)))
        for id, point in hard:
            self.assertEqual(doubles(evaluate(id, point)), doubles(evaluate(id, point, more=700)), (id, point))
            self.assertEqual(doubles(jacobian(id, point)), doubles(jacobian(id, point, more=700)), (id, point))

    def test_differences_hold_60_digits(self):
        """Against derivatives known in closed form."""
        point = {"f2": 0.3, "f3": -1.7}
        with mp.workprec(1500):
            f2, f3 = mpf(0.3), mpf(-1.7)
            exact = {"f2": f2 / mp.sqrt(f2**2 + f3**2), "f3": f3 / mp.sqrt(f2**2 + f3**2)}
            for name, d in jacobian("slot.contact_force", point)["fc"].items():
                self.assertLess(abs(d - exact[name]), mpf(10) ** -150)
            s = mpf(0.4) / mpf(0.7) + 1
            exact_h = mpf(2.5) / (mp.e - 1) * (mp.exp(s) - 1 + s * mp.exp(s)) / mpf(0.7)
            got = jacobian("interaction.pressure_exponential", {"h": 0.4, "c0": 0.7, "p0": 2.5})["p"]["h"]
            self.assertLess(abs(got - exact_h), mpf(10) ** -150)

    def test_ties_are_recognised(self):
        """xb - xa = 2^53 + 1 lies halfway between two doubles; its neighbours do not disturb the rule."""
        zero, e = [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]
        xa, xb = [-1.0, 0.0, 0.0], [2.0**53, 0.0, 0.0]
        d = derivatives("slot.relative_position", e1a=e, e2a=e, e3a=zero, xa=xa, xb=xb)
        self.assertEqual(d["x"]["e1a"][0], 2.0**53)

    def test_extreme_norms(self):
        self.assertEqual(values("slot.contact_force", f2=1e200, f3=1e-200), {"fc": 1e200})
        d = derivatives("slot.contact_force", f2=1e200, f3=1e-200)["fc"]
        self.assertEqual(d, {"f2": 1.0, "f3": 0.0})
        d = derivatives("slot.contact_force", f2=3e-200, f3=4e-200)["fc"]
        self.assertLess(abs(d["f2"] - 0.6), 1e-15)
        self.assertEqual(derivatives("slot.contact_force", f2=1.0, f3=1e-300)["fc"]["f3"], 1e-300)
        self.assertEqual(derivatives("slot.contact_force", f2=5e-324, f3=0.0)["fc"], {"f2": 1.0, "f3": 0.0})


# ------------------------------------------------------------------------------------------- values worked by hand


class HandWorked(unittest.TestCase):
    def test_slot(self):
        self.assertEqual(values("slot.contact_force", f2=3.0, f3=4.0), {"fc": 5.0})
        self.assertEqual(derivatives("slot.contact_force", f2=3.0, f3=4.0), {"fc": {"f2": 0.6, "f3": 0.8}})
        self.assertEqual(derivatives("slot.contact_force", f2=0.0, f3=0.0), {"fc": {"f2": 0.0, "f3": 0.0}})
        got = values("slot.friction", f1=-2.0, f2=3.0, f3=-4.0, fc_int=-6.0, mu=0.5)
        self.assertEqual(got, {"p": 2.0, "fn": 1.0, "phi": 1.5})

    def test_kinks_have_derivative_zero(self):
        d = derivatives("slot.friction", f1=0.0, f2=3.0, f3=4.0, fc_int=-5.0, mu=0.5)
        self.assertEqual(leaves(d["p"]) + leaves(d["fn"]), [0.0] * 10)
        self.assertEqual(leaves(d["phi"]), [0.0] * 5)

    def test_kinks_and_switches_are_noticed(self):
        for id, inputs, want in [
            ("slot.contact_force", dict(f2=0.0, f3=0.0), {"kink"}),
            ("slot.contact_force", dict(f2=0.0, f3=1.0), set()),
            ("coulomb.return_map", dict(f_trial=-1.0, mu=0.5, fn=2.0), {"switch"}),
            ("interaction.damping", dict(h=-1.0, v=1.0, mu0=1.0, c0=4.0, eta=0.25), {"switch"}),
            ("translator.torque_force", dict(m1=1.0, rr=0.0), {"switch"}),
            ("translator.torque_force", dict(m1=0.0, rr=1.0), {"kink"}),
            ("ujoint.hinge_bending", dict(f_bend=0.0, m2=0.0, la=1.0, rp=1.0, ls=0.0), {"kink", "switch"}),
            # |m2| is squared under a root that is not zero: smooth.
            ("ujoint.hinge_bending", dict(f_bend=3.0, m2=0.0, la=1.0, rp=1.0, ls=1.0), set()),
            ("ujoint.hinge_bending", dict(f_bend=0.0, m2=3.0, la=1.0, rp=1.0, ls=1.0), {"kink"}),
            ("ujoint.hinge_bending", dict(f_bend=1e-200, m2=0.0, la=1e200, rp=1.0, ls=1.0), set()),
        ]:
            self.assertEqual(kinks(id, inputs), want, (id, inputs))

    def test_return_map(self):
        self.assertEqual(values("coulomb.return_map", f_trial=-3.0, mu=0.5, fn=4.0), {"f": -2.0})
        self.assertEqual(values("coulomb.return_map", f_trial=-2.0, mu=0.5, fn=4.0), {"f": -2.0})
        self.assertEqual(values("coulomb.return_map", f_trial=1.5, mu=0.5, fn=4.0), {"f": 1.5})
        self.assertEqual(derivatives("coulomb.return_map", f_trial=-3.0, mu=0.5, fn=4.0)["f"],
                         {"f_trial": 0.0, "mu": -4.0, "fn": -0.5})  # fmt: skip

    def test_translator(self):
        got = values("translator.friction", f1=1.0, f2=3.0, f3=4.0, m1=-2.0, m2=5.0, m3=12.0, rr=0.5, l=2.0,
                     fc_int=-30.0, mu=0.25)  # fmt: skip
        self.assertEqual(got, {"p": 1.0, "fn": 8.0, "phi": -1.0})  # FC = 4 + 5 + 13 = 22
        got = values("translator.contact_force", f2=3.0, f3=4.0, m1=9.0, m2=9.0, m3=9.0, rr=0.0, l=0.0)
        self.assertEqual(got, {"fc": 5.0})

    def test_cardan_at_quarter_turns(self):
        a = dict(e1a=[1.0, 0.0, 0.0], e2a=[0.0, 1.0, 0.0], e3a=[0.0, 0.0, 1.0])
        # b turned by +90 degrees about axis 1: e2b = e3a, e3b = -e2a
        quarter = dict(e1b=[1.0, 0.0, 0.0], e2b=[0.0, 0.0, 1.0], e3b=[0.0, -1.0, 0.0])
        self.assertEqual(values("cardan.angles", **a, **quarter), {"alpha": PI / 2, "beta": 0.0, "gamma": 0.0})
        self.assertEqual(derivatives("cardan.angles", **a, **quarter)["alpha"]["e2a"], [0.0, 0.0, 0.0])
        self.assertEqual(derivatives("cardan.angles", **a, **quarter)["alpha"]["e3a"], [0.0, 1.0, 0.0])
        half = dict(e1b=[1.0, 0.0, 0.0], e2b=[0.0, -1.0, 0.0], e3b=[0.0, 0.0, -1.0])
        self.assertEqual(values("cardan.angles", **a, **half)["alpha"], -PI)
        self.assertEqual(derivatives("cardan.angles", **a, **half)["alpha"]["e2a"], [0.0, 0.0, -1.0])
        with self.assertRaises(OutsideDomain):
            evaluate("cardan.beta_two_argument", dict(e1a=[0.0] * 3, e1b=[1.0, 0, 0], e2b=[0, 1.0, 0], e3b=[0, 0, 1.0]))

    def test_arc_sine_at_one(self):
        """abs(e1a . e3b) = 1 exactly has the value 90 degrees and no derivative: the golden case must leave jac out."""
        p = dict(e1a=[1.0, 0.0, 0.0], e2a=[0.0, 1.0, 0.0], e3a=[0.0, 0.0, 1.0],
                 e1b=[1e-8, 0.0, -1.0], e2b=[0.0, 1.0, 0.0], e3b=[1.0, 0.0, 1e-8])  # fmt: skip
        self.assertEqual(values("cardan.angles", **p)["beta"], PI / 2)
        with self.assertRaises(OutsideDomain):
            jacobian("cardan.angles", p)

    def test_arm_factor_limits(self):
        self.assertEqual(values("ujoint.twist_factors", la=1e-170, rp=1.0), {"alpha_twist": 0.0, "beta_twist": 0.25})
        self.assertEqual(values("ujoint.twist_factors", la=1e12, rp=1e-12), {"alpha_twist": 0.125, "beta_twist": 0.375})
        self.assertEqual(values("ujoint.axial_factors", la=1e-12, rp=1e12), {"alpha_axial": 0.25, "beta_axial": 0.25})
        self.assertEqual(values("ujoint.axial_factors", la=1e12, rp=1e-12)["alpha_axial"], 0.5)
        self.assertEqual(values("ujoint.axial_factors", la=3.0, rp=1.0), {"alpha_axial": 0.4, "beta_axial": 0.1})
        # lambda = 2: phi = 2.2, alpha = 1/21.2 = 5/106
        self.assertEqual(values("ujoint.twist_factors", la=4.0, rp=2.0)["alpha_twist"], 5 / 106)

    def test_contact_moment_of_a_pure_axial_force(self):
        """f1 = 20 along e1a, arms of lambda = 3: 0.4 * 20 Ra, and no transverse force on hinge 1."""
        e = dict(e1a=[1.0, 0.0, 0.0], e2a=[0.0, 1.0, 0.0], e3a=[0.0, 0.0, 1.0], e3b=[0.0, 0.0, 1.0])
        got = values("ujoint.contact_moments", **e, f1=-20.0, f2=0.0, f3=0.0, m2=0.0, rp=1.0, la=3.0, ra=0.5, ls=0.0)
        self.assertEqual(got, {"mc1": 4.0, "mc3": 2.0})  # hinge 3: beta_axial * 20 * Rp

    def test_slider(self):
        self.assertEqual(values("slider.line", x1=[1.0, 1.0, 1.0], xn=[3.0, 4.0, 7.0])["l"], 7.0)
        got = values("slider.eliminate", x1=[0.0, 0.0, 0.0], xn=[2.0, 1.0, 4.0], xmk=8.0)
        self.assertEqual(pivots([mpf(2), mpf(1), mpf(4)]), (1, 0, 2))
        self.assertEqual(got, {"xmi": 2.0, "xmj": 4.0})
        self.assertEqual(pivots([mpf(2), mpf(1), mpf(1)]), (1, 0, 2))  # the tie where the bound is attained
        self.assertEqual(pivots([mpf(-1), mpf(0), mpf(0)]), (1, 2, 0))
        got = values("slider.basis", n=[-1.0, 0.0, 0.0])
        self.assertEqual(got, {"t1": [0.0, 1.0, 0.0], "t2": [0.0, 0.0, -1.0]})

    def test_slide_line(self):
        self.assertEqual(values("slide_line.basis", dx=[3.0, 4.0]), {"t": [0.6, 0.8], "n": [-0.8, 0.6]})
        got = values("slide_line.closest_linear", xs=[1.0, 2.0], x1=[0.0, 0.0], x2=[4.0, 0.0])
        self.assertEqual(got, {"g": -0.5, "separation": 2.0})
        # the parabola z = r^2 below its centre of curvature, and a point on it
        line = dict(x1=[-1.0, 1.0], x2=[0.0, 0.0], x3=[1.0, 1.0])
        self.assertEqual(values("slide_line.closest_parabolic", xs=[0.0, 0.25], **line), {"g": 0.0, "separation": 0.25})
        self.assertEqual(values("slide_line.closest_parabolic", xs=[0.5, 0.25], **line), {"g": 0.5, "separation": 0.0})
        # beyond the end: the end itself, and its own normal
        got = values("slide_line.closest_parabolic", xs=[3.0, 1.0], **line)
        self.assertEqual(got, {"g": 1.0, "separation": to_double(-4 / mp.sqrt(5))})
        # (0, 1): g = +-1/sqrt(2) are equally near, the smaller is taken; g = 0 is a root too, but the farthest
        self.assertEqual(values("slide_line.closest_parabolic", xs=[0.0, 1.0], **line)["g"], -math.sqrt(0.5))
        # on the centre of curvature of the vertex: a triple root
        self.assertEqual(values("slide_line.closest_parabolic", xs=[0.0, 0.5], **line), {"g": 0.0, "separation": 0.5})

    def test_interaction(self):
        self.assertEqual(values("interaction.pressure_exponential", h=0.0, c0=2.0, p0=3.5), {"p": 3.5})
        self.assertEqual(values("interaction.pressure_exponential", h=-2.0, c0=2.0, p0=3.5), {"p": 0.0})
        for h, p in [(1.0, 6.0), (-1.0, 6.0), (-2.0, 4.0), (-4.0, 0.0), (-5.0, 0.0)]:
            self.assertEqual(values("interaction.damping", h=h, v=2.0, mu0=3.0, c0=4.0, eta=0.25), {"p": p}, h)


# ----------------------------------------------------------------------------------- claims of the formulary


class Claims(unittest.TestCase):
    """Statements that FORMULAS.md makes about the formulas, tried at random points."""

    def setUp(self):
        self.rng = random.Random(99)
        self.context = mp.workprec(1200)
        self.context.__enter__()
        self.addCleanup(self.context.__exit__, None, None, None)

    def near(self, a, b, size=1):
        self.assertLess(abs(a - b), mpf(10) ** -120 * size)

    def test_pivot_bound(self):
        """The rule from d is the documented one on t1, t2, and abs(n_k) >= 1/sqrt(6)."""
        smallest = mpf(1)
        for _ in range(3000):
            d = [mpf(self.rng.randint(-9, 9)) for _ in range(3)]
            if self.rng.random() < 0.5:
                d = [mpf(self.rng.gauss(0, 1)) for _ in range(3)]
            if not any(d):
                continue
            i, j, k = pivots(d)
            length = mp.sqrt(sum(c * c for c in d))
            smallest = min(smallest, abs(d[k]) / length)
            if d[1] or d[2]:
                t1, t2 = [0, d[2], -d[1]], [-(d[1] ** 2 + d[2] ** 2), d[0] * d[1], d[0] * d[2]]  # times a length
            else:
                t1, t2 = [0, -d[0], 0], [0, 0, -d[0]]
            self.assertEqual(abs(t1[i]), max(map(abs, t1)))
            self.assertEqual(abs(t2[j]), max(abs(t2[a]) for a in range(3) if a != i))
        self.near(smallest, 1 / mp.sqrt(6))  # attained at (2, 1, 1)

    def test_twist_agrees_with_timoshenko_to_first_order(self):
        for phi in (mpf("1e-40"), mpf("1e-50")):
            rational, beam = 1 / (8 + 6 * phi), (2 - phi) / (4 * (4 + phi))
            self.assertLess(abs(rational - beam), phi**2)
            spring = 4 / phi  # Euler-Bernoulli arm on a rotational spring of this stiffness (times EI/La)
            self.near(spring / (6 + 2 * spring) / 4, rational)

    def test_linear_torque_is_exact(self):
        p = sample("slide_line.torque_linear", self.rng)
        (r1, z1), (r2, z2), p1, p2 = [mpf(c) for c in p["x1"]], [mpf(c) for c in p["x2"]], mpf(p["p1"]), mpf(p["p2"])
        # Simpson's rule in two halves is exact for cubics: r^2 p along the element
        f = lambda s: (r1 + s * (r2 - r1)) ** 2 * (p1 + s * (p2 - p1))  # noqa: E731
        integral = (f(0) + 4 * f(mpf(1) / 2) + f(1)) / 6
        length = mp.sqrt((r2 - r1) ** 2 + (z2 - z1) ** 2)
        self.near(evaluate("slide_line.torque_linear", p)["t"], 2 * mp.pi * length * integral, 10)

    def test_gauss_legendre(self):
        for power in range(10):
            total = sum(w * x**power for x, w in gauss_legendre_5())
            self.near(total, mpf(2) / (power + 1) if power % 2 == 0 else mpf(0))

    def test_parabolic_torque_on_a_straight_even_element_matches_the_linear_one(self):
        x1, x3, p1, p3 = [1.0, 0.0], [3.0, 4.0], 0.5, 2.5
        middle = evaluate(
            "slide_line.torque_parabolic", dict(x1=x1, x2=[2.0, 2.0], x3=x3, p1=p1, p2=(p1 + p3) / 2, p3=p3)
        )
        self.near(middle["t"], evaluate("slide_line.torque_linear", dict(x1=x1, x2=x3, p1=p1, p2=p3))["t"], 1e3)

    def test_separation_gradient_at_an_interior_foot(self):
        """d separation / d xs = n and d separation / d x_i = -N_i n."""
        point = dict(xs=[0.1, 0.6], x1=[-1.0, 0.1], x2=[0.05, 0.3], x3=[1.0, -0.1])
        g = evaluate("slide_line.closest_parabolic", point)["g"]
        self.assertLess(abs(g), 1)
        d = jacobian("slide_line.closest_parabolic", point)["separation"]
        nodes = [[mpf(c) for c in point[x]] for x in ("x1", "x2", "x3")]
        velocity = [value([c * k for k, c in enumerate(p)][1:], g) for p in parabolic(*nodes)]
        speed = mp.sqrt(velocity[0] ** 2 + velocity[1] ** 2)
        n = [-velocity[1] / speed, velocity[0] / speed]
        weights = {"xs": -1, "x1": g * (g - 1) / 2, "x2": 1 - g * g, "x3": g * (g + 1) / 2}
        for name, weight in weights.items():
            for axis in range(2):
                self.near(d[name][axis], -weight * n[axis])

    def test_smoothing_of_straight_even_segments(self):
        """The cubic is the parabola of the linear slide line, and it touches both segments."""
        x1, x3, x5, f = [mpf(0), mpf(0)], [mpf(2), mpf(1)], [mpf(3), mpf(4)], mpf(1) / 5
        middle = lambda a, b: [(p + q) / 2 for p, q in zip(a, b)]  # noqa: E731
        cubic = smoothed_parabolic(x1, middle(x1, x3), x3, middle(x3, x5), x5, f)
        square = smoothed_linear(x1, x3, x5, f)
        for c, s in zip(cubic, square):
            for a, b in zip(c, s + [mpf(0)]):
                self.near(a, b)

    def test_slider_elimination_satisfies_the_constraint(self):
        for _ in range(20):
            p = sample("slider.eliminate", self.rng)
            d = [mpf(b) - mpf(a) for a, b in zip(p["x1"], p["xn"])]
            i, j, k = pivots(d)
            got = evaluate("slider.eliminate", p)
            xm = [mpf(0)] * 3
            xm[i], xm[j], xm[k] = got["xmi"], got["xmj"], mpf(p["xmk"])
            r = [m - mpf(a) for m, a in zip(xm, p["x1"])]
            for a, b in ((0, 1), (1, 2), (2, 0)):
                self.near(r[a] * d[b] - r[b] * d[a], 0, 1e3)

    def test_incremental_constraint_vanishes_for_the_increment(self):
        """Solving the documented 2x2 system in t1, t2 gives what `slider.increment` gives directly."""
        for _ in range(10):
            p = sample("slider.increment", self.rng)
            d = [mpf(b) - mpf(a) for a, b in zip(p["x1"], p["xn"])]
            i, j, k = pivots(d)
            got = evaluate("slider.increment", p)
            dxm = [0.0] * 3
            dxm[k] = p.pop("dxmk")
            base = evaluate("slider.incremental_constraint", p | {"dxm": dxm})
            slope = jacobian("slider.incremental_constraint", p | {"dxm": dxm})
            for r in ("r1", "r2"):
                row = slope[r]["dxm"]
                self.near(base[r] + row[i] * got["dxmi"] + row[j] * got["dxmj"], 0, 1e6)

    def test_incremental_constraint_is_the_variation_of_the_constraint(self):
        """On the line; off it, the turning of t1 and t2 adds to it."""
        x1, xn = [1.0, -2.0, 0.5], [4.0, 3.0, 2.5]
        xm = [a + 0.375 * (b - a) for a, b in zip(x1, xn)]
        steps = {x: [self.rng.uniform(-1, 1) for _ in range(3)] for x in ("dx1", "dxn", "dxm")}
        slope = jacobian("slider.constraint", dict(x1=x1, xn=xn, xm=xm))
        got = evaluate("slider.incremental_constraint", dict(x1=x1, xn=xn, xm=xm, **steps))
        for g, r in (("g1", "r1"), ("g2", "r2")):
            self.near(got[r], sum(a * mpf(b) for x in ("x1", "xn", "xm") for a, b in zip(slope[g][x], steps["d" + x])))

    def test_basis_variation_is_the_derivative_of_the_basis(self):
        for _ in range(10):
            p = sample("slider.basis_variation", self.rng)
            d = jacobian("slider.basis", {"n": p["n"]})
            got = evaluate("slider.basis_variation", p)
            for t in ("t1", "t2"):
                for row in range(3):
                    self.near(got["d" + t][row], sum(a * mpf(b) for a, b in zip(d[t]["n"][row], p["dn"])), 1e6)

    def test_direction_variation_is_the_derivative_of_the_line(self):
        p = sample("slider.direction_variation", self.rng)
        d = jacobian("slider.line", {"x1": p["x1"], "xn": p["xn"]})
        got = evaluate("slider.direction_variation", p)
        along = lambda row: sum(a * mpf(b) for x in ("x1", "xn") for a, b in zip(row[x], p["d" + x]))  # noqa: E731
        self.near(got["dl"], along(d["l"]), 1e6)
        for row in range(3):
            self.near(got["dn"][row], along({x: d["n"][x][row] for x in ("x1", "xn")}), 1e6)

    def test_universal_moment_is_minus_m2_times_the_cross_direction(self):
        e1a, e2a, e3a = [0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]
        e3b = [-0.64, 0.48, 0.6]  # 0.8 e2a + 0.6 e3a
        moment = values("universal.constraint_moment", e2a=e2a, e3a=e3a, e3b=e3b, m2=1.0)["m"]
        across = values("ujoint.cross_direction", e1a=e1a, e3b=e3b)["e_cross"]
        for a, b in zip(moment, across):
            self.assertAlmostEqual(a, -b, places=15)

    def test_assemblies(self):
        p = sample("translator.constraint", self.rng)
        part = lambda id: evaluate(id, {k: p[k] for k in CATALOG[id].inputs})  # noqa: E731
        self.assertEqual(evaluate("translator.constraint", p), part("slot.constraint") | part("align.constraint"))
        p = sample("ujoint.constraint", self.rng)
        whole = evaluate("ujoint.constraint", p)
        self.assertEqual(whole["g"], part("join.constraint")["g"])
        self.assertEqual(whole["g_rot"], part("universal.constraint")["g"])


class Coverage(unittest.TestCase):
    def test_the_formulas_are_those_of_the_golden_files(self):
        files = {path.stem for path in GOLDEN.glob("*.json") if not is_schema(path)}
        self.assertEqual(set(CATALOG), files)


if __name__ == "__main__":
    unittest.main()
