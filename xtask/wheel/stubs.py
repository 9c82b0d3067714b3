"""The type stubs of the formulas, which the wheel is built with: what the catalog says of each."""

import pathlib
import re

import jointproof
from jointproof.formula import docstring

FOLDER = pathlib.Path(__file__).parent / "python" / "jointproof"
HEAD = '''# Generated from the catalog when the wheel was built.
from collections.abc import Callable, Sequence
from typing import Any, Final, Generic, NamedTuple, TypeAlias, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .formula import Formula, Gradient, Jacobian

Array: TypeAlias = NDArray[np.float64]
# What a number is: a float at one point, an array at several.
N = TypeVar("N")
'''
PACKAGE = '''# Generated from the catalog when the wheel was built.
from collections.abc import Mapping

__version__: str
formulas: Mapping[str, Formula]

def find(formula: str | Formula) -> Formula: ...

'''
ARRAYS = '''# Generated from the catalog when the wheel was built.
from typing import Any, Final, NamedTuple

from ..formula import Gradient, Jacobian
from ._function import Function
'''
ELEMENT = "from {} import Contribution as Contribution, Element as Element\n"
LIBRARY = '''# Generated from the catalog when the wheel was built.
from typing import Any

from ..formula import Formula
from ._function import Function as Function
from ._function import Missing as Missing

def find(formula: str | Formula) -> Any: ...
def there(formula: str | Formula) -> Function: ...
'''


def write():
    """Puts a stub for each family beside the sources of the package, from where maturin takes them."""
    for former in [*FOLDER.glob("[!_]*.pyi"), FOLDER / "__init__.pyi"]:
        former.unlink(missing_ok=True)
    families = {}
    for id, formula in jointproof.formulas.items():
        families.setdefault(id.split(".")[0], []).append(formula)
    arrays = FOLDER / "arrays"
    for former in arrays.glob("*.pyi"):
        former.unlink()
    (arrays / "__init__.pyi").write_text(LIBRARY + "".join(f"from . import {family} as {family}\n" for family in families), encoding="utf-8")
    for family, formulas in families.items():
        elements = re.findall(r"^(\w+) = Element\(", (arrays / f"{family}.py").read_text(encoding="utf-8"), re.MULTILINE)
        there = ARRAYS + ELEMENT.format("._element") * bool(elements) + "".join(map(over_arrays, formulas))
        here = HEAD + ELEMENT.format(".arrays._element") * bool(elements) + "".join(map(stub, formulas))
        for folder, text in ((arrays, there), (FOLDER, here)):
            (folder / f"{family}.pyi").write_text(text + "".join(f"{id}: Final[Element]\n" for id in elements), encoding="utf-8")
    (FOLDER / "__init__.pyi").write_text(package(families), encoding="utf-8")


def package(families):
    """The stub of the package: what it imports, and a module for each family."""
    imported = re.findall(r"^from (\.\w+) import (.+)$", (FOLDER / "__init__.py").read_text(encoding="utf-8"), re.MULTILINE)
    lines = [f"from {module} import {name} as {name}" for module, names in imported for name in names.split(", ")]
    lines += [f"from . import {module} as {module}" for module in sorted([*families, "arrays", "blocks"])]
    return PACKAGE + "\n".join(lines) + "\n"


def point(shape):
    """The type of an input at one point."""
    return "Sequence[" * len(shape) + "float" + "]" * len(shape)


def stub(formula):
    name = formula.__name__
    kind = type(formula).__name__
    at_point = ", ".join(f"{field.name}: {point(field.shape)}" for field in formula.inputs)
    inputs = ", ".join(f"{field.name}: ArrayLike" for field in formula.inputs)
    # An array for a vector may be one point or several.
    many = "Any" if any(field.shape for field in formula.inputs) else "Array"
    number = lambda field: "Array" if field.shape else "N"  # noqa: E731
    values = "".join(f"    {field.name}: {number(field)}\n" for field in formula.outputs)
    gradients = "".join(f"    {field.name}: {number(field)}\n" for field in formula.inputs)
    rows = "".join(f"    {field.name}: _{kind}Gradient[{number(field)}]\n" for field in formula.outputs)
    doc = "\n".join(f"    {line}".rstrip() for line in docstring(formula).split("\n")).strip().replace("\\", "\\\\")
    methods = ""
    for method, result in (("__call__", "Value"), ("linearize", "Linearized")):
        methods += f'''    @overload  # type: ignore[override]
    def {method}(self, {at_point}, *, out: None = None) -> _{kind}{result}[float]: ...
    @overload
    def {method}(self, {inputs}, *, out: Any = None) -> _{kind}{result}[{many}]: ...
'''
    return f'''
class _{kind}Value(NamedTuple, Generic[N]):
{values}
class _{kind}Gradient(Gradient, Generic[N]):
{gradients}
class _{kind}Jacobian(Jacobian, Generic[N]):
{rows}
class _{kind}Linearized(NamedTuple, Generic[N]):
    value: _{kind}Value[N]
    jacobian: _{kind}Jacobian[N]

class _{kind}(Formula):
    """{doc}
    """
{methods}    def exact(self, {inputs}, *, number: Callable[[str], Any] = ...) -> _{kind}Value[Any]: ...
    def exact_linearize(self, {inputs}, *, number: Callable[[str], Any] = ...) -> _{kind}Linearized[Any]: ...

{name}: Final[_{kind}]
'''


def over_arrays(formula):
    """The stub of a formula over arrays, of whatever library."""
    kind = type(formula).__name__
    inputs = ", ".join(f"{field.name}: Any" for field in formula.inputs)
    fields = {of: "".join(f"    {field.name}: Any\n" for field in fields) for of, fields in (("out", formula.outputs), ("in", formula.inputs))}
    rows = "".join(f"    {field.name}: _{kind}Gradient\n" for field in formula.outputs)
    return f'''
class _{kind}Value(NamedTuple):
{fields["out"]}
class _{kind}Gradient(Gradient):
{fields["in"]}
class _{kind}Jacobian(Jacobian):
{rows}
class _{kind}Linearized(NamedTuple):
    value: _{kind}Value
    jacobian: _{kind}Jacobian

class _{kind}(Function):
    def __call__(self, {inputs}, *, checked: bool = False) -> _{kind}Value: ...  # type: ignore[override]
    def linearize(self, {inputs}, *, checked: bool = False) -> _{kind}Linearized: ...  # type: ignore[override]

{formula.__name__}: Final[_{kind}]
'''
