"""The documented equations of sliding and universal joints, coded once and proved, over arrays of NumPy.

Every formula is a function in the module of its family::

    >>> import jointproof
    >>> jointproof.slot.contact_force(f2=3.0, f3=[4.0, 0.0]).fc
    array([5., 3.])
    >>> value, jacobian = jointproof.slot.contact_force.linearize(3.0, 4.0)
    >>> print(jacobian.fc.f2)
    0.6

``formulas`` has all of them by identifier. :func:`check` judges a function of yours, :func:`audit` proves formulas again,
:func:`scene` evaluates scene files, :func:`plot` draws an output and its derivative. ``jointproof.arrays``, ``jointproof.jax``,
``jointproof.torch`` and ``jointproof.blocks`` bring formulas to
where arrays are those of others.
"""

import importlib
import json
import sys
from types import MappingProxyType, ModuleType

from . import _jointproof
from .auditing import Audits, audit, audit_part, merge, merge_parts
from .checking import Checked, check
from .errors import InputError, ShapeError
from .formula import Field, Formula, Gradient, Jacobian, Linearized, made
from .plotting import Plot, plot
from .scenes import Scene, scene

__all__ = [
    "Audits",
    "Checked",
    "Field",
    "Formula",
    "Gradient",
    "InputError",
    "Jacobian",
    "Linearized",
    "Plot",
    "Scene",
    "ShapeError",
    "audit",
    "audit_part",
    "check",
    "find",
    "formulas",
    "merge",
    "merge_parts",
    "plot",
    "scene",
]

__version__ = _jointproof.VERSION

_all = {said["id"]: made(place, said) for place, said in enumerate(json.loads(_jointproof.catalog()))}

#: All formulas by identifier, in the order of the book.
formulas = MappingProxyType(_all)


def find(formula):
    """The formula of this identifier; a formula is itself."""
    if isinstance(formula, Formula):
        return formula
    if formula not in _all:
        raise KeyError(f"there is no formula {formula!r}{_like(formula)}")
    return _all[formula]


def _like(formula):
    """What was perhaps meant."""
    from difflib import get_close_matches

    near = [id for id in _all if id.split(".")[1] == formula] or get_close_matches(str(formula), _all, 3)
    return f"; there is {' and '.join(near)}" if near else "; jointproof.formulas has all"


def _families():
    for id, formula in _all.items():
        family, _ = id.split(".")
        path = f"{__name__}.{family}"
        if path not in sys.modules:
            module = ModuleType(path, f"The formulas of the family {family}.")
            module.__package__ = __name__
            module.__all__ = []
            sys.modules[path] = module
            globals()[family] = module
            __all__.append(family)
        setattr(sys.modules[path], formula.__name__, formula)
        sys.modules[path].__all__.append(formula.__name__)


def _element(name):
    if name.startswith("__"):
        raise AttributeError(name)
    from .arrays import element

    return getattr(element, name)


_families()
#: The elements are there beside the formulas of the family.
element.__getattr__ = _element  # noqa: F821
del _families


def __getattr__(name):
    # What takes time to import is imported when it is asked for.
    if name in ("arrays", "blocks"):
        return importlib.import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
