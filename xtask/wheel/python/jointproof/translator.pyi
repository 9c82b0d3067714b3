# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _ConstraintValue(NamedTuple):
    gy: Numbers
    gz: Numbers
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
    xa: Numbers
    xb: Numbers
    y0: Numbers
    z0: Numbers
    alpha0: Numbers
    beta0: Numbers
    gamma0: Numbers

class _ConstraintJacobian(Jacobian):
    gy: _ConstraintGradient
    gz: _ConstraintGradient
    ur1: _ConstraintGradient
    ur2: _ConstraintGradient
    ur3: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        \\begin{aligned} g_y &= \\mathbf{e}_{2a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - y_0, & g_z &= \\mathbf{e}_{3a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - z_0,
        u_{r1} &= \\alpha - \\alpha_0, & u_{r2} &= \\beta - \\beta_0,\\quad u_{r3} = \\gamma - \\gamma_0 \\end{aligned}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        y0: initial relative position along e2a: offset of the slot (unit L; a finite number)
        z0: initial relative position along e3a: offset of the slot (unit L; a finite number)
        alpha0: initial value of the first Cardan angle (unit 1; a finite number)
        beta0: initial value of the second Cardan angle (unit 1; a finite number)
        gamma0: initial value of the third Cardan angle (unit 1; a finite number)

    Outputs:
        gy: constraint residual along e2a, zero when b is on the slot (unit L; a finite number)
        gz: constraint residual along e3a, zero when b is on the slot (unit L; a finite number)
        ur1: constraint residual of the first Cardan angle, zero when it has its initial value (unit 1; a finite number)
        ur2: constraint residual of the second Cardan angle, zero when it has its initial value (unit 1; a finite number)
        ur3: constraint residual of the third Cardan angle, zero when it has its initial value (unit 1; a finite number)

    Accuracy: η at most 2.5 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: g_y and g_z are printed for SLOT; the page of ALIGN was not given).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, alpha0: ArrayLike, beta0: ArrayLike, gamma0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _TorqueForceValue(NamedTuple):
    m_torq: Numbers
    f_torq: Numbers

class _TorqueForceGradient(Gradient):
    m1: Numbers
    rr: Numbers

class _TorqueForceJacobian(Jacobian):
    m_torq: _TorqueForceGradient
    f_torq: _TorqueForceGradient

class _TorqueForceLinearized(NamedTuple):
    value: _TorqueForceValue
    jacobian: _TorqueForceJacobian

class _TorqueForce(Formula):
    """Contact force from torque.

        M_{\\mathrm{torq}} = \\lvert m_1\\rvert,\\quad F_{\\mathrm{torq}} = \\begin{cases} M_{\\mathrm{torq}}/R_r & R_r > 0
        0 & R_r = 0 \\end{cases}

    Inputs:
        m1: constraint moment about e1a on node b, its opposite on node a (unit FL; a finite number)
        rr: effective radius of the shaft normal to the slot; 0 omits the friction from torque (unit L; a finite number ≥ 0)

    Outputs:
        m_torq: magnitude of the torque about the slot (unit FL; a finite number ≥ 0)
        f_torq: contact force that the torque produces (unit F; a finite number ≥ 0)

    Accuracy: η at most 0.5 of the value, 0.5 of the Jacobian, inputs from 1/1e80 to 1e80 in size.
    Source: TRANSLATOR, Friction (reconstructed: the quotient by R_r was lost).
    """
    def __call__(self, m1: ArrayLike, rr: ArrayLike, *, out: Any = None) -> _TorqueForceValue: ...
    def linearize(self, m1: ArrayLike, rr: ArrayLike, *, out: Any = None) -> _TorqueForceLinearized: ...
    def exact(self, m1: ArrayLike, rr: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueForceValue: ...
    def exact_linearize(self, m1: ArrayLike, rr: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueForceLinearized: ...

torque_force: Final[_TorqueForce]

class _RadialForceValue(NamedTuple):
    fr: Numbers

class _RadialForceGradient(Gradient):
    f2: Numbers
    f3: Numbers

class _RadialForceJacobian(Jacobian):
    fr: _RadialForceGradient

class _RadialForceLinearized(NamedTuple):
    value: _RadialForceValue
    jacobian: _RadialForceJacobian

class _RadialForce(Formula):
    """Radial contact force.

        F_r = \\sqrt{f_2^2 + f_3^2}

    Inputs:
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fr: magnitude of the radial constraint force, normal to the slot (unit F; a finite number ≥ 0)

    Accuracy: η at most 1 of the value, 3 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Friction (reconstructed: the root was lost).
    """
    def __call__(self, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _RadialForceValue: ...
    def linearize(self, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _RadialForceLinearized: ...
    def exact(self, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RadialForceValue: ...
    def exact_linearize(self, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RadialForceLinearized: ...

radial_force: Final[_RadialForce]

class _BendingForceValue(NamedTuple):
    m_bend: Numbers
    f_bend: Numbers

class _BendingForceGradient(Gradient):
    m2: Numbers
    m3: Numbers
    l: Numbers

class _BendingForceJacobian(Jacobian):
    m_bend: _BendingForceGradient
    f_bend: _BendingForceGradient

class _BendingForceLinearized(NamedTuple):
    value: _BendingForceValue
    jacobian: _BendingForceJacobian

class _BendingForce(Formula):
    """Contact force from bending.

        M_{\\mathrm{bend}} = \\sqrt{m_2^2 + m_3^2},\\quad F_{\\mathrm{bend}} = \\begin{cases} 2 M_{\\mathrm{bend}}/L & L > 0
        0 & L = 0 \\end{cases}

    Inputs:
        m2: constraint moment about e2a on node b, its opposite on node a (unit FL; a finite number)
        m3: constraint moment about e3a on node b, its opposite on node a (unit FL; a finite number)
        l: characteristic overlap length along the slot; 0 omits the friction from bending (unit L; a finite number ≥ 0)

    Outputs:
        m_bend: magnitude of the bending moment (unit FL; a finite number ≥ 0)
        f_bend: contact force that bending produces (unit F; a finite number ≥ 0)

    Accuracy: η at most 1 of the value, 3 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: TRANSLATOR, Friction (reconstructed: the root and the quotient by L were lost).
    """
    def __call__(self, m2: ArrayLike, m3: ArrayLike, l: ArrayLike, *, out: Any = None) -> _BendingForceValue: ...
    def linearize(self, m2: ArrayLike, m3: ArrayLike, l: ArrayLike, *, out: Any = None) -> _BendingForceLinearized: ...
    def exact(self, m2: ArrayLike, m3: ArrayLike, l: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BendingForceValue: ...
    def exact_linearize(self, m2: ArrayLike, m3: ArrayLike, l: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BendingForceLinearized: ...

bending_force: Final[_BendingForce]

class _ContactForceValue(NamedTuple):
    fc: Numbers

class _ContactForceGradient(Gradient):
    f2: Numbers
    f3: Numbers
    m1: Numbers
    m2: Numbers
    m3: Numbers
    rr: Numbers
    l: Numbers

class _ContactForceJacobian(Jacobian):
    fc: _ContactForceGradient

class _ContactForceLinearized(NamedTuple):
    value: _ContactForceValue
    jacobian: _ContactForceJacobian

class _ContactForce(Formula):
    """Contact force.

        \\begin{aligned} F_C &= F_{\\mathrm{torq}} + F_r + F_{\\mathrm{bend}} = \\begin{cases} \\lvert m_1/R_r\\rvert & R_r > 0
        0 & R_r = 0 \\end{cases} + \\sqrt{f_2^2 + f_3^2} + \\sqrt{(\\beta m_2)^2 + (\\beta m_3)^2},
        \\beta &= \\begin{cases} 2/L & L > 0
        0 & L = 0 \\end{cases} \\end{aligned}

    Inputs:
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m1: constraint moment about e1a on node b, its opposite on node a (unit FL; a finite number)
        m2: constraint moment about e2a on node b, its opposite on node a (unit FL; a finite number)
        m3: constraint moment about e3a on node b, its opposite on node a (unit FL; a finite number)
        rr: effective radius of the shaft normal to the slot; 0 omits the friction from torque (unit L; a finite number ≥ 0)
        l: characteristic overlap length along the slot; 0 omits the friction from bending (unit L; a finite number ≥ 0)

    Outputs:
        fc: contact force that the connector's loads produce (unit F; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 3 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: TRANSLATOR, Friction (reconstructed: both roots and the quotients by R_r and L were lost).
    """
    def __call__(self, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, *, out: Any = None) -> _ContactForceValue: ...
    def linearize(self, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, *, out: Any = None) -> _ContactForceLinearized: ...
    def exact(self, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactForceValue: ...
    def exact_linearize(self, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactForceLinearized: ...

contact_force: Final[_ContactForce]

class _FrictionValue(NamedTuple):
    p: Numbers
    fn: Numbers
    phi: Numbers

class _FrictionGradient(Gradient):
    f1: Numbers
    f2: Numbers
    f3: Numbers
    m1: Numbers
    m2: Numbers
    m3: Numbers
    rr: Numbers
    l: Numbers
    fc_int: Numbers
    mu: Numbers

class _FrictionJacobian(Jacobian):
    p: _FrictionGradient
    fn: _FrictionGradient
    phi: _FrictionGradient

class _FrictionLinearized(NamedTuple):
    value: _FrictionValue
    jacobian: _FrictionJacobian

class _Friction(Formula):
    """Friction.

        P = \\lvert f_1\\rvert,\\quad F_N = \\left\\lvert F_C + F_C^{\\mathrm{int}}\\right\\rvert,\\quad \\Phi = P - \\mu F_N

    Inputs:
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m1: constraint moment about e1a on node b, its opposite on node a (unit FL; a finite number)
        m2: constraint moment about e2a on node b, its opposite on node a (unit FL; a finite number)
        m3: constraint moment about e3a on node b, its opposite on node a (unit FL; a finite number)
        rr: effective radius of the shaft normal to the slot; 0 omits the friction from torque (unit L; a finite number ≥ 0)
        l: characteristic overlap length along the slot; 0 omits the friction from bending (unit L; a finite number ≥ 0)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        p: magnitude of the frictional tangential tractions (unit F; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)
        phi: yield function: stick below 0, slip at 0 (unit F; a finite number)

    Accuracy: η at most 4 of the value, 3 of the Jacobian, inputs from 1/1e80 to 1e80 in size.
    Source: TRANSLATOR, Friction (printed).
    """
    def __call__(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionValue: ...
    def linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionLinearized: ...
    def exact(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionValue: ...
    def exact_linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionLinearized: ...

friction: Final[_Friction]

class _RowsValue(NamedTuple):
    gy_ua: Numbers
    gy_ta: Numbers
    gy_ub: Numbers
    gz_ua: Numbers
    gz_ta: Numbers
    gz_ub: Numbers
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
    xa: Numbers
    xb: Numbers

class _RowsJacobian(Jacobian):
    gy_ua: _RowsGradient
    gy_ta: _RowsGradient
    gy_ub: _RowsGradient
    gz_ua: _RowsGradient
    gz_ta: _RowsGradient
    gz_ub: _RowsGradient
    ur1_tb: _RowsGradient
    ur2_tb: _RowsGradient
    ur3_tb: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of TRANSLATOR.

        \\begin{aligned} \\mathbf{g}_{y,ua} &= -\\mathbf{e}_{2a}, & \\mathbf{g}_{y,\\theta a} &= \\mathbf{e}_{2a}\\times(\\mathbf{x}_b-\\mathbf{x}_a), & \\mathbf{g}_{y,ub} &= \\mathbf{e}_{2a},
        \\mathbf{g}_{z,ua} &= -\\mathbf{e}_{3a}, & \\mathbf{g}_{z,\\theta a} &= \\mathbf{e}_{3a}\\times(\\mathbf{x}_b-\\mathbf{x}_a), & \\mathbf{g}_{z,ub} &= \\mathbf{e}_{3a},
        \\mathbf{u}_{r1,\\theta b} &= \\mathbf{e}_{3b}\\times\\mathbf{u}_1, & \\mathbf{u}_{r2,\\theta b} &= \\frac{\\mathbf{e}_{3b}\\times\\mathbf{e}_{1a}}{\\sqrt{1-(\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})^2}}, & \\mathbf{u}_{r3,\\theta b} &= \\mathbf{u}_3\\times\\mathbf{e}_{1a} \\end{aligned}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)

    Outputs:
        gy_ua: derivative of SLOT's residual along e2a by the translation of node a ([3], unit 1; a finite number)
        gy_ta: derivative of SLOT's residual along e2a by the spin of node a ([3], unit L; a finite number)
        gy_ub: derivative of SLOT's residual along e2a by the translation of node b ([3], unit 1; a finite number)
        gz_ua: derivative of SLOT's residual along e3a by the translation of node a ([3], unit 1; a finite number)
        gz_ta: derivative of SLOT's residual along e3a by the spin of node a ([3], unit L; a finite number)
        gz_ub: derivative of SLOT's residual along e3a by the translation of node b ([3], unit 1; a finite number)
        ur1_tb: derivative of the first residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)
        ur2_tb: derivative of the second residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)
        ur3_tb: derivative of the third residual of ALIGN by the spin of node b; the derivative by the spin of node a is its negative ([3], unit 1; a finite number)

    Accuracy: η at most 4 of the value, 8 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page names SLOT and ALIGN; these are made of theirs).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalForcesValue(NamedTuple):
    fa: Numbers
    ma: Numbers
    fb: Numbers
    mb: Numbers

class _NodalForcesGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers
    f3: Numbers
    lambda_r1: Numbers
    lambda_r2: Numbers
    lambda_r3: Numbers

class _NodalForcesJacobian(Jacobian):
    fa: _NodalForcesGradient
    ma: _NodalForcesGradient
    fb: _NodalForcesGradient
    mb: _NodalForcesGradient

class _NodalForcesLinearized(NamedTuple):
    value: _NodalForcesValue
    jacobian: _NodalForcesJacobian

class _NodalForces(Formula):
    """Nodal forces of TRANSLATOR.

        \\mathbf{f}_b = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{f}_a = -\\mathbf{f}_b,\\quad \\mathbf{m}_b = \\lambda_{r1}\\,\\mathbf{u}_{r1,\\theta b} + \\lambda_{r2}\\,\\mathbf{u}_{r2,\\theta b} + \\lambda_{r3}\\,\\mathbf{u}_{r3,\\theta b},\\quad \\mathbf{m}_a = \\mathbf{f}_b\\times(\\mathbf{x}_b-\\mathbf{x}_a) - \\mathbf{m}_b

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        lambda_r1: multiplier of ALIGN's first residual: the moment on b about e1a (unit FL; a finite number)
        lambda_r2: multiplier of ALIGN's second residual: the moment on b about the line of nodes (unit FL; a finite number)
        lambda_r3: multiplier of ALIGN's third residual: the moment on b about e3b (unit FL; a finite number)

    Outputs:
        fa: force of the connector on node a, in the global frame ([3], unit F; a finite number)
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        fb: force of the connector on node b, in the global frame ([3], unit F; a finite number)
        mb: moment of the connector on node b, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 6 of the value, 48 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page names SLOT and ALIGN; these are made of theirs).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _NodalForcesValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _NodalForcesLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearized: ...

nodal_forces: Final[_NodalForces]

class _GeometricStiffnessValue(NamedTuple):
    k_ua_ta: Numbers
    k_ta_ta: Numbers
    k_tb_tb: Numbers

class _GeometricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e1b: Numbers
    e2b: Numbers
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers
    f3: Numbers
    lambda_r1: Numbers
    lambda_r2: Numbers
    lambda_r3: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_ua_ta: _GeometricStiffnessGradient
    k_ta_ta: _GeometricStiffnessGradient
    k_tb_tb: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of TRANSLATOR.

        \\mathbf{f} = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{K}_{ua,\\theta a} = \\mathbf{f}\\times\\mathbf{I},\\quad \\mathbf{K}_{\\theta a,\\theta a} = \\mathbf{f}\\otimes\\mathbf{d} - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I} + \\mathbf{K}_{\\theta b,\\theta b} + \\mathbf{m}_b\\times\\mathbf{I}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e1b: first unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e2b: second unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        lambda_r1: multiplier of ALIGN's first residual: the moment on b about e1a (unit FL; a finite number)
        lambda_r2: multiplier of ALIGN's second residual: the moment on b about the line of nodes (unit FL; a finite number)
        lambda_r3: multiplier of ALIGN's third residual: the moment on b about e3b (unit FL; a finite number)

    Outputs:
        k_ua_ta: derivative of the force on node a by the spin of node a, at constant multipliers ([3, 3], unit F; a finite number)
        k_ta_ta: derivative of the moment on node a by the spin of node a, at constant multipliers ([3, 3], unit FL; a finite number)
        k_tb_tb: derivative of the moment on node b by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 3 of the value, 24 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: TRANSLATOR, Description (ours: the page names SLOT and ALIGN; these are made of theirs).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e1b: ArrayLike, e2b: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_r1: ArrayLike, lambda_r2: ArrayLike, lambda_r3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _FrictionResponseValue(NamedTuple):
    f1: Numbers
    slip: Numbers

class _FrictionResponseGradient(Gradient):
    u1: Numbers
    slip_before: Numbers
    k_el: Numbers
    f2: Numbers
    f3: Numbers
    m1: Numbers
    m2: Numbers
    m3: Numbers
    rr: Numbers
    l: Numbers
    fc_int: Numbers
    mu: Numbers

class _FrictionResponseJacobian(Jacobian):
    f1: _FrictionResponseGradient
    slip: _FrictionResponseGradient

class _FrictionResponseLinearized(NamedTuple):
    value: _FrictionResponseValue
    jacobian: _FrictionResponseJacobian

class _FrictionResponse(Formula):
    """Friction of TRANSLATOR after a motion.

        f_1 = \\begin{cases} f^{\\mathrm{trial}} & \\lvert f^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N \\operatorname{sign} f^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},\\quad f^{\\mathrm{trial}} = k_{\\mathrm{el}}(u_1-u_0^{\\mathrm{slip}}),\\quad u^{\\mathrm{slip}} = u_1 - \\frac{f_1}{k_{\\mathrm{el}}}

    Inputs:
        u1: available displacement along e1a, zero at the start (unit L; a finite number)
        slip_before: slip before the increment: the motion at which the tangential force would be 0 (unit L; a finite number)
        k_el: stiffness in stick (unit F/L; a finite number > 0)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m1: constraint moment about e1a on node b, its opposite on node a (unit FL; a finite number)
        m2: constraint moment about e2a on node b, its opposite on node a (unit FL; a finite number)
        m3: constraint moment about e3a on node b, its opposite on node a (unit FL; a finite number)
        rr: effective radius of the shaft normal to the slot; 0 omits the friction from torque (unit L; a finite number ≥ 0)
        l: characteristic overlap length along the slot; 0 omits the friction from bending (unit L; a finite number ≥ 0)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)
        slip: slip after the increment: the motion at which the tangential force would be 0 (unit L; a finite number)

    Accuracy: η at most 2 of the value, 3 of the Jacobian, inputs from 1/1e80 to 1e80 in size.
    Source: TRANSLATOR, Friction (ours: the page prints F_N and the yield function; the response is the return map's).
    """
    def __call__(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseValue: ...
    def linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseLinearized: ...
    def exact(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseValue: ...
    def exact_linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, m1: ArrayLike, m2: ArrayLike, m3: ArrayLike, rr: ArrayLike, l: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseLinearized: ...

friction_response: Final[_FrictionResponse]
