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

GOLDEN = Path(__file__).resolve().parents[2] / "golden"
FLAGS = {"hand", "limit", "random", "hard", "kink", "invalid"}
SPECIAL = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}
MIN_VALID_CASES = 32
SHOWN = 20  # failures printed per formula


@dataclass
class Report:
    """What was checked in one file."""

    formula: str
    cases: int = 0
    invalid: int = 0
    without_jacobian: int = 0
    values: int = 0
    entries: int = 0
    failures: list[str] = field(default_factory=list)

    def fail(self, message: str) -> None:
        self.failures.append(f"{self.formula}: {message}")

    @property
    def passed(self) -> int:
        return self.values + self.entries


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
    return [n for n in lengths if n]


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


def check_case(report: Report, case: dict[str, Any]) -> None:
    formula, name, flags = CATALOG[report.formula], case["id"], set(case["flags"])
    if not flags or not flags <= FLAGS:
        report.fail(f"case {name}: flags {sorted(flags)}, expected some of {sorted(FLAGS)}")
    if not same_keys(report, f"case {name}: in", case["in"], formula.inputs):
        return
    inputs: dict[str, Any] = {}
    for key, length in formula.inputs.items():
        value = case["in"][key]
        if not has_shape(value, shape_of(length)):
            report.fail(f"case {name}: in.{key}: {value!r} has not the shape {shape_of(length)}")
            return
        try:
            inputs[key] = [number(x) for x in value] if length else number(value)
        except TypeError as error:
            report.fail(f"case {name}: in.{key}: {error}")
            return
    finite = all(math.isfinite(x) for _, x in flatten(list(inputs.values())))

    if "invalid" in flags:
        report.invalid += 1
        if not isinstance(case.get("error"), str) or not case["error"]:
            report.fail(f"case {name}: invalid, but no error is named")
        if "out" in case or "jac" in case:
            report.fail(f"case {name}: invalid, yet it has out or jac")
        return

    report.cases += 1
    if "error" in case:
        report.fail(f"case {name}: names an error without the flag invalid")
    if not finite:
        report.fail(f"case {name}: an input that is not finite without the flag invalid")
        return
    if same_keys(report, f"case {name}: out", case.get("out"), formula.outputs):
        exact = evaluate(report.formula, inputs)
        for out, length in formula.outputs.items():
            if has_shape(case["out"][out], shape_of(length)):
                report.values += compare(report, name, f"out.{out}", case["out"][out], exact[out])
            else:
                report.fail(f"case {name}: out.{out} has not the shape {shape_of(length)}")

    for kind in kinks(report.formula, inputs):
        if "kink" not in flags:
            report.fail(f"case {name}: stands on a {kind} without the flag kink")
        if kind == "switch" and "jac" in case:
            report.fail(f"case {name}: stands on a switch, where there is no derivative, yet it has jac")

    if "jac" not in case:
        report.without_jacobian += 1
        if "kink" not in flags:
            report.fail(f"case {name}: no jac, which only a kink may leave out")
        return
    if not same_keys(report, f"case {name}: jac", case["jac"], formula.outputs):
        return
    exact = jacobian(report.formula, inputs)
    for out, rows in formula.outputs.items():
        if not same_keys(report, f"case {name}: jac.{out}", case["jac"][out], formula.inputs):
            continue
        for key, columns in formula.inputs.items():
            golden, where = case["jac"][out][key], f"jac.{out}.{key}"
            if has_shape(golden, shape_of(rows, columns)):
                report.entries += compare(report, name, where, golden, exact[out][key])
            else:
                report.fail(f"case {name}: {where} has not the shape {shape_of(rows, columns)}")


def check_document(document: dict[str, Any], expected_id: str) -> Report:
    """One golden file, already parsed; its name says which formula it must be."""
    report = Report(expected_id)
    if document.get("formula") != expected_id:
        report.fail(f"the file says formula {document.get('formula')!r}, its name says {expected_id!r}")
        return report
    if expected_id not in CATALOG:
        report.fail("unknown formula")
        return report
    for key in ("title", "source", "latex", "inputs", "outputs", "cases"):
        if not document.get(key):
            report.fail(f"{key} is missing or empty")
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
                f"{report.invalid} invalid, {report.values} values, {report.entries} Jacobian entries",
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
