"""The check of elements finds what is planted in their golden files."""

import contextlib
import io
import json
import multiprocessing
import tempfile
import unittest
from pathlib import Path

import check_elements


def few(element: str, cases: int = 2) -> dict:
    """The golden file with its first cases that have results, smooth and rubbing."""
    file = json.loads((check_elements.GOLDEN / f"{element}.json").read_text(encoding="utf-8"))
    valid = [case for case in file["cases"] if "out" in case]
    rubbing = [case for case in valid if "mu" in case["in"]]
    return file | {"cases": valid[:cases] + rubbing[:cases]}


class Elements(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.workers = multiprocessing.Pool(1)

    @classmethod
    def tearDownClass(cls) -> None:
        cls.workers.terminate()

    def wrong(self, file: dict) -> list[str]:
        return check_elements.check(file, self.workers)[2]

    def test_what_is_right_passes(self) -> None:
        cases, right, wrong = check_elements.check(few("slot"), self.workers)
        self.assertEqual((cases, wrong), (4, []))
        self.assertGreater(right, 4 * 200)

    def test_an_ulp_in_any_part_is_found(self) -> None:
        plants = {
            "residuals": lambda out: out["residuals"].__setitem__(0, out["residuals"][0] * (1 + 2**-52)),
            "rows": lambda out: out["rows"][0].__setitem__(1, -out["rows"][0][1]),
            "forces": lambda out: out["forces"].__setitem__(6, out["forces"][6] * (1 + 2**-52)),
            "stiffness": lambda out: out["stiffness"][0].__setitem__(4, out["stiffness"][0][4] * (1 - 2**-53)),
            "by_multipliers": lambda out: out["by_multipliers"][6].__setitem__(0, 1.5),
            "after": lambda out: out["after"].__setitem__("u1", out["after"]["u1"] + 2**-40),
        }
        for part, plant in plants.items():
            file = few("slot")
            plant(file["cases"][-1]["out"])
            wrong = self.wrong(file)
            self.assertEqual(len(wrong), 1, (part, wrong))
            self.assertIn(f": {part}", wrong[0])

    def test_each_number_of_a_list_in_the_state_is_checked(self) -> None:
        file = few("isl21a_linear")
        file["cases"][-1]["out"]["after"]["s12"][1] += 2**-40
        wrong = self.wrong(file)
        self.assertEqual(len(wrong), 1, wrong)
        self.assertIn(": after.s12[1]: ", wrong[0])

    def test_an_unknown_element_is_named(self) -> None:
        self.assertEqual(self.wrong(few("slot") | {"element": "hub"}), ["hub: no such element here"])

    def test_the_command_tells_what_is_off_and_fails(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = few("slot_2d", 1)
            file["cases"][0]["out"]["forces"][0] += 1.0
            (Path(folder) / "slot_2d.json").write_text(json.dumps(file), encoding="utf-8")
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                code = check_elements.main(["--golden", folder])
            self.assertEqual(code, 1)
            self.assertIn("off slot_2d: 2 cases", said.getvalue())


if __name__ == "__main__":
    unittest.main()
