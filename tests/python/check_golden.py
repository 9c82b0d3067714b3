#!/usr/bin/env python3
"""Recompute every number of the golden files with the independent oracle and demand the correctly rounded double.

examples:
  python check_golden.py                          all files of ../../golden
  python check_golden.py --filter 'slot.*'        one family
  python check_golden.py --golden /tmp/golden     another directory
  python check_golden.py --complete               fail also on formulas that have no golden file yet
"""

from __future__ import annotations

import argparse
import fnmatch
import json
import math
import multiprocessing
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Iterator

from oracle import CATALOG, evaluate, jacobian, kinks
from oracle.core import bits_of, to_double, ulps_between
from oracle.scales import four_digits_up, jacobian_scales, out_scales

GOLDEN = Path(__file__).resolve().parents[2] / "golden"
FLAGS = {"hand", "limit", "random", "hard", "worst", "kink", "invalid"}
LAYOUT = 2
PROVENANCE = {("printed", False), ("reconstructed", True), ("ours", True)}  # kind, and whether it says why
SPECIAL = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}
MIN_VALID_CASES = 32
SHOWN = 20  # failures printed per formula


@dataclass
class Report:
    """What was checked in one file."""

    formula: str
    # Whether the file has the Jacobian, which is in closed form then.
    is_closed: bool = True
    cases: int = 0
    invalid: int = 0
    without_jacobian: int = 0
    values: int = 0
    entries: int = 0
    scales: int = 0
    failures: list[str] = field(default_factory=list)

    def fail(self, message: str) -> None:
        self.failures.append(f"{self.formula}: {message}")

    @property
    def passed(self) -> int:
        return self.values + self.entries + self.scales


def number(x: Any) -> float:
    """A JSON number or one of the three strings; anything else is a TypeError."""
    if isinstance(x, str) and x in SPECIAL:
        return SPECIAL[x]
    if isinstance(x, bool) or not isinstance(x, (int, float)):
        raise TypeError(f"{x!r} is not a number")
    return float(x)


def has_shape(value: Any, shape: list[int]) -> bool:
    if not shape:
        return not isinstance(value, (list, dict))
    return isinstance(value, list) and len(value) == shape[0] and all(has_shape(v, shape[1:]) for v in value)


def shape_of(*lengths: int) -> list[int]:
    """A scalar has length 0; a list of four or nine is a square matrix, row by row."""
    matrices = {4: [2, 2], 9: [3, 3]}
    return [n for length in lengths for n in matrices.get(length, [length]) if n]


def flatten(value: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """('[0][2]', leaf) for every leaf of nested lists."""
    if isinstance(value, list):
        for k, item in enumerate(value):
            yield from flatten(item, f"{path}[{k}]")
    else:
        yield path, value


def compare(report: Report, case: str, name: str, golden: Any, exact: Any) -> int:
    """Each golden double must be the exact number rounded once; 0 and -0 are equal. Returns how many were right."""
    right = 0
    for (path, written), (_, true) in zip(flatten(golden), flatten(exact), strict=True):
        try:
            have = number(written)
        except TypeError as error:
            report.fail(f"case {case}: {name}{path}: {error}")
            continue
        want = to_double(true)
        if bits_of(have) == bits_of(want) or have == want == 0:
            right += 1
        else:
            report.fail(
                f"case {case}: {name}{path}: golden {have!r} (0x{bits_of(have):016x}), "
                f"oracle {want!r} (0x{bits_of(want):016x}), {ulps_between(have, want)} ulp apart"
            )
    return right


def compare_scales(report: Report, case: str, name: str, golden: Any, exact: Any) -> int:
    """Each scale must be the exact one, rounded up to four digits. Returns how many were right."""
    right = 0
    for (path, written), (_, true) in zip(flatten(golden), flatten(exact), strict=True):
        have, want = (written if isinstance(written, str) else float(written)), four_digits_up(true)
        if have == want or (have == "Infinity" and want == math.inf):
            right += 1
        else:
            report.fail(f"case {case}: {name}{path}: golden {have!r}, oracle {want!r}")
    return right


def at_least(report: Report, case: str, name: str, scales: Any, numbers: Any) -> None:
    """No scale is below the magnitude of its number, but for rounding."""
    for (path, scale), (_, written) in zip(flatten(scales), flatten(numbers), strict=True):
        if not number(scale) >= abs(number(written)) * (1 - 2**-39):
            report.fail(f"case {case}: {name}{path}: {scale!r} is less than |{written!r}|")


def same_keys(report: Report, where: str, have: Any, want: dict[str, Any]) -> bool:
    if isinstance(have, dict) and set(have) == set(want):
        return True
    names = sorted(have) if isinstance(have, dict) else repr(have)
    report.fail(f"{where}: has {names}, expected {sorted(want)}")
    return False


def check_fields(report: Report, kind: str, declared: Any, expected: dict[str, int]) -> None:
    """The `inputs` and `outputs` lists: names, shapes, units."""
    try:
        found = {f["name"]: f["shape"] for f in declared}
        missing_unit = [f["name"] for f in declared if not isinstance(f.get("unit"), str)]
    except (TypeError, KeyError) as error:
        report.fail(f"{kind}: not a list of name, shape, unit ({error!r})")
        return
    if len(found) != len(declared):
        report.fail(f"{kind}: a name is declared twice")
    if missing_unit:
        report.fail(f"{kind}: no unit for {missing_unit}")
    if same_keys(report, kind, found, expected):
        for name, length in expected.items():
            if found[name] != shape_of(length):
                report.fail(f"{kind}: {name} has shape {found[name]}, expected {shape_of(length)}")


def read_inputs(report: Report, case: dict[str, Any]) -> dict[str, Any] | None:
    """The inputs as doubles; None where they are not as they should be."""
    formula, name = CATALOG[report.formula], case["id"]
    if not same_keys(report, f"case {name}: in", case["in"], formula.inputs):
        return None
    inputs: dict[str, Any] = {}
    for key, length in formula.inputs.items():
        value = case["in"][key]
        if not has_shape(value, shape_of(length)):
            report.fail(f"case {name}: in.{key}: {value!r} has not the shape {shape_of(length)}")
            return None
        try:
            inputs[key] = [number(x) for x in value] if length else number(value)
        except TypeError as error:
            report.fail(f"case {name}: in.{key}: {error}")
            return None
    return inputs


def has_fields(report: Report, case: dict[str, Any], key: str, jacobian: bool) -> bool:
    """Whether out, jac or the scales of either have every field, in its shape."""
    formula, name, found = CATALOG[report.formula], case["id"], case.get(key)
    if not same_keys(report, f"case {name}: {key}", found, formula.outputs):
        return False
    expected = {f".{out}": (found[out], shape_of(rows)) for out, rows in formula.outputs.items()}
    if jacobian:
        if not all(same_keys(report, f"case {name}: {key}.{out}", found[out], formula.inputs) for out in found):
            return False
        expected = {
            f".{out}.{column}": (found[out][column], shape_of(rows, columns))
            for out, rows in formula.outputs.items()
            for column, columns in formula.inputs.items()
        }
    wrong = [(path, shape) for path, (value, shape) in expected.items() if not has_shape(value, shape)]
    for path, shape in wrong:
        report.fail(f"case {name}: {key}{path} has not the shape {shape}")
    return not wrong


def check_case(report: Report, case: dict[str, Any]) -> None:
    name, flags = case["id"], set(case["flags"])
    if not flags or not flags <= FLAGS:
        report.fail(f"case {name}: flags {sorted(flags)}, expected some of {sorted(FLAGS)}")
    inputs = read_inputs(report, case)
    if inputs is None:
        return
    if "invalid" in flags:
        check_invalid(report, case)
        return
    report.cases += 1
    if "error" in case:
        report.fail(f"case {name}: names an error without the flag invalid")
    if not all(math.isfinite(x) for _, x in flatten(list(inputs.values()))):
        report.fail(f"case {name}: an input that is not finite without the flag invalid")
        return
    check_kinks(report, case, inputs)
    exact = evaluate(report.formula, inputs)
    if has_fields(report, case, "out", jacobian=False):
        for out in exact:
            report.values += compare(report, name, f"out.{out}", case["out"][out], exact[out])
    try:
        slopes = jacobian(report.formula, inputs)
    except (ArithmeticError, ValueError):
        if "jac" in case:
            raise
        slopes = None  # there is none at this kink
    check_out_scales(report, case, inputs, exact, slopes)
    if "jac" in case and slopes is not None:
        check_jacobian(report, case, inputs, slopes)
    else:
        report.without_jacobian += 1


def check_invalid(report: Report, case: dict[str, Any]) -> None:
    report.invalid += 1
    if not isinstance(case.get("error"), str) or not case["error"]:
        report.fail(f"case {case['id']}: invalid, but no error is named")
    if any(key in case for key in ("out", "out_scale", "jac", "jac_scale")):
        report.fail(f"case {case['id']}: invalid, yet it has out or jac")


def check_kinks(report: Report, case: dict[str, Any], inputs: dict[str, Any]) -> None:
    name, flagged = case["id"], "kink" in case["flags"]
    for kind in kinks(report.formula, inputs):
        if not flagged:
            report.fail(f"case {name}: stands on a {kind} without the flag kink")
        if kind == "switch" and "jac" in case:
            report.fail(f"case {name}: stands on a switch, where there is no derivative, yet it has jac")
    if report.is_closed and "jac" not in case and not flagged:
        report.fail(f"case {name}: no jac, which only a kink may leave out")
    if not report.is_closed and ("jac" in case or "jac_scale" in case):
        report.fail(f"case {name}: jac without a bound of it, eta.jacobian")


def check_out_scales(report: Report, case: dict[str, Any], inputs: dict[str, Any], exact: Any, slopes: Any) -> None:
    if not has_fields(report, case, "out_scale", jacobian=False):
        return
    true = out_scales(report.formula, inputs, exact, slopes) if slopes is not None else {}
    for out in case["out_scale"]:
        if slopes is None:
            at_least(report, case["id"], f"out_scale.{out}", case["out_scale"][out], case["out"][out])
        else:
            have = case["out_scale"][out]
            report.scales += compare_scales(report, case["id"], f"out_scale.{out}", have, true[out])


def check_jacobian(report: Report, case: dict[str, Any], inputs: dict[str, Any], slopes: Any) -> None:
    """On a kink the derivative is a convention, and so is its scale, which is not recomputed there."""
    name, on_kink = case["id"], "kink" in case["flags"]
    if not (has_fields(report, case, "jac", jacobian=True) and has_fields(report, case, "jac_scale", jacobian=True)):
        return
    scales = {} if on_kink else jacobian_scales(report.formula, inputs)
    for out, row in slopes.items():
        for key, slope in row.items():
            where, have, scale = f"{out}.{key}", case["jac"][out][key], case["jac_scale"][out][key]
            report.entries += compare(report, name, f"jac.{where}", have, slope)
            if on_kink:
                at_least(report, name, f"jac_scale.{where}", scale, have)
            else:
                report.scales += compare_scales(report, name, f"jac_scale.{where}", scale, scales[out][key])


def check_header(report: Report, document: dict[str, Any]) -> None:
    """Where the equation is from, and the bounds of the backward error."""
    provenance, eta = document.get("provenance") or {}, document.get("eta") or {}
    if (provenance.get("kind"), bool(provenance.get("why"))) not in PROVENANCE:
        report.fail(f"provenance: {provenance!r}")
    report.is_closed = "jacobian" in eta
    if sorted(eta) not in (["jacobian", "value"], ["value"]) or not all(number(bound) >= 0 for bound in eta.values()):
        report.fail(f"eta: {eta!r}")


def check_document(document: dict[str, Any], expected_id: str) -> Report:
    """One golden file, already parsed; its name says which formula it must be."""
    report = Report(expected_id)
    if document.get("formula") != expected_id:
        report.fail(f"the file says formula {document.get('formula')!r}, its name says {expected_id!r}")
        return report
    if expected_id not in CATALOG:
        report.fail("unknown formula")
        return report
    if document.get("layout") != LAYOUT:
        report.fail(f"the layout is {document.get('layout')!r}, expected {LAYOUT}")
    for key in ("title", "source", "provenance", "latex", "eta", "inputs", "outputs", "cases"):
        if not document.get(key):
            report.fail(f"{key} is missing or empty")
    check_header(report, document)
    check_fields(report, "inputs", document.get("inputs"), CATALOG[expected_id].inputs)
    check_fields(report, "outputs", document.get("outputs"), CATALOG[expected_id].outputs)
    seen: set[str] = set()
    for index, case in enumerate(document.get("cases") or []):
        if not isinstance(case, dict) or not all(key in case for key in ("id", "flags", "in")):
            report.fail(f"case number {index}: id, flags or in is missing")
            continue
        if case["id"] in seen:
            report.fail(f"case {case['id']}: the id occurs twice")
        seen.add(case["id"])
        try:
            check_case(report, case)
        except (ArithmeticError, ValueError) as error:
            report.fail(f"case {case['id']}: the oracle has no value: {error}")
    if report.cases < MIN_VALID_CASES:
        report.fail(f"{report.cases} valid cases, at least {MIN_VALID_CASES} are asked for")
    return report


def check_file(path: Path) -> Report:
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        report = Report(path.stem)
        report.fail(f"cannot be read: {error}")
        return report
    return check_document(document, path.stem)


def is_schema(path: Path) -> bool:
    return "schema" in path.name


def parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--golden", type=Path, default=GOLDEN, metavar="DIR", help="directory of the golden files")
    parser.add_argument("--filter", default="*", metavar="GLOB", help="check only the formulas that match")
    parser.add_argument("--complete", action="store_true", help="every formula of the oracle must have a file")
    return parser.parse_args(arguments)


def main(arguments: list[str] | None = None) -> int:
    options = parse(arguments)
    files = sorted(p for p in options.golden.glob("*.json") if not is_schema(p))
    files = [p for p in files if fnmatch.fnmatch(p.stem, options.filter)]
    passed = failed = 0
    with multiprocessing.Pool(2) as pool:
        for report in pool.imap(check_file, files):
            mark = "ok  " if not report.failures else "FAIL"
            print(
                f"{mark} {report.formula}: {report.cases} cases ({report.without_jacobian} without Jacobian), "
                f"{report.invalid} invalid, {report.values} values, {report.entries} Jacobian entries, "
                f"{report.scales} scales",
                flush=True,
            )
            for message in report.failures[:SHOWN]:
                print(f"     {message}")
            if len(report.failures) > SHOWN:
                print(f"     and {len(report.failures) - SHOWN} more")
            passed += report.passed
            failed += len(report.failures)
    if not files:
        print(f"FAIL no golden file matches {options.filter!r} in {options.golden}")
        failed += 1
    if options.complete:
        present = {p.stem for p in files}
        for id in sorted(fnmatch.filter(CATALOG, options.filter)):
            if id not in present:
                print(f"FAIL {id}: no golden file")
                failed += 1
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
