"""The other programs, which may be absent."""

from __future__ import annotations

import importlib
import importlib.util
import os
from types import ModuleType

from export import FOLDER

#: Our module for each, and the module that its package has.
PROGRAMS = {"by_pinocchio": "pinocchio", "by_mujoco": "mujoco", "by_exudyn": "exudyn"}
REQUIRED = "JOINTPROOF_REQUIRE_FOREIGN"


class Absent(Exception):
    """A program, or what is compared with it, is not there."""


def load(ours: str) -> ModuleType:
    """The comparisons with a program. Absent is an error where the environment says that nothing may be."""
    missing = None
    if not (FOLDER / "jp_runtime.py").is_file():
        missing = f"no export in {FOLDER}: cargo xtask export --lang numpy --out {FOLDER}"
    elif importlib.util.find_spec(PROGRAMS[ours]) is None:
        missing = f"{PROGRAMS[ours]} is not installed: pip install --requirement tests/python/foreign/requirements.txt"
    if missing is None:
        return importlib.import_module(ours)
    raise (RuntimeError if os.environ.get(REQUIRED) else Absent)(missing)
