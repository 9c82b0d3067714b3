# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _AnglesValue(NamedTuple):
    alpha: Numbers
    beta: Numbers
    gamma: Numbers

class _AnglesGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers

class _AnglesJacobian(Jacobian):
    alpha: _AnglesGradient
    beta: _AnglesGradient
    gamma: _AnglesGradient

class _AnglesLinearized(NamedTuple):
    value: _AnglesValue
    jacobian: _AnglesJacobian

class _Angles(Formula):
    """Cardan angles.

        \\alpha = -\\operatorname{atan2}(\\mathbf{e}_{2a}\\cdot\\mathbf{e}_{3b},\\ \\mathbf{e}_{3a}\\cdot\\mathbf{e}_{3b}),\\quad \\beta = \\arcsin(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b}),\\quad \\gamma = -\\operatorname{atan2}(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{2b},\\ \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{1b})

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        alpha: first Cardan angle of b's triad relative to a's, about e1a, from −π to below π (unit 1; a finite number)
        beta: second Cardan angle of b's triad relative to a's, from −π/2 to π/2 (unit 1; a finite number)
        gamma: third Cardan angle of b's triad relative to a's, about e3b, from −π to below π (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; these are the angles of three turns about 1, 2 and 3).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _AnglesValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _AnglesLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AnglesValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AnglesLinearized: ...

angles: Final[_Angles]

class _BetaTwoArgumentValue(NamedTuple):
    beta: Numbers

class _BetaTwoArgumentGradient(Gradient):
    e1a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers

class _BetaTwoArgumentJacobian(Jacobian):
    beta: _BetaTwoArgumentGradient

class _BetaTwoArgumentLinearized(NamedTuple):
    value: _BetaTwoArgumentValue
    jacobian: _BetaTwoArgumentJacobian

class _BetaTwoArgument(Formula):
    """Second Cardan angle, two-argument form.

        \\beta = \\operatorname{atan2}\\!\\left(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b},\\ \\sqrt{(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{1b})^2 + (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{2b})^2}\\right)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        beta: second Cardan angle of b's triad relative to a's, from −π/2 to π/2 (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; this form of the second angle is accurate up to 90°).
    """
    def __call__(self, e1a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _BetaTwoArgumentValue: ...
    def linearize(self, e1a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _BetaTwoArgumentLinearized: ...
    def exact(self, e1a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BetaTwoArgumentValue: ...
    def exact_linearize(self, e1a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BetaTwoArgumentLinearized: ...

beta_two_argument: Final[_BetaTwoArgument]
