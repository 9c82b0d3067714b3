"""Writes the type stubs of the formulas, from the catalog: python3 xtask/wheel/stubs.py [--check]

They are what the installed package says of itself, so install it first; a test holds that they are current.
"""

import argparse
import pathlib
import sys

import jointproof
from jointproof.formula import docstring

FOLDER = pathlib.Path(__file__).parent / "python" / "jointproof"
HEAD = '''# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]
'''


def main():
    parser = argparse.ArgumentParser(description="Write the type stubs of the formulas.")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a stub is not current")
    check = parser.parse_args().check
    stale = [name for name, text in stubs().items() if not is_current(FOLDER / name, text, check)]
    for name in stale if check else []:
        print(f"{name} is not current; python3 xtask/wheel/stubs.py writes it", file=sys.stderr)
    return 1 if check and stale else 0


def is_current(path, text, check):
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return True
    if not check:
        path.write_text(text, encoding="utf-8")
    return False


def stubs():
    """The text of every stub, by the name of its file."""
    families = {}
    for id, formula in jointproof.formulas.items():
        families.setdefault(id.split(".")[0], []).append(formula)
    return {f"{family}.pyi": HEAD + "".join(map(stub, formulas)) for family, formulas in families.items()}


def stub(formula):
    name = formula.__name__
    kind = type(formula).__name__
    inputs = ", ".join(f"{field.name}: ArrayLike" for field in formula.inputs)
    values = "".join(f"    {field.name}: Numbers\n" for field in formula.outputs)
    gradients = "".join(f"    {field.name}: Numbers\n" for field in formula.inputs)
    rows = "".join(f"    {field.name}: _{kind}Gradient\n" for field in formula.outputs)
    doc = "\n".join(f"    {line}".rstrip() for line in docstring(formula).split("\n")).strip().replace("\\", "\\\\")
    return f'''
class _{kind}Value(NamedTuple):
{values}
class _{kind}Gradient(Gradient):
{gradients}
class _{kind}Jacobian(Jacobian):
{rows}
class _{kind}Linearized(NamedTuple):
    value: _{kind}Value
    jacobian: _{kind}Jacobian

class _{kind}(Formula):
    """{doc}
    """
    def __call__(self, {inputs}, *, out: Any = None) -> _{kind}Value: ...
    def linearize(self, {inputs}, *, out: Any = None) -> _{kind}Linearized: ...
    def exact(self, {inputs}, *, number: Callable[[str], Any] = ...) -> _{kind}Value: ...
    def exact_linearize(self, {inputs}, *, number: Callable[[str], Any] = ...) -> _{kind}Linearized: ...

{name}: Final[_{kind}]
'''


if __name__ == "__main__":
    sys.exit(main())
