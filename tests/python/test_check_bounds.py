#!/usr/bin/env python3
"""Self-checks of the checker of proved bounds: python -m unittest test_check_bounds, or run this file."""

from __future__ import annotations

import copy
import hashlib
import json
import random
import struct
import unittest
from collections import Counter
from fractions import Fraction
from pathlib import Path

import check_bounds
from check_bounds import Refused, are_all, check, shapes

ROOT = Path(__file__).resolve().parents[2]
GRAPHS, BOUNDS = ROOT / "target/graphs", ROOT / "golden/bounds"


def number(x: float) -> list:
    return ["number", struct.pack(">d", x).hex()]


def real(k: int) -> list:
    return ["input", k, None, None]


def of_sum(amount: str, n: int, *places: int) -> list:
    """The step that bounds the first of these parts of a sum of two by the others."""
    return ["sum", amount, *(["-1" if place == 0 else "1", n, 0, place] for place in places)]


def outcome(ops: list[list], *certificates: dict, others: tuple = (), shapes: tuple = ((), ())) -> str:
    """What is refused of certificates for the last operation of a graph, nothing if they hold; other results are open."""
    result = len(ops) - 1
    graph = "".join(json.dumps(line) + "\n" for line in [*ops, ["value", result, *others], ["jacobian"]])
    bounds = [Fraction(certificate["bound"]) for certificate in certificates]
    value = {"entries": 1 + len(others), "proved": 1, "bound": str(max(bounds))}
    jacobian = {"entries": 0, "proved": 0, "bound": "0"}
    head = {"formula": "planted", "graph": hashlib.sha256(graph.encode()).hexdigest(), "value": value, "jacobian": jacobian}
    lines = [head] + [{"result": result, "way": [], **certificate} for certificate in certificates]
    lines += [{"result": other, "open": "planted"} for other in others]
    try:
        check("\n".join(map(json.dumps, lines)), graph.encode(), shapes)
    except (Refused, LookupError) as refused:
        return str(refused)
    return ""


class Planted(unittest.TestCase):
    """Graphs of a few operations, whose bounds are known by hand."""

    # a b + c d
    DOT = [real(0), real(1), real(2), real(3), ["multiply", 0, 1], ["multiply", 2, 3], ["add", 4, 5]]

    def test_a_sum_of_two_products_has_bound_one(self):
        # Half of the load of the result goes to each input, as do the loads of the products.
        self.assertEqual(outcome(self.DOT, {"bound": "1", "steps": []}), "")
        half = {"bound": "3/4", "steps": [of_sum("1/2", 6, 0, 1, 2)]}
        self.assertEqual(outcome(self.DOT, half), "")
        self.assertIn("3/4 is proved", outcome(self.DOT, {**half, "bound": "2/3"}))

    def test_an_inexact_constant_and_one_made_of_it_are_rounded(self):
        # π x: the constant and the product, each half on x and half on the result. For x π/3 the quotient is rounded, too.
        turn = [real(0), number(3.141592653589793), ["multiply", 0, 1]]
        third = [real(0), number(3.141592653589793), number(3.0), ["divide", 1, 2], ["multiply", 0, 3]]
        for ops, bound in ((turn, Fraction(1)), (third, Fraction(3, 2))):
            self.assertEqual(outcome(ops, {"bound": str(bound), "steps": []}), "")
            self.assertIn("is proved", outcome(ops, {"bound": str(bound - Fraction(1, 2)), "steps": []}))
        exact = [real(0), number(6.0), number(3.0), ["divide", 1, 2], ["multiply", 0, 3]]
        self.assertEqual(outcome(exact, {"bound": "1/2", "steps": []}), "")
        quotient = [real(0), number(1.0), number(3.0), ["divide", 1, 2], ["multiply", 0, 3]]
        self.assertIn("1 is proved", outcome(quotient, {"bound": "1/2", "steps": []}))

    def test_no_constant_carries_anything(self):
        # x + 0.1: the rounding of the constant moves on to x and to the sum.
        ops = [real(0), number(0.1), ["add", 0, 1]]
        self.assertIn("no input carries", outcome(ops, {"bound": "9", "steps": []}))
        moved = {"bound": "2", "steps": [of_sum("1", 2, 2, 0, 1)]}
        self.assertEqual(outcome(ops, moved), "")

    def test_what_cancels_has_no_parts_below_it(self):
        # (a + b) − b: nothing bounds the rounding of the first sum.
        ops = [real(0), real(1), ["add", 0, 1], ["subtract", 2, 1]]
        self.assertIn("no input carries", outcome(ops, {"bound": "99", "steps": []}))
        self.assertIn("may cancel", outcome(ops, {"bound": "99", "steps": [["parts", "1", 2, 0]]}))
        squares = [real(0), real(1), ["multiply", 0, 0], ["multiply", 1, 1], ["add", 2, 3]]
        self.assertEqual(outcome(squares, {"bound": "2", "steps": [["parts", "1", 4, 0]]}), "")

    def test_every_way_needs_its_certificate_and_no_other(self):
        # a + b where a < b, else a − b.
        ops = [real(0), real(1), ["less", 0, 1], ["add", 0, 1], ["subtract", 0, 1], ["select", 2, 3, 4]]
        both = [{"way": [[2, answer]], "bound": "1", "steps": []} for answer in (True, False)]
        self.assertEqual(outcome(ops, *both), "")
        self.assertIn("not on every way", outcome(ops, both[0]))
        self.assertIn("not on every way", outcome(ops, both[0], both[0]))
        self.assertIn("does not say", outcome(ops, {"bound": "1", "steps": []}))
        self.assertFalse(are_all([{1: True, 2: True}, {1: False}]))
        self.assertTrue(are_all([{1: True, 2: True}, {1: True, 2: False}, {1: False}]))

    def test_a_length_that_vanishes_has_no_part_that_does_not(self):
        # a where |(a, b)| is normal, else b: a ≠ 0 and a length below all normal numbers contradict each other.
        ops = [real(0), real(1), number(0.0), ["equal", 0, 2], number(2.0**-1022), ["norm", 0, 1], ["less or equal", 4, 5],
               ["select", 3, 0, 1], ["select", 6, 7, 0]]  # fmt: skip
        ways = ({3: True, 6: True}, {3: True, 6: False}, {3: False, 6: True})
        all_ = [{"way": [*map(list, way.items())], "bound": "0", "steps": []} for way in ways]
        self.assertNotIn("not on every way", outcome(ops, *all_))
        for k in range(3):
            self.assertIn("not on every way", outcome(ops, *all_[:k], *all_[k + 1 :]))

    def test_what_is_made_of_zeros_is_zero(self):
        # a where |(a, b)| is normal or 4 |(a, b)| is 0, else b, which is never: the first length is 0, so the second one is.
        ops = [real(0), real(1), number(2.0**-1022), ["norm", 0, 1], ["less or equal", 2, 3], number(4.0), ["multiply", 0, 5], ["multiply", 1, 5],
               ["norm", 6, 7], number(0.0), ["equal", 8, 9], ["select", 10, 0, 1], ["select", 4, 0, 11]]  # fmt: skip
        normal, zero = ({"way": way, "bound": "0", "steps": []} for way in ([[4, True]], [[4, False], [10, True]]))
        self.assertNotIn("not on every way", outcome(ops, normal, zero))
        for some in (normal, zero):
            self.assertIn("not on every way", outcome(ops, some))
        other = [*ops[:7], ["add", 1, 5], *ops[8:]]
        self.assertIn("not on every way", outcome(other, normal, zero))

    def test_normwise_a_part_may_end_on_another_component(self):
        # (a + b) − b: the rounding of the first sum is at most |a| + |b|, both times the derivative with respect to a.
        ops = [real(0), real(1), ["add", 0, 1], ["subtract", 2, 1]]
        steps = [["sum", "1", ["1", 2, 0, 0], ["-1", 0, 1, 0], ["-1", 1, 3, 0]], ["beside", "1", 0, 1], ["beside", "1", 1, 3],
                 ["beside", "1", 3, 1]]  # fmt: skip
        normwise = {"bound": "2", "beside": [], "steps": steps}
        vector = ([2], [1])
        self.assertEqual(outcome(ops, normwise, shapes=vector), "")
        self.assertIn("2 is proved", outcome(ops, {**normwise, "bound": "3/2"}, shapes=vector))
        # Of two scalars the second is not there, by components nothing is, and what is not beside it is refused.
        self.assertNotEqual(outcome(ops, normwise, shapes=([1, 1], [1])), "")
        self.assertNotEqual(outcome(ops, {"bound": "2", "steps": steps}, shapes=vector), "")
        with_other = {**normwise, "beside": [2]}
        self.assertEqual(outcome(ops, with_other, others=(2,), shapes=([2], [2])), "")
        self.assertIn("not beside", outcome(ops, with_other, others=(2,), shapes=([2], [1, 1])))
        for k in range(4):
            self.assertIn("carries", outcome(ops, {**normwise, "steps": steps[:k] + steps[k + 1 :]}, shapes=vector))

    def test_a_comparison_bounds_only_what_it_compares(self):
        # p / (p + q) where 0 ≤ p < q: 1 − p / (p + q) is at least as large as the quotient.
        ops = [["input", 0, 0.0, None], ["input", 1, 0.0, None], ["less", 0, 1], ["add", 0, 1], ["divide", 0, 3], number(1.0),
               ["subtract", 5, 4], ["select", 2, 6, 4]]  # fmt: skip
        other = {"way": [[2, False]], "bound": "2", "steps": []}
        way = {"way": [[2, True]], "bound": "3", "steps": [["range", "2", [6, 0, 2], [6, 0, 0], 2]]}
        self.assertEqual(outcome(ops, way, other), "")
        # Not the other way round, and nothing where the comparison says the opposite.
        self.assertIn("say nothing", outcome(ops, {**way, "steps": [["range", "2", [6, 0, 0], [6, 0, 2], 3]]}, other))
        self.assertIn("left", outcome(ops, {**way, "steps": []}, other))
        more = {"way": [[2, False]], "bound": "2", "steps": [["range", "1", [3, 0, 1], [3, 0, 2], 2]]}
        self.assertIn("say nothing", outcome(ops, way, more))

    def test_a_sum_that_does_not_vanish_is_refused(self):
        for terms in (["1", 6, 0, 1], ["2", 6, 0, 2], ["1", 6, 0, 3], ["1", 6, 5, 2], ["1", 6, -1, 2]):
            steps = [["sum", "1/2", ["-1", 6, 0, 0], ["1", 6, 0, 1], terms]]
            self.assertTrue(outcome(self.DOT, {"bound": "1", "steps": steps}), terms)

    def test_an_equation_may_follow_from_two(self):
        # x (a - b) + x b is x a in exact numbers: what is used twice is eliminated.
        ops = [real(0), real(1), real(2), ["subtract", 1, 2], ["multiply", 0, 3], ["multiply", 0, 2], ["add", 4, 5]]
        steps = [["sum", "1", ["1", 4, 0, 0], ["1", 5, 0, 0], ["-1", 6, 0, 0]]]
        self.assertIn("no input carries", outcome(ops, {"bound": "99", "steps": steps}))

    def test_the_head_says_what_is_proved(self):
        graph = "".join(json.dumps(line) + "\n" for line in [*self.DOT, ["value", 6], ["jacobian"]])
        head = {"formula": "planted", "graph": hashlib.sha256(graph.encode()).hexdigest()}
        summary = {"entries": 1, "proved": 1, "bound": "1"}
        nothing = {"entries": 0, "proved": 0, "bound": "0"}
        line = json.dumps({"result": 6, "way": [], "bound": "1", "steps": []})
        for value, holds in ((summary, True), ({**summary, "bound": "1/2"}, False), ({**summary, "proved": 0}, False)):
            text = json.dumps({**head, "value": value, "jacobian": nothing}) + "\n" + line
            if holds:
                check(text, graph.encode())
            else:
                self.assertRaises(Refused, check, text, graph.encode())

    def test_an_input_within_bounds_bounds_a_ratio(self):
        # x (g + 1/2) where g is from -1/4 to 1/4, computed as x g + x / 2; then x g is no larger than the result.
        ops = [real(0), ["input", 1, -0.25, 0.25], ["multiply", 0, 1], number(0.5), ["multiply", 0, 3], ["add", 2, 4]]
        self.assertEqual(outcome(ops, {"bound": "1", "steps": [["range", "1", [5, 0, 1], [5, 0, 0], 1]]}), "")
        wider = [real(0), ["input", 1, -0.5, 0.25], *ops[2:]]
        self.assertIn("say nothing", outcome(wider, {"bound": "1", "steps": [["range", "1", [5, 0, 1], [5, 0, 0], 1]]}))

    def test_a_sign_bounds_a_ratio(self):
        # a / (h (2 − h)) with h = 1 − b: the part of h is −2 b / (1 + b) times the result, at most twice the result where 0 ≤ b.
        ops = [real(0), real(1), number(0.0), ["less or equal", 2, 1], number(1.0), ["subtract", 4, 1], number(2.0), ["subtract", 6, 5],
               ["multiply", 5, 7], ["divide", 0, 8]]  # fmt: skip
        steps = [["range", "1", [5, 0, 0], [9, 0, 0], 1]]
        of_quotient, of_input = ({"bound": "5/2", "steps": steps}, {"bound": "0", "steps": []})
        of = lambda answer, line: {**line, "way": [[3, answer]]}
        is_up = [*ops, ["select", 3, 9, 0]]
        self.assertEqual(outcome(is_up, of(True, of_quotient), of(False, of_input)), "")
        self.assertIn("5/2 is proved", outcome(is_up, of(True, {**of_quotient, "bound": "2"}), of(False, of_input)))
        self.assertIn("carries", outcome(is_up, of(True, {**of_quotient, "steps": []}), of(False, of_input)))
        is_down = [*ops, ["select", 3, 0, 9]]
        self.assertIn("say nothing", outcome(is_down, of(True, of_input), of(False, of_quotient)))
        self.assertIn("say nothing", outcome(ops, of_quotient))


@unittest.skipUnless(GRAPHS.is_dir(), "no graphs: cargo xtask prove --graphs target/graphs")
class Tampered(unittest.TestCase):
    """Certificates of the catalogue with a fault each."""

    def judged(self, fault) -> Counter:
        """How often a fault is refused, and how often the bound still holds."""
        rng, verdicts = random.Random(7), Counter()
        for file in rng.sample(sorted(BOUNDS.glob("*.jsonl")), 40):
            head, *lines = map(json.loads, file.read_text().splitlines())
            places = [k for k, line in enumerate(lines) if line.get("steps")]
            if len(lines) > 200 or not places:
                continue
            lines = copy.deepcopy(lines)
            fault(rng, lines, rng.choice(places))
            try:
                check("\n".join(map(json.dumps, [head, *lines])), (GRAPHS / file.name).read_bytes(), shapes(ROOT / "golden" / f"{file.stem}.json"))
                verdicts["harmless"] += 1
            except (Refused, KeyError, IndexError, TypeError, ValueError):
                verdicts["refused"] += 1
        self.assertGreater(verdicts.total(), 20)
        return verdicts

    def test_a_lower_bound_is_refused(self):
        def fault(_, lines, k):
            lines[k]["bound"] = str(Fraction(lines[k]["bound"]) - Fraction(1, 1000))

        self.assertEqual(self.judged(fault)["harmless"], 0)

    def test_steps_that_are_dropped_or_halved_are_refused_or_idle(self):
        def dropped(rng, lines, k):
            lines[k]["steps"].pop(rng.randrange(len(lines[k]["steps"])))

        def halved(rng, lines, k):
            step = rng.choice(lines[k]["steps"])
            step[1] = str(Fraction(step[1]) / 2)

        for fault in (dropped, halved):
            verdicts = self.judged(fault)
            self.assertGreater(verdicts["refused"], 4 * verdicts["harmless"], verdicts)

    def test_another_rule_a_negative_amount_and_a_missing_result_are_refused(self):
        def turned(rng, lines, k):
            step = rng.choice(lines[k]["steps"])
            step[1] = str(-Fraction(step[1]))

        def missing(_, lines, k):
            lines.pop(k)

        for fault in (turned, missing):
            self.assertEqual(self.judged(fault)["harmless"], 0)

    def test_more_roundings_are_refused(self):
        def nothing(*_):
            pass

        for name in ("multiply", "add"):
            rounded = dict(check_bounds.ROUNDINGS)
            try:
                check_bounds.ROUNDINGS[name] = Fraction(11, 10)
                self.assertGreater(self.judged(nothing)["refused"], 0, name)
            finally:
                check_bounds.ROUNDINGS.update(rounded)


if __name__ == "__main__":
    unittest.main()
