# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _ConstraintValue(NamedTuple):
    ur1: Numbers
    ur2: Numbers
    ur3: Numbers

class _ConstraintGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers
    alpha0: Numbers
    beta0: Numbers
    gamma0: Numbers

class _ConstraintJacobian(Jacobian):
    ur1: _ConstraintGradient
    ur2: _ConstraintGradient
    ur3: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        u_{r1} = \\alpha - \\alpha_0,\\quad u_{r2} = \\beta - \\beta_0,\\quad u_{r3} = \\gamma - \\gamma_0

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        alpha0: initial value of the first Cardan angle (unit 1; a finite number)
        beta0: initial value of the second Cardan angle (unit 1; a finite number)
        gamma0: initial value of the third Cardan angle (unit 1; a finite number)

    Outputs:
        ur1: constraint residual of the first Cardan angle, zero when it has its initial value (unit 1; a finite number)
        ur2: constraint residual of the second Cardan angle, zero when it has its initial value (unit 1; a finite number)
        ur3: constraint residual of the third Cardan angle, zero when it has its initial value (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; the angles are held at their initial values).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _ConstraintMomentValue(NamedTuple):
    m: Numbers

class _ConstraintMomentGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    m1: Numbers
    m2: Numbers
    m3: Numbers

class _ConstraintMomentJacobian(Jacobian):
    m: _ConstraintMomentGradient

class _ConstraintMomentLinearized(NamedTuple):
    value: _ConstraintMomentValue
    jacobian: _ConstraintMomentJacobian

class _ConstraintMoment(Formula):
    """Constraint moment.

        \\mathbf{m} = m_1\\,\\mathbf{e}_{1a} + m_2\\,\\mathbf{e}_{2a} + m_3\\,\\mathbf{e}_{3a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        m1: constraint moment about e1a on node b, its opposite on node a (unit FL; a finite number)
        m2: constraint moment about e2a on node b, its opposite on node a (unit FL; a finite number)
        m3: constraint moment about e3a on node b, its opposite on node a (unit FL; a finite number)

    Outputs:
        m: constraint moment on node b, its opposite on node a, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Summary (ours: the page names the components m1, m2, m3; that they are along the triad of a is ours).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, *, out: Any = None) -> _ConstraintMomentValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, *, out: Any = None) -> _ConstraintMomentLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintMomentValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintMomentLinearized: ...

constraint_moment: Final[_ConstraintMoment]

class _RowsValue(NamedTuple):
    ur1_tb: Numbers
    ur2_tb: Numbers
    ur3_tb: Numbers

class _RowsGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers

class _RowsJacobian(Jacobian):
    ur1_tb: _RowsGradient
    ur2_tb: _RowsGradient
    ur3_tb: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of ALIGN.

        \\begin{aligned} S_1 &= \\mathbf{e}_{2a}\\cdot\\mathbf{e}_{3b}, & C_1 &= \\mathbf{e}_{3a}\\cdot\\mathbf{e}_{3b}, & \\mathbf{u}_1 &= \\frac{S_1\\,\\mathbf{e}_{3a} - C_1\\,\\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \\mathbf{u}_{r1,\\theta b} &= \\mathbf{e}_{3b}\\times\\mathbf{u}_1,
        S_3 &= \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{2b}, & C_3 &= \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{1b}, & \\mathbf{u}_3 &= \\frac{S_3\\,\\mathbf{e}_{1b} - C_3\\,\\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \\mathbf{u}_{r3,\\theta b} &= \\mathbf{u}_3\\times\\mathbf{e}_{1a} \\end{aligned},\\quad \\mathbf{u}_{r2,\\theta b} = \\frac{\\mathbf{e}_{3b}\\times\\mathbf{e}_{1a}}{\\sqrt{1-(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})^2}}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        ur1_tb: derivative of the first residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)
        ur2_tb: derivative of the second residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)
        ur3_tb: derivative of the third residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)

    Accuracy: η at most 4 of the value, 8 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; these are derivatives of the angles that are held).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalMomentsValue(NamedTuple):
    ma: Numbers
    mb: Numbers

class _NodalMomentsGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers
    lambda_r1: Numbers
    lambda_r2: Numbers
    lambda_r3: Numbers

class _NodalMomentsJacobian(Jacobian):
    ma: _NodalMomentsGradient
    mb: _NodalMomentsGradient

class _NodalMomentsLinearized(NamedTuple):
    value: _NodalMomentsValue
    jacobian: _NodalMomentsJacobian

class _NodalMoments(Formula):
    """Nodal moments of ALIGN.

        \\mathbf{m}_b = \\lambda_{r1}\\,\\mathbf{u}_{r1,\\theta b} + \\lambda_{r2}\\,\\mathbf{u}_{r2,\\theta b} + \\lambda_{r3}\\,\\mathbf{u}_{r3,\\theta b},\\quad \\mathbf{m}_a = -\\mathbf{m}_b

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        lambda_r1: multiplier of ALIGN's first residual: the moment on b about e1a (unit FL; a finite number)
        lambda_r2: multiplier of ALIGN's second residual: the moment on b about the line of nodes (unit FL; a finite number)
        lambda_r3: multiplier of ALIGN's third residual: the moment on b about e3b (unit FL; a finite number)

    Outputs:
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        mb: moment of the connector on node b, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 6 of the value, 48 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; these are derivatives of the angles that are held).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _NodalMomentsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _NodalMomentsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalMomentsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalMomentsLinearized: ...

nodal_moments: Final[_NodalMoments]

class _GeometricStiffnessValue(NamedTuple):
    k_tb_tb: Numbers

class _GeometricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers
    lambda_r1: Numbers
    lambda_r2: Numbers
    lambda_r3: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_tb_tb: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of ALIGN.

        \\begin{aligned} S_1 &= \\mathbf{e}_{2a}\\cdot\\mathbf{e}_{3b}, & C_1 &= \\mathbf{e}_{3a}\\cdot\\mathbf{e}_{3b}, & \\mathbf{u}_1 &= \\frac{S_1\\,\\mathbf{e}_{3a} - C_1\\,\\mathbf{e}_{2a}}{S_1^2+C_1^2}, & \\mathbf{h}_1 &= \\mathbf{e}_{3b}\\times\\frac{C_1\\,\\mathbf{e}_{3a} + S_1\\,\\mathbf{e}_{2a}}{S_1^2+C_1^2},
        S_3 &= \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{2b}, & C_3 &= \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{1b}, & \\mathbf{u}_3 &= \\frac{S_3\\,\\mathbf{e}_{1b} - C_3\\,\\mathbf{e}_{2b}}{S_3^2+C_3^2}, & \\mathbf{h}_3 &= \\mathbf{e}_{1a}\\times\\frac{C_3\\,\\mathbf{e}_{1b} + S_3\\,\\mathbf{e}_{2b}}{S_3^2+C_3^2} \\end{aligned},\\quad s = \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b},\\quad \\begin{aligned} \\mathbf{K}_{\\theta b,\\theta b} &= \\lambda_{r1}(\\mathbf{e}_{3b}\\otimes\\mathbf{u}_1 - \\mathbf{h}_1\\otimes\\mathbf{u}_{r1,\\theta b} - \\mathbf{u}_{r1,\\theta b}\\otimes\\mathbf{h}_1) + \\frac{\\lambda_{r2}}{\\sqrt{1-s^2}}(\\mathbf{e}_{3b}\\otimes\\mathbf{e}_{1a} - s\\,\\mathbf{I} + s\\,\\mathbf{u}_{r2,\\theta b}\\otimes\\mathbf{u}_{r2,\\theta b}) + \\lambda_{r3}(\\mathbf{u}_3\\otimes\\mathbf{e}_{1a} + \\mathbf{h}_3\\otimes\\mathbf{u}_{r3,\\theta b} + \\mathbf{u}_{r3,\\theta b}\\otimes\\mathbf{h}_3) \\end{aligned}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        lambda_r1: multiplier of ALIGN's first residual: the moment on b about e1a (unit FL; a finite number)
        lambda_r2: multiplier of ALIGN's second residual: the moment on b about the line of nodes (unit FL; a finite number)
        lambda_r3: multiplier of ALIGN's third residual: the moment on b about e3b (unit FL; a finite number)

    Outputs:
        k_tb_tb: derivative of the moment on node b by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 3 of the value, 24 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page of ALIGN was not given; these are derivatives of the angles that are held).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]
