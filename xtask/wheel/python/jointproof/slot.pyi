# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _RelativePositionValue(NamedTuple):
    x: Numbers
    y: Numbers
    z: Numbers

class _RelativePositionGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers

class _RelativePositionJacobian(Jacobian):
    x: _RelativePositionGradient
    y: _RelativePositionGradient
    z: _RelativePositionGradient

class _RelativePositionLinearized(NamedTuple):
    value: _RelativePositionValue
    jacobian: _RelativePositionJacobian

class _RelativePosition(Formula):
    """Relative position.

        x = \\mathbf{e}_{1a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a),\\quad y = \\mathbf{e}_{2a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a),\\quad z = \\mathbf{e}_{3a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)

    Outputs:
        x: relative position of b along e1a, positive in its direction (unit L; a finite number)
        y: relative position of b along e2a, positive in its direction (unit L; a finite number)
        z: relative position of b along e3a, positive in its direction (unit L; a finite number)

    Accuracy: η at most 4 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RelativePositionValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RelativePositionLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativePositionValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativePositionLinearized: ...

relative_position: Final[_RelativePosition]

class _ConstraintValue(NamedTuple):
    gy: Numbers
    gz: Numbers

class _ConstraintGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    y0: Numbers
    z0: Numbers

class _ConstraintJacobian(Jacobian):
    gy: _ConstraintGradient
    gz: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        g_y = \\mathbf{e}_{2a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - y_0,\\quad g_z = \\mathbf{e}_{3a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - z_0

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        y0: initial relative position along e2a: offset of the slot (unit L; a finite number)
        z0: initial relative position along e3a: offset of the slot (unit L; a finite number)

    Outputs:
        gy: constraint residual along e2a, zero when b is on the slot (unit L; a finite number)
        gz: constraint residual along e3a, zero when b is on the slot (unit L; a finite number)

    Accuracy: η at most 4 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, z0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _Constraint2dValue(NamedTuple):
    gy: Numbers

class _Constraint2dGradient(Gradient):
    e2a: Numbers
    xa: Numbers
    xb: Numbers
    y0: Numbers

class _Constraint2dJacobian(Jacobian):
    gy: _Constraint2dGradient

class _Constraint2dLinearized(NamedTuple):
    value: _Constraint2dValue
    jacobian: _Constraint2dJacobian

class _Constraint2d(Formula):
    """Constraint in the plane.

        g_y = \\mathbf{e}_{2a}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - y_0

    Inputs:
        e2a: second unit vector of node a's triad in the plane, in the global frame ([2], unit 1; a finite number)
        xa: position of node a in the plane, in the global frame ([2], unit L; a finite number)
        xb: position of node b in the plane, in the global frame ([2], unit L; a finite number)
        y0: initial relative position along e2a: offset of the slot (unit L; a finite number)

    Outputs:
        gy: constraint residual along e2a, zero when b is on the slot (unit L; a finite number)

    Accuracy: η at most 4 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, *, out: Any = None) -> _Constraint2dValue: ...
    def linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, *, out: Any = None) -> _Constraint2dLinearized: ...
    def exact(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Constraint2dValue: ...
    def exact_linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, y0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Constraint2dLinearized: ...

constraint_2d: Final[_Constraint2d]

class _ConstraintForceValue(NamedTuple):
    f: Numbers

class _ConstraintForceGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    f2: Numbers
    f3: Numbers

class _ConstraintForceJacobian(Jacobian):
    f: _ConstraintForceGradient

class _ConstraintForceLinearized(NamedTuple):
    value: _ConstraintForceValue
    jacobian: _ConstraintForceJacobian

class _ConstraintForce(Formula):
    """Constraint force.

        \\mathbf{f} = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a}

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        f: constraint force on node b, its opposite on node a, in the global frame ([3], unit F; a finite number)

    Accuracy: η at most 2 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ConstraintForceValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ConstraintForceLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintForceValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintForceLinearized: ...

constraint_force: Final[_ConstraintForce]

class _RelativeMotionValue(NamedTuple):
    u1: Numbers
    u1_mat: Numbers

class _RelativeMotionGradient(Gradient):
    x: Numbers
    x0: Numbers
    l1_ref: Numbers

class _RelativeMotionJacobian(Jacobian):
    u1: _RelativeMotionGradient
    u1_mat: _RelativeMotionGradient

class _RelativeMotionLinearized(NamedTuple):
    value: _RelativeMotionValue
    jacobian: _RelativeMotionJacobian

class _RelativeMotion(Formula):
    """Relative motion.

        u_1 = x - x_0,\\quad u_1^{\\mathrm{mat}} = x - l_1^{\\mathrm{ref}}

    Inputs:
        x: relative position of b along e1a, positive in its direction (unit L; a finite number)
        x0: initial relative position along e1a (unit L; a finite number)
        l1_ref: constitutive reference length along e1a (unit L; a finite number)

    Outputs:
        u1: available displacement along e1a, zero at the start (unit L; a finite number)
        u1_mat: constitutive displacement along e1a, zero at the reference length (unit L; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, x: ArrayLike, x0: ArrayLike, l1_ref: ArrayLike, *, out: Any = None) -> _RelativeMotionValue: ...
    def linearize(self, x: ArrayLike, x0: ArrayLike, l1_ref: ArrayLike, *, out: Any = None) -> _RelativeMotionLinearized: ...
    def exact(self, x: ArrayLike, x0: ArrayLike, l1_ref: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativeMotionValue: ...
    def exact_linearize(self, x: ArrayLike, x0: ArrayLike, l1_ref: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RelativeMotionLinearized: ...

relative_motion: Final[_RelativeMotion]

class _KineticForceValue(NamedTuple):
    f: Numbers

class _KineticForceGradient(Gradient):
    e1a: Numbers
    f1: Numbers

class _KineticForceJacobian(Jacobian):
    f: _KineticForceGradient

class _KineticForceLinearized(NamedTuple):
    value: _KineticForceValue
    jacobian: _KineticForceJacobian

class _KineticForce(Formula):
    """Kinetic force.

        \\mathbf{f} = f_1\\,\\mathbf{e}_{1a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)

    Outputs:
        f: kinetic force on node a, its opposite on node b, in the global frame ([3], unit F; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (printed).
    """
    def __call__(self, e1a: ArrayLike, f1: ArrayLike, *, out: Any = None) -> _KineticForceValue: ...
    def linearize(self, e1a: ArrayLike, f1: ArrayLike, *, out: Any = None) -> _KineticForceLinearized: ...
    def exact(self, e1a: ArrayLike, f1: ArrayLike, *, number: Callable[[str], Any] = ...) -> _KineticForceValue: ...
    def exact_linearize(self, e1a: ArrayLike, f1: ArrayLike, *, number: Callable[[str], Any] = ...) -> _KineticForceLinearized: ...

kinetic_force: Final[_KineticForce]

class _ContactForceValue(NamedTuple):
    fc: Numbers

class _ContactForceGradient(Gradient):
    f2: Numbers
    f3: Numbers

class _ContactForceJacobian(Jacobian):
    fc: _ContactForceGradient

class _ContactForceLinearized(NamedTuple):
    value: _ContactForceValue
    jacobian: _ContactForceJacobian

class _ContactForce(Formula):
    """Contact force.

        F_C = \\sqrt{f_2^2 + f_3^2}

    Inputs:
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fc: contact force that the connector's loads produce (unit F; a finite number ≥ 0)

    Accuracy: η at most 1 of the value, 3 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Friction (reconstructed: the root was lost).
    """
    def __call__(self, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ContactForceValue: ...
    def linearize(self, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ContactForceLinearized: ...
    def exact(self, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactForceValue: ...
    def exact_linearize(self, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactForceLinearized: ...

contact_force: Final[_ContactForce]

class _NormalForceValue(NamedTuple):
    fn: Numbers

class _NormalForceGradient(Gradient):
    fc: Numbers
    fc_int: Numbers

class _NormalForceJacobian(Jacobian):
    fn: _NormalForceGradient

class _NormalForceLinearized(NamedTuple):
    value: _NormalForceValue
    jacobian: _NormalForceJacobian

class _NormalForce(Formula):
    """Normal force.

        F_N = \\lvert F_C + F_C^{\\mathrm{int}}\\rvert

    Inputs:
        fc: contact force that the connector's loads produce (unit F; a finite number ≥ 0)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)

    Outputs:
        fn: normal force that produces friction (unit F; a finite number ≥ 0)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Friction (printed).
    """
    def __call__(self, fc: ArrayLike, fc_int: ArrayLike, *, out: Any = None) -> _NormalForceValue: ...
    def linearize(self, fc: ArrayLike, fc_int: ArrayLike, *, out: Any = None) -> _NormalForceLinearized: ...
    def exact(self, fc: ArrayLike, fc_int: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NormalForceValue: ...
    def exact_linearize(self, fc: ArrayLike, fc_int: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NormalForceLinearized: ...

normal_force: Final[_NormalForce]

class _FrictionValue(NamedTuple):
    p: Numbers
    fn: Numbers
    phi: Numbers

class _FrictionGradient(Gradient):
    f1: Numbers
    f2: Numbers
    f3: Numbers
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

        P = \\lvert f_1\\rvert,\\quad F_N = \\left\\lvert\\sqrt{f_2^2+f_3^2} + F_C^{\\mathrm{int}}\\right\\rvert,\\quad \\Phi = P - \\mu F_N

    Inputs:
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        p: magnitude of the frictional tangential tractions (unit F; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)
        phi: yield function: stick below 0, slip at 0 (unit F; a finite number)

    Accuracy: η at most 4 of the value, 4 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Friction (reconstructed: the root in F_C was lost).
    """
    def __call__(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionValue: ...
    def linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionLinearized: ...
    def exact(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionValue: ...
    def exact_linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionLinearized: ...

friction: Final[_Friction]

class _StopValue(NamedTuple):
    gap_min: Numbers
    gap_max: Numbers

class _StopGradient(Gradient):
    x: Numbers
    l1_min: Numbers
    l1_max: Numbers

class _StopJacobian(Jacobian):
    gap_min: _StopGradient
    gap_max: _StopGradient

class _StopLinearized(NamedTuple):
    value: _StopValue
    jacobian: _StopJacobian

class _Stop(Formula):
    """Stops.

        \\mathit{gap}_{\\min} = x - l_1^{\\min},\\quad \\mathit{gap}_{\\max} = l_1^{\\max} - x

    Inputs:
        x: relative position of b along e1a, positive in its direction (unit L; a finite number)
        l1_min: lower stop: least relative position along e1a (unit L; a finite number)
        l1_max: upper stop: greatest relative position along e1a (unit L; a finite number)

    Outputs:
        gap_min: distance to the lower stop, negative beyond it (unit L; a finite number)
        gap_max: distance to the upper stop, negative beyond it (unit L; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Summary (reconstructed: both signs ≤ were lost; l, which the page does not define, is taken for x).
    """
    def __call__(self, x: ArrayLike, l1_min: ArrayLike, l1_max: ArrayLike, *, out: Any = None) -> _StopValue: ...
    def linearize(self, x: ArrayLike, l1_min: ArrayLike, l1_max: ArrayLike, *, out: Any = None) -> _StopLinearized: ...
    def exact(self, x: ArrayLike, l1_min: ArrayLike, l1_max: ArrayLike, *, number: Callable[[str], Any] = ...) -> _StopValue: ...
    def exact_linearize(self, x: ArrayLike, l1_min: ArrayLike, l1_max: ArrayLike, *, number: Callable[[str], Any] = ...) -> _StopLinearized: ...

stop: Final[_Stop]

class _RowsValue(NamedTuple):
    gy_ua: Numbers
    gy_ta: Numbers
    gy_ub: Numbers
    gz_ua: Numbers
    gz_ta: Numbers
    gz_ub: Numbers

class _RowsGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers

class _RowsJacobian(Jacobian):
    gy_ua: _RowsGradient
    gy_ta: _RowsGradient
    gy_ub: _RowsGradient
    gz_ua: _RowsGradient
    gz_ta: _RowsGradient
    gz_ub: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of SLOT.

        \\begin{aligned} \\mathbf{g}_{y,ua} &= -\\mathbf{e}_{2a}, & \\mathbf{g}_{y,\\theta a} &= \\mathbf{e}_{2a}\\times(\\mathbf{x}_b-\\mathbf{x}_a), & \\mathbf{g}_{y,ub} &= \\mathbf{e}_{2a},
        \\mathbf{g}_{z,ua} &= -\\mathbf{e}_{3a}, & \\mathbf{g}_{z,\\theta a} &= \\mathbf{e}_{3a}\\times(\\mathbf{x}_b-\\mathbf{x}_a), & \\mathbf{g}_{z,ub} &= \\mathbf{e}_{3a} \\end{aligned}

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)

    Outputs:
        gy_ua: derivative of SLOT's residual along e2a by the translation of node a ([3], unit 1; a finite number)
        gy_ta: derivative of SLOT's residual along e2a by the spin of node a ([3], unit L; a finite number)
        gy_ub: derivative of SLOT's residual along e2a by the translation of node b ([3], unit 1; a finite number)
        gz_ua: derivative of SLOT's residual along e3a by the translation of node a ([3], unit 1; a finite number)
        gz_ta: derivative of SLOT's residual along e3a by the spin of node a ([3], unit L; a finite number)
        gz_ub: derivative of SLOT's residual along e3a by the translation of node b ([3], unit 1; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (ours: the page prints the residuals; these are their derivatives).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalForcesValue(NamedTuple):
    fa: Numbers
    ma: Numbers
    fb: Numbers

class _NodalForcesGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
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
    """Nodal forces of SLOT.

        \\mathbf{f}_b = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{f}_a = -\\mathbf{f}_b,\\quad \\mathbf{m}_a = \\mathbf{f}_b\\times(\\mathbf{x}_b-\\mathbf{x}_a)

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fa: force of the connector on node a, in the global frame ([3], unit F; a finite number)
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        fb: force of the connector on node b, in the global frame ([3], unit F; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Description (ours: the page prints the force on b; on a is what balances it).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _NodalForcesValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _NodalForcesLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearized: ...

nodal_forces: Final[_NodalForces]

class _GeometricStiffnessValue(NamedTuple):
    k_ua_ta: Numbers
    k_ta_ta: Numbers

class _GeometricStiffnessGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers
    f3: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_ua_ta: _GeometricStiffnessGradient
    k_ta_ta: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of SLOT.

        \\mathbf{f} = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{K}_{ua,\\theta a} = \\mathbf{f}\\times\\mathbf{I},\\quad \\mathbf{K}_{\\theta a,\\theta a} = \\mathbf{f}\\otimes\\mathbf{d} - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I}

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        k_ua_ta: derivative of the force on node a by the spin of node a, at constant multipliers ([3, 3], unit F; a finite number)
        k_ta_ta: derivative of the moment on node a by the spin of node a, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Description (ours: the page prints the residuals; it is the derivative of their nodal forces).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _SymmetricStiffnessValue(NamedTuple):
    s_ta_ta: Numbers

class _SymmetricStiffnessGradient(Gradient):
    e2a: Numbers
    e3a: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers
    f3: Numbers

class _SymmetricStiffnessJacobian(Jacobian):
    s_ta_ta: _SymmetricStiffnessGradient

class _SymmetricStiffnessLinearized(NamedTuple):
    value: _SymmetricStiffnessValue
    jacobian: _SymmetricStiffnessJacobian

class _SymmetricStiffness(Formula):
    """Symmetric part of the geometric stiffness of SLOT.

        \\mathbf{f} = f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{S}_{\\theta a,\\theta a} = \\tfrac12(\\mathbf{f}\\otimes\\mathbf{d} + \\mathbf{d}\\otimes\\mathbf{f}) - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I}

    Inputs:
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        s_ta_ta: symmetric part of the derivative of the moment on node a by the spin of node a ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Description (ours: the page prints the residuals; for programs that solve symmetric equations).
    """
    def __call__(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessValue: ...
    def linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessLinearized: ...
    def exact(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessValue: ...
    def exact_linearize(self, e2a: ArrayLike, e3a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessLinearized: ...

symmetric_stiffness: Final[_SymmetricStiffness]

class _Rows2dValue(NamedTuple):
    gy_ua: Numbers
    gy_ta: Numbers
    gy_ub: Numbers

class _Rows2dGradient(Gradient):
    e2a: Numbers
    xa: Numbers
    xb: Numbers

class _Rows2dJacobian(Jacobian):
    gy_ua: _Rows2dGradient
    gy_ta: _Rows2dGradient
    gy_ub: _Rows2dGradient

class _Rows2dLinearized(NamedTuple):
    value: _Rows2dValue
    jacobian: _Rows2dJacobian

class _Rows2d(Formula):
    """Row of SLOT in the plane.

        \\mathbf{g}_{y,ua} = -\\mathbf{e}_{2a},\\quad g_{y,\\theta a} = (\\mathbf{s}\\times\\mathbf{e}_{2a})\\cdot(\\mathbf{x}_b-\\mathbf{x}_a),\\quad \\mathbf{g}_{y,ub} = \\mathbf{e}_{2a}

    Inputs:
        e2a: second unit vector of node a's triad in the plane, in the global frame ([2], unit 1; a finite number)
        xa: position of node a in the plane, in the global frame ([2], unit L; a finite number)
        xb: position of node b in the plane, in the global frame ([2], unit L; a finite number)

    Outputs:
        gy_ua: derivative of SLOT's residual in the plane by the translation of node a ([2], unit 1; a finite number)
        gy_ta: derivative of SLOT's residual in the plane by the spin of node a, positive from the first axis to the second (unit L; a finite number)
        gy_ub: derivative of SLOT's residual in the plane by the translation of node b ([2], unit 1; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Description (ours: the page prints the residual; this is its derivative).
    """
    def __call__(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _Rows2dValue: ...
    def linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _Rows2dLinearized: ...
    def exact(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Rows2dValue: ...
    def exact_linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Rows2dLinearized: ...

rows_2d: Final[_Rows2d]

class _NodalForces2dValue(NamedTuple):
    fa: Numbers
    ma: Numbers
    fb: Numbers

class _NodalForces2dGradient(Gradient):
    e2a: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers

class _NodalForces2dJacobian(Jacobian):
    fa: _NodalForces2dGradient
    ma: _NodalForces2dGradient
    fb: _NodalForces2dGradient

class _NodalForces2dLinearized(NamedTuple):
    value: _NodalForces2dValue
    jacobian: _NodalForces2dJacobian

class _NodalForces2d(Formula):
    """Nodal forces of SLOT in the plane.

        \\mathbf{f}_b = f_2\\,\\mathbf{e}_{2a},\\quad \\mathbf{f}_a = -\\mathbf{f}_b,\\quad m_a = (\\mathbf{s}\\times\\mathbf{f}_b)\\cdot(\\mathbf{x}_b-\\mathbf{x}_a)

    Inputs:
        e2a: second unit vector of node a's triad in the plane, in the global frame ([2], unit 1; a finite number)
        xa: position of node a in the plane, in the global frame ([2], unit L; a finite number)
        xb: position of node b in the plane, in the global frame ([2], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fa: force of the connector on node a in the plane, in the global frame ([2], unit F; a finite number)
        ma: moment of the connector on node a in the plane, positive from the first axis to the second (unit FL; a finite number)
        fb: force of the connector on node b in the plane, in the global frame ([2], unit F; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Description (ours: the page prints the force on b; on a is what balances it).
    """
    def __call__(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, out: Any = None) -> _NodalForces2dValue: ...
    def linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, out: Any = None) -> _NodalForces2dLinearized: ...
    def exact(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForces2dValue: ...
    def exact_linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForces2dLinearized: ...

nodal_forces_2d: Final[_NodalForces2d]

class _GeometricStiffness2dValue(NamedTuple):
    k_ua_ta: Numbers
    k_ta_ta: Numbers

class _GeometricStiffness2dGradient(Gradient):
    e2a: Numbers
    xa: Numbers
    xb: Numbers
    f2: Numbers

class _GeometricStiffness2dJacobian(Jacobian):
    k_ua_ta: _GeometricStiffness2dGradient
    k_ta_ta: _GeometricStiffness2dGradient

class _GeometricStiffness2dLinearized(NamedTuple):
    value: _GeometricStiffness2dValue
    jacobian: _GeometricStiffness2dJacobian

class _GeometricStiffness2d(Formula):
    """Geometric stiffness of SLOT in the plane.

        \\mathbf{f} = f_2\\,\\mathbf{e}_{2a},\\quad \\mathbf{k}_{ua,\\theta a} = -\\mathbf{s}\\times\\mathbf{f},\\quad k_{\\theta a,\\theta a} = -\\mathbf{f}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a)

    Inputs:
        e2a: second unit vector of node a's triad in the plane, in the global frame ([2], unit 1; a finite number)
        xa: position of node a in the plane, in the global frame ([2], unit L; a finite number)
        xb: position of node b in the plane, in the global frame ([2], unit L; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        k_ua_ta: derivative of the force on node a by the spin of node a in the plane, at constant multipliers ([2], unit F; a finite number)
        k_ta_ta: derivative of the moment on node a by the spin of node a in the plane, at constant multipliers (unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Description (ours: the page prints the residual; it is the derivative of its nodal forces).
    """
    def __call__(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, out: Any = None) -> _GeometricStiffness2dValue: ...
    def linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, out: Any = None) -> _GeometricStiffness2dLinearized: ...
    def exact(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffness2dValue: ...
    def exact_linearize(self, e2a: ArrayLike, xa: ArrayLike, xb: ArrayLike, f2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffness2dLinearized: ...

geometric_stiffness_2d: Final[_GeometricStiffness2d]

class _FrictionResponseValue(NamedTuple):
    f1: Numbers
    slip: Numbers

class _FrictionResponseGradient(Gradient):
    u1: Numbers
    slip_before: Numbers
    k_el: Numbers
    f2: Numbers
    f3: Numbers
    fc_int: Numbers
    mu: Numbers

class _FrictionResponseJacobian(Jacobian):
    f1: _FrictionResponseGradient
    slip: _FrictionResponseGradient

class _FrictionResponseLinearized(NamedTuple):
    value: _FrictionResponseValue
    jacobian: _FrictionResponseJacobian

class _FrictionResponse(Formula):
    """Friction of SLOT after a motion.

        f_1 = \\begin{cases} f^{\\mathrm{trial}} & \\lvert f^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N \\operatorname{sign} f^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},\\quad f^{\\mathrm{trial}} = k_{\\mathrm{el}}(u_1-u_0^{\\mathrm{slip}}),\\quad u^{\\mathrm{slip}} = u_1 - \\frac{f_1}{k_{\\mathrm{el}}}

    Inputs:
        u1: available displacement along e1a, zero at the start (unit L; a finite number)
        slip_before: slip before the increment: the motion at which the tangential force would be 0 (unit L; a finite number)
        k_el: stiffness in stick (unit F/L; a finite number > 0)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)
        slip: slip after the increment: the motion at which the tangential force would be 0 (unit L; a finite number)

    Accuracy: η at most 1.5 of the value, 2 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Friction (ours: the page prints F_N and the yield function; the response is the return map's).
    """
    def __call__(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseValue: ...
    def linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseLinearized: ...
    def exact(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseValue: ...
    def exact_linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, f3: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseLinearized: ...

friction_response: Final[_FrictionResponse]

class _FrictionResponse2dValue(NamedTuple):
    f1: Numbers
    slip: Numbers

class _FrictionResponse2dGradient(Gradient):
    u1: Numbers
    slip_before: Numbers
    k_el: Numbers
    f2: Numbers
    fc_int: Numbers
    mu: Numbers

class _FrictionResponse2dJacobian(Jacobian):
    f1: _FrictionResponse2dGradient
    slip: _FrictionResponse2dGradient

class _FrictionResponse2dLinearized(NamedTuple):
    value: _FrictionResponse2dValue
    jacobian: _FrictionResponse2dJacobian

class _FrictionResponse2d(Formula):
    """Friction of SLOT in the plane after a motion.

        f_1 = \\begin{cases} f^{\\mathrm{trial}} & \\lvert f^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N \\operatorname{sign} f^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},\\quad F_N = \\left\\lvert\\lvert f_2\\rvert + F_C^{\\mathrm{int}}\\right\\rvert,\\quad f^{\\mathrm{trial}} = k_{\\mathrm{el}}(u_1-u_0^{\\mathrm{slip}}),\\quad u^{\\mathrm{slip}} = u_1 - \\frac{f_1}{k_{\\mathrm{el}}}

    Inputs:
        u1: available displacement along e1a, zero at the start (unit L; a finite number)
        slip_before: slip before the increment: the motion at which the tangential force would be 0 (unit L; a finite number)
        k_el: stiffness in stick (unit F/L; a finite number > 0)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        fc_int: self-equilibrated internal contact force, for instance from a press fit (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        f1: kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1 (unit F; a finite number)
        slip: slip after the increment: the motion at which the tangential force would be 0 (unit L; a finite number)

    Accuracy: η at most 1.5 of the value, 2 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Friction (ours: the page prints F_N and the yield function; the response is the return map's).
    """
    def __call__(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponse2dValue: ...
    def linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponse2dLinearized: ...
    def exact(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponse2dValue: ...
    def exact_linearize(self, u1: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, f2: ArrayLike, fc_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponse2dLinearized: ...

friction_response_2d: Final[_FrictionResponse2d]
