#!/usr/bin/env python3
"""Self-checks of the golden checker, of the scales, and of the reader: python -m unittest test_golden, or run this file."""

from __future__ import annotations

import contextlib
import copy
import importlib.util
import io
import json
import math
import random
import tempfile
import unittest
from pathlib import Path

from mpmath import mpf

import check_golden
from oracle import CATALOG, evaluate, jacobian
from oracle.core import ulps_between
from oracle.scales import four_digits_up, jacobian_scales, out_scales
from points import doubles, leaves, sample

ROOT = Path(__file__).resolve().parents[2]
READER = ROOT / "book" / "examples" / "read_golden.py"

# ---------------------------------------------------------------------------------------------------- the checker


def document(id: str, count: int = 32, seed: int = 3) -> dict:
    """A golden file made with the oracle itself: enough to try the checker."""
    rng, cases = random.Random(seed), []
    for index in range(count):
        point = sample(id, rng)
        out, jac = evaluate(id, point), jacobian(id, point)
        scales = out_scales(id, point, out, jac), jacobian_scales(id, point)
        out_scale, jac_scale = (doubles(scale, four_digits_up) for scale in scales)
        cases.append({"id": f"random-{index}", "flags": ["random"], "in": point, "out": doubles(out),
                      "out_scale": out_scale, "jac": doubles(jac), "jac_scale": jac_scale})  # fmt: skip

    def shaped(fields: dict[str, int]) -> list[dict]:
        return [{"name": name, "shape": [k] if k else [], "unit": "1"} for name, k in fields.items()]

    return {
        "schema": "x", "layout": 2, "formula": id, "title": "t", "source": "s", "provenance": {"kind": "printed"},
        "latex": "l", "eta": {"value": 2.0, "jacobian": 2.0},
        "inputs": shaped(CATALOG[id].inputs), "outputs": shaped(CATALOG[id].outputs), "cases": cases,
    }  # fmt: skip


class Checker(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.good = document("slot.contact_force")
        invalid = {"id": "nan", "flags": ["invalid"], "in": {"f2": "NaN", "f3": 4.0}, "error": "NonFinite"}
        kink = {"id": "zero", "flags": ["kink"], "in": {"f2": 0.0, "f3": -0.0}, "out": {"fc": -0.0},
                "out_scale": {"fc": 0.0}, "jac": {"fc": {"f2": 0.0, "f3": 0.0}},
                "jac_scale": {"fc": {"f2": 0.0, "f3": 0.0}}}  # fmt: skip
        cls.good["cases"] += [invalid, kink]

    def failures(self, change, id="slot.contact_force", base=None) -> list[str]:
        changed = copy.deepcopy(base or self.good)
        change(changed)
        return check_golden.check_document(changed, id).failures

    def test_a_good_file_passes(self):
        report = check_golden.check_document(self.good, "slot.contact_force")
        self.assertEqual(report.failures, [])
        self.assertEqual((report.cases, report.invalid, report.values, report.entries), (33, 1, 33, 66))
        self.assertEqual(report.scales, 33 + 64)  # those of the Jacobian are not recomputed on the kink

    def test_a_wrong_last_bit_in_a_value(self):
        def plant(d):
            d["cases"][5]["out"]["fc"] = math.nextafter(d["cases"][5]["out"]["fc"], 9)

        (message,) = self.failures(plant)
        for part in ("slot.contact_force", "case random-5", "out.fc", "0x3f", "1 ulp"):
            self.assertIn(part, message)

    def test_a_wrong_last_bit_in_any_jacobian_entry(self):
        for id, out, name, row, column in [
            ("slot.contact_force", "fc", "f3", None, None),
            ("slide_line.basis", "n", "dx", 1, 0),
            ("ujoint.contact_moments", "mc3", "e3b", 2, None),
            ("align.constraint", "ur1", "e2a", 1, None),
        ]:
            def plant(d):
                place, key = d["cases"][9]["jac"][out], name
                for index in (row, column):
                    if index is not None:
                        place, key = place[key], index
                place[key] = math.nextafter(place[key], -9)

            (message,) = self.failures(plant, id, document(id))
            self.assertIn(f"jac.{out}.{name}", message)
            self.assertIn("1 ulp", message)

    def test_a_wrong_digit_in_a_scale(self):
        for id, key, path in [
            ("slot.contact_force", "out_scale", ["fc"]),
            ("slot.contact_force", "jac_scale", ["fc", "f3"]),
            ("slide_line.basis", "jac_scale", ["n", "dx", 1, 0]),
        ]:
            def plant(d):
                place = d["cases"][9][key]
                for step in path[:-1]:
                    place = place[step]
                place[path[-1]] = four_digits_up(mpf(place[path[-1]]) * mpf("1.0005"))

            (message,) = self.failures(plant, id, document(id))
            self.assertIn(f"case random-9: {key}.{'.'.join(map(str, path[: 2 if key == 'jac_scale' else 1]))}", message)

    def test_faults_of_form(self):
        def case(k, key, new):
            return lambda d: d["cases"][k].__setitem__(key, new)

        faults = {
            "the id occurs twice": case(1, "id", "random-0"),
            "flags": case(0, "flags", ["rnd"]),
            "no jac": lambda d: d["cases"][0].pop("jac"),
            "expected ['fc']": case(0, "jac", {}),
            "expected ['f2', 'f3']": case(0, "in", {"f2": 1.0}),
            "has not the shape": case(0, "out", {"fc": [5.0]}),
            "is not a number": case(0, "out", {"fc": "5.0"}),
            "no error is named": lambda d: d["cases"][32].pop("error"),
            "yet it has out": case(32, "out", {"fc": 1.0}),
            "without the flag invalid": case(32, "flags", ["hard"]),
            "latex is missing": lambda d: d.pop("latex"),
            "valid cases, at least 32": lambda d: d["cases"].__delitem__(slice(0, 2)),
            "its name says": lambda d: d.__setitem__("formula", "slot.friction"),
            "on a kink without the flag": case(33, "flags", ["hard"]),
            "is less than": case(33, "jac_scale", {"fc": {"f2": -1.0, "f3": 0.0}}),
            "out_scale: has": lambda d: d["cases"][0].pop("out_scale"),
            "jac_scale: has": lambda d: d["cases"][0].pop("jac_scale"),
            "the layout is 1": lambda d: d.__setitem__("layout", 1),
            "provenance: ": lambda d: d.__setitem__("provenance", {"kind": "ours"}),
            "eta: ": lambda d: d["eta"].pop("value"),
            "has shape [3]": lambda d: d["inputs"][0].__setitem__("shape", [3]),
            "no unit": lambda d: d["inputs"][0].pop("unit"),
        }
        for message, change in faults.items():
            found = self.failures(change)
            self.assertTrue(any(message in f for f in found), (message, found))
        self.assertEqual(self.failures(lambda d: d.__setitem__("formula", "a.b"), "a.b"), ["a.b: unknown formula"])

    def test_command_line(self):
        with tempfile.TemporaryDirectory() as directory:
            path = Path(directory, "slot.contact_force.json")
            path.write_text(json.dumps(self.good, allow_nan=False))
            Path(directory, "schema.json").write_text("{}")

            def run(*more: str) -> int:
                with contextlib.redirect_stdout(io.StringIO()) as said:
                    code = check_golden.main(["--golden", directory, *more])
                self.assertRegex(said.getvalue(), r"\n\d+ passed, \d+ failed\n$")
                return code

            self.assertEqual(run(), 0)
            self.assertEqual(run("--complete"), 1)
            self.assertEqual(run("--complete", "--filter", "slot.contact*"), 0)
            self.assertEqual(run("--filter", "nothing.*"), 1)
            path.write_text("{")
            self.assertEqual(run(), 1)


# ------------------------------------------------------------------------------------------------------ the reader


def load_reader():
    spec = importlib.util.spec_from_file_location("read_golden", READER)
    reader = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(reader)
    return reader


def line(x1, xn):
    """A plain port of slider.line: n = (xn - x1) / l, and dn / dxn = (1 - n n^T) / l with 1 - n_i^2 as a sum."""
    d = [b - a for a, b in zip(x1, xn)]
    l = math.hypot(*d)  # noqa: E741
    if l == 0 or not all(map(math.isfinite, x1 + xn)):
        raise ValueError("no line through these nodes")
    n = [c / l for c in d]
    across = [sum(c * c for c in n[:i] + n[i + 1 :]) for i in range(3)]
    slope = [[(across[i] if i == k else -n[i] * n[k]) / l for k in range(3)] for i in range(3)]
    minus = [[-c for c in row] for row in slope]
    return {"n": n, "l": l}, {"n": {"x1": minus, "xn": slope}, "l": {"x1": [-c for c in n], "xn": n}}


class Reader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.reader = load_reader()
        cls.golden = cls.reader.read(ROOT / "golden", "slider.line")

    def passes(self, function) -> list[bool]:
        return [self.reader.check(function, case, self.golden["eta"]) for case in self.golden["cases"]]

    def test_the_example_passes_and_sees_what_is_wrong(self):
        file, function = self.reader.read(ROOT / "golden", "slot.contact_force"), self.reader.contact_force
        self.assertTrue(all(self.reader.check(function, case, file["eta"]) for case in file["cases"]))
        case = file["cases"][0]
        for key, wrong in [
            ("out", {"fc": case["out"]["fc"] * (1 + 1e-14)}),
            ("jac", {"fc": {"f2": 0.1, "f3": 0.1}}),
            ("error", "NonFinite"),  # accepted what should be refused
        ]:
            self.assertFalse(self.reader.check(function, case | {key: wrong}, file["eta"]), key)
        refused = next(case for case in file["cases"] if "error" in case)
        accepted = lambda **_: ({"fc": 0.0}, {"fc": {"f2": 0.0, "f3": 0.0}})  # noqa: E731
        self.assertFalse(self.reader.check(accepted, refused, file["eta"]))

    def test_a_correct_port_passes_although_it_is_off_by_more_than_two_ulps(self):
        self.assertTrue(all(self.passes(line)))
        valid = [case for case in self.golden["cases"] if "error" not in case]
        ulps = lambda case: max(map(ulps_between, leaves(line(**case["in"])[1]), leaves(case["jac"])))  # noqa: E731
        self.assertTrue(any(ulps(case) > 2 for case in valid))

    def test_a_port_that_cancels_or_is_slightly_wrong_does_not_pass(self):
        def cancelling(x1, xn):
            out, jac = line(x1, xn)
            for i in range(3):
                jac["n"]["xn"][i][i] = (1 - out["n"][i] ** 2) / out["l"]
            return out, jac

        def inaccurate(x1, xn):
            out, jac = line(x1, xn)
            return out | {"l": out["l"] * (1 + 1e-14)}, jac

        self.assertFalse(all(self.passes(cancelling)))
        random = ["random" in case["flags"] for case in self.golden["cases"]]
        self.assertFalse(any(right for right, drawn in zip(self.passes(inaccurate), random) if drawn))

    def test_eta_at_the_ends_of_the_doubles(self):
        eta, tiny, u = self.reader.eta, 2.0**-1074, 2.0**-53
        for mine, golden, scale, want in [
            (1.0, 1.0, 0.0, 0.0),
            (1.0 + 4 * u, 1.0, 2.0, 2.0),
            (tiny, 0.0, 0.0, 2.0),  # half the smallest subnormal is allowed for
            (1.0, 0.0, math.inf, 0.0),
            (math.inf, 1.0, 1.0, math.inf),
            (math.inf, 1.0, math.inf, math.inf),
            (math.nan, 1.0, 1.0, math.inf),
            ([1.0, 2.0], [1.0, 2.0, 3.0], [1.0, 2.0, 3.0], math.inf),
            ({"a": [[1.0, 1.0 + 2 * u]]}, {"a": [[1.0, 1.0]]}, {"a": [[1.0, 1.0]]}, 2.0),
        ]:
            self.assertEqual(eta(mine, golden, scale), want, (mine, golden, scale))


class Scales(unittest.TestCase):
    def test_four_digits_up(self):
        for x, want in [(0.0, 0.0), (5.0, 5.0), (0.6, 0.6), (1 / 3, 0.3334), (9.9991, 10.0), (123456.0, 123500.0),
                        (1.2340000000000001, 1.234), (1.23401, 1.235), (5e-324, 5e-324), (1.7977e308, math.inf)]:  # fmt: skip
            self.assertEqual(four_digits_up(mpf(x)), want, x)

    def test_scales_worked_by_hand(self):
        point = {"f2": 3.0, "f3": -4.0}
        out, jac = evaluate("slot.contact_force", point), jacobian("slot.contact_force", point)
        # 0.6 * 3 + 0.8 * 4 + 5; d2 fc/df2^2 = 16/125, d2 fc/df2 df3 = 12/125: 16/125 * 3 + 12/125 * 4 + 0.6
        self.assertEqual(doubles(out_scales("slot.contact_force", point, out, jac)), {"fc": 10.0})
        got = doubles(jacobian_scales("slot.contact_force", point))["fc"]
        self.assertEqual(got, {"f2": 1.368, "f3": 1.376})


if __name__ == "__main__":
    unittest.main()
