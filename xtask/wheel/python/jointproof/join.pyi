# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _ConstraintValue(NamedTuple):
    g: Numbers

class _ConstraintGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    d0: Numbers

class _ConstraintJacobian(Jacobian):
    g: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        g_i = \\mathbf{e}_{ia}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - d_{0i},\\quad i = 1, 2, 3

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        d0: initial position of b relative to a, as components in a's triad ([3], unit L; a finite number)

    Outputs:
        g: residual of JOIN as components in a's triad, zero when b is in its place ([3], unit L; a finite number)

    Accuracy: η at most 2 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of JOIN was not given; b is held where it was at the start).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _RowsValue(NamedTuple):
    g1_ua: Numbers
    g1_ta: Numbers
    g1_ub: Numbers
    g2_ua: Numbers
    g2_ta: Numbers
    g2_ub: Numbers
    g3_ua: Numbers
    g3_ta: Numbers
    g3_ub: Numbers

class _RowsGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers

class _RowsJacobian(Jacobian):
    g1_ua: _RowsGradient
    g1_ta: _RowsGradient
    g1_ub: _RowsGradient
    g2_ua: _RowsGradient
    g2_ta: _RowsGradient
    g2_ub: _RowsGradient
    g3_ua: _RowsGradient
    g3_ta: _RowsGradient
    g3_ub: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of JOIN.

        \\mathbf{g}_{i,ua} = -\\mathbf{e}_{ia},\\quad \\mathbf{g}_{i,\\theta a} = \\mathbf{e}_{ia}\\times(\\mathbf{x}_b-\\mathbf{x}_a),\\quad \\mathbf{g}_{i,ub} = \\mathbf{e}_{ia}\\quad (i = 1, 2, 3)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)

    Outputs:
        g1_ua: derivative of the first residual of JOIN by the translation of node a ([3], unit 1; a finite number)
        g1_ta: derivative of the first residual of JOIN by the spin of node a ([3], unit L; a finite number)
        g1_ub: derivative of the first residual of JOIN by the translation of node b ([3], unit 1; a finite number)
        g2_ua: derivative of the second residual of JOIN by the translation of node a ([3], unit 1; a finite number)
        g2_ta: derivative of the second residual of JOIN by the spin of node a ([3], unit L; a finite number)
        g2_ub: derivative of the second residual of JOIN by the translation of node b ([3], unit 1; a finite number)
        g3_ua: derivative of the third residual of JOIN by the translation of node a ([3], unit 1; a finite number)
        g3_ta: derivative of the third residual of JOIN by the spin of node a ([3], unit L; a finite number)
        g3_ub: derivative of the third residual of JOIN by the translation of node b ([3], unit 1; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of JOIN was not given; these are the derivatives of its residuals).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalForcesValue(NamedTuple):
    fa: Numbers
    ma: Numbers
    fb: Numbers

class _NodalForcesGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _NodalForcesJacobian(Jacobian):
    fa: _NodalForcesGradient
    ma: _NodalForcesGradient
    fb: _NodalForcesGradient

class _NodalForcesLinearized(NamedTuple):
    value: _NodalForcesValue
    jacobian: _NodalForcesJacobian

class _NodalForces(Formula):
    """Nodal forces of JOIN.

        \\mathbf{f}_b = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{f}_a = -\\mathbf{f}_b,\\quad \\mathbf{m}_a = \\mathbf{f}_b\\times(\\mathbf{x}_b-\\mathbf{x}_a)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fa: force of the connector on node a, in the global frame ([3], unit F; a finite number)
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        fb: force of the connector on node b, in the global frame ([3], unit F; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page of JOIN was not given; these do the work of its multipliers).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _NodalForcesValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _NodalForcesLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearized: ...

nodal_forces: Final[_NodalForces]

class _GeometricStiffnessValue(NamedTuple):
    k_ua_ta: Numbers
    k_ta_ta: Numbers

class _GeometricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_ua_ta: _GeometricStiffnessGradient
    k_ta_ta: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of JOIN.

        \\mathbf{f} = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{K}_{ua,\\theta a} = \\mathbf{f}\\times\\mathbf{I},\\quad \\mathbf{K}_{\\theta a,\\theta a} = \\mathbf{f}\\otimes\\mathbf{d} - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        k_ua_ta: derivative of the force on node a by the spin of node a, at constant multipliers ([3, 3], unit F; a finite number)
        k_ta_ta: derivative of the moment on node a by the spin of node a, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page of JOIN was not given; it is the derivative of its nodal forces).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _SymmetricStiffnessValue(NamedTuple):
    s_ta_ta: Numbers

class _SymmetricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _SymmetricStiffnessJacobian(Jacobian):
    s_ta_ta: _SymmetricStiffnessGradient

class _SymmetricStiffnessLinearized(NamedTuple):
    value: _SymmetricStiffnessValue
    jacobian: _SymmetricStiffnessJacobian

class _SymmetricStiffness(Formula):
    """Symmetric part of the geometric stiffness of JOIN.

        \\mathbf{f} = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{S}_{\\theta a,\\theta a} = \\tfrac12(\\mathbf{f}\\otimes\\mathbf{d} + \\mathbf{d}\\otimes\\mathbf{f}) - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        s_ta_ta: symmetric part of the derivative of the moment on node a by the spin of node a ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page of JOIN was not given; for programs that solve symmetric equations).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessLinearized: ...

symmetric_stiffness: Final[_SymmetricStiffness]
