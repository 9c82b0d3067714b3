"""An oracle for every formula of the formulary, independent of the Rust code.

Each module is one family of documented pages and states its equations in the plainest way, over mpmath numbers of
thousands of bits. Jacobians are never derived by hand: `core` forms central differences with a step so small that
hundreds of digits are right.

    >>> from oracle import evaluate, jacobian
    >>> float(evaluate("slot.contact_force", {"f2": 3.0, "f3": 4.0})["fc"])
    5.0
    >>> float(jacobian("slot.contact_force", {"f2": 3.0, "f3": 4.0})["fc"]["f2"])
    0.6
"""

from importlib import import_module
from pkgutil import iter_modules

from .core import CATALOG, Ambiguous, OutsideDomain, evaluate, jacobian, kinks

for module in iter_modules(__path__):
    import_module(f".{module.name}", __name__)  # This fills CATALOG.

__all__ = ["CATALOG", "Ambiguous", "OutsideDomain", "evaluate", "jacobian", "kinks"]
