"""The type stubs of the formulas, which the wheel is built with: what the catalog says of each."""

import pathlib
import re

import jointproof
from jointproof.formula import docstring

FOLDER = pathlib.Path(__file__).parent / "python" / "jointproof"
HEAD = '''# Generated from the catalog when the wheel was built.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]
'''
PACKAGE = '''# Generated from the catalog when the wheel was built.
from collections.abc import Mapping

__version__: str
formulas: Mapping[str, Formula]

def find(formula: str | Formula) -> Formula: ...

'''


def write():
    """Puts a stub for each family beside the sources of the package, from where maturin takes them."""
    for former in [*FOLDER.glob("[!_]*.pyi"), FOLDER / "__init__.pyi"]:
        former.unlink(missing_ok=True)
    families = {}
    for id, formula in jointproof.formulas.items():
        families.setdefault(id.split(".")[0], []).append(formula)
    for family, formulas in families.items():
        (FOLDER / f"{family}.pyi").write_text(HEAD + "".join(map(stub, formulas)), encoding="utf-8")
    (FOLDER / "__init__.pyi").write_text(package(families), encoding="utf-8")


def package(families):
    """The stub of the package: what it imports, and a module for each family."""
    imported = re.findall(r"^from (\.\w+) import (.+)$", (FOLDER / "__init__.py").read_text(encoding="utf-8"), re.MULTILINE)
    lines = [f"from {module} import {name} as {name}" for module, names in imported for name in names.split(", ")]
    lines += [f"from . import {family} as {family}" for family in sorted(families)]
    return PACKAGE + "\n".join(lines) + "\n"


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
