#!/usr/bin/env python3
"""Compare the golden Cardan angles with scipy's.

The formulary has R_ij = ei_a . ej_b and R = R1(alpha) R2(beta) R3(gamma), each R_k the active rotation about axis k, so

    R13 = sin beta, R23 = -sin alpha cos beta, R33 = cos alpha cos beta,
    R12 = -cos beta sin gamma, R11 = cos beta cos gamma.

scipy's Rotation.from_matrix(R).as_euler("XYZ") (capitals: rotations about the axes that move along) factors R the same
way, so (alpha, beta, gamma) are its three angles as they stand: no sign changes, and the minus signs in
alpha = -atan2(R23, R33) and gamma = -atan2(R12, R11) are what makes it so. Angles are compared modulo 2 pi.

scipy expects a rotation, so a case whose triads are not orthonormal and right-handed to 1e-12 is left out and
counted, as is one where cos beta < 1e-6, since scipy there sets the third angle to zero. The tolerance is
1e-14 / cos beta, because near +-90 degrees the rounding of R moves alpha, gamma and the arc sine beta by so much.

    python check_cardan_scipy.py [GOLDEN_DIRECTORY]
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

GOLDEN = Path(__file__).resolve().parents[2] / "golden"
FORMULAS = {"cardan.angles": ("alpha", "beta", "gamma"), "universal.angles": ("alpha", "gamma")}
TOLERANCE = 1e-14
ORTHONORMAL = 1e-12
GIMBAL = 1e-6


def triad(inputs: dict, node: str) -> np.ndarray:
    """Rows e1, e2, e3."""
    return np.array([inputs[f"e{k}{node}"] for k in (1, 2, 3)], dtype=float)


def is_rotation(e: np.ndarray) -> bool:
    return float(np.abs(e @ e.T - np.eye(3)).max()) < ORTHONORMAL and float(np.linalg.det(e)) > 0


def check(path: Path, names: tuple[str, ...]) -> tuple[int, int]:
    passed = failed = skewed = gimbal = 0
    worst = 0.0
    for case in json.loads(path.read_text(encoding="utf-8"))["cases"]:
        if "out" not in case:
            continue
        a, b = triad(case["in"], "a"), triad(case["in"], "b")
        if not (is_rotation(a) and is_rotation(b)):
            skewed += 1
            continue
        r = a @ b.T
        cos_beta = math.hypot(r[0, 0], r[0, 1])
        if cos_beta < GIMBAL:
            gimbal += 1
            continue
        theirs = dict(zip(("alpha", "beta", "gamma"), Rotation.from_matrix(r).as_euler("XYZ")))
        for name in names:
            difference = abs(math.remainder(case["out"][name] - theirs[name], 2 * math.pi))
            worst = max(worst, difference * cos_beta / TOLERANCE)
            if difference <= TOLERANCE / cos_beta:
                passed += 1
            else:
                failed += 1
                print(
                    f"FAIL {path.stem}: case {case['id']}: {name}: golden {case['out'][name]!r}, "
                    f"scipy {float(theirs[name])!r}, {difference:.2e} apart, allowed {TOLERANCE / cos_beta:.2e}"
                )
    if passed + failed == 0:
        failed += 1
        print(f"FAIL {path.stem}: not one case could be compared")
    print(
        f"{path.stem}: {passed} angles agree, worst at {worst:.2f} of the tolerance; "
        f"left out: {skewed} cases with skewed triads, {gimbal} near gimbal lock"
    )
    return passed, failed


def main(directory: Path = GOLDEN) -> int:
    passed = failed = 0
    for formula, names in FORMULAS.items():
        path = directory / f"{formula}.json"
        if not path.exists():
            print(f"{formula}: skipped, {path} does not exist yet")
            continue
        p, f = check(path, names)
        passed, failed = passed + p, failed + f
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    if "--help" in sys.argv or "-h" in sys.argv:
        print(__doc__)
        sys.exit(0)
    sys.exit(main(*map(Path, sys.argv[1:2])))
