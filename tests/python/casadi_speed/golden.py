"""How far a program is from the golden numbers: η, in units of 2⁻⁵³, of its outputs and of its Jacobian."""

from __future__ import annotations

import importlib.util
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Iterator

import numpy as np

ROOT = Path(__file__).resolve().parents[3]


def reader():
    """The reader that the book gives its users."""
    found = importlib.util.spec_from_file_location("read_golden", ROOT / "book/examples/read_golden.py")
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


READER = reader()


@dataclass(frozen=True)
class Case:
    """A valid point with a derivative, away from kinks, and what is right there: numbers in a row, the Jacobian output by output."""

    id: str
    random: bool
    x: np.ndarray
    value: tuple[list[float], list[float]]
    jacobian: tuple[list[float], list[float]]

    def eta(self, outputs: np.ndarray, entries: np.ndarray) -> tuple[float, float]:
        pairs = ((outputs, self.value), (entries, self.jacobian))
        return tuple(READER.eta(mine.tolist(), golden, scale) for mine, (golden, scale) in pairs)

    def is_near(self, outputs: np.ndarray, entries: np.ndarray) -> bool:
        """Whether six digits of the largest output and of the largest entry are right."""
        pairs = ((outputs, np.array(self.value[0])), (entries, np.array(self.jacobian[0])))
        return all(np.abs(mine - golden).max() <= 1e-6 * np.abs(golden).max() for mine, golden in pairs)


def cases(id: str, folder: Path) -> list[Case]:
    """Those of the golden file of a formula in this folder."""
    file = json.loads((folder / f"{id}.json").read_text(encoding="utf-8"))
    inputs, outputs = (fields(file[kind]) for kind in ("inputs", "outputs"))

    def row(values: dict[str, Any]) -> list[float]:
        return [x for name in outputs for x in flat(READER.numbers(values[name]))]

    def rows(jacobian: dict[str, dict[str, Any]]) -> list[float]:
        """Each component of an output over all inputs; a golden entry has the shape of its output, then of its input."""
        return [
            x
            for out, rows in outputs.items()
            for k in range(rows)
            for name, columns in inputs.items()
            for x in list(flat(READER.numbers(jacobian[out][name])))[k * columns : (k + 1) * columns]
        ]

    return [
        Case(
            case["id"],
            "random" in case["flags"],
            np.array([x for name in inputs for x in flat(READER.numbers(case["in"][name]))]),
            (row(case["out"]), row(case["out_scale"])),
            (rows(case["jac"]), rows(case["jac_scale"])),
        )
        for case in file["cases"]
        if "jac" in case and "kink" not in case["flags"]
    ]


def fields(declared: list[dict[str, Any]]) -> dict[str, int]:
    return {field["name"]: int(np.prod(field["shape"], initial=1)) for field in declared}


def flat(value: Any) -> Iterator[float]:
    if isinstance(value, list):
        for item in value:
            yield from flat(item)
    else:
        yield value


@dataclass
class Errors:
    """The largest η of outputs and of Jacobians at random cases and at the chosen ones, which are limits and hard."""

    random: list[tuple[float, float]]
    chosen: list[tuple[float, float]]
    #: At how many of the random ones six digits are right.
    near: int = 0

    def are_of_this_formula(self) -> bool:
        """Whatever is lost at chosen cases: at random ones only another formula has fewer digits."""
        return self.near == len(self.random)

    def jacobian(self) -> list[float]:
        """The largest η of the Jacobian, at either."""
        return [max((eta[1] for eta in some), default=0.0) for some in (self.random, self.chosen)]


def errors(cases: list[Case], evaluate: Callable[[np.ndarray], np.ndarray]) -> Errors:
    found = Errors([], [])
    for case in cases:
        both, outputs = evaluate(case.x), len(case.value[0])
        parts = (both[:outputs], both[outputs:])
        (found.random if case.random else found.chosen).append(case.eta(*parts))
        found.near += case.random and case.is_near(*parts)
    return found
