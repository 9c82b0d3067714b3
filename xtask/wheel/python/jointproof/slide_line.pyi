# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _RowsLinearValue(NamedTuple):
    e11_us: Numbers
    e11_u1: Numbers
    e11_u2: Numbers
    e12_us: Numbers
    e12_u1: Numbers
    e12_u2: Numbers

class _RowsLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers
    g: Numbers

class _RowsLinearJacobian(Jacobian):
    e11_us: _RowsLinearGradient
    e11_u1: _RowsLinearGradient
    e11_u2: _RowsLinearGradient
    e12_us: _RowsLinearGradient
    e12_u1: _RowsLinearGradient
    e12_u2: _RowsLinearGradient

class _RowsLinearLinearized(NamedTuple):
    value: _RowsLinearValue
    jacobian: _RowsLinearJacobian

class _RowsLinear(Formula):
    """Rows of contact on a straight segment.

        \\begin{aligned} \\mathbf{e}_{11,us} &= \\mathbf{n}, & \\mathbf{e}_{11,u1} &= -N_1\\,\\mathbf{n}, & \\mathbf{e}_{11,u2} &= -N_2\\,\\mathbf{n},
        \\mathbf{e}_{12,us} &= \\mathbf{t}, & \\mathbf{e}_{12,u1} &= -N_1\\,\\mathbf{t}, & \\mathbf{e}_{12,u2} &= -N_2\\,\\mathbf{t},
        N_1 &= \\tfrac12(1-g), & N_2 &= \\tfrac12(1+g) \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)

    Outputs:
        e11_us: variation of the separation by the translation of the slave point ([2], unit 1; a finite number)
        e11_u1: variation of the separation by the translation of the first node ([2], unit 1; a finite number)
        e11_u2: variation of the separation by the translation of the second node ([2], unit 1; a finite number)
        e12_us: variation of the slip over a place that is held by the translation of the slave point ([2], unit 1; a finite number)
        e12_u1: variation of the slip over a place that is held by the translation of the first node ([2], unit 1; a finite number)
        e12_u2: variation of the slip over a place that is held by the translation of the second node ([2], unit 1; a finite number)

    Accuracy: η at most 4 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Element output (ours: the section names separation and slip; these are their variations).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, out: Any = None) -> _RowsLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, out: Any = None) -> _RowsLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearLinearized: ...

rows_linear: Final[_RowsLinear]

class _RowsParabolicValue(NamedTuple):
    e11_us: Numbers
    e11_u1: Numbers
    e11_u2: Numbers
    e11_u3: Numbers
    e12_us: Numbers
    e12_u1: Numbers
    e12_u2: Numbers
    e12_u3: Numbers

class _RowsParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    g: Numbers

class _RowsParabolicJacobian(Jacobian):
    e11_us: _RowsParabolicGradient
    e11_u1: _RowsParabolicGradient
    e11_u2: _RowsParabolicGradient
    e11_u3: _RowsParabolicGradient
    e12_us: _RowsParabolicGradient
    e12_u1: _RowsParabolicGradient
    e12_u2: _RowsParabolicGradient
    e12_u3: _RowsParabolicGradient

class _RowsParabolicLinearized(NamedTuple):
    value: _RowsParabolicValue
    jacobian: _RowsParabolicJacobian

class _RowsParabolic(Formula):
    """Rows of contact on a parabolic segment.

        \\begin{aligned} \\mathbf{e}_{11,us} &= \\mathbf{n}, & \\mathbf{e}_{11,u1} &= -N_1\\,\\mathbf{n}, & \\mathbf{e}_{11,u2} &= -N_2\\,\\mathbf{n}, & \\mathbf{e}_{11,u3} &= -N_3\\,\\mathbf{n},
        \\mathbf{e}_{12,us} &= \\mathbf{t}, & \\mathbf{e}_{12,u1} &= -N_1\\,\\mathbf{t}, & \\mathbf{e}_{12,u2} &= -N_2\\,\\mathbf{t}, & \\mathbf{e}_{12,u3} &= -N_3\\,\\mathbf{t},
        N_1 &= \\tfrac12 g(g-1), & N_2 &= 1-g^2, & N_3 &= \\tfrac12 g(g+1) \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)

    Outputs:
        e11_us: variation of the separation by the translation of the slave point ([2], unit 1; a finite number)
        e11_u1: variation of the separation by the translation of the first node ([2], unit 1; a finite number)
        e11_u2: variation of the separation by the translation of the second node ([2], unit 1; a finite number)
        e11_u3: variation of the separation by the translation of the third node ([2], unit 1; a finite number)
        e12_us: variation of the slip over a place that is held by the translation of the slave point ([2], unit 1; a finite number)
        e12_u1: variation of the slip over a place that is held by the translation of the first node ([2], unit 1; a finite number)
        e12_u2: variation of the slip over a place that is held by the translation of the second node ([2], unit 1; a finite number)
        e12_u3: variation of the slip over a place that is held by the translation of the third node ([2], unit 1; a finite number)

    Accuracy: η at most 4 of the value, 10 of the Jacobian, by vectors, inputs from 1/1e20 to 1e20 in size.
    Source: Slide lines, Element output (ours: the section names separation and slip; these are their variations).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, out: Any = None) -> _RowsParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, out: Any = None) -> _RowsParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsParabolicLinearized: ...

rows_parabolic: Final[_RowsParabolic]

class _NodalForcesLinearValue(NamedTuple):
    fs: Numbers
    f1: Numbers
    f2: Numbers

class _NodalForcesLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers
    g: Numbers
    area: Numbers
    s11: Numbers
    s12: Numbers

class _NodalForcesLinearJacobian(Jacobian):
    fs: _NodalForcesLinearGradient
    f1: _NodalForcesLinearGradient
    f2: _NodalForcesLinearGradient

class _NodalForcesLinearLinearized(NamedTuple):
    value: _NodalForcesLinearValue
    jacobian: _NodalForcesLinearJacobian

class _NodalForcesLinear(Formula):
    """Nodal forces of contact on a straight segment.

        \\mathbf{f}_s = A\\,(S_{11}\\,\\mathbf{n} - S_{12}\\,\\mathbf{t}),\\quad \\mathbf{f}_1 = -\\tfrac12(1-g)\\,\\mathbf{f}_s,\\quad \\mathbf{f}_2 = -\\tfrac12(1+g)\\,\\mathbf{f}_s

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        area: contact area of the slave node, around the whole circumference (unit L^2; a finite number ≥ 0)
        s11: contact pressure, positive where it pushes the slave point along the normal (unit F/L^2; a finite number)
        s12: shear stress, positive where it resists positive slip and pushes the slave point against the tangent (unit F/L^2; a finite number)

    Outputs:
        fs: force of the contact on the slave point, around the whole circumference ([2], unit F; a finite number)
        f1: force of the contact on the first node, around the whole circumference ([2], unit F; a finite number)
        f2: force of the contact on the second node, around the whole circumference ([2], unit F; a finite number)

    Accuracy: η at most 2 of the value, 4 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Element output (ours: the section names pressure and shear stress, and prints no forces).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, out: Any = None) -> _NodalForcesLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, out: Any = None) -> _NodalForcesLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearLinearized: ...

nodal_forces_linear: Final[_NodalForcesLinear]

class _NodalForcesParabolicValue(NamedTuple):
    fs: Numbers
    f1: Numbers
    f2: Numbers
    f3: Numbers

class _NodalForcesParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    g: Numbers
    area: Numbers
    s11: Numbers
    s12: Numbers

class _NodalForcesParabolicJacobian(Jacobian):
    fs: _NodalForcesParabolicGradient
    f1: _NodalForcesParabolicGradient
    f2: _NodalForcesParabolicGradient
    f3: _NodalForcesParabolicGradient

class _NodalForcesParabolicLinearized(NamedTuple):
    value: _NodalForcesParabolicValue
    jacobian: _NodalForcesParabolicJacobian

class _NodalForcesParabolic(Formula):
    """Nodal forces of contact on a parabolic segment.

        \\mathbf{f}_s = A\\,(S_{11}\\,\\mathbf{n} - S_{12}\\,\\mathbf{t}),\\quad \\mathbf{f}_1 = -\\tfrac12 g(g-1)\\,\\mathbf{f}_s,\\quad \\mathbf{f}_2 = -(1-g^2)\\,\\mathbf{f}_s,\\quad \\mathbf{f}_3 = -\\tfrac12 g(g+1)\\,\\mathbf{f}_s

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        area: contact area of the slave node, around the whole circumference (unit L^2; a finite number ≥ 0)
        s11: contact pressure, positive where it pushes the slave point along the normal (unit F/L^2; a finite number)
        s12: shear stress, positive where it resists positive slip and pushes the slave point against the tangent (unit F/L^2; a finite number)

    Outputs:
        fs: force of the contact on the slave point, around the whole circumference ([2], unit F; a finite number)
        f1: force of the contact on the first node, around the whole circumference ([2], unit F; a finite number)
        f2: force of the contact on the second node, around the whole circumference ([2], unit F; a finite number)
        f3: force of the contact on the third node, around the whole circumference ([2], unit F; a finite number)

    Accuracy: η at most 2 of the value, 8 of the Jacobian, by vectors, inputs from 1/1e20 to 1e20 in size.
    Source: Slide lines, Element output (ours: the section names pressure and shear stress, and prints no forces).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, out: Any = None) -> _NodalForcesParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, out: Any = None) -> _NodalForcesParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, area: ArrayLike, s11: ArrayLike, s12: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesParabolicLinearized: ...

nodal_forces_parabolic: Final[_NodalForcesParabolic]

class _GeometricStiffnessLinearValue(NamedTuple):
    k_us_u1: Numbers
    k_u1_u1: Numbers
    k_u1_u2: Numbers
    k_u2_u2: Numbers

class _GeometricStiffnessLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers
    g: Numbers
    separation: Numbers
    lambda_: Numbers

class _GeometricStiffnessLinearJacobian(Jacobian):
    k_us_u1: _GeometricStiffnessLinearGradient
    k_u1_u1: _GeometricStiffnessLinearGradient
    k_u1_u2: _GeometricStiffnessLinearGradient
    k_u2_u2: _GeometricStiffnessLinearGradient

class _GeometricStiffnessLinearLinearized(NamedTuple):
    value: _GeometricStiffnessLinearValue
    jacobian: _GeometricStiffnessLinearJacobian

class _GeometricStiffnessLinear(Formula):
    """Geometric stiffness of contact on a straight segment.

        \\begin{aligned} \\mathbf{P} &= \\frac{\\lambda}{\\ell}\\,\\mathbf{t}\\otimes\\mathbf{n},\\quad \\mathbf{Q} = \\frac{\\lambda}{\\ell}\\,\\mathbf{n}\\otimes\\mathbf{t},\\quad \\mathbf{R} = \\frac{\\lambda E_{11}}{\\ell^2}\\,\\mathbf{n}\\otimes\\mathbf{n},
        \\mathbf{K}_{us,u1} &= \\mathbf{P},\\quad \\mathbf{K}_{u1,u1} = -N_1(\\mathbf{P}+\\mathbf{Q}) - \\mathbf{R},\\quad \\mathbf{K}_{u1,u2} = N_1\\,\\mathbf{P} - N_2\\,\\mathbf{Q} + \\mathbf{R},\\quad \\mathbf{K}_{u2,u2} = N_2(\\mathbf{P}+\\mathbf{Q}) - \\mathbf{R},
        N_1 &= \\tfrac12(1-g),\\quad N_2 = \\tfrac12(1+g),\\quad \\ell = \\lvert\\mathbf{x}_2-\\mathbf{x}_1\\rvert \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)
        lambda_: contact force on the slave point along the normal, around the whole circumference (unit F; a finite number)

    Outputs:
        k_us_u1: derivative of the force on the slave point by the translation of the first node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u1_u1: derivative of the force on the first node by the translation of the first node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u1_u2: derivative of the force on the first node by the translation of the second node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u2_u2: derivative of the force on the second node by the translation of the second node, at a constant contact force ([2, 2], unit F/L; a finite number)

    Accuracy: η at most 4 of the value, 6 of the Jacobian, by vectors, inputs from 1/1e80 to 1e80 in size.
    Source: Slide lines, Element output (ours: the section names the separation; it is the derivative of the force along its normal).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearLinearized: ...

geometric_stiffness_linear: Final[_GeometricStiffnessLinear]

class _GeometricStiffnessParabolicValue(NamedTuple):
    k_us_us: Numbers
    k_us_u1: Numbers
    k_us_u2: Numbers
    k_us_u3: Numbers
    k_u1_u1: Numbers
    k_u1_u2: Numbers
    k_u1_u3: Numbers
    k_u2_u2: Numbers
    k_u2_u3: Numbers
    k_u3_u3: Numbers

class _GeometricStiffnessParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    g: Numbers
    separation: Numbers
    lambda_: Numbers

class _GeometricStiffnessParabolicJacobian(Jacobian):
    k_us_us: _GeometricStiffnessParabolicGradient
    k_us_u1: _GeometricStiffnessParabolicGradient
    k_us_u2: _GeometricStiffnessParabolicGradient
    k_us_u3: _GeometricStiffnessParabolicGradient
    k_u1_u1: _GeometricStiffnessParabolicGradient
    k_u1_u2: _GeometricStiffnessParabolicGradient
    k_u1_u3: _GeometricStiffnessParabolicGradient
    k_u2_u2: _GeometricStiffnessParabolicGradient
    k_u2_u3: _GeometricStiffnessParabolicGradient
    k_u3_u3: _GeometricStiffnessParabolicGradient

class _GeometricStiffnessParabolicLinearized(NamedTuple):
    value: _GeometricStiffnessParabolicValue
    jacobian: _GeometricStiffnessParabolicJacobian

class _GeometricStiffnessParabolic(Formula):
    """Geometric stiffness of contact on a parabolic segment.

        \\begin{aligned} \\mathbf{K}_{us,us} &= -c\\kappa\\,\\mathbf{t}\\otimes\\mathbf{t},\\quad \\mathbf{K}_{us,u1} = -c\\,(\\mathbf{t}\\otimes\\mathbf{b}_1 + \\kappa\\,\\mathbf{t}\\otimes\\mathbf{a}_1),\\quad \\mathbf{K}_{us,u2} = -c\\,(\\mathbf{t}\\otimes\\mathbf{b}_2 + \\kappa\\,\\mathbf{t}\\otimes\\mathbf{a}_2),\\quad \\mathbf{K}_{us,u3} = -c\\,(\\mathbf{t}\\otimes\\mathbf{b}_3 + \\kappa\\,\\mathbf{t}\\otimes\\mathbf{a}_3),
        \\mathbf{K}_{u1,u1} &= -c\\,(\\mathbf{a}_1\\otimes\\mathbf{b}_1 + \\mathbf{b}_1\\otimes\\mathbf{a}_1 + \\kappa\\,\\mathbf{a}_1\\otimes\\mathbf{a}_1 + E_{11}\\,\\mathbf{b}_1\\otimes\\mathbf{b}_1),\\quad \\mathbf{K}_{u1,u2} = -c\\,(\\mathbf{a}_1\\otimes\\mathbf{b}_2 + \\mathbf{b}_1\\otimes\\mathbf{a}_2 + \\kappa\\,\\mathbf{a}_1\\otimes\\mathbf{a}_2 + E_{11}\\,\\mathbf{b}_1\\otimes\\mathbf{b}_2),
        \\mathbf{K}_{u1,u3} &= -c\\,(\\mathbf{a}_1\\otimes\\mathbf{b}_3 + \\mathbf{b}_1\\otimes\\mathbf{a}_3 + \\kappa\\,\\mathbf{a}_1\\otimes\\mathbf{a}_3 + E_{11}\\,\\mathbf{b}_1\\otimes\\mathbf{b}_3),\\quad \\mathbf{K}_{u2,u2} = -c\\,(\\mathbf{a}_2\\otimes\\mathbf{b}_2 + \\mathbf{b}_2\\otimes\\mathbf{a}_2 + \\kappa\\,\\mathbf{a}_2\\otimes\\mathbf{a}_2 + E_{11}\\,\\mathbf{b}_2\\otimes\\mathbf{b}_2),
        \\mathbf{K}_{u2,u3} &= -c\\,(\\mathbf{a}_2\\otimes\\mathbf{b}_3 + \\mathbf{b}_2\\otimes\\mathbf{a}_3 + \\kappa\\,\\mathbf{a}_2\\otimes\\mathbf{a}_3 + E_{11}\\,\\mathbf{b}_2\\otimes\\mathbf{b}_3),\\quad \\mathbf{K}_{u3,u3} = -c\\,(\\mathbf{a}_3\\otimes\\mathbf{b}_3 + \\mathbf{b}_3\\otimes\\mathbf{a}_3 + \\kappa\\,\\mathbf{a}_3\\otimes\\mathbf{a}_3 + E_{11}\\,\\mathbf{b}_3\\otimes\\mathbf{b}_3),
        c &= \\frac{\\lambda}{1-\\kappa E_{11}},\\quad \\kappa = \\frac{\\mathbf{n}\\cdot(\\mathbf{x}_1-2\\,\\mathbf{x}_2+\\mathbf{x}_3)}{\\lvert\\mathbf{X}'\\rvert^2},\\quad \\mathbf{a}_1 = -\\tfrac12 g(g-1)\\,\\mathbf{t},\\quad \\mathbf{a}_2 = -(1-g^2)\\,\\mathbf{t},\\quad \\mathbf{a}_3 = -\\tfrac12 g(g+1)\\,\\mathbf{t},
        \\mathbf{b}_1 &= \\frac{g-\\tfrac12}{\\lvert\\mathbf{X}'\\rvert}\\,\\mathbf{n},\\quad \\mathbf{b}_2 = -\\frac{2g}{\\lvert\\mathbf{X}'\\rvert}\\,\\mathbf{n},\\quad \\mathbf{b}_3 = \\frac{g+\\tfrac12}{\\lvert\\mathbf{X}'\\rvert}\\,\\mathbf{n} \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)
        lambda_: contact force on the slave point along the normal, around the whole circumference (unit F; a finite number)

    Outputs:
        k_us_us: derivative of the force on the slave point by the translation of the slave point, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_us_u1: derivative of the force on the slave point by the translation of the first node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_us_u2: derivative of the force on the slave point by the translation of the second node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_us_u3: derivative of the force on the slave point by the translation of the third node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u1_u1: derivative of the force on the first node by the translation of the first node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u1_u2: derivative of the force on the first node by the translation of the second node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u1_u3: derivative of the force on the first node by the translation of the third node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u2_u2: derivative of the force on the second node by the translation of the second node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u2_u3: derivative of the force on the second node by the translation of the third node, at a constant contact force ([2, 2], unit F/L; a finite number)
        k_u3_u3: derivative of the force on the third node by the translation of the third node, at a constant contact force ([2, 2], unit F/L; a finite number)

    Accuracy: η at most 6 of the value, 256 of the Jacobian, by vectors, inputs from 1/1e3 to 1e3 in size.
    Source: Slide lines, Element output (ours: the section names the separation; it is the derivative of the force along its normal).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffnessParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffnessParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, separation: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessParabolicLinearized: ...

geometric_stiffness_parabolic: Final[_GeometricStiffnessParabolic]

class _FrictionResponseValue(NamedTuple):
    s12: Numbers

class _FrictionResponseGradient(Gradient):
    s11: Numbers
    dslip: Numbers
    s12_before: Numbers
    k_el: Numbers
    mu: Numbers

class _FrictionResponseJacobian(Jacobian):
    s12: _FrictionResponseGradient

class _FrictionResponseLinearized(NamedTuple):
    value: _FrictionResponseValue
    jacobian: _FrictionResponseJacobian

class _FrictionResponse(Formula):
    """Shear stress of contact after a slip.

        S_{12} = \\begin{cases} S^{\\mathrm{trial}} & S_{11} > 0,\\ \\lvert S^{\\mathrm{trial}}\\rvert < \\mu S_{11}
        \\mu S_{11} \\operatorname{sign} S^{\\mathrm{trial}} & S_{11} > 0
        0 & \\text{otherwise}\\end{cases},\\quad S^{\\mathrm{trial}} = S_{12}^{\\mathrm{before}} + k_{\\mathrm{el}}\\,\\Delta E_{12}

    Inputs:
        s11: contact pressure, positive where it pushes the slave point along the normal (unit F/L^2; a finite number)
        dslip: increment of the tangential displacement of the slave point relative to the slide line (unit L; a finite number)
        s12_before: shear stress before the increment (unit F/L^2; a finite number)
        k_el: stiffness in stick, shear stress per slip (unit F/L^3; a finite number > 0)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        s12: shear stress, positive where it resists positive slip and pushes the slave point against the tangent (unit F/L^2; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining nondefault mechanical surface interactions with slide line elements (ours: the section names friction; the return map of a trial stress is the usual one).
    """
    def __call__(self, s11: ArrayLike, dslip: ArrayLike, s12_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseValue: ...
    def linearize(self, s11: ArrayLike, dslip: ArrayLike, s12_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _FrictionResponseLinearized: ...
    def exact(self, s11: ArrayLike, dslip: ArrayLike, s12_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseValue: ...
    def exact_linearize(self, s11: ArrayLike, dslip: ArrayLike, s12_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _FrictionResponseLinearized: ...

friction_response: Final[_FrictionResponse]

class _ContactResponseLinearValue(NamedTuple):
    g: Numbers
    dslip: Numbers
    s11: Numbers
    s12: Numbers
    fs: Numbers
    f1: Numbers
    f2: Numbers

class _ContactResponseLinearGradient(Gradient):
    xs: Numbers
    xo: Numbers
    x1: Numbers
    x2: Numbers
    g_before: Numbers
    s12_before: Numbers
    k: Numbers
    k_el: Numbers
    mu: Numbers

class _ContactResponseLinearJacobian(Jacobian):
    g: _ContactResponseLinearGradient
    dslip: _ContactResponseLinearGradient
    s11: _ContactResponseLinearGradient
    s12: _ContactResponseLinearGradient
    fs: _ContactResponseLinearGradient
    f1: _ContactResponseLinearGradient
    f2: _ContactResponseLinearGradient

class _ContactResponseLinearLinearized(NamedTuple):
    value: _ContactResponseLinearValue
    jacobian: _ContactResponseLinearJacobian

class _ContactResponseLinear(Formula):
    """Response of ISL21A on a straight segment.

        \\begin{aligned} g &= \\frac{2\\,(\\mathbf{x}_s-\\mathbf{x}_1)\\cdot\\mathbf{t}}{\\ell} - 1,\\quad \\Delta E_{12} = \\tfrac12\\ell\\,(g - g^{\\mathrm{before}}),\\quad S_{11} = \\begin{cases} -k E_{11} & E_{11} < 0
        0 & \\text{otherwise}\\end{cases},\\quad S_{12} = \\begin{cases} S^{\\mathrm{trial}} & \\lvert S^{\\mathrm{trial}}\\rvert < \\mu S_{11}
        \\mu S_{11} \\operatorname{sign} S^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},
        \\mathbf{f}_s &= A\\,(S_{11}\\,\\mathbf{n} - S_{12}\\,\\mathbf{t}),\\quad \\mathbf{f}_1 = -\\tfrac12(1-g)\\,\\mathbf{f}_s,\\quad \\mathbf{f}_2 = -\\tfrac12(1+g)\\,\\mathbf{f}_s,
        E_{11} &= (\\mathbf{x}_s-\\mathbf{x}_1)\\cdot\\mathbf{n},\\quad S^{\\mathrm{trial}} = S_{12}^{\\mathrm{before}} + k_{\\mathrm{el}}\\,\\Delta E_{12},\\quad A = \\pi\\,x_{s,1}\\,\\lvert\\mathbf{x}_o-\\mathbf{x}_s\\rvert,\\quad \\ell = \\lvert\\mathbf{x}_2-\\mathbf{x}_1\\rvert \\end{aligned}

    Inputs:
        xs: position of the slave point, in the plane (r, z) ([2], unit L; a finite number)
        xo: position of the other node of the ISL21A element, in the plane (r, z) ([2], unit L; a finite number)
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g_before: coordinate on the segment before the increment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        s12_before: shear stress before the increment (unit F/L^2; a finite number)
        k: contact stiffness, pressure per overclosure (unit F/L^3; a finite number > 0)
        k_el: stiffness in stick, shear stress per slip (unit F/L^3; a finite number > 0)
        mu: friction coefficient (unit 1; a finite number ≥ 0)

    Outputs:
        g: coordinate along a straight segment and what goes on straight past its ends, from -1 at its first node to 1 at its last (unit 1; a finite number)
        dslip: increment of the tangential displacement of the slave point relative to the slide line (unit L; a finite number)
        s11: contact pressure, positive where it pushes the slave point along the normal (unit F/L^2; a finite number)
        s12: shear stress, positive where it resists positive slip and pushes the slave point against the tangent (unit F/L^2; a finite number)
        fs: force of the contact on the slave point, around the whole circumference ([2], unit F; a finite number)
        f1: force of the contact on the first node, around the whole circumference ([2], unit F; a finite number)
        f2: force of the contact on the second node, around the whole circumference ([2], unit F; a finite number)

    Accuracy: η at most 4 of the value, 32 of the Jacobian, by vectors, inputs from 1/1e20 to 1e20 in size.
    Source: Slide lines, Element output (ours: the section names what is put out; how it follows from places is ours).
    """
    def __call__(self, xs: ArrayLike, xo: ArrayLike, x1: ArrayLike, x2: ArrayLike, g_before: ArrayLike, s12_before: ArrayLike, k: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _ContactResponseLinearValue: ...
    def linearize(self, xs: ArrayLike, xo: ArrayLike, x1: ArrayLike, x2: ArrayLike, g_before: ArrayLike, s12_before: ArrayLike, k: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, out: Any = None) -> _ContactResponseLinearLinearized: ...
    def exact(self, xs: ArrayLike, xo: ArrayLike, x1: ArrayLike, x2: ArrayLike, g_before: ArrayLike, s12_before: ArrayLike, k: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactResponseLinearValue: ...
    def exact_linearize(self, xs: ArrayLike, xo: ArrayLike, x1: ArrayLike, x2: ArrayLike, g_before: ArrayLike, s12_before: ArrayLike, k: ArrayLike, k_el: ArrayLike, mu: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactResponseLinearLinearized: ...

contact_response_linear: Final[_ContactResponseLinear]

class _BasisValue(NamedTuple):
    t: Numbers
    n: Numbers

class _BasisGradient(Gradient):
    dx: Numbers

class _BasisJacobian(Jacobian):
    t: _BasisGradient
    n: _BasisGradient

class _BasisLinearized(NamedTuple):
    value: _BasisValue
    jacobian: _BasisJacobian

class _Basis(Formula):
    """Local basis.

        \\mathbf{t} = \\frac{\\mathbf{X}'}{\\lvert\\mathbf{X}'\\rvert},\\quad \\mathbf{n} = \\mathbf{s}\\times\\mathbf{t} = (-t_2, t_1)

    Inputs:
        dx: derivative of the point with respect to its coordinate, along the tangent ([2], unit L; a finite number)

    Outputs:
        t: unit tangent of the slide line, in the sequence of its nodes ([2], unit 1; a finite number)
        n: unit normal of the slide line, 90° to the left of the tangent, towards the slave ([2], unit 1; a finite number)

    Accuracy: η at most 3 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining the local basis system (reconstructed: the symbol of the tangent was lost; its words: along the sequence of the nodes).
    """
    def __call__(self, dx: ArrayLike, *, out: Any = None) -> _BasisValue: ...
    def linearize(self, dx: ArrayLike, *, out: Any = None) -> _BasisLinearized: ...
    def exact(self, dx: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisValue: ...
    def exact_linearize(self, dx: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisLinearized: ...

basis: Final[_Basis]

class _LinearPointValue(NamedTuple):
    x: Numbers
    dx: Numbers

class _LinearPointGradient(Gradient):
    x1: Numbers
    x2: Numbers
    g: Numbers

class _LinearPointJacobian(Jacobian):
    x: _LinearPointGradient
    dx: _LinearPointGradient

class _LinearPointLinearized(NamedTuple):
    value: _LinearPointValue
    jacobian: _LinearPointJacobian

class _LinearPoint(Formula):
    """Point of a straight segment.

        \\mathbf{X} = \\tfrac12(1-g)\\,\\mathbf{x}_1 + \\tfrac12(1+g)\\,\\mathbf{x}_2,\\quad \\mathbf{X}' = \\tfrac12(\\mathbf{x}_2-\\mathbf{x}_1)

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)

    Outputs:
        x: point of the slide line, in the plane (r, z) ([2], unit L; a finite number)
        dx: derivative of the point with respect to its coordinate, along the tangent ([2], unit L; a finite number)

    Accuracy: η at most 2 of the value, 1 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining a linear slide line (ours: the section says linear segments; the shape functions are the usual ones).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, out: Any = None) -> _LinearPointValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, out: Any = None) -> _LinearPointLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _LinearPointValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _LinearPointLinearized: ...

linear_point: Final[_LinearPoint]

class _ParabolicPointValue(NamedTuple):
    x: Numbers
    dx: Numbers

class _ParabolicPointGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    g: Numbers

class _ParabolicPointJacobian(Jacobian):
    x: _ParabolicPointGradient
    dx: _ParabolicPointGradient

class _ParabolicPointLinearized(NamedTuple):
    value: _ParabolicPointValue
    jacobian: _ParabolicPointJacobian

class _ParabolicPoint(Formula):
    """Point of a parabolic segment.

        \\begin{aligned} \\mathbf{X} &= \\tfrac12 g(g-1)\\,\\mathbf{x}_1 + (1-g^2)\\,\\mathbf{x}_2 + \\tfrac12 g(g+1)\\,\\mathbf{x}_3,
        \\mathbf{X}' &= (g-\\tfrac12)\\,\\mathbf{x}_1 - 2g\\,\\mathbf{x}_2 + (g+\\tfrac12)\\,\\mathbf{x}_3 \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)

    Outputs:
        x: point of the slide line, in the plane (r, z) ([2], unit L; a finite number)
        dx: derivative of the point with respect to its coordinate, along the tangent ([2], unit L; a finite number)

    Accuracy: η at most 3 of the value, 3 of the Jacobian, inputs from 1/1e40 to 1e40 in size.
    Source: Slide lines, Defining a parabolic slide line (ours: the section says second-order segments; the shape functions are the usual ones).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, out: Any = None) -> _ParabolicPointValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, out: Any = None) -> _ParabolicPointLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ParabolicPointValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ParabolicPointLinearized: ...

parabolic_point: Final[_ParabolicPoint]

class _SmoothedLinearPointValue(NamedTuple):
    x: Numbers
    dx: Numbers

class _SmoothedLinearPointGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    f: Numbers
    t: Numbers

class _SmoothedLinearPointJacobian(Jacobian):
    x: _SmoothedLinearPointGradient
    dx: _SmoothedLinearPointGradient

class _SmoothedLinearPointLinearized(NamedTuple):
    value: _SmoothedLinearPointValue
    jacobian: _SmoothedLinearPointJacobian

class _SmoothedLinearPoint(Formula):
    """Point of a smoothed corner between straight segments.

        \\begin{aligned} \\mathbf{X} &= \\mathbf{x}_2 + f\\bigl[(1-t)^2(\\mathbf{x}_1-\\mathbf{x}_2) + t^2(\\mathbf{x}_3-\\mathbf{x}_2)\\bigr],
        \\mathbf{X}' &= 2f\\bigl[t\\,(\\mathbf{x}_3-\\mathbf{x}_2) - (1-t)(\\mathbf{x}_1-\\mathbf{x}_2)\\bigr] \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        f: smoothing fraction: the part of each segment that is replaced by a smoothed corner (unit 1; a number > 0 and < 0.5)
        t: coordinate along a smoothed corner, from 0 at its start to 1 at its end (unit 1; a number ≥ 0 and ≤ 1)

    Outputs:
        x: point of the slide line, in the plane (r, z) ([2], unit L; a finite number)
        dx: derivative of the point with respect to its coordinate, along the tangent ([2], unit L; a finite number)

    Accuracy: η at most 3 of the value, 3 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Smoothing the slide line (ours: the section on smoothing that it refers to was not given).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, t: ArrayLike, *, out: Any = None) -> _SmoothedLinearPointValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, t: ArrayLike, *, out: Any = None) -> _SmoothedLinearPointLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, t: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SmoothedLinearPointValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, t: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SmoothedLinearPointLinearized: ...

smoothed_linear_point: Final[_SmoothedLinearPoint]

class _SmoothedParabolicPointValue(NamedTuple):
    x: Numbers
    dx: Numbers

class _SmoothedParabolicPointGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    x4: Numbers
    x5: Numbers
    f: Numbers
    t: Numbers

class _SmoothedParabolicPointJacobian(Jacobian):
    x: _SmoothedParabolicPointGradient
    dx: _SmoothedParabolicPointGradient

class _SmoothedParabolicPointLinearized(NamedTuple):
    value: _SmoothedParabolicPointValue
    jacobian: _SmoothedParabolicPointJacobian

class _SmoothedParabolicPoint(Formula):
    """Point of a smoothed corner between parabolic segments.

        \\begin{aligned} \\mathbf{X} &= (1-t)^3\\mathbf{A} + 3(1-t)^2 t\\,\\bigl(\\mathbf{A}+\\tfrac{4f}{3}\\mathbf{A}'\\bigr) + 3(1-t)t^2\\bigl(\\mathbf{B}-\\tfrac{4f}{3}\\mathbf{B}'\\bigr) + t^3\\mathbf{B},
        \\mathbf{X}' &= 4f\\bigl[(1-t)^2\\mathbf{A}' + t^2\\mathbf{B}'\\bigr] + 6(1-t)t\\,\\bigl[\\mathbf{B}-\\mathbf{A}-\\tfrac{4f}{3}(\\mathbf{A}'+\\mathbf{B}')\\bigr],
        \\mathbf{A} &= -f(1-2f)\\,\\mathbf{x}_1 + 4f(1-f)\\,\\mathbf{x}_2 + (1-f)(1-2f)\\,\\mathbf{x}_3, & \\mathbf{A}' &= (\\tfrac12-2f)\\,\\mathbf{x}_1 - 2(1-2f)\\,\\mathbf{x}_2 + (\\tfrac32-2f)\\,\\mathbf{x}_3,
        \\mathbf{B} &= (1-f)(1-2f)\\,\\mathbf{x}_3 + 4f(1-f)\\,\\mathbf{x}_4 - f(1-2f)\\,\\mathbf{x}_5, & \\mathbf{B}' &= (2f-\\tfrac32)\\,\\mathbf{x}_3 + 2(1-2f)\\,\\mathbf{x}_4 + (2f-\\tfrac12)\\,\\mathbf{x}_5 \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x4: position of the fourth node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x5: position of the fifth node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        f: smoothing fraction: the part of each segment that is replaced by a smoothed corner (unit 1; a number > 0 and < 0.5)
        t: coordinate along a smoothed corner, from 0 at its start to 1 at its end (unit 1; a number ≥ 0 and ≤ 1)

    Outputs:
        x: point of the slide line, in the plane (r, z) ([2], unit L; a finite number)
        dx: derivative of the point with respect to its coordinate, along the tangent ([2], unit L; a finite number)

    Accuracy: η at most 4 of the value, 5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Smoothing the slide line (ours: the section on smoothing that it refers to was not given).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, t: ArrayLike, *, out: Any = None) -> _SmoothedParabolicPointValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, t: ArrayLike, *, out: Any = None) -> _SmoothedParabolicPointLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, t: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SmoothedParabolicPointValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, t: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SmoothedParabolicPointLinearized: ...

smoothed_parabolic_point: Final[_SmoothedParabolicPoint]

class _ClosestLinearValue(NamedTuple):
    g: Numbers
    separation: Numbers

class _ClosestLinearGradient(Gradient):
    xs: Numbers
    x1: Numbers
    x2: Numbers

class _ClosestLinearJacobian(Jacobian):
    g: _ClosestLinearGradient
    separation: _ClosestLinearGradient

class _ClosestLinearLinearized(NamedTuple):
    value: _ClosestLinearValue
    jacobian: _ClosestLinearJacobian

class _ClosestLinear(Formula):
    """Closest point of a straight segment.

        g = \\operatorname*{arg\\,min}_{-1 \\le g \\le 1}\\,\\lvert\\mathbf{x}_s-\\mathbf{X}(g)\\rvert,\\quad E_{11} = \\bigl(\\mathbf{x}_s-\\mathbf{X}(g)\\bigr)\\cdot\\mathbf{n}

    Inputs:
        xs: position of the slave point, in the plane (r, z) ([2], unit L; a finite number)
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)

    Outputs:
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)

    Accuracy: η at most 6 of the value, 8 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Element output (ours: the section says separation, and prints no equation).
    """
    def __call__(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, *, out: Any = None) -> _ClosestLinearValue: ...
    def linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, *, out: Any = None) -> _ClosestLinearLinearized: ...
    def exact(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestLinearValue: ...
    def exact_linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestLinearLinearized: ...

closest_linear: Final[_ClosestLinear]

class _ClosestParabolicValue(NamedTuple):
    g: Numbers
    separation: Numbers

class _ClosestParabolicGradient(Gradient):
    xs: Numbers
    x1: Numbers
    x2: Numbers
    x3: Numbers

class _ClosestParabolicJacobian(Jacobian):
    g: _ClosestParabolicGradient
    separation: _ClosestParabolicGradient

class _ClosestParabolicLinearized(NamedTuple):
    value: _ClosestParabolicValue
    jacobian: _ClosestParabolicJacobian

class _ClosestParabolic(Formula):
    """Closest point of a parabolic segment.

        g = \\operatorname*{arg\\,min}_{-1 \\le g \\le 1}\\,\\lvert\\mathbf{x}_s-\\mathbf{X}(g)\\rvert,\\quad E_{11} = \\bigl(\\mathbf{x}_s-\\mathbf{X}(g)\\bigr)\\cdot\\mathbf{n}

    Inputs:
        xs: position of the slave point, in the plane (r, z) ([2], unit L; a finite number)
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)

    Outputs:
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)

    Accuracy: η at most 4 of the value, 8 of the Jacobian, by vectors, inputs from 1/1e3 to 1e3 in size.
    Source: Slide lines, Element output (ours: the section says separation, and prints no equation).
    """
    def __call__(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, out: Any = None) -> _ClosestParabolicValue: ...
    def linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, out: Any = None) -> _ClosestParabolicLinearized: ...
    def exact(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestParabolicValue: ...
    def exact_linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestParabolicLinearized: ...

closest_parabolic: Final[_ClosestParabolic]

class _ClosestSmoothedLinearValue(NamedTuple):
    t: Numbers
    separation: Numbers

class _ClosestSmoothedLinearGradient(Gradient):
    xs: Numbers
    x1: Numbers
    x2: Numbers
    x3: Numbers
    f: Numbers

class _ClosestSmoothedLinearJacobian(Jacobian):
    t: _ClosestSmoothedLinearGradient
    separation: _ClosestSmoothedLinearGradient

class _ClosestSmoothedLinearLinearized(NamedTuple):
    value: _ClosestSmoothedLinearValue
    jacobian: _ClosestSmoothedLinearJacobian

class _ClosestSmoothedLinear(Formula):
    """Closest point of a smoothed corner between straight segments.

        t = \\operatorname*{arg\\,min}_{0 \\le t \\le 1}\\,\\lvert\\mathbf{x}_s-\\mathbf{X}(t)\\rvert,\\quad E_{11} = \\bigl(\\mathbf{x}_s-\\mathbf{X}(t)\\bigr)\\cdot\\mathbf{n}

    Inputs:
        xs: position of the slave point, in the plane (r, z) ([2], unit L; a finite number)
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        f: smoothing fraction: the part of each segment that is replaced by a smoothed corner (unit 1; a number > 0 and < 0.5)

    Outputs:
        t: coordinate along a smoothed corner, from 0 at its start to 1 at its end (unit 1; a number ≥ 0 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)

    Accuracy: η at most 4 of the value, 48 of the Jacobian, inputs from 1/1e3 to 1e3 in size.
    Source: Slide lines, Smoothing the slide line (ours: the section on smoothing that it refers to was not given).
    """
    def __call__(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, *, out: Any = None) -> _ClosestSmoothedLinearValue: ...
    def linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, *, out: Any = None) -> _ClosestSmoothedLinearLinearized: ...
    def exact(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestSmoothedLinearValue: ...
    def exact_linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, f: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestSmoothedLinearLinearized: ...

closest_smoothed_linear: Final[_ClosestSmoothedLinear]

class _ClosestSmoothedParabolicValue(NamedTuple):
    t: Numbers
    separation: Numbers

class _ClosestSmoothedParabolicGradient(Gradient):
    xs: Numbers
    x1: Numbers
    x2: Numbers
    x3: Numbers
    x4: Numbers
    x5: Numbers
    f: Numbers

class _ClosestSmoothedParabolicJacobian(Jacobian):
    t: _ClosestSmoothedParabolicGradient
    separation: _ClosestSmoothedParabolicGradient

class _ClosestSmoothedParabolicLinearized(NamedTuple):
    value: _ClosestSmoothedParabolicValue
    jacobian: _ClosestSmoothedParabolicJacobian

class _ClosestSmoothedParabolic(Formula):
    """Closest point of a smoothed corner between parabolic segments.

        t = \\operatorname*{arg\\,min}_{0 \\le t \\le 1}\\,\\lvert\\mathbf{x}_s-\\mathbf{X}(t)\\rvert,\\quad E_{11} = \\bigl(\\mathbf{x}_s-\\mathbf{X}(t)\\bigr)\\cdot\\mathbf{n}

    Inputs:
        xs: position of the slave point, in the plane (r, z) ([2], unit L; a finite number)
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x4: position of the fourth node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x5: position of the fifth node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        f: smoothing fraction: the part of each segment that is replaced by a smoothed corner (unit 1; a number > 0 and < 0.5)

    Outputs:
        t: coordinate along a smoothed corner, from 0 at its start to 1 at its end (unit 1; a number ≥ 0 and ≤ 1)
        separation: separation of the slave point from the slide line along its normal, positive when open (unit L; a finite number)

    Accuracy: η at most 4 of the value, 512 of the Jacobian, inputs from 1/1e3 to 1e3 in size.
    Source: Slide lines, Smoothing the slide line (ours: the section on smoothing that it refers to was not given).
    """
    def __call__(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, *, out: Any = None) -> _ClosestSmoothedParabolicValue: ...
    def linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, *, out: Any = None) -> _ClosestSmoothedParabolicLinearized: ...
    def exact(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestSmoothedParabolicValue: ...
    def exact_linearize(self, xs: ArrayLike, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, x4: ArrayLike, x5: ArrayLike, f: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ClosestSmoothedParabolicLinearized: ...

closest_smoothed_parabolic: Final[_ClosestSmoothedParabolic]

class _SlipIncrementLinearValue(NamedTuple):
    dslip: Numbers

class _SlipIncrementLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers
    g: Numbers
    dxs: Numbers
    dx1: Numbers
    dx2: Numbers

class _SlipIncrementLinearJacobian(Jacobian):
    dslip: _SlipIncrementLinearGradient

class _SlipIncrementLinearLinearized(NamedTuple):
    value: _SlipIncrementLinearValue
    jacobian: _SlipIncrementLinearJacobian

class _SlipIncrementLinear(Formula):
    """Slip increment on a straight segment.

        \\Delta E_{12} = \\mathbf{t}\\cdot\\Bigl(\\Delta\\mathbf{x}_s - \\sum_{i=1}^{2} N_i\\,\\Delta\\mathbf{x}_i\\Bigr),\\quad N_1 = \\tfrac12(1-g),\\quad N_2 = \\tfrac12(1+g)

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        dxs: displacement increment of the slave point ([2], unit L; a finite number)
        dx1: displacement increment of the first node in sequence ([2], unit L; a finite number)
        dx2: displacement increment of the second node in sequence ([2], unit L; a finite number)

    Outputs:
        dslip: increment of the tangential displacement of the slave point relative to the slide line (unit L; a finite number)

    Accuracy: η at most 4 of the value, 5 of the Jacobian, inputs from 1/1e20 to 1e20 in size.
    Source: Slide lines, Element output (ours: the section says accumulated tangential displacement, and prints no equation).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, *, out: Any = None) -> _SlipIncrementLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, *, out: Any = None) -> _SlipIncrementLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SlipIncrementLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SlipIncrementLinearLinearized: ...

slip_increment_linear: Final[_SlipIncrementLinear]

class _SlipIncrementParabolicValue(NamedTuple):
    dslip: Numbers

class _SlipIncrementParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    g: Numbers
    dxs: Numbers
    dx1: Numbers
    dx2: Numbers
    dx3: Numbers

class _SlipIncrementParabolicJacobian(Jacobian):
    dslip: _SlipIncrementParabolicGradient

class _SlipIncrementParabolicLinearized(NamedTuple):
    value: _SlipIncrementParabolicValue
    jacobian: _SlipIncrementParabolicJacobian

class _SlipIncrementParabolic(Formula):
    """Slip increment on a parabolic segment.

        \\Delta E_{12} = \\mathbf{t}\\cdot\\Bigl(\\Delta\\mathbf{x}_s - \\sum_{i=1}^{3} N_i\\,\\Delta\\mathbf{x}_i\\Bigr),\\quad N_1 = \\tfrac12 g(g-1),\\quad N_2 = 1-g^2,\\quad N_3 = \\tfrac12 g(g+1)

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        g: coordinate along a segment, from -1 at its first node to 1 at its last (unit 1; a number ≥ -1 and ≤ 1)
        dxs: displacement increment of the slave point ([2], unit L; a finite number)
        dx1: displacement increment of the first node in sequence ([2], unit L; a finite number)
        dx2: displacement increment of the second node in sequence ([2], unit L; a finite number)
        dx3: displacement increment of the third node in sequence ([2], unit L; a finite number)

    Outputs:
        dslip: increment of the tangential displacement of the slave point relative to the slide line (unit L; a finite number)

    Accuracy: η at most 4 of the value, 5 of the Jacobian, inputs from 1/1e10 to 1e10 in size.
    Source: Slide lines, Element output (ours: the section says accumulated tangential displacement, and prints no equation).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, dx3: ArrayLike, *, out: Any = None) -> _SlipIncrementParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, dx3: ArrayLike, *, out: Any = None) -> _SlipIncrementParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, dx3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SlipIncrementParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, g: ArrayLike, dxs: ArrayLike, dx1: ArrayLike, dx2: ArrayLike, dx3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _SlipIncrementParabolicLinearized: ...

slip_increment_parabolic: Final[_SlipIncrementParabolic]

class _ContactAreaLinearValue(NamedTuple):
    a1: Numbers
    a2: Numbers

class _ContactAreaLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers

class _ContactAreaLinearJacobian(Jacobian):
    a1: _ContactAreaLinearGradient
    a2: _ContactAreaLinearGradient

class _ContactAreaLinearLinearized(NamedTuple):
    value: _ContactAreaLinearValue
    jacobian: _ContactAreaLinearJacobian

class _ContactAreaLinear(Formula):
    """Contact areas of ISL21A.

        A_i = 2\\pi r_i\\,\\tfrac{\\ell}{2},\\quad r_i = x_{i,1}\\quad (i = 1, 2),\\quad \\ell = \\lvert\\mathbf{x}_2-\\mathbf{x}_1\\rvert

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)

    Outputs:
        a1: contact area of the first node, around the whole circumference (unit L^2; a finite number ≥ 0)
        a2: contact area of the second node, around the whole circumference (unit L^2; a finite number ≥ 0)

    Accuracy: η at most 3 of the value, 4 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining slide line elements (slave surface) (ours: the section says current length times width; the shares of the nodes are ours).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, *, out: Any = None) -> _ContactAreaLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, *, out: Any = None) -> _ContactAreaLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactAreaLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactAreaLinearLinearized: ...

contact_area_linear: Final[_ContactAreaLinear]

class _ContactAreaParabolicValue(NamedTuple):
    a1: Numbers
    a2: Numbers
    a3: Numbers

class _ContactAreaParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers

class _ContactAreaParabolicJacobian(Jacobian):
    a1: _ContactAreaParabolicGradient
    a2: _ContactAreaParabolicGradient
    a3: _ContactAreaParabolicGradient

class _ContactAreaParabolicLinearized(NamedTuple):
    value: _ContactAreaParabolicValue
    jacobian: _ContactAreaParabolicJacobian

class _ContactAreaParabolic(Formula):
    """Contact areas of ISL22A.

        A_i = 2\\pi r_i\\,w_i\\,\\lvert\\mathbf{X}'(g_i)\\rvert,\\quad r_i = x_{i,1}\\quad (i = 1, 2, 3),\\quad (w_1, w_2, w_3) = (\\tfrac13, \\tfrac43, \\tfrac13),\\quad (g_1, g_2, g_3) = (-1, 0, 1)

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)

    Outputs:
        a1: contact area of the first node, around the whole circumference (unit L^2; a finite number ≥ 0)
        a2: contact area of the second node, around the whole circumference (unit L^2; a finite number ≥ 0)
        a3: contact area of the third node, around the whole circumference (unit L^2; a finite number ≥ 0)

    Accuracy: η at most 3 of the value, 6 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Slide lines, Defining slide line elements (slave surface) (ours: the section says current length times width; the shares of the nodes are ours).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, out: Any = None) -> _ContactAreaParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, out: Any = None) -> _ContactAreaParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactAreaParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ContactAreaParabolicLinearized: ...

contact_area_parabolic: Final[_ContactAreaParabolic]

class _TorqueLinearValue(NamedTuple):
    t: Numbers

class _TorqueLinearGradient(Gradient):
    x1: Numbers
    x2: Numbers
    p1: Numbers
    p2: Numbers

class _TorqueLinearJacobian(Jacobian):
    t: _TorqueLinearGradient

class _TorqueLinearLinearized(NamedTuple):
    value: _TorqueLinearValue
    jacobian: _TorqueLinearJacobian

class _TorqueLinear(Formula):
    """Torque over ISL21A.

        T = 2\\pi\\ell\\left[p_1\\Bigl(\\tfrac{r_1^2}{4}+\\tfrac{r_1 r_2}{6}+\\tfrac{r_2^2}{12}\\Bigr) + p_2\\Bigl(\\tfrac{r_1^2}{12}+\\tfrac{r_1 r_2}{6}+\\tfrac{r_2^2}{4}\\Bigr)\\right],\\quad r_i = x_{i,1}\\quad (i = 1, 2),\\quad \\ell = \\lvert\\mathbf{x}_2-\\mathbf{x}_1\\rvert

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        p1: contact pressure at the first node, positive in compression (unit F/L^2; a finite number ≥ 0)
        p2: contact pressure at the second node, positive in compression (unit F/L^2; a finite number ≥ 0)

    Outputs:
        t: largest torque about the z axis that the interface can transmit with friction coefficient 1 (unit FL; a finite number)

    Accuracy: η at most 3 of the value, 12 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Slide lines, Obtaining the “maximum torque” that can be transmitted across axisymmetric slide lines (ours: the integral of r² p is printed; how r and p go along an element, and the integration, are ours).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, p1: ArrayLike, p2: ArrayLike, *, out: Any = None) -> _TorqueLinearValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, p1: ArrayLike, p2: ArrayLike, *, out: Any = None) -> _TorqueLinearLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, p1: ArrayLike, p2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueLinearValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, p1: ArrayLike, p2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueLinearLinearized: ...

torque_linear: Final[_TorqueLinear]

class _TorqueParabolicValue(NamedTuple):
    t: Numbers

class _TorqueParabolicGradient(Gradient):
    x1: Numbers
    x2: Numbers
    x3: Numbers
    p1: Numbers
    p2: Numbers
    p3: Numbers

class _TorqueParabolicJacobian(Jacobian):
    t: _TorqueParabolicGradient

class _TorqueParabolicLinearized(NamedTuple):
    value: _TorqueParabolicValue
    jacobian: _TorqueParabolicJacobian

class _TorqueParabolic(Formula):
    """Torque over ISL22A.

        \\begin{aligned} T &= 2\\pi \\sum_{q=1}^{5} w_q\\, r(g_q)^2\\, p(g_q)\\, \\lvert\\mathbf{X}'(g_q)\\rvert,\\quad r(g) = \\sum_{i=1}^{3} N_i(g)\\,r_i,\\quad p(g) = \\sum_{i=1}^{3} N_i(g)\\,p_i,
        N_1(g) &= \\tfrac12 g(g-1),\\quad N_2(g) = 1-g^2,\\quad N_3(g) = \\tfrac12 g(g+1),\\quad r_i = x_{i,1}\\quad (i = 1, 2, 3),
        g_5 &= \\tfrac13\\sqrt{5+2\\sqrt{\\tfrac{10}{7}}},\\quad g_4 = \\tfrac13\\sqrt{5-2\\sqrt{\\tfrac{10}{7}}},\\quad g_3 = 0,\\quad g_2 = -g_4,\\quad g_1 = -g_5,
        w_5 &= \\tfrac{322-13\\sqrt{70}}{900},\\quad w_4 = \\tfrac{322+13\\sqrt{70}}{900},\\quad w_3 = \\tfrac{128}{225},\\quad w_2 = w_4,\\quad w_1 = w_5 \\end{aligned}

    Inputs:
        x1: position of the first node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x2: position of the second node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        x3: position of the third node in sequence, in the plane (r, z) ([2], unit L; a finite number)
        p1: contact pressure at the first node, positive in compression (unit F/L^2; a finite number ≥ 0)
        p2: contact pressure at the second node, positive in compression (unit F/L^2; a finite number ≥ 0)
        p3: contact pressure at the third node, positive in compression (unit F/L^2; a finite number ≥ 0)

    Outputs:
        t: largest torque about the z axis that the interface can transmit with friction coefficient 1 (unit FL; a finite number)

    Accuracy: η at most 16 of the value, 96 of the Jacobian, inputs from 1/1e3 to 1e3 in size.
    Source: Slide lines, Obtaining the “maximum torque” that can be transmitted across axisymmetric slide lines (ours: the integral of r² p is printed; how r and p go along an element, and the integration, are ours).
    """
    def __call__(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, *, out: Any = None) -> _TorqueParabolicValue: ...
    def linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, *, out: Any = None) -> _TorqueParabolicLinearized: ...
    def exact(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueParabolicValue: ...
    def exact_linearize(self, x1: ArrayLike, x2: ArrayLike, x3: ArrayLike, p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, *, number: Callable[[str], Any] = ...) -> _TorqueParabolicLinearized: ...

torque_parabolic: Final[_TorqueParabolic]
