#!/usr/bin/env python3
"""Test your own formula against a golden file. Standard library only; copy it and replace `contact_force`.

    python read_golden.py [GOLDEN_DIRECTORY]
"""

import json
import math
import sys
from pathlib import Path

GOLDEN = Path(__file__).resolve().parents[2] / "golden"
SPECIAL = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}


def read(directory, formula):
    """The golden file of a formula."""
    return json.loads((Path(directory) / f"{formula}.json").read_text(encoding="utf-8"))


def numbers(x):
    """Numbers, and the strings that stand for what JSON cannot write, in nested lists and dicts."""
    if isinstance(x, dict):
        return {key: numbers(value) for key, value in x.items()}
    return [numbers(v) for v in x] if isinstance(x, list) else SPECIAL[x] if isinstance(x, str) else float(x)


def eta(mine, golden, scale):
    """The largest backward error in nested lists and dicts: |mine - golden| / (u scale + 2^-1075) with u = 2^-53."""
    if isinstance(golden, dict):
        return max(eta(mine[key], golden[key], scale[key]) for key in golden)
    if isinstance(golden, list):
        return max(map(eta, mine, golden, scale)) if len(mine) == len(golden) else math.inf
    error = 2.0**53 * (abs(mine - golden) / (scale + 2.0**-1022))  # u times either is too small for a double
    return math.inf if math.isnan(error) else error


def contact_force(f2, f3):
    """Your code: FC = sqrt(f2^2 + f3^2) and its Jacobian; ValueError where the input is refused."""
    if not (math.isfinite(f2) and math.isfinite(f3)):
        raise ValueError("the forces must be finite")
    fc = math.hypot(f2, f3)
    return {"fc": fc}, {"fc": {"f2": f2 / fc if fc else 0.0, "f3": f3 / fc if fc else 0.0}}  # 0 at the kink


def check(function, case, bound):
    """Whether `function` agrees with one case. The golden numbers are rounded, too, by which η may grow by 1."""
    try:
        out, jac = function(**numbers(case["in"]))
    except ValueError:
        return "error" in case  # refused, as it should be
    if "error" in case or eta(out, case["out"], numbers(case["out_scale"])) > bound["value"] + 1:
        return False
    return "jac" not in case or eta(jac, case["jac"], numbers(case["jac_scale"])) <= bound["jacobian"] + 1


if __name__ == "__main__":
    file = read(sys.argv[1] if sys.argv[1:] else GOLDEN, "slot.contact_force")
    wrong = [case["id"] for case in file["cases"] if not check(contact_force, case, file["eta"])]
    for name in wrong:
        print(f"wrong: {name}")
    print(f"{len(file['cases']) - len(wrong)} passed, {len(wrong)} failed")
    sys.exit(1 if wrong else 0)
