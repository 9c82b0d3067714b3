"""The formulas over arrays of any library with the Array API: NumPy, JAX, PyTorch, CuPy and others, as one text that each of them traces,
compiles, maps and differentiates::

    >>> import numpy as np
    >>> from jointproof import arrays
    >>> arrays.slot.contact_force(f2=np.asarray([3.0, 0.0], np.float32), f3=4.0).fc
    array([5., 4.], dtype=float32)

Every formula is in the module of its family. The functions of the package itself are faster for NumPy, exact to the last bit that is proved,
and say what is wrong with inputs; what is not allowed is NaN here, unless ``checked=True``.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._function import Function as Function
from ._function import Missing as Missing

if TYPE_CHECKING:
    from ..formula import Formula


def find(formula: "str | Formula") -> Any:
    """The function of a formula, or of its identifier."""
    from .. import find

    found = find(formula)
    return getattr(import_module(f".{found.id.split('.')[0]}", __name__), found.__name__)


def there(formula: "str | Formula") -> Function:
    """The same, or an error that says why there is none."""
    function = find(formula)
    if isinstance(function, Missing):
        raise function.error()
    return function


def __getattr__(name: str) -> Any:
    from .. import formulas

    if any(id.startswith(f"{name}.") for id in formulas):
        return import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
