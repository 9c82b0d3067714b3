"""What a comparison with another program is, and the file that keeps how well it agreed."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from export import Export, outputs

#: Poses at which a connector is compared, unless it says otherwise.
POSES = 100
RECORDS = Path(__file__).parents[2] / "data/foreign"
UNIT = 2.0**-53
#: A sum of ten products whose factors went through up to five turns of a body has about this many roundings.
ROUNDINGS = 64
#: What is measured may differ by this from what is recorded, since libraries round in other places on other processors.
FACTOR = 4


def gap(found: np.ndarray, expected: np.ndarray, size: float) -> float:
    """The largest difference, relative to the size of what is added up."""
    return float(np.abs(found - expected).max() / size)


def terms(*factors: np.ndarray) -> float:
    """The largest sum of the sizes of what a product adds up."""
    product = np.abs(factors[0])
    for factor in factors[1:]:
        product = product @ np.abs(factor)
    return float(product.max())


@dataclass(frozen=True)
class Comparison:
    """A quantity of a connector by our formulas and by another program.

    `measure(export, count)` is the worst error at so many places. It may not be above `bound`. `formulas` are those
    that it rests on, and which of their outputs (None for all): a wrong sign in one of their numbers must be found,
    at `few` places. An error below `rounding` is never worse than a recorded one.
    """

    connector: str
    quantity: str
    formulas: dict[str, list[str] | None]
    measure: Callable[[Export, int], float]
    count: int
    places: str = "poses"
    bound: float = ROUNDINGS * UNIT
    rounding: float = 8 * UNIT
    few: int = 1

    @classmethod
    def at_poses(cls, name: str, quantity: str, formulas: dict, worst: Callable, connector, count: int) -> Comparison:
        return cls(name, quantity, formulas, partial(worst, connector, quantity), count)

    def name(self) -> str:
        return f"{self.connector}, {self.quantity}"

    def planted(self) -> list[tuple[str, str, int]]:
        """Every number of every formula that it rests on."""
        found = []
        for id, names in self.formulas.items():
            found += [
                (id, name, k) for name, length in outputs(id) if names is None or name in names for k in range(length)
            ]
        return found


def record_file(program: str) -> Path:
    return RECORDS / f"{program.lower()}.json"


def recorded(program: str) -> dict[str, float]:
    """The worst errors in the file, by connector and quantity."""
    entries = json.loads(record_file(program).read_text(encoding="utf-8"))["comparisons"]
    return {f"{entry['connector']}, {entry['quantity']}": entry["worst"] for entry in entries}


def write(program: str, version: str, measured: list[tuple[Comparison, float]]) -> None:
    entries = [
        dict(connector=c.connector, quantity=c.quantity, places=f"{c.count} {c.places}", worst=float(f"{error:.2g}"))
        for c, error in measured
    ]
    lines = ",\n".join("    " + json.dumps(entry) for entry in entries)
    head = json.dumps(dict(program=program, version=version))[1:-1]
    record_file(program).write_text(f'{{\n  {head},\n  "comparisons": [\n{lines}\n  ]\n}}\n', encoding="utf-8")
