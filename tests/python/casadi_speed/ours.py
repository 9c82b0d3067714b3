"""Our formulas: times by `report`, and numbers by the C that we export, which has the bits of the Rust."""

from __future__ import annotations

import ctypes
import json
import shlex
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from compiled import FLAGS, compilers, pointer
from golden import ROOT


def run(command: str, *arguments: Any) -> None:
    subprocess.run([*shlex.split(command), *map(str, arguments)], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


@dataclass
class Exported:
    """The exported functions of all formulas in one library."""

    library: ctypes.CDLL

    @classmethod
    def made(cls, xtask: str, filter: str, folder: Path) -> Exported:
        # Parts of an older export would be linked, too.
        shutil.rmtree(folder, ignore_errors=True)
        run(xtask, "export", "--lang", "c", "--filter", filter, "--out", folder)
        library = folder / "all.so"
        sources = sorted(folder.glob("jp_*.c"))
        command = [compilers()[0], "-std=c99", "-O2", "-ffp-contract=off", *FLAGS, "-o", library, *sources, "-lm"]
        subprocess.run(command, check=True)
        return cls(ctypes.CDLL(str(library)))

    def evaluate(self, id: str, inputs: dict[str, int], outputs: dict[str, int], x: np.ndarray) -> np.ndarray:
        """Outputs and Jacobian in a row."""
        arguments, first, values = [], 0, sum(outputs.values())
        both = np.zeros(values * (1 + len(x)))
        for length in inputs.values():
            part = x[first : first + length].copy()
            arguments.append(ctypes.c_double(part[0]) if length == 1 else pointer(part))
            first += length
        places = np.cumsum([0, *outputs.values()])
        arguments += [pointer(both[place:]) for place in places]
        function = getattr(self.library, f"jp_{id.replace('.', '_')}_jacobian")
        if code := function(*arguments):
            raise ValueError(f"{id} refuses input {code} of a case that is valid")
        return both


def times(xtask: str, family: str, folder: Path) -> dict[str, Any]:
    """What `report` measures now of a family, over points that it leaves in the folder."""
    file = folder / f"{family}.json"
    run(xtask, "report", "--quick", "--filter", f"{family}.*", "--inputs", folder, "--timing-json", file)
    return json.loads(file.read_text(encoding="utf-8"))["formulas"]


def points(id: str, folder: Path) -> np.ndarray:
    """The points over which that time was taken."""
    description = json.loads((folder / f"{id}.json").read_text(encoding="utf-8"))
    return np.fromfile(folder / description["file"], "<f8").reshape(-1, description["stride"])
