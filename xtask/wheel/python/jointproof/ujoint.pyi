# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _ConstraintValue(NamedTuple):
    g: Numbers
    g_rot: Numbers

class _ConstraintGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    d0: Numbers
    c0: Numbers

class _ConstraintJacobian(Jacobian):
    g: _ConstraintGradient
    g_rot: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        g_i = \\mathbf{e}_{ia}\\cdot(\\mathbf{x}_b-\\mathbf{x}_a) - d_{0i}\\ (i = 1, 2, 3),\\quad g_{\\mathrm{rot}} = \\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b} - c_0

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        d0: initial position of b relative to a, as components in a's triad ([3], unit L; a finite number)
        c0: initial value of e1a·e3b, the sine of the second Cardan angle (unit 1; a finite number)

    Outputs:
        g: residual of JOIN as components in a's triad, zero when b is in its place ([3], unit L; a finite number)
        g_rot: residual of UNIVERSAL in UJOINT, zero when e1a and e3b have their initial angle (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the pages of JOIN and UNIVERSAL were not given).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, c0: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, c0: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, c0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, d0: ArrayLike, c0: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _ReactionValue(NamedTuple):
    fr: Numbers

class _ReactionGradient(Gradient):
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _ReactionJacobian(Jacobian):
    fr: _ReactionGradient

class _ReactionLinearized(NamedTuple):
    value: _ReactionValue
    jacobian: _ReactionJacobian

class _Reaction(Formula):
    """Reaction force.

        F_r = \\sqrt{f_1^2 + f_2^2 + f_3^2}

    Inputs:
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        fr: reaction force: magnitude of the force that JOIN transmits (unit F; a finite number ≥ 0)

    Accuracy: η at most 1.5 of the value, 3.5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Friction (reconstructed: the root was lost).
    """
    def __call__(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ReactionValue: ...
    def linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _ReactionLinearized: ...
    def exact(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReactionValue: ...
    def exact_linearize(self, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReactionLinearized: ...

reaction: Final[_Reaction]

class _CrossDirectionValue(NamedTuple):
    e_cross: Numbers

class _CrossDirectionGradient(Gradient):
    e1a: Numbers
    e3b: Numbers

class _CrossDirectionJacobian(Jacobian):
    e_cross: _CrossDirectionGradient

class _CrossDirectionLinearized(NamedTuple):
    value: _CrossDirectionValue
    jacobian: _CrossDirectionJacobian

class _CrossDirection(Formula):
    """Direction across the cross.

        \\mathbf{e}_{\\mathrm{cross}} = \\mathbf{e}_{1a}\\times\\mathbf{e}_{3b}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)

    Outputs:
        e_cross: normal of the cross plane, e1a × e3b, in the global frame ([3], unit 1; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Friction (printed).
    """
    def __call__(self, e1a: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _CrossDirectionValue: ...
    def linearize(self, e1a: ArrayLike, e3b: ArrayLike, *, out: Any = None) -> _CrossDirectionLinearized: ...
    def exact(self, e1a: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _CrossDirectionValue: ...
    def exact_linearize(self, e1a: ArrayLike, e3b: ArrayLike, *, number: Callable[[str], Any] = ...) -> _CrossDirectionLinearized: ...

cross_direction: Final[_CrossDirection]

class _TwistFactorsValue(NamedTuple):
    alpha_twist: Numbers
    beta_twist: Numbers

class _TwistFactorsGradient(Gradient):
    la: Numbers
    rp: Numbers

class _TwistFactorsJacobian(Jacobian):
    alpha_twist: _TwistFactorsGradient
    beta_twist: _TwistFactorsGradient

class _TwistFactorsLinearized(NamedTuple):
    value: _TwistFactorsValue
    jacobian: _TwistFactorsJacobian

class _TwistFactors(Formula):
    """Shares of the twisting moment.

        \\alpha_{\\mathrm{twist}} = \\frac{1}{8+6\\varphi},\\quad \\beta_{\\mathrm{twist}} = \\tfrac14 + \\alpha_{\\mathrm{twist}},\\quad \\varphi = \\frac{44}{5\\lambda^2},\\quad \\lambda = \\frac{L_a}{R_p}

    Inputs:
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)

    Outputs:
        alpha_twist: share of the twisting moment that acts as bending moment on a hinge (unit 1; a finite number ≥ 0)
        beta_twist: transverse force on a hinge, divided by the twisting moment over the arm length (unit 1; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Friction (ours: the page prints the limits and names the beam theories; the curve between is ours).
    """
    def __call__(self, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _TwistFactorsValue: ...
    def linearize(self, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _TwistFactorsLinearized: ...
    def exact(self, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TwistFactorsValue: ...
    def exact_linearize(self, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TwistFactorsLinearized: ...

twist_factors: Final[_TwistFactors]

class _AxialFactorsValue(NamedTuple):
    alpha_axial: Numbers
    beta_axial: Numbers

class _AxialFactorsGradient(Gradient):
    la: Numbers
    rp: Numbers

class _AxialFactorsJacobian(Jacobian):
    alpha_axial: _AxialFactorsGradient
    beta_axial: _AxialFactorsGradient

class _AxialFactorsLinearized(NamedTuple):
    value: _AxialFactorsValue
    jacobian: _AxialFactorsJacobian

class _AxialFactors(Formula):
    """Shares of an axial force.

        \\alpha_{\\mathrm{axial}} = \\frac{\\lambda^2+3}{2(\\lambda^2+6)},\\quad \\beta_{\\mathrm{axial}} = \\frac{3}{2(\\lambda^2+6)},\\quad \\lambda = \\frac{L_a}{R_p}

    Inputs:
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)

    Outputs:
        alpha_axial: share of a force along an axis of the cross for each hinge on that axis (unit 1; a finite number ≥ 0)
        beta_axial: share of a force along an axis of the cross for each hinge on the other axis (unit 1; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (ours: the page uses both factors and defines neither).
    """
    def __call__(self, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _AxialFactorsValue: ...
    def linearize(self, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _AxialFactorsLinearized: ...
    def exact(self, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AxialFactorsValue: ...
    def exact_linearize(self, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _AxialFactorsLinearized: ...

axial_factors: Final[_AxialFactors]

class _DecompositionValue(NamedTuple):
    f_axial1: Numbers
    f_axial3: Numbers
    f_bend: Numbers

class _DecompositionGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _DecompositionJacobian(Jacobian):
    f_axial1: _DecompositionGradient
    f_axial3: _DecompositionGradient
    f_bend: _DecompositionGradient

class _DecompositionLinearized(NamedTuple):
    value: _DecompositionValue
    jacobian: _DecompositionJacobian

class _Decomposition(Formula):
    """Force in the axes of the cross.

        F_{\\mathrm{axial1}} = \\mathbf{F}\\cdot\\mathbf{e}_{1a},\\quad F_{\\mathrm{axial3}} = \\mathbf{F}\\cdot\\mathbf{e}_{3b},\\quad F_{\\mathrm{bend}} = \\mathbf{F}\\cdot\\mathbf{e}_{\\mathrm{cross}},\\quad \\mathbf{F} = f_1\\mathbf{e}_{1a} + f_2\\mathbf{e}_{2a} + f_3\\mathbf{e}_{3a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)

    Outputs:
        f_axial1: force along e1a at the centre of the cross (unit F; a finite number)
        f_axial3: force along e3b at the centre of the cross (unit F; a finite number)
        f_bend: force along e1a × e3b at the centre of the cross, which bends its arms (unit F; a finite number)

    Accuracy: η at most 2 of the value, 2 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Friction (printed).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _DecompositionValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, out: Any = None) -> _DecompositionLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DecompositionValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DecompositionLinearized: ...

decomposition: Final[_Decomposition]

class _HingeTwistValue(NamedTuple):
    m_twist_hinge: Numbers
    f_twist_hinge: Numbers

class _HingeTwistGradient(Gradient):
    m2: Numbers
    la: Numbers
    rp: Numbers

class _HingeTwistJacobian(Jacobian):
    m_twist_hinge: _HingeTwistGradient
    f_twist_hinge: _HingeTwistGradient

class _HingeTwistLinearized(NamedTuple):
    value: _HingeTwistValue
    jacobian: _HingeTwistJacobian

class _HingeTwist(Formula):
    """Hinge loads of the twisting moment.

        M_{\\mathrm{twist}}^{\\mathrm{hinge}} = \\alpha_{\\mathrm{twist}}\\lvert m_2\\rvert,\\quad F_{\\mathrm{twist}}^{\\mathrm{hinge}} = \\beta_{\\mathrm{twist}}\\frac{\\lvert m_2\\rvert}{L_a}

    Inputs:
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)

    Outputs:
        m_twist_hinge: bending moment on each hinge from the twisting moment (unit FL; a finite number ≥ 0)
        f_twist_hinge: transverse force on each hinge from the twisting moment (unit F; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 3 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (reconstructed: the quotient by L_a was lost).
    """
    def __call__(self, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeTwistValue: ...
    def linearize(self, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeTwistLinearized: ...
    def exact(self, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeTwistValue: ...
    def exact_linearize(self, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeTwistLinearized: ...

hinge_twist: Final[_HingeTwist]

class _HingeAxialValue(NamedTuple):
    f_axial_hinge1: Numbers
    f_axial_hinge3: Numbers
    f_transv_hinge1: Numbers
    f_transv_hinge3: Numbers

class _HingeAxialGradient(Gradient):
    f_axial1: Numbers
    f_axial3: Numbers
    la: Numbers
    rp: Numbers

class _HingeAxialJacobian(Jacobian):
    f_axial_hinge1: _HingeAxialGradient
    f_axial_hinge3: _HingeAxialGradient
    f_transv_hinge1: _HingeAxialGradient
    f_transv_hinge3: _HingeAxialGradient

class _HingeAxialLinearized(NamedTuple):
    value: _HingeAxialValue
    jacobian: _HingeAxialJacobian

class _HingeAxial(Formula):
    """Hinge loads of the axial forces.

        F_{\\mathrm{axial}k}^{\\mathrm{hinge}} = \\alpha_{\\mathrm{axial}}\\lvert F_{\\mathrm{axial}k}\\rvert\\ (k = 1, 3),\\quad F_{\\mathrm{transv1}}^{\\mathrm{hinge}} = \\beta_{\\mathrm{axial}}\\lvert F_{\\mathrm{axial3}}\\rvert,\\quad F_{\\mathrm{transv3}}^{\\mathrm{hinge}} = \\beta_{\\mathrm{axial}}\\lvert F_{\\mathrm{axial1}}\\rvert

    Inputs:
        f_axial1: force along e1a at the centre of the cross (unit F; a finite number)
        f_axial3: force along e3b at the centre of the cross (unit F; a finite number)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)

    Outputs:
        f_axial_hinge1: axial force on each hinge along e1a (unit F; a finite number ≥ 0)
        f_axial_hinge3: axial force on each hinge along e3b (unit F; a finite number ≥ 0)
        f_transv_hinge1: transverse force on each hinge along e1a from the force along e3b (unit F; a finite number ≥ 0)
        f_transv_hinge3: transverse force on each hinge along e3b from the force along e1a (unit F; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 3 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (ours: printed without bars, so that a load reversed would relieve the hinge).
    """
    def __call__(self, f_axial1: ArrayLike, f_axial3: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeAxialValue: ...
    def linearize(self, f_axial1: ArrayLike, f_axial3: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeAxialLinearized: ...
    def exact(self, f_axial1: ArrayLike, f_axial3: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeAxialValue: ...
    def exact_linearize(self, f_axial1: ArrayLike, f_axial3: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeAxialLinearized: ...

hinge_axial: Final[_HingeAxial]

class _HingeTransverseValue(NamedTuple):
    f_total_hinge1: Numbers
    f_total_hinge3: Numbers

class _HingeTransverseGradient(Gradient):
    f_axial1: Numbers
    f_axial3: Numbers
    f_bend: Numbers
    m2: Numbers
    la: Numbers
    rp: Numbers

class _HingeTransverseJacobian(Jacobian):
    f_total_hinge1: _HingeTransverseGradient
    f_total_hinge3: _HingeTransverseGradient

class _HingeTransverseLinearized(NamedTuple):
    value: _HingeTransverseValue
    jacobian: _HingeTransverseJacobian

class _HingeTransverse(Formula):
    """Transverse force on a hinge.

        F_{\\mathrm{total}k}^{\\mathrm{hinge}} = \\sqrt{\\left(\\tfrac14 F_{\\mathrm{bend}}\\right)^2 + \\left(F_{\\mathrm{twist}}^{\\mathrm{hinge}}\\right)^2 + \\left(F_{\\mathrm{transv}k}^{\\mathrm{hinge}}\\right)^2}\\quad (k = 1, 3)

    Inputs:
        f_axial1: force along e1a at the centre of the cross (unit F; a finite number)
        f_axial3: force along e3b at the centre of the cross (unit F; a finite number)
        f_bend: force along e1a × e3b at the centre of the cross, which bends its arms (unit F; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)

    Outputs:
        f_total_hinge1: total transverse force on each hinge along e1a (unit F; a finite number ≥ 0)
        f_total_hinge3: total transverse force on each hinge along e3b (unit F; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (reconstructed: the root and the quotient by 4 were lost).
    """
    def __call__(self, f_axial1: ArrayLike, f_axial3: ArrayLike, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeTransverseValue: ...
    def linearize(self, f_axial1: ArrayLike, f_axial3: ArrayLike, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, out: Any = None) -> _HingeTransverseLinearized: ...
    def exact(self, f_axial1: ArrayLike, f_axial3: ArrayLike, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeTransverseValue: ...
    def exact_linearize(self, f_axial1: ArrayLike, f_axial3: ArrayLike, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeTransverseLinearized: ...

hinge_transverse: Final[_HingeTransverse]

class _HingeBendingValue(NamedTuple):
    m_bend_hinge: Numbers
    m_total_hinge: Numbers
    f_total_bend: Numbers

class _HingeBendingGradient(Gradient):
    f_bend: Numbers
    m2: Numbers
    la: Numbers
    rp: Numbers
    ls: Numbers

class _HingeBendingJacobian(Jacobian):
    m_bend_hinge: _HingeBendingGradient
    m_total_hinge: _HingeBendingGradient
    f_total_bend: _HingeBendingGradient

class _HingeBendingLinearized(NamedTuple):
    value: _HingeBendingValue
    jacobian: _HingeBendingJacobian

class _HingeBending(Formula):
    """Bending moment on a hinge.

        M_{\\mathrm{bend}}^{\\mathrm{hinge}} = \\tfrac18\\lvert F_{\\mathrm{bend}}\\rvert L_a,\\quad M_{\\mathrm{total}}^{\\mathrm{hinge}} = \\sqrt{\\left(M_{\\mathrm{bend}}^{\\mathrm{hinge}}\\right)^2 + \\left(M_{\\mathrm{twist}}^{\\mathrm{hinge}}\\right)^2},\\quad F_{\\mathrm{total}}^{\\mathrm{bend}} = \\begin{cases} 2 M_{\\mathrm{total}}^{\\mathrm{hinge}}/L_s & L_s > 0
        0 & L_s = 0 \\end{cases}

    Inputs:
        f_bend: force along e1a × e3b at the centre of the cross, which bends its arms (unit F; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)
        ls: length over which pin and sleeve overlap; 0 omits the bending moments (unit L; a finite number ≥ 0)

    Outputs:
        m_bend_hinge: bending moment on each hinge from the force normal to the cross (unit FL; a finite number ≥ 0)
        m_total_hinge: total bending moment on each hinge (unit FL; a finite number ≥ 0)
        f_total_bend: contact force in a sleeve from the total bending moment (unit F; a finite number ≥ 0)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (reconstructed: the root and the quotients 1/8 and by L_s were lost; the bars are ours).
    """
    def __call__(self, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, ls: ArrayLike, *, out: Any = None) -> _HingeBendingValue: ...
    def linearize(self, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, ls: ArrayLike, *, out: Any = None) -> _HingeBendingLinearized: ...
    def exact(self, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, ls: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeBendingValue: ...
    def exact_linearize(self, f_bend: ArrayLike, m2: ArrayLike, la: ArrayLike, rp: ArrayLike, ls: ArrayLike, *, number: Callable[[str], Any] = ...) -> _HingeBendingLinearized: ...

hinge_bending: Final[_HingeBending]

class _ContactMomentsValue(NamedTuple):
    mc1: Numbers
    mc3: Numbers

class _ContactMomentsGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    m2: Numbers
    rp: Numbers
    la: Numbers
    ra: Numbers
    ls: Numbers

class _ContactMomentsJacobian(Jacobian):
    mc1: _ContactMomentsGradient
    mc3: _ContactMomentsGradient

class _ContactMomentsLinearized(NamedTuple):
    value: _ContactMomentsValue
    jacobian: _ContactMomentsJacobian

class _ContactMoments(Formula):
    """Contact moments.

        M_{Ck} = F_{\\mathrm{axial}k}^{\\mathrm{hinge}} R_a + \\left(F_{\\mathrm{total}k}^{\\mathrm{hinge}} + F_{\\mathrm{total}}^{\\mathrm{bend}}\\right) R_p\\quad (k = 1, 3)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        ra: effective friction arm of the axial force of a pin; 0 omits this force (unit L; a finite number ≥ 0)
        ls: length over which pin and sleeve overlap; 0 omits the bending moments (unit L; a finite number ≥ 0)

    Outputs:
        mc1: contact moment of a hinge along e1a, which the connector's loads produce (unit FL; a finite number)
        mc3: contact moment of a hinge along e3b, which the connector's loads produce (unit FL; a finite number)

    Accuracy: η at most 2 of the value, 6 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (printed).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, *, out: Any = None) -> _ContactMomentsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, *, out: Any = None) -> _ContactMomentsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactMomentsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactMomentsLinearized: ...

contact_moments: Final[_ContactMoments]

class _NormalMomentsValue(NamedTuple):
    mn1: Numbers
    mn3: Numbers

class _NormalMomentsGradient(Gradient):
    mc1: Numbers
    mc3: Numbers
    mc1_int: Numbers
    mc3_int: Numbers

class _NormalMomentsJacobian(Jacobian):
    mn1: _NormalMomentsGradient
    mn3: _NormalMomentsGradient

class _NormalMomentsLinearized(NamedTuple):
    value: _NormalMomentsValue
    jacobian: _NormalMomentsJacobian

class _NormalMoments(Formula):
    """Normal moments.

        M_{Nk} = 2\\lvert M_{Ck}\\rvert + \\lvert M_{Ck}^{\\mathrm{int}}\\rvert\\quad (k = 1, 3)

    Inputs:
        mc1: contact moment of a hinge along e1a, which the connector's loads produce (unit FL; a finite number)
        mc3: contact moment of a hinge along e3b, which the connector's loads produce (unit FL; a finite number)
        mc1_int: self-equilibrated internal contact moment about e1a, for instance from a press fit (unit FL; a finite number)
        mc3_int: self-equilibrated internal contact moment about e3b, for instance from a press fit (unit FL; a finite number)

    Outputs:
        mn1: normal moment that produces friction about e1a (unit FL; a finite number ≥ 0)
        mn3: normal moment that produces friction about e3b (unit FL; a finite number ≥ 0)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Friction (printed).
    """
    def __call__(self, mc1: ArrayLike, mc3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, *, out: Any = None) -> _NormalMomentsValue: ...
    def linearize(self, mc1: ArrayLike, mc3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, *, out: Any = None) -> _NormalMomentsLinearized: ...
    def exact(self, mc1: ArrayLike, mc3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NormalMomentsValue: ...
    def exact_linearize(self, mc1: ArrayLike, mc3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NormalMomentsLinearized: ...

normal_moments: Final[_NormalMoments]

class _FrictionValue(NamedTuple):
    phi1: Numbers
    phi3: Numbers

class _FrictionGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    m2: Numbers
    rp: Numbers
    la: Numbers
    ra: Numbers
    ls: Numbers
    m1: Numbers
    m3: Numbers
    mc1_int: Numbers
    mc3_int: Numbers
    mu: Numbers

class _FrictionJacobian(Jacobian):
    phi1: _FrictionGradient
    phi3: _FrictionGradient

class _FrictionLinearized(NamedTuple):
    value: _FrictionValue
    jacobian: _FrictionJacobian

class _Friction(Formula):
    """Friction.

        \\Phi_k = \\lvert m_k\\rvert - \\mu M_{Nk}\\quad (k = 1, 3)

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        ra: effective friction arm of the axial force of a pin; 0 omits this force (unit L; a finite number ≥ 0)
        ls: length over which pin and sleeve overlap; 0 omits the bending moments (unit L; a finite number ≥ 0)
        m1: kinetic moment about e1a, which acts on node a, and its opposite on node b: conjugate to ur1 (unit FL; a finite number)
        m3: kinetic moment about e3b, which acts on node a, and its opposite on node b: conjugate to ur3 (unit FL; a finite number)
        mc1_int: self-equilibrated internal contact moment about e1a, for instance from a press fit (unit FL; a finite number)
        mc3_int: self-equilibrated internal contact moment about e3b, for instance from a press fit (unit FL; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        phi1: yield function about e1a: stick below 0, slip at 0 (unit FL; a finite number)
        phi3: yield function about e3b: stick below 0, slip at 0 (unit FL; a finite number)

    Accuracy: η at most 2 of the value, 6 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (printed).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, m1: ArrayLike, m3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, m1: ArrayLike, m3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, m1: ArrayLike, m3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, m1: ArrayLike, m3: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionLinearized: ...

friction: Final[_Friction]

class _StopValue(NamedTuple):
    gap1_min: Numbers
    gap1_max: Numbers
    gap3_min: Numbers
    gap3_max: Numbers

class _StopGradient(Gradient):
    alpha: Numbers
    gamma: Numbers
    theta1_min: Numbers
    theta1_max: Numbers
    theta3_min: Numbers
    theta3_max: Numbers

class _StopJacobian(Jacobian):
    gap1_min: _StopGradient
    gap1_max: _StopGradient
    gap3_min: _StopGradient
    gap3_max: _StopGradient

class _StopLinearized(NamedTuple):
    value: _StopValue
    jacobian: _StopJacobian

class _Stop(Formula):
    """Stops.

        \\mathit{gap}_{1\\min} = \\alpha - \\theta_1^{\\min},\\quad \\mathit{gap}_{1\\max} = \\theta_1^{\\max} - \\alpha,\\quad \\mathit{gap}_{3\\min} = \\gamma - \\theta_3^{\\min},\\quad \\mathit{gap}_{3\\max} = \\theta_3^{\\max} - \\gamma

    Inputs:
        alpha: first Cardan angle of b's triad relative to a's, about e1a, from −π to below π (unit 1; a finite number)
        gamma: third Cardan angle of b's triad relative to a's, about e3b, from −π to below π (unit 1; a finite number)
        theta1_min: lower stop: least angle about e1a (unit 1; a finite number)
        theta1_max: upper stop: greatest angle about e1a (unit 1; a finite number)
        theta3_min: lower stop: least angle about e3b (unit 1; a finite number)
        theta3_max: upper stop: greatest angle about e3b (unit 1; a finite number)

    Outputs:
        gap1_min: angle to the lower stop about e1a, negative beyond it (unit 1; a finite number)
        gap1_max: angle to the upper stop about e1a, negative beyond it (unit 1; a finite number)
        gap3_min: angle to the lower stop about e3b, negative beyond it (unit 1; a finite number)
        gap3_max: angle to the upper stop about e3b, negative beyond it (unit 1; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Summary (reconstructed: the signs ≤ were lost; the first row is printed with γ, where α is meant).
    """
    def __call__(self, alpha: ArrayLike, gamma: ArrayLike, theta1_min: ArrayLike, theta1_max: ArrayLike, theta3_min: ArrayLike, theta3_max: ArrayLike, *, out: Any = None) -> _StopValue: ...
    def linearize(self, alpha: ArrayLike, gamma: ArrayLike, theta1_min: ArrayLike, theta1_max: ArrayLike, theta3_min: ArrayLike, theta3_max: ArrayLike, *, out: Any = None) -> _StopLinearized: ...
    def exact(self, alpha: ArrayLike, gamma: ArrayLike, theta1_min: ArrayLike, theta1_max: ArrayLike, theta3_min: ArrayLike, theta3_max: ArrayLike, *, number: Callable[[str], Any] = ...) -> _StopValue: ...
    def exact_linearize(self, alpha: ArrayLike, gamma: ArrayLike, theta1_min: ArrayLike, theta1_max: ArrayLike, theta3_min: ArrayLike, theta3_max: ArrayLike, *, number: Callable[[str], Any] = ...) -> _StopLinearized: ...

stop: Final[_Stop]

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
    g_rot_ta: Numbers
    g_rot_tb: Numbers

class _RowsGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
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
    g_rot_ta: _RowsGradient
    g_rot_tb: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of UJOINT.

        \\mathbf{g}_{i,ua} = -\\mathbf{e}_{ia},\\quad \\mathbf{g}_{i,\\theta a} = \\mathbf{e}_{ia}\\times(\\mathbf{x}_b-\\mathbf{x}_a),\\quad \\mathbf{g}_{i,ub} = \\mathbf{e}_{ia}\\quad (i = 1, 2, 3),\\quad \\mathbf{g}_{\\mathrm{rot},\\theta a} = \\mathbf{e}_{1a}\\times\\mathbf{e}_{3b},\\quad \\mathbf{g}_{\\mathrm{rot},\\theta b} = \\mathbf{e}_{3b}\\times\\mathbf{e}_{1a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
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
        g_rot_ta: derivative of the residual of UNIVERSAL by the spin of node a ([3], unit 1; a finite number)
        g_rot_tb: derivative of the residual of UNIVERSAL by the spin of node b ([3], unit 1; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page names the residuals; these are their derivatives).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

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
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    lambda_rot: Numbers

class _NodalForcesJacobian(Jacobian):
    fa: _NodalForcesGradient
    ma: _NodalForcesGradient
    fb: _NodalForcesGradient
    mb: _NodalForcesGradient

class _NodalForcesLinearized(NamedTuple):
    value: _NodalForcesValue
    jacobian: _NodalForcesJacobian

class _NodalForces(Formula):
    """Nodal forces of UJOINT.

        \\mathbf{f}_b = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{f}_a = -\\mathbf{f}_b,\\quad \\mathbf{m}_a = \\mathbf{f}_b\\times(\\mathbf{x}_b-\\mathbf{x}_a) + \\lambda_{\\mathrm{rot}}\\,\\mathbf{e}_{1a}\\times\\mathbf{e}_{3b},\\quad \\mathbf{m}_b = \\lambda_{\\mathrm{rot}}\\,\\mathbf{e}_{3b}\\times\\mathbf{e}_{1a}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        fa: force of the connector on node a, in the global frame ([3], unit F; a finite number)
        ma: moment of the connector on node a, in the global frame ([3], unit FL; a finite number)
        fb: force of the connector on node b, in the global frame ([3], unit F; a finite number)
        mb: moment of the connector on node b, in the global frame ([3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: UJOINT, Description (ours: the page names the residuals; these do the work of their multipliers).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _NodalForcesValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _NodalForcesLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearized: ...

nodal_forces: Final[_NodalForces]

class _GeometricStiffnessValue(NamedTuple):
    k_ua_ta: Numbers
    k_ta_ta: Numbers
    k_ta_tb: Numbers
    k_tb_tb: Numbers

class _GeometricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    lambda_rot: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_ua_ta: _GeometricStiffnessGradient
    k_ta_ta: _GeometricStiffnessGradient
    k_ta_tb: _GeometricStiffnessGradient
    k_tb_tb: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of UJOINT.

        \\mathbf{f} = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{K}_{ua,\\theta a} = \\mathbf{f}\\times\\mathbf{I},\\quad \\mathbf{K}_{\\theta a,\\theta a} = \\mathbf{f}\\otimes\\mathbf{d} - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I} + \\lambda_{\\mathrm{rot}}(\\mathbf{e}_{1a}\\otimes\\mathbf{e}_{3b} - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{K}_{\\theta b,\\theta b} = \\lambda_{\\mathrm{rot}}(\\mathbf{e}_{3b}\\otimes\\mathbf{e}_{1a} - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{K}_{\\theta a,\\theta b} = -\\mathbf{K}_{\\theta b,\\theta b}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        k_ua_ta: derivative of the force on node a by the spin of node a, at constant multipliers ([3, 3], unit F; a finite number)
        k_ta_ta: derivative of the moment on node a by the spin of node a, at constant multipliers ([3, 3], unit FL; a finite number)
        k_ta_tb: derivative of the moment on node a by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)
        k_tb_tb: derivative of the moment on node b by the spin of node b, at constant multipliers ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page names the residuals; it is the derivative of their nodal forces).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _SymmetricStiffnessValue(NamedTuple):
    s_ta_ta: Numbers
    s_tb_tb: Numbers

class _SymmetricStiffnessGradient(Gradient):
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    xa: Numbers
    xb: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    lambda_rot: Numbers

class _SymmetricStiffnessJacobian(Jacobian):
    s_ta_ta: _SymmetricStiffnessGradient
    s_tb_tb: _SymmetricStiffnessGradient

class _SymmetricStiffnessLinearized(NamedTuple):
    value: _SymmetricStiffnessValue
    jacobian: _SymmetricStiffnessJacobian

class _SymmetricStiffness(Formula):
    """Symmetric part of the geometric stiffness of UJOINT.

        \\mathbf{f} = f_1\\,\\mathbf{e}_{1a} + f_2\\,\\mathbf{e}_{2a} + f_3\\,\\mathbf{e}_{3a},\\quad \\mathbf{d} = \\mathbf{x}_b-\\mathbf{x}_a,\\quad \\mathbf{S}_{\\theta b,\\theta b} = \\lambda_{\\mathrm{rot}}(\\tfrac12(\\mathbf{e}_{1a}\\otimes\\mathbf{e}_{3b} + \\mathbf{e}_{3b}\\otimes\\mathbf{e}_{1a}) - (\\mathbf{e}_{1a}\\cdot\\mathbf{e}_{3b})\\,\\mathbf{I}),\\quad \\mathbf{S}_{\\theta a,\\theta a} = \\tfrac12(\\mathbf{f}\\otimes\\mathbf{d} + \\mathbf{d}\\otimes\\mathbf{f}) - (\\mathbf{f}\\cdot\\mathbf{d})\\,\\mathbf{I} + \\mathbf{S}_{\\theta b,\\theta b}

    Inputs:
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        xa: position of node a, in the global frame ([3], unit L; a finite number)
        xb: position of node b, in the global frame ([3], unit L; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        lambda_rot: multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle (unit FL; a finite number)

    Outputs:
        s_ta_ta: symmetric part of the derivative of the moment on node a by the spin of node a ([3, 3], unit FL; a finite number)
        s_tb_tb: symmetric part of the derivative of the moment on node b by the spin of node b ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page names the residuals; for programs that solve symmetric equations).
    """
    def __call__(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessValue: ...
    def linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, out: Any = None) -> _SymmetricStiffnessLinearized: ...
    def exact(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessValue: ...
    def exact_linearize(self, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, xa: ArrayLike, xb: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, lambda_rot: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SymmetricStiffnessLinearized: ...

symmetric_stiffness: Final[_SymmetricStiffness]

class _FrictionResponseValue(NamedTuple):
    m1: Numbers
    m3: Numbers
    slip1: Numbers
    slip3: Numbers

class _FrictionResponseGradient(Gradient):
    ur1: Numbers
    ur3: Numbers
    slip1_before: Numbers
    slip3_before: Numbers
    k_el1: Numbers
    k_el3: Numbers
    e1a: Numbers
    e2a: Numbers
    e3a: Numbers
    e3b: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers
    m2: Numbers
    rp: Numbers
    la: Numbers
    ra: Numbers
    ls: Numbers
    mc1_int: Numbers
    mc3_int: Numbers
    mu: Numbers

class _FrictionResponseJacobian(Jacobian):
    m1: _FrictionResponseGradient
    m3: _FrictionResponseGradient
    slip1: _FrictionResponseGradient
    slip3: _FrictionResponseGradient

class _FrictionResponseLinearized(NamedTuple):
    value: _FrictionResponseValue
    jacobian: _FrictionResponseJacobian

class _FrictionResponse(Formula):
    """Friction of UJOINT after turns.

        m_k = \\begin{cases} m_k^{\\mathrm{trial}} & \\lvert m_k^{\\mathrm{trial}}\\rvert < \\mu M_{Nk}
        \\mu M_{Nk} \\operatorname{sign} m_k^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},\\quad m_k^{\\mathrm{trial}} = k_{\\mathrm{el},k}(u_{rk}-u_{rk,0}^{\\mathrm{slip}}),\\quad u_{rk}^{\\mathrm{slip}} = u_{rk} - \\frac{m_k}{k_{\\mathrm{el},k}}\\quad (k = 1, 3)

    Inputs:
        ur1: rotation of b relative to a about e1a, continued beyond half a turn (unit 1; a finite number)
        ur3: rotation of b relative to a about e3b, continued beyond half a turn (unit 1; a finite number)
        slip1_before: slip about e1a before the increment: the rotation at which m1 would be 0 (unit 1; a finite number)
        slip3_before: slip about e3b before the increment: the rotation at which m3 would be 0 (unit 1; a finite number)
        k_el1: stiffness about e1a in stick, moment per radian (unit FL; a finite number > 0)
        k_el3: stiffness about e3b in stick, moment per radian (unit FL; a finite number > 0)
        e1a: first unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e2a: second unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3a: third unit vector of node a's triad, in the global frame ([3], unit 1; a finite number)
        e3b: third unit vector of node b's triad, in the global frame ([3], unit 1; a finite number)
        f1: constraint force along e1a on node b, its opposite on node a (unit F; a finite number)
        f2: constraint force along e2a on node b, its opposite on node a (unit F; a finite number)
        f3: constraint force along e3a on node b, its opposite on node a (unit F; a finite number)
        m2: constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a (unit FL; a finite number)
        rp: average radius of the pins at the ends of the cross (unit L; a finite number > 0)
        la: length of a cross arm, from the centre to the pin (unit L; a finite number > 0)
        ra: effective friction arm of the axial force of a pin; 0 omits this force (unit L; a finite number ≥ 0)
        ls: length over which pin and sleeve overlap; 0 omits the bending moments (unit L; a finite number ≥ 0)
        mc1_int: self-equilibrated internal contact moment about e1a, for instance from a press fit (unit FL; a finite number)
        mc3_int: self-equilibrated internal contact moment about e3b, for instance from a press fit (unit FL; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        m1: kinetic moment about e1a, which acts on node a, and its opposite on node b: conjugate to ur1 (unit FL; a finite number)
        m3: kinetic moment about e3b, which acts on node a, and its opposite on node b: conjugate to ur3 (unit FL; a finite number)
        slip1: slip about e1a after the increment: the rotation at which m1 would be 0 (unit 1; a finite number)
        slip3: slip about e3b after the increment: the rotation at which m3 would be 0 (unit 1; a finite number)

    Accuracy: η at most 2 of the value, 6 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: UJOINT, Friction (ours: the page prints M_N and the yield functions; the response is the return map's).
    """
    def __call__(self, ur1: ArrayLike, ur3: ArrayLike, slip1_before: ArrayLike, slip3_before: ArrayLike, k_el1: ArrayLike, k_el3: ArrayLike, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseValue: ...
    def linearize(self, ur1: ArrayLike, ur3: ArrayLike, slip1_before: ArrayLike, slip3_before: ArrayLike, k_el1: ArrayLike, k_el3: ArrayLike, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseLinearized: ...
    def exact(self, ur1: ArrayLike, ur3: ArrayLike, slip1_before: ArrayLike, slip3_before: ArrayLike, k_el1: ArrayLike, k_el3: ArrayLike, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseValue: ...
    def exact_linearize(self, ur1: ArrayLike, ur3: ArrayLike, slip1_before: ArrayLike, slip3_before: ArrayLike, k_el1: ArrayLike, k_el3: ArrayLike, e1a: ArrayLike, e2a: ArrayLike, e3a: ArrayLike, e3b: ArrayLike, f1: ArrayLike, f2: ArrayLike, f3: ArrayLike, m2: ArrayLike, rp: ArrayLike, la: ArrayLike, ra: ArrayLike, ls: ArrayLike, mc1_int: ArrayLike, mc3_int: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseLinearized: ...

friction_response: Final[_FrictionResponse]
