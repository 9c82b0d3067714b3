#!/usr/bin/env python3
"""Other programs agree with our elements as exported to NumPy, and would not with a wrong sign in any number of them.

A program that is not installed is skipped, unless JOINTPROOF_REQUIRE_FOREIGN is set, as in .ci/run.
"""

from __future__ import annotations

import unittest

from agreement import FACTOR, recorded
from export import Export
from programs import Absent, load


class Agreement:
    """With one program."""

    ours: str

    @classmethod
    def setUpClass(cls):
        try:
            cls.program = load(cls.ours)
        except Absent as absent:
            raise unittest.SkipTest(str(absent)) from None
        cls.comparisons = cls.program.comparisons()
        cls.recorded = recorded(cls.program.NAME)

    def test_agrees_no_worse_than_the_book_says(self):
        self.assertEqual([comparison.name() for comparison in self.comparisons], list(self.recorded))
        for comparison in self.comparisons:
            with self.subTest(comparison.name()):
                error, said = comparison.measure(Export(), comparison.count), self.recorded[comparison.name()]
                if "poses" not in comparison.places:
                    print(f"{self.program.NAME}, {comparison.name()}, {comparison.count} steps: {error:.1e}")
                self.assertLessEqual(error, comparison.bound)
                worse = f"the book says {said}; if that has to change: python3 tests/python/foreign/record.py"
                self.assertLessEqual(error, max(FACTOR * said, comparison.rounding), worse)

    def test_a_wrong_sign_is_found(self):
        for comparison in self.comparisons:
            for planted in comparison.planted():
                with self.subTest(comparison.name(), planted=planted):
                    self.assertGreater(comparison.measure(Export(planted), comparison.few), comparison.bound)


class Pinocchio(Agreement, unittest.TestCase):
    ours = "by_pinocchio"


class MuJoCo(Agreement, unittest.TestCase):
    ours = "by_mujoco"


class Exudyn(Agreement, unittest.TestCase):
    ours = "by_exudyn"


if __name__ == "__main__":
    unittest.main()
