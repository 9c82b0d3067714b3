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


def numbers(x):
    """Numbers, and the strings that stand for what JSON cannot write, in nested lists and dicts."""
    if isinstance(x, dict):
        return {key: numbers(value) for key, value in x.items()}
    return [numbers(v) for v in x] if isinstance(x, list) else SPECIAL[x] if isinstance(x, str) else float(x)


def cases(directory, formula):
    """Yield (id, inputs, outputs, Jacobian); no outputs: the input is invalid; no Jacobian: a kink."""
    for case in json.loads((Path(directory) / f"{formula}.json").read_text(encoding="utf-8"))["cases"]:
        out, jac = (numbers(case[key]) if key in case else None for key in ("out", "jac"))
        yield case["id"], numbers(case["in"]), out, jac


def close(have, want, ulps):
    return have == want or abs(have - want) <= ulps * math.ulp(want)


def contact_force(f2, f3):
    """Your code: FC = sqrt(f2^2 + f3^2) and its Jacobian; ValueError where the input is refused."""
    if not (math.isfinite(f2) and math.isfinite(f3)):
        raise ValueError("the forces must be finite")
    fc = math.hypot(f2, f3)
    return {"fc": fc}, {"fc": {"f2": f2 / fc if fc else 0.0, "f3": f3 / fc if fc else 0.0}}  # 0 at the kink


def check(case, ulps=2):
    """Whether your code agrees with one case; compare the fields one by one where yours are vectors."""
    _, inputs, out, jac = case
    try:
        my_out, my_jac = contact_force(**inputs)
    except ValueError:
        return out is None  # refused, as it should be
    right = out is not None and all(close(my_out[field], out[field], ulps) for field in out)
    return right and (jac is None or all(close(my_jac[o][i], jac[o][i], ulps) for o in jac for i in jac[o]))


if __name__ == "__main__":
    results = {c[0]: check(c) for c in cases(sys.argv[1] if sys.argv[1:] else GOLDEN, "slot.contact_force")}
    wrong = [name for name, right in results.items() if not right]
    for name in wrong:
        print(f"wrong: {name}")
    print(f"{len(results) - len(wrong)} passed, {len(wrong)} failed")
    sys.exit(1 if wrong else 0)
