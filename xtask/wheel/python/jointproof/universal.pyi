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
    e3b: Numbers
    c0: Numbers

class _ConstraintJacobian(Jacobian):
    g: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        g = \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b} - c_0

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        c0: initial value of e1a·e3b, the sine of the second Cardan angle (unit 1; a finite number)

    Outputs:
        g: residual of UNIVERSAL, zero when e1a and e3b have their initial angle (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of UNIVERSAL was not given; the arms of the cross keep their initial angle).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, c0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, c0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, c0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, c0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _AnglesValue(NamedTuple):
    alpha: Numbers
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
    gamma: _AnglesGradient

class _AnglesLinearized(NamedTuple):
    value: _AnglesValue
    jacobian: _AnglesJacobian

class _Angles(Formula):
    """Angles.

        \\alpha = -\\operatorname{atan2}(\\mathbf{e}_{2a}\\cdot\\mathbf{e}_{3b},\\ \\mathbf{e}_{3a}\\cdot\\mathbf{e}_{3b}),\\quad \\gamma = -\\operatorname{atan2}(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{2b},\\ \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{1b})

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        alpha: first Cardan angle of b's triad relative to a's, about e1a, from −π to below π (unit 1; a finite number)
        gamma: third Cardan angle of b's triad relative to a's, about e3b, from −π to below π (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 8 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Summary (ours: the page of UNIVERSAL was not given; these are the first and the third Cardan angle).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _AnglesValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _AnglesLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AnglesValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AnglesLinearized: ...

angles: Final[_Angles]

class _RelativeMotionValue(NamedTuple):
    ur1: Numbers
    ur3: Numbers
    ur1_mat: Numbers
    ur3_mat: Numbers

class _RelativeMotionGradient(Gradient):
    alpha: Numbers
    gamma: Numbers
    alpha0: Numbers
    gamma0: Numbers
    theta1_ref: Numbers
    theta3_ref: Numbers

class _RelativeMotionJacobian(Jacobian):
    ur1: _RelativeMotionGradient
    ur3: _RelativeMotionGradient
    ur1_mat: _RelativeMotionGradient
    ur3_mat: _RelativeMotionGradient

class _RelativeMotionLinearized(NamedTuple):
    value: _RelativeMotionValue
    jacobian: _RelativeMotionJacobian

class _RelativeMotion(Formula):
    """Relative motion.

        u_{r1} = \\alpha-\\alpha_0,\\quad u_{r3} = \\gamma-\\gamma_0,\\quad u_{r1}^{\\mathrm{mat}} = \\alpha-\\theta_1^{\\mathrm{ref}},\\quad u_{r3}^{\\mathrm{mat}} = \\gamma-\\theta_3^{\\mathrm{ref}}

    Inputs:
        alpha: first Cardan angle of b's triad relative to a's, about e1a, from −π to below π (unit 1; a finite number)
        gamma: third Cardan angle of b's triad relative to a's, about e3b, from −π to below π (unit 1; a finite number)
        alpha0: initial value of the first Cardan angle (unit 1; a finite number)
        gamma0: initial value of the third Cardan angle (unit 1; a finite number)
        theta1_ref: constitutive reference angle about e1a (unit 1; a finite number)
        theta3_ref: constitutive reference angle about e3b (unit 1; a finite number)

    Outputs:
        ur1: available rotation about e1a, zero at the start (unit 1; a finite number)
        ur3: available rotation about e3b, zero at the start (unit 1; a finite number)
        ur1_mat: constitutive rotation about e1a, zero at the reference angle (unit 1; a finite number)
        ur3_mat: constitutive rotation about e3b, zero at the reference angle (unit 1; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Summary (ours: the page names the components and the reference angles, and prints no equation).
    """
    def __call__(self, alpha: ArrayLike, gamma: ArrayLike, alpha0: ArrayLike, gamma0: ArrayLike, theta1_ref: ArrayLike, theta3_ref: ArrayLike, *, out: Any = None) -> _RelativeMotionValue: ...
    def linearize(self, alpha: ArrayLike, gamma: ArrayLike, alpha0: ArrayLike, gamma0: ArrayLike, theta1_ref: ArrayLike, theta3_ref: ArrayLike, *, out: Any = None) -> _RelativeMotionLinearized: ...
    def exact(self, alpha: ArrayLike, gamma: ArrayLike, alpha0: ArrayLike, gamma0: ArrayLike, theta1_ref: ArrayLike, theta3_ref: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativeMotionValue: ...
    def exact_linearize(self, alpha: ArrayLike, gamma: ArrayLike, alpha0: ArrayLike, gamma0: ArrayLike, theta1_ref: ArrayLike, theta3_ref: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativeMotionLinearized: ...

relative_motion: Final[_RelativeMotion]

class _ConstraintMomentValue(NamedTuple):
    m: Numbers

class _ConstraintMomentGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    m2: Numbers

class _ConstraintMomentJacobian(Jacobian):
    m: _ConstraintMomentGradient

class _ConstraintMomentLinearized(NamedTuple):
    value: _ConstraintMomentValue
    jacobian: _ConstraintMomentJacobian

class _ConstraintMoment(Formula):
    """Constraint moment.

        \\mathbf{m} = m_2\\,(\\cos\\alpha\\,\\mathbf{e}_{2a} + \\sin\\alpha\\,\\mathbf{e}_{3a})

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)

    Outputs:
        m: constraint moment on node b, its opposite on node a, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 4 of the value, 16 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Friction (ours: the page prints the axis e1a × e3b; the sign follows the second Cardan angle).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, m2: ArrayLike, *, out: Any = None) -> _ConstraintMomentValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, m2: ArrayLike, *, out: Any = None) -> _ConstraintMomentLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, m2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintMomentValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, m2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintMomentLinearized: ...

constraint_moment: Final[_ConstraintMoment]

class _KineticMomentValue(NamedTuple):
    m: Numbers

class _KineticMomentGradient(Gradient):
    e1a: Numbers
    e3b: Numbers
    m1: Numbers
    m3: Numbers

class _KineticMomentJacobian(Jacobian):
    m: _KineticMomentGradient

class _KineticMomentLinearized(NamedTuple):
    value: _KineticMomentValue
    jacobian: _KineticMomentJacobian

class _KineticMoment(Formula):
    """Kinetic moment.

        \\mathbf{m} = m_1\\,\\mathbf{e}_{1a} + m_3\\,\\mathbf{e}_{3b}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        m1: kinetic moment about e1a, which acts on node a, and its opposite on node b: conjugate to ur1 (unit FL; a finite number)
        m3: kinetic moment about e3b, which acts on node a, and its opposite on node b: conjugate to ur3 (unit FL; a finite number)

    Outputs:
        m: kinetic moment on node a, its opposite on node b, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Summary (ours: the page names m1, m3 and the arms e1a, e3b, and prints no vector).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, m1: ArrayLike, m3: ArrayLike, *, out: Any = None) -> _KineticMomentValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, m1: ArrayLike, m3: ArrayLike, *, out: Any = None) -> _KineticMomentLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, m1: ArrayLike, m3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _KineticMomentValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, m1: ArrayLike, m3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _KineticMomentLinearized: ...

kinetic_moment: Final[_KineticMoment]

class _RowsValue(NamedTuple):
    g_rot_ta: Numbers
    g_rot_tb: Numbers

class _RowsGradient(Gradient):
    e1a: Numbers
    e3b: Numbers

class _RowsJacobian(Jacobian):
    g_rot_ta: _RowsGradient
    g_rot_tb: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Row of UNIVERSAL.

        \\mathbf{g}_{\\mathrm{rot},\\theta a} = \\mathbf{e}_{1a}\\times\\mathbf{e}_{3b},\\quad \\mathbf{g}_{\\mathrm{rot},\\theta b} = \\mathbf{e}_{3b}\\times\\mathbf{e}_{1a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        g_rot_ta: derivative of the residual of UNIVERSAL by the spin of node a ([3], unit 1; a finite number)
        g_rot_tb: derivative of the residual of UNIVERSAL by the spin of node b ([3], unit 1; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of UNIVERSAL was not given; this is the derivative of its residual).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalMomentsValue(NamedTuple):
    ma: Numbers
    mb: Numbers

class _NodalMomentsGradient(Gradient):
    e1a: Numbers
    e3b: Numbers
    lambda_rot: Numbers

class _NodalMomentsJacobian(Jacobian):
    ma: _NodalMomentsGradient
    mb: _NodalMomentsGradient

class _NodalMomentsLinearized(NamedTuple):
    value: _NodalMomentsValue
    jacobian: _NodalMomentsJacobian

class _NodalMoments(Formula):
    """Nodal moments of UNIVERSAL.

        \\mathbf{m}_a = \\lambda_{\\mathrm{rot}}\\,\\mathbf{e}_{1a}\\times\\mathbf{e}_{3b},\\quad \\mathbf{m}_b = -\\mathbf{m}_a

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        mb: moment of the connector on node b, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of UNIVERSAL was not given; these do the work of its multiplier).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _NodalMomentsValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _NodalMomentsLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalMomentsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalMomentsLinearized: ...

nodal_moments: Final[_NodalMoments]

class _GeometricStiffnessValue(NamedTuple):
    k_ta_ta: Numbers
    k_ta_tb: Numbers
    k_tb_tb: Numbers

class _GeometricStiffnessGradient(Gradient):
    e1a: Numbers
    e3b: Numbers
    lambda_rot: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_ta_ta: _GeometricStiffnessGradient
    k_ta_tb: _GeometricStiffnessGradient
    k_tb_tb: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of UNIVERSAL.

        \\mathbf{K}_{\\theta a,\\theta a} = \\lambda_{\\mathrm{rot}}(\\mathbf{e}_{1a}\\otimes\\mathbf{e}_{3b} - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{K}_{\\theta b,\\theta b} = \\lambda_{\\mathrm{rot}}(\\mathbf{e}_{3b}\\otimes\\mathbf{e}_{1a} - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{K}_{\\theta a,\\theta b} = -\\mathbf{K}_{\\theta b,\\theta b}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        k_ta_ta: derivative of the moment on node a by the spin of node a, at constant multipliers ([3, 3], unit FL; a finite number)
        k_ta_tb: derivative of the moment on node a by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)
        k_tb_tb: derivative of the moment on node b by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of UNIVERSAL was not given; it is the derivative of its nodal moments).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _SymmetricStiffnessValue(NamedTuple):
    s_ta_ta: Numbers
    s_tb_tb: Numbers

class _SymmetricStiffnessGradient(Gradient):
    e1a: Numbers
    e3b: Numbers
    lambda_rot: Numbers

class _SymmetricStiffnessJacobian(Jacobian):
    s_ta_ta: _SymmetricStiffnessGradient
    s_tb_tb: _SymmetricStiffnessGradient

class _SymmetricStiffnessLinearized(NamedTuple):
    value: _SymmetricStiffnessValue
    jacobian: _SymmetricStiffnessJacobian

class _SymmetricStiffness(Formula):
    """Symmetric part of the geometric stiffness of UNIVERSAL.

        \\mathbf{S}_{\\theta a,\\theta a} = \\lambda_{\\mathrm{rot}}(\\tfrac12(\\mathbf{e}_{1a}\\otimes\\mathbf{e}_{3b} + \\mathbf{e}_{3b}\\otimes\\mathbf{e}_{1a}) - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{S}_{\\theta b,\\theta b} = \\mathbf{S}_{\\theta a,\\theta a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        s_ta_ta: symmetric part of the derivative of the moment on node a by the spin of node a ([3, 3], unit FL; a finite number)
        s_tb_tb: symmetric part of the derivative of the moment on node b by the spin of node b ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page of UNIVERSAL was not given; for programs that solve symmetric equations).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessLinearized: ...

symmetric_stiffness: Final[_SymmetricStiffness]
