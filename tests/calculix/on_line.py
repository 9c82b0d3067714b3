#!/usr/bin/env python3
"""How far node m is from the line through nodes 1 and n in a run of CalculiX, and how many iterations it took.

    on_line.py JOB M 1 N

The distance may not be above the rounding of what CalculiX prints, seven digits of each displacement; an increment may take
three iterations.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path


def nodes(deck: str) -> dict[int, list[float]]:
    """The places of nodes at the start."""
    _, _, rest = deck.partition("*NODE, NSET=ALL\n")
    lines = rest.split("\n*")[0].splitlines()
    return {int(number): [float(x) for x in place] for number, *place in (line.split(",") for line in lines)}


def distance(m: list[float], first: list[float], last: list[float]) -> float:
    line, off = ([b - a for a, b in zip(first, end)] for end in (last, m))
    along = sum(a * b for a, b in zip(line, off)) / sum(a * a for a in line)
    return math.hypot(*(b - along * a for a, b in zip(line, off)))


def main() -> int:
    job, *numbers = sys.argv[1], *map(int, sys.argv[2:5])
    start = nodes(Path(f"{job}.inp").read_text(encoding="utf-8"))
    worst, moved, increments = 0.0, 0.0, 0
    for block in Path(f"{job}.dat").read_text(encoding="utf-8").split("displacements")[1:]:
        rows = [line.split() for line in block.splitlines()[1:] if line.strip()]
        motions = {int(number): [float(x) for x in u] for number, *u in rows}
        places = [[x + u for x, u in zip(start[node], motions[node])] for node in numbers]
        worst, increments = max(worst, distance(*places)), increments + 1
        moved = max(moved, *(abs(u) for node in numbers for u in motions[node]))
    rows = [line.split() for line in Path(f"{job}.sta").read_text(encoding="utf-8").splitlines()[2:]]
    iterations = [int(row[3]) for row in rows]
    print(f"{job}: {worst:.0e} off the line at a displacement of {moved:g}, iterations {' '.join(map(str, iterations))}")
    return 0 if increments == len(rows) > 1 and worst <= 1e-6 * moved and max(iterations) <= 3 else 1


if __name__ == "__main__":
    sys.exit(main())
