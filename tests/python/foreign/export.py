"""The formulas as they are exported to NumPy: what is compared here is what users take away.

JOINTPROOF_EXPORT names the folder that `cargo xtask export --lang numpy --out FOLDER` has written.
"""

from __future__ import annotations

import importlib
import os
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

FOLDER = Path(os.environ.get("JOINTPROOF_EXPORT", Path(__file__).parents[3] / "target/export/numpy")).resolve()
sys.path.insert(0, str(FOLDER))
#: What rounding leaves where numbers of order 1 cancel.
ZERO = 1e-12


def module(id: str):
    return importlib.import_module("jp_" + id.replace(".", "_"))


def outputs(id: str) -> list[tuple[str, int]]:
    return module(id).OUTPUTS


def split(fields: list[tuple[str, int]], numbers: np.ndarray) -> dict[str, np.ndarray]:
    """Numbers along the first axis by the names of fields; a number stays one, nine of them are a matrix."""
    named, first = {}, 0
    for name, length in fields:
        part = numbers[first : first + length]
        named[name] = part[0] if length == 1 else part.reshape(3, 3) if length == 9 else part
        first += length
    return named


@dataclass(frozen=True)
class Export:
    """Values of formulas and how they change, by the names of their inputs. What is asked for too much is ignored.

    `planted` is an error that a comparison must find: a formula, one of its outputs, and the component that gets a
    wrong sign. One that is zero but for rounding, and so has none, gets a one.
    """

    planted: tuple[str, str, int] | None = None

    def with_error(self, id: str, numbers: np.ndarray) -> np.ndarray:
        if self.planted is None or self.planted[0] != id:
            return numbers
        _, output, component = self.planted
        place, numbers = component, numbers.copy()
        for name, length in outputs(id):
            if name == output:
                break
            place += length
        numbers[place] = -numbers[place] if abs(numbers[place]) > ZERO else 1.0
        return numbers

    def value(self, id: str, **given) -> dict[str, np.ndarray]:
        formula = module(id)
        inputs = [given[name] for name, _ in formula.INPUTS]
        if formula.refused(*inputs):
            raise ValueError(f"{id} refuses {given}")
        return split(formula.OUTPUTS, self.with_error(id, formula.value(*inputs)))
