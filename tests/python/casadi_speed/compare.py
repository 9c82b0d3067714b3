#!/usr/bin/env python3
"""Time and error of every formula beside the C that CasADi generates from the oracle's definitions.

CasADi differentiates the definitions and writes C, which is compiled by gcc and clang with -O2 and -O3; the fastest
counts. It is compiled in the loop that times it, as our formulas are; with --called it is called, as a program calls
what stands in a file of its own. Both compute the outputs and the dense Jacobian over the same points, in rounds: Rust
by `report`, then C, whose formulas take turns as the ways of `report` do. A ratio is our time by that of C, the median
of the rounds; below 1 ours is faster. The hardest is the largest ratio at a case flagged hard, each timed alone. η is
the largest backward error of the Jacobian at golden cases, random ones and chosen ones (hand, limit, hard), away from
kinks.

examples:
  python3 tests/python/casadi_speed/compare.py
  python3 tests/python/casadi_speed/compare.py --filter 'slot.*' --rounds 5
  python3 tests/python/casadi_speed/compare.py --compiler gcc --called
"""

from __future__ import annotations

import argparse
import fnmatch
import importlib.util
import math
import shutil
import sys
from dataclasses import dataclass, field
from pathlib import Path
from statistics import geometric_mean, median
from typing import Any

REQUIREMENTS = Path(__file__).with_name("requirements.txt")
#: What the quantiles of `report` and the rounds may differ by on a machine that does other things too.
SPREAD = 1.05


@dataclass
class Row:
    """One formula."""

    id: str
    c: list[Any]
    cases: list[Any]
    errors: Any
    ours: Any
    points: Any = None
    ratios: list[float] = field(default_factory=list)
    hard: dict[str, list[float]] = field(default_factory=dict)
    times: tuple[float, float, float] = (math.nan, math.nan, math.nan)
    fastest: Any = None

    @property
    def ratio(self) -> float:
        return median(self.ratios)

    @property
    def hardest(self) -> float:
        """The largest ratio at a case flagged hard."""
        return max(map(median, self.hard.values()), default=math.nan)

    def is_slower(self) -> bool:
        """In every round, and by more than the times are uncertain, or than it takes to write the results."""
        return min(self.ratios) > SPREAD and self.times[0] > SPREAD * self.times[2]

    def is_less_accurate(self) -> bool:
        """By more than the rounding of the golden numbers."""
        return any(ours > theirs + 1 for ours, theirs in zip(self.ours.jacobian(), self.errors.jacobian()))

    def take(self, ours: dict[str, Any], by_compiled: list[float]) -> None:
        """A round over all points; C by every compilation."""
        c, self.fastest = min(zip(by_compiled, self.c), key=lambda pair: pair[0])
        rust = ours["value_and_jacobian"]["median"]
        self.ratios.append(rust / c)
        self.times = (rust, c, ours["copy"]["median"])

    def text(self) -> str:
        etas = " ".join(f"{eta:9.2g}" for eta in (*self.ours.jacobian(), *self.errors.jacobian()))
        rust, c, copy = self.times
        spread = f"{min(self.ratios):.2f} to {max(self.ratios):.2f}"
        return f"{self.id:40} {rust:8.1f} {c:8.1f} {copy:7.1f} {self.ratio:6.2f}  {spread:14} {self.hardest:7.2f} {etas}  {self.fastest.flags}"


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--filter", default="*", metavar="GLOB", help="only the formulas that match")
    parser.add_argument("--rounds", type=int, default=3, help="how often both are timed (3)")
    parser.add_argument("--turns", type=int, default=21, help="turns of C a round, whose median counts (21)")
    parser.add_argument("--random", type=int, default=200, metavar="N", help="random golden cases of a formula (200)")
    parser.add_argument("--compiler", choices=("gcc", "clang"), help="only this one (the faster of both)")
    parser.add_argument("--called", action="store_true", help="C is called, as from a file of its own")
    parser.add_argument("--xtask", default="cargo xtask", metavar="COMMAND", help="runs report and export (cargo xtask)")
    parser.add_argument("--out", type=Path, default=Path("target/casadi"), metavar="FOLDER", help="what is generated")
    return parser.parse_args()


def missing(options: argparse.Namespace) -> str | None:
    packages = [name for name in ("casadi", "numpy") if importlib.util.find_spec(name) is None]
    if packages:
        return f"{' and '.join(packages)} not installed: pip install --requirement {REQUIREMENTS}"
    if options.compiler and not shutil.which(options.compiler):
        return f"{options.compiler} is not here"
    return None if any(map(shutil.which, ("gcc", "clang"))) else "neither gcc nor clang is here"


def main() -> int:
    options = parse()
    if why := missing(options):
        print(f"skipped: {why}")
        return 0
    rows = prepared(options)
    for round in range(options.rounds):
        for family in dict.fromkeys(row.id.split(".")[0] for row in rows):
            measure(options, family, [row for row in rows if row.id.split(".")[0] == family])
        print(f"round {round + 1} of {options.rounds}", file=sys.stderr)
    return report(rows)


def prepared(options: argparse.Namespace) -> list[Row]:
    """Everything compiled, and compared with the golden files."""
    from compiled import COMPILERS, compiled, compilers
    from golden import ROOT, cases, errors
    from ours import Exported, run
    from symbols import CATALOG, ITERATIVE

    folder = options.out.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    by, exact = compilers((options.compiler,) if options.compiler else COMPILERS), folder / "golden"
    run(options.xtask, "golden", "--filter", options.filter, "--random", options.random, "--out", exact)
    exported, rows = Exported.made(options.xtask, options.filter, folder / "export"), []
    for id, entry in sorted(CATALOG.items()):
        if id in ITERATIVE or not fnmatch.fnmatch(id, options.filter):
            continue
        lengths = [{name: length or 1 for name, length in some.items()} for some in (entry.inputs, entry.outputs)]
        c, at = compiled(id, folder, by, options.called), cases(id, exact)
        ours = errors(at, lambda x: exported.evaluate(id, *lengths, x))
        rows.append(Row(id, c, at, errors(at, c[0].evaluate), ours))
        # Of the committed cases: among many more, C itself loses digits at some.
        if not errors(cases(id, ROOT / "golden"), c[0].evaluate).are_of_this_formula():
            raise SystemExit(f"what CasADi makes of {id} is not what golden/{id}.json says")
        print(f"compiled {id}", file=sys.stderr)
    return rows


def measure(options: argparse.Namespace, family: str, rows: list[Row]) -> None:
    import numpy as np
    from compiled import Timed, nanoseconds
    from ours import points, times

    folder = options.out.resolve()
    found = times(options.xtask, family, folder)
    for row in rows:
        row.points = points(row.id, folder)
    of_c = iter(nanoseconds([Timed(one, row.points) for row in rows for one in row.c], options.turns))
    for row in rows:
        row.take(found[row.id], [next(of_c) for _ in row.c])
    # At hard points that ours is timed at, each alone, only what was fastest.
    hard = [(row, case) for row in rows for case in row.cases if case.id in found[row.id]["hard"]]
    at_each = [Timed(row.fastest, np.tile(case.x, (len(row.points), 1))) for row, case in hard]
    for (row, case), c in zip(hard, nanoseconds(at_each, options.turns // 4 + 1)):
        row.hard.setdefault(case.id, []).append(found[row.id]["hard"][case.id]["median"] / c)


def report(rows: list[Row]) -> int:
    print(f"{'':40} {'ns':>8} {'C, ns':>8} {'copying':>7} {'ratio':>6}  {'of rounds':14} {'hardest':>7} {'η random, chosen':>19} {'of C':>19}")
    rows.sort(key=lambda row: -row.ratio)
    for row in rows:
        print(row.text())
    faster, slower = sum(row.ratio < 1 for row in rows), [row.id for row in rows if row.is_slower()]
    worse = [row.id for row in rows if row.is_less_accurate()]
    mean = geometric_mean([row.ratio for row in rows])
    print(f"{faster} of {len(rows)} faster, {len(slower)} slower beyond the spread; geometric mean {mean:.2f}")
    if worse:
        print(f"less accurate: {', '.join(worse)}")
    return 1 if slower or worse else 0


if __name__ == "__main__":
    sys.exit(main())
