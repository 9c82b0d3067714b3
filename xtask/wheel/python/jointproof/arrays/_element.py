"""Printed elements over arrays: residuals, forces and their derivatives."""

import math
from typing import Any, NamedTuple

import array_api_compat as compat
import numpy as np

from ..formula import bound, described, fields_of
from ._function import components, in_one_library


class Contribution(NamedTuple):
    """What an element gives: ``residuals``, whose derivatives with respect to the unknowns are ``rows``; ``forces`` on the nodes,
    whose derivatives with respect to the unknowns are ``stiffness`` and with respect to the multipliers ``by_multipliers``; with
    friction the state ``after`` the step.

    ``residual`` and ``matrix`` are those of Newton's method for the unknowns and the multipliers: forces and residuals in one vector, and
    its derivative. Residuals that no multiplier keeps at 0 are not in them."""

    residuals: Any
    rows: Any
    forces: Any
    stiffness: Any
    by_multipliers: Any
    after: Any

    @property
    def residual(self) -> Any:
        if not self._is_held():
            return self.forces
        return compat.array_namespace(self.forces).concat([self.forces, self.residuals], axis=-1)

    @property
    def matrix(self) -> Any:
        if not self._is_held():
            return self.stiffness
        xp = compat.array_namespace(self.forces)
        corner = xp.zeros_like(self.by_multipliers[..., : self.residuals.shape[-1], :])
        above = xp.concat([self.stiffness, self.by_multipliers], axis=-1)
        return xp.concat([above, xp.concat([self.rows, corner], axis=-1)], axis=-2)

    def _is_held(self) -> bool:
        return bool(self.by_multipliers.shape[-1])


class Element:
    """An element over arrays of any library: called with its inputs by place or by name, without those of friction or with all of them.
    What is not allowed gives NaN."""

    def __init__(self, id: str, title: str, source: str, smooth: Any, rubbing: Any = None) -> None:
        self.id, self.__name__ = id, id
        self._forms = [(fields_of(said), shapes, value) for said, shapes, value in (smooth, rubbing or smooth)]
        fields, more = (form[0] for form in self._forms)
        #: Those with friction; without it those of friction are left out, which come last.
        self.inputs = more
        lines = [f"{title}.", "", "Inputs:", *map(described, fields)]
        if rubbing:
            lines += ["", "With friction also:", *map(described, more[len(fields) :])]
        self.__doc__ = "\n".join([*lines, "", f"Source: {source}."])

    def __repr__(self) -> str:
        return f"<element {self.id}>"

    def __call__(self, *args: Any, **kwargs: Any) -> Contribution:
        smooth, rubbing = self._forms
        rubs = len(args) > len(smooth[0]) or not {field.name for field in smooth[0]} >= set(kwargs)
        fields, shapes, value = rubbing if rubs else smooth
        names = [field.name for field in fields]
        lib, inputs = in_one_library(names, bound(f"element {self.id}", names, args, kwargs))
        numbers, shape = components(lib, fields, inputs)
        with np.errstate(all="ignore"):
            results = lib.run(value, numbers)
        found, start = {}, 0
        for name, own in shapes:
            parts = results[start : start + math.prod(own)]
            start += len(parts)
            packed = lib.joined(parts) if parts else numbers[0][..., None][..., :0]
            found[name] = lib.xp.reshape(packed, (*shape, *own))
        return Contribution(**found)
