# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _PressureLinearValue(NamedTuple):
    p: Numbers

class _PressureLinearGradient(Gradient):
    h: Numbers
    k: Numbers

class _PressureLinearJacobian(Jacobian):
    p: _PressureLinearGradient

class _PressureLinearLinearized(NamedTuple):
    value: _PressureLinearValue
    jacobian: _PressureLinearJacobian

class _PressureLinear(Formula):
    """Linear pressure–overclosure law.

        p = \\begin{cases} k\\,h & h > 0
        0 & \\text{otherwise}\\end{cases}

    Inputs:
        h: overclosure, the separation with the opposite sign: positive when the surfaces overlap (unit L; a finite number)
        k: contact stiffness, pressure per overclosure (unit F/L^3; a finite number > 0)

    Outputs:
        p: contact pressure, positive in compression (unit F/L^2; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining nondefault mechanical surface interactions with slide line elements (ours: the section names the laws; those that it refers to were not given).
    """
    def __call__(self, h: ArrayLike, k: ArrayLike, *, out: Any = None) -> _PressureLinearValue: ...
    def linearize(self, h: ArrayLike, k: ArrayLike, *, out: Any = None) -> _PressureLinearLinearized: ...
    def exact(self, h: ArrayLike, k: ArrayLike, *, number: Callable[[str], Any] = ...) -> _PressureLinearValue: ...
    def exact_linearize(self, h: ArrayLike, k: ArrayLike, *, number: Callable[[str], Any] = ...) -> _PressureLinearLinearized: ...

pressure_linear: Final[_PressureLinear]

class _PressureExponentialValue(NamedTuple):
    p: Numbers

class _PressureExponentialGradient(Gradient):
    h: Numbers
    c0: Numbers
    p0: Numbers

class _PressureExponentialJacobian(Jacobian):
    p: _PressureExponentialGradient

class _PressureExponentialLinearized(NamedTuple):
    value: _PressureExponentialValue
    jacobian: _PressureExponentialJacobian

class _PressureExponential(Formula):
    """Exponential pressure–overclosure law.

        p = \\begin{cases} \\dfrac{p_0}{e-1}\\,s\\,(e^s - 1) & s > 0
        0 & \\text{otherwise}\\end{cases}\\qquad s = \\frac{h}{c_0} + 1

    Inputs:
        h: overclosure, the separation with the opposite sign: positive when the surfaces overlap (unit L; a finite number)
        c0: clearance at which pressure or damping begins (unit L; a finite number > 0)
        p0: contact pressure at zero overclosure (unit F/L^2; a finite number > 0)

    Outputs:
        p: contact pressure, positive in compression (unit F/L^2; a finite number)

    Accuracy: η at most 5 of the value, 8 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Defining nondefault mechanical surface interactions with slide line elements (ours: the section names the laws; those that it refers to were not given).
    """
    def __call__(self, h: ArrayLike, c0: ArrayLike, p0: ArrayLike, *, out: Any = None) -> _PressureExponentialValue: ...
    def linearize(self, h: ArrayLike, c0: ArrayLike, p0: ArrayLike, *, out: Any = None) -> _PressureExponentialLinearized: ...
    def exact(self, h: ArrayLike, c0: ArrayLike, p0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _PressureExponentialValue: ...
    def exact_linearize(self, h: ArrayLike, c0: ArrayLike, p0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _PressureExponentialLinearized: ...

pressure_exponential: Final[_PressureExponential]

class _DampingValue(NamedTuple):
    p: Numbers

class _DampingGradient(Gradient):
    h: Numbers
    v: Numbers
    mu0: Numbers
    c0: Numbers
    eta: Numbers

class _DampingJacobian(Jacobian):
    p: _DampingGradient

class _DampingLinearized(NamedTuple):
    value: _DampingValue
    jacobian: _DampingJacobian

class _Damping(Formula):
    """Viscous contact damping.

        p = v \\begin{cases} \\mu_0 & -h \\le \\eta c_0
        \\mu_0\\,\\dfrac{c_0 + h}{(1-\\eta)\\,c_0} & \\eta c_0 < -h < c_0
        0 & \\text{otherwise}\\end{cases}

    Inputs:
        h: overclosure, the separation with the opposite sign: positive when the surfaces overlap (unit L; a finite number)
        v: rate of the overclosure, positive while the surfaces approach (unit L/T; a finite number)
        mu0: damping coefficient in full contact, pressure per closing rate (unit FT/L^3; a finite number ≥ 0)
        c0: clearance at which pressure or damping begins (unit L; a finite number > 0)
        eta: fraction of the clearance up to which the damping coefficient is constant (unit 1; a number ≥ 0 and < 1)

    Outputs:
        p: contact pressure, positive in compression (unit F/L^2; a finite number)

    Accuracy: η at most 2 of the value, 2 of the Jacobian, inputs from 1/1e40 to 1e40 in size.
    Source: Slide lines, Defining nondefault mechanical surface interactions with slide line elements (ours: the section names the laws; those that it refers to were not given).
    """
    def __call__(self, h: ArrayLike, v: ArrayLike, mu0: ArrayLike, c0: ArrayLike, eta: ArrayLike, *, out: Any = None) -> _DampingValue: ...
    def linearize(self, h: ArrayLike, v: ArrayLike, mu0: ArrayLike, c0: ArrayLike, eta: ArrayLike, *, out: Any = None) -> _DampingLinearized: ...
    def exact(self, h: ArrayLike, v: ArrayLike, mu0: ArrayLike, c0: ArrayLike, eta: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DampingValue: ...
    def exact_linearize(self, h: ArrayLike, v: ArrayLike, mu0: ArrayLike, c0: ArrayLike, eta: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DampingLinearized: ...

damping: Final[_Damping]
