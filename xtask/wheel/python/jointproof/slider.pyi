# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _RowsValue(NamedTuple):
    g1_u1: Numbers
    g1_un: Numbers
    g1_um: Numbers
    g2_u1: Numbers
    g2_un: Numbers
    g2_um: Numbers

class _RowsGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers

class _RowsJacobian(Jacobian):
    g1_u1: _RowsGradient
    g1_un: _RowsGradient
    g1_um: _RowsGradient
    g2_u1: _RowsGradient
    g2_un: _RowsGradient
    g2_um: _RowsGradient

class _RowsLinearized(NamedTuple):
    value: _RowsValue
    jacobian: _RowsJacobian

class _Rows(Formula):
    """Rows of SLIDER.

        \\mathbf{g}_{q,u1} = -(1-\\xi)\\,\\mathbf{t}_q,\\quad \\mathbf{g}_{q,un} = -\\xi\\,\\mathbf{t}_q,\\quad \\mathbf{g}_{q,um} = \\mathbf{t}_q\\quad (q = 1, 2)

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)

    Outputs:
        g1_u1: derivative of the first residual of SLIDER by the translation of node 1, with m on the line ([3], unit 1; a finite number)
        g1_un: derivative of the first residual of SLIDER by the translation of node n, with m on the line ([3], unit 1; a finite number)
        g1_um: derivative of the first residual of SLIDER by the translation of node m, with m on the line ([3], unit 1; a finite number)
        g2_u1: derivative of the second residual of SLIDER by the translation of node 1, with m on the line ([3], unit 1; a finite number)
        g2_un: derivative of the second residual of SLIDER by the translation of node n, with m on the line ([3], unit 1; a finite number)
        g2_um: derivative of the second residual of SLIDER by the translation of node m, with m on the line ([3], unit 1; a finite number)

    Accuracy: η at most 5 of the value, 8 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (ours: the page has the constraints and their increments, without multipliers).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _RowsValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _RowsLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RowsLinearized: ...

rows: Final[_Rows]

class _NodalForcesValue(NamedTuple):
    force_1: Numbers
    force_n: Numbers
    force_m: Numbers

class _NodalForcesGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    lambda_1: Numbers
    lambda_2: Numbers

class _NodalForcesJacobian(Jacobian):
    force_1: _NodalForcesGradient
    force_n: _NodalForcesGradient
    force_m: _NodalForcesGradient

class _NodalForcesLinearized(NamedTuple):
    value: _NodalForcesValue
    jacobian: _NodalForcesJacobian

class _NodalForces(Formula):
    """Nodal forces of SLIDER.

        \\mathbf{f}_m = \\lambda_1\\,\\mathbf{t}_1 + \\lambda_2\\,\\mathbf{t}_2,\\quad \\mathbf{f}_1 = -(1-\\xi)\\,\\mathbf{f}_m,\\quad \\mathbf{f}_n = -\\xi\\,\\mathbf{f}_m

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)
        lambda_1: multiplier of SLIDER's first residual: the force on node m along t1 (unit F; a finite number)
        lambda_2: multiplier of SLIDER's second residual: the force on node m along t2 (unit F; a finite number)

    Outputs:
        force_1: force of the constraint on node 1, in the global frame ([3], unit F; a finite number)
        force_n: force of the constraint on node n, in the global frame ([3], unit F; a finite number)
        force_m: force of the constraint on node m, in the global frame ([3], unit F; a finite number)

    Accuracy: η at most 4 of the value, 6 of the Jacobian, by vectors, inputs from 1/1e80 to 1e80 in size.
    Source: Sliding constraint (ours: the page has the constraints and their increments, without multipliers).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, out: Any = None) -> _NodalForcesValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, out: Any = None) -> _NodalForcesLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForcesLinearized: ...

nodal_forces: Final[_NodalForces]

class _GeometricStiffnessValue(NamedTuple):
    k_u1_u1: Numbers
    k_u1_un: Numbers
    k_un_un: Numbers
    k_um_un: Numbers

class _GeometricStiffnessGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    lambda_1: Numbers
    lambda_2: Numbers

class _GeometricStiffnessJacobian(Jacobian):
    k_u1_u1: _GeometricStiffnessGradient
    k_u1_un: _GeometricStiffnessGradient
    k_un_un: _GeometricStiffnessGradient
    k_um_un: _GeometricStiffnessGradient

class _GeometricStiffnessLinearized(NamedTuple):
    value: _GeometricStiffnessValue
    jacobian: _GeometricStiffnessJacobian

class _GeometricStiffness(Formula):
    """Geometric stiffness of SLIDER.

        \\begin{aligned} \\mathbf{P} &= \\frac{\\lambda_2}{l}\\Bigl(\\frac{\\mathbf{n}\\cdot\\mathbf{e}}{h}\\,\\mathbf{t}_1\\otimes\\mathbf{t}_1 - \\mathbf{n}\\otimes\\mathbf{t}_2\\Bigr) - \\frac{\\lambda_1}{l h}\\,(\\mathbf{e}\\times\\mathbf{t}_1)\\otimes\\mathbf{t}_1,
        \\mathbf{Q} &= \\frac{\\lambda_2}{l}\\Bigl(\\frac{\\mathbf{n}\\cdot\\mathbf{e}}{h}\\,\\mathbf{t}_1\\otimes\\mathbf{t}_1 - \\mathbf{t}_2\\otimes\\mathbf{n}\\Bigr) - \\frac{\\lambda_1}{l h}\\,\\mathbf{t}_1\\otimes(\\mathbf{e}\\times\\mathbf{t}_1),
        \\mathbf{K}_{um,un} &= \\mathbf{P},\\quad \\mathbf{K}_{u1,un} = \\xi\\,\\mathbf{Q} - (1-\\xi)\\,\\mathbf{P},\\quad \\mathbf{K}_{u1,u1} = (1-\\xi)(\\mathbf{P}+\\mathbf{Q}),\\quad \\mathbf{K}_{un,un} = -\\xi\\,(\\mathbf{P}+\\mathbf{Q}),
        h &= \\lvert\\mathbf{n}\\times\\mathbf{e}\\rvert,\\quad \\mathbf{e} = \\begin{cases} \\mathbf{i} & \\mathbf{n}\\times\\mathbf{i} \\ne \\mathbf{0}
        \\mathbf{k} & \\text{otherwise} \\end{cases} \\end{aligned}

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)
        lambda_1: multiplier of SLIDER's first residual: the force on node m along t1 (unit F; a finite number)
        lambda_2: multiplier of SLIDER's second residual: the force on node m along t2 (unit F; a finite number)

    Outputs:
        k_u1_u1: derivative of the force on node 1 by the translation of node 1, at constant multipliers ([3, 3], unit F/L; a finite number)
        k_u1_un: derivative of the force on node 1 by the translation of node n, at constant multipliers ([3, 3], unit F/L; a finite number)
        k_un_un: derivative of the force on node n by the translation of node n, at constant multipliers ([3, 3], unit F/L; a finite number)
        k_um_un: derivative of the force on node m by the translation of node n, at constant multipliers ([3, 3], unit F/L; a finite number)

    Accuracy: η at most 5 of the value, 32 of the Jacobian, by vectors, inputs from 1/1e20 to 1e20 in size.
    Source: Sliding constraint (ours: the page has the constraints and their increments, without multipliers).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, out: Any = None) -> _GeometricStiffnessValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, out: Any = None) -> _GeometricStiffnessLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_1: ArrayLike, lambda_2: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffnessLinearized: ...

geometric_stiffness: Final[_GeometricStiffness]

class _Rows2dValue(NamedTuple):
    g_u1: Numbers
    g_un: Numbers
    g_um: Numbers

class _Rows2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers

class _Rows2dJacobian(Jacobian):
    g_u1: _Rows2dGradient
    g_un: _Rows2dGradient
    g_um: _Rows2dGradient

class _Rows2dLinearized(NamedTuple):
    value: _Rows2dValue
    jacobian: _Rows2dJacobian

class _Rows2d(Formula):
    """Row of SLIDER in the plane.

        \\mathbf{g}_{u1} = -(1-\\xi)\\,\\mathbf{t},\\quad \\mathbf{g}_{un} = -\\xi\\,\\mathbf{t},\\quad \\mathbf{g}_{um} = \\mathbf{t},\\quad \\mathbf{t} = \\mathbf{s}\\times\\mathbf{n}

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)

    Outputs:
        g_u1: derivative of the residual of SLIDER in the plane by the translation of node 1, with m on the line ([2], unit 1; a finite number)
        g_un: derivative of the residual of SLIDER in the plane by the translation of node n, with m on the line ([2], unit 1; a finite number)
        g_um: derivative of the residual of SLIDER in the plane by the translation of node m, with m on the line ([2], unit 1; a finite number)

    Accuracy: η at most 4 of the value, 8 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (ours: the page has the constraint and its increment, without a multiplier).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _Rows2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _Rows2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Rows2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Rows2dLinearized: ...

rows_2d: Final[_Rows2d]

class _NodalForces2dValue(NamedTuple):
    force_1: Numbers
    force_n: Numbers
    force_m: Numbers

class _NodalForces2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    lambda_: Numbers

class _NodalForces2dJacobian(Jacobian):
    force_1: _NodalForces2dGradient
    force_n: _NodalForces2dGradient
    force_m: _NodalForces2dGradient

class _NodalForces2dLinearized(NamedTuple):
    value: _NodalForces2dValue
    jacobian: _NodalForces2dJacobian

class _NodalForces2d(Formula):
    """Nodal forces of SLIDER in the plane.

        \\mathbf{f}_m = \\lambda\\,\\mathbf{t},\\quad \\mathbf{f}_1 = -(1-\\xi)\\,\\mathbf{f}_m,\\quad \\mathbf{f}_n = -\\xi\\,\\mathbf{f}_m,\\quad \\mathbf{t} = \\mathbf{s}\\times\\mathbf{n}

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)
        lambda_: multiplier of SLIDER's residual in the plane: the force on node m along t (unit F; a finite number)

    Outputs:
        force_1: force of the constraint on node 1 in the plane, in the global frame ([2], unit F; a finite number)
        force_n: force of the constraint on node n in the plane, in the global frame ([2], unit F; a finite number)
        force_m: force of the constraint on node m in the plane, in the global frame ([2], unit F; a finite number)

    Accuracy: η at most 4 of the value, 8 of the Jacobian, inputs from 1/1e80 to 1e80 in size.
    Source: Sliding constraint (ours: the page has the constraint and its increment, without a multiplier).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _NodalForces2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _NodalForces2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForces2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _NodalForces2dLinearized: ...

nodal_forces_2d: Final[_NodalForces2d]

class _GeometricStiffness2dValue(NamedTuple):
    k_u1_u1: Numbers
    k_u1_un: Numbers
    k_un_un: Numbers
    k_um_un: Numbers

class _GeometricStiffness2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    lambda_: Numbers

class _GeometricStiffness2dJacobian(Jacobian):
    k_u1_u1: _GeometricStiffness2dGradient
    k_u1_un: _GeometricStiffness2dGradient
    k_un_un: _GeometricStiffness2dGradient
    k_um_un: _GeometricStiffness2dGradient

class _GeometricStiffness2dLinearized(NamedTuple):
    value: _GeometricStiffness2dValue
    jacobian: _GeometricStiffness2dJacobian

class _GeometricStiffness2d(Formula):
    """Geometric stiffness of SLIDER in the plane.

        \\begin{aligned} \\mathbf{P} &= -\\frac{\\lambda}{l}\\,\\mathbf{n}\\otimes\\mathbf{t},\\quad \\mathbf{Q} = -\\frac{\\lambda}{l}\\,\\mathbf{t}\\otimes\\mathbf{n},\\quad \\mathbf{t} = \\mathbf{s}\\times\\mathbf{n},
        \\mathbf{K}_{um,un} &= \\mathbf{P},\\quad \\mathbf{K}_{u1,un} = \\xi\\,\\mathbf{Q} - (1-\\xi)\\,\\mathbf{P},\\quad \\mathbf{K}_{u1,u1} = (1-\\xi)(\\mathbf{P}+\\mathbf{Q}),\\quad \\mathbf{K}_{un,un} = -\\xi\\,(\\mathbf{P}+\\mathbf{Q}) \\end{aligned}

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)
        lambda_: multiplier of SLIDER's residual in the plane: the force on node m along t (unit F; a finite number)

    Outputs:
        k_u1_u1: derivative of the force on node 1 by the translation of node 1 in the plane, at constant multipliers ([2, 2], unit F/L; a finite number)
        k_u1_un: derivative of the force on node 1 by the translation of node n in the plane, at constant multipliers ([2, 2], unit F/L; a finite number)
        k_un_un: derivative of the force on node n by the translation of node n in the plane, at constant multipliers ([2, 2], unit F/L; a finite number)
        k_um_un: derivative of the force on node m by the translation of node n in the plane, at constant multipliers ([2, 2], unit F/L; a finite number)

    Accuracy: η at most 4 of the value, 12 of the Jacobian, inputs from 1/1e80 to 1e80 in size.
    Source: Sliding constraint (ours: the page has the constraint and its increment, without a multiplier).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffness2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, out: Any = None) -> _GeometricStiffness2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffness2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, lambda_: ArrayLike, *, number: Callable[[str], Any] = ...) -> _GeometricStiffness2dLinearized: ...

geometric_stiffness_2d: Final[_GeometricStiffness2d]

class _LineValue(NamedTuple):
    n: Numbers
    l: Numbers

class _LineGradient(Gradient):
    x1: Numbers
    xn: Numbers

class _LineJacobian(Jacobian):
    n: _LineGradient
    l: _LineGradient

class _LineLinearized(NamedTuple):
    value: _LineValue
    jacobian: _LineJacobian

class _Line(Formula):
    """Line.

        l = \\lvert\\mathbf{x}_n-\\mathbf{x}_1\\rvert,\\quad \\mathbf{n} = (\\mathbf{x}_n-\\mathbf{x}_1)/l

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)

    Outputs:
        n: direction of the line, from node 1 to node n ([3], unit 1; a finite number)
        l: distance from node 1 to node n (unit L; a finite number > 0)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the direction of the line, and its length).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, *, out: Any = None) -> _LineValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, *, out: Any = None) -> _LineLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _LineValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _LineLinearized: ...

line: Final[_Line]

class _BasisValue(NamedTuple):
    t1: Numbers
    t2: Numbers

class _BasisGradient(Gradient):
    n: Numbers

class _BasisJacobian(Jacobian):
    t1: _BasisGradient
    t2: _BasisGradient

class _BasisLinearized(NamedTuple):
    value: _BasisValue
    jacobian: _BasisJacobian

class _Basis(Formula):
    """Directions across the line.

        \\mathbf{t}_1 = \\begin{cases} \\mathbf{n}\\times\\mathbf{i}/\\lvert\\mathbf{n}\\times\\mathbf{i}\\rvert & \\mathbf{n}\\times\\mathbf{i}\\ne\\mathbf{0}
        \\mathbf{n}\\times\\mathbf{k}/\\lvert\\mathbf{n}\\times\\mathbf{k}\\rvert & \\text{otherwise}\\end{cases},\\quad \\mathbf{t}_2 = \\mathbf{n}\\times\\mathbf{t}_1

    Inputs:
        n: direction of the line, from node 1 to node n ([3], unit 1; a finite number)

    Outputs:
        t1: first direction normal to the line ([3], unit 1; a finite number)
        t2: second direction normal to the line ([3], unit 1; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: a unit normal to the line, unless it vanishes, and the orthogonal normal).
    """
    def __call__(self, n: ArrayLike, *, out: Any = None) -> _BasisValue: ...
    def linearize(self, n: ArrayLike, *, out: Any = None) -> _BasisLinearized: ...
    def exact(self, n: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisValue: ...
    def exact_linearize(self, n: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisLinearized: ...

basis: Final[_Basis]

class _ConstraintValue(NamedTuple):
    g1: Numbers
    g2: Numbers

class _ConstraintGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers

class _ConstraintJacobian(Jacobian):
    g1: _ConstraintGradient
    g2: _ConstraintGradient

class _ConstraintLinearized(NamedTuple):
    value: _ConstraintValue
    jacobian: _ConstraintJacobian

class _Constraint(Formula):
    """Constraint.

        g_q = (\\mathbf{x}_m-\\mathbf{x}_1)\\cdot\\mathbf{t}_q,\\quad q = 1, 2

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)

    Outputs:
        g1: distance of node m from the line along t1, zero when m is on the line (unit L; a finite number)
        g2: distance of node m from the line along t2, zero when m is on the line (unit L; a finite number)

    Accuracy: η at most 4 of the value, 6 of the Jacobian, by vectors, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the line from node 1 to m is perpendicular to both normals).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _ConstraintValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _ConstraintLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ConstraintLinearized: ...

constraint: Final[_Constraint]

class _EliminateValue(NamedTuple):
    xmi: Numbers
    xmj: Numbers

class _EliminateGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xmk: Numbers

class _EliminateJacobian(Jacobian):
    xmi: _EliminateGradient
    xmj: _EliminateGradient

class _EliminateLinearized(NamedTuple):
    value: _EliminateValue
    jacobian: _EliminateJacobian

class _Eliminate(Formula):
    """Elimination.

        \\begin{aligned} x_{m,i} &= x_{1,i} + \\frac{n_i}{n_k}(x_{m,k}-x_{1,k}),\\quad x_{m,j} = x_{1,j} + \\frac{n_j}{n_k}(x_{m,k}-x_{1,k}),
        (i, j, k) &= \\begin{cases} (2, 1, 3) & \\lvert d_3\\rvert \\ge \\lvert d_2\\rvert,\\ d_2^2 + d_3^2 \\ge \\lvert d_1 d_3\\rvert,\\ d_3 \\ne 0
        (2, 3, 1) & \\lvert d_3\\rvert \\ge \\lvert d_2\\rvert
        (3, 1, 2) & d_2^2 + d_3^2 \\ge \\lvert d_1 d_2\\rvert
        (3, 2, 1) & \\text{otherwise} \\end{cases},\\quad \\mathbf{d} = \\mathbf{x}_n-\\mathbf{x}_1 \\end{aligned}

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xmk: coordinate of node m along the retained axis k (unit L; a finite number)

    Outputs:
        xmi: coordinate of node m along the first eliminated axis, i (unit L; a finite number)
        xmj: coordinate of node m along the second eliminated axis, j (unit L; a finite number)

    Accuracy: η at most 2 of the value, 2 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: eliminate i and j, the axes of the largest projections of the normals).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, out: Any = None) -> _EliminateValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, out: Any = None) -> _EliminateLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _EliminateValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _EliminateLinearized: ...

eliminate: Final[_Eliminate]

class _DirectionVariationValue(NamedTuple):
    dn: Numbers
    dl: Numbers

class _DirectionVariationGradient(Gradient):
    x1: Numbers
    xn: Numbers
    dx1: Numbers
    dxn: Numbers

class _DirectionVariationJacobian(Jacobian):
    dn: _DirectionVariationGradient
    dl: _DirectionVariationGradient

class _DirectionVariationLinearized(NamedTuple):
    value: _DirectionVariationValue
    jacobian: _DirectionVariationJacobian

class _DirectionVariation(Formula):
    """Variation of the direction.

        \\mathrm{d}l = \\mathbf{n}\\cdot(\\mathrm{d}\\mathbf{x}_n-\\mathrm{d}\\mathbf{x}_1),\\quad \\mathrm{d}\\mathbf{n} = \\bigl((\\mathrm{d}\\mathbf{x}_n-\\mathrm{d}\\mathbf{x}_1) - \\mathrm{d}l\\,\\mathbf{n}\\bigr)/l

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        dx1: increment of the position of node 1 ([3], unit L; a finite number)
        dxn: increment of the position of node n ([3], unit L; a finite number)

    Outputs:
        dn: variation of the direction of the line ([3], unit 1; a finite number)
        dl: variation of the distance from node 1 to node n (unit L; a finite number)

    Accuracy: η at most 5 of the value, 6 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the change of the direction, from its definition).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, *, out: Any = None) -> _DirectionVariationValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, *, out: Any = None) -> _DirectionVariationLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DirectionVariationValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _DirectionVariationLinearized: ...

direction_variation: Final[_DirectionVariation]

class _BasisVariationValue(NamedTuple):
    dt1: Numbers
    dt2: Numbers

class _BasisVariationGradient(Gradient):
    n: Numbers
    dn: Numbers

class _BasisVariationJacobian(Jacobian):
    dt1: _BasisVariationGradient
    dt2: _BasisVariationGradient

class _BasisVariationLinearized(NamedTuple):
    value: _BasisVariationValue
    jacobian: _BasisVariationJacobian

class _BasisVariation(Formula):
    """Variation of the directions across.

        \\mathrm{d}\\mathbf{t}_1 = \\frac{\\mathrm{d}\\mathbf{n}\\times\\mathbf{e} - \\bigl(\\mathbf{t}_1\\cdot(\\mathrm{d}\\mathbf{n}\\times\\mathbf{e})\\bigr)\\,\\mathbf{t}_1}{\\lvert\\mathbf{n}\\times\\mathbf{e}\\rvert},\\quad \\mathrm{d}\\mathbf{t}_2 = \\mathrm{d}\\mathbf{n}\\times\\mathbf{t}_1 + \\mathbf{n}\\times\\mathrm{d}\\mathbf{t}_1,\\quad \\mathbf{e} = \\begin{cases} \\mathbf{i} & \\mathbf{n}\\times\\mathbf{i} \\ne \\mathbf{0}
        \\mathbf{k} & \\text{otherwise} \\end{cases}

    Inputs:
        n: direction of the line, from node 1 to node n ([3], unit 1; a finite number)
        dn: variation of the direction of the line ([3], unit 1; a finite number)

    Outputs:
        dt1: variation of the first direction normal to the line ([3], unit 1; a finite number)
        dt2: variation of the second direction normal to the line ([3], unit 1; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the changes of both normals in the derivatives of the constraints).
    """
    def __call__(self, n: ArrayLike, dn: ArrayLike, *, out: Any = None) -> _BasisVariationValue: ...
    def linearize(self, n: ArrayLike, dn: ArrayLike, *, out: Any = None) -> _BasisVariationLinearized: ...
    def exact(self, n: ArrayLike, dn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisVariationValue: ...
    def exact_linearize(self, n: ArrayLike, dn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _BasisVariationLinearized: ...

basis_variation: Final[_BasisVariation]

class _IncrementalConstraintValue(NamedTuple):
    r1: Numbers
    r2: Numbers

class _IncrementalConstraintGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    dx1: Numbers
    dxn: Numbers
    dxm: Numbers

class _IncrementalConstraintJacobian(Jacobian):
    r1: _IncrementalConstraintGradient
    r2: _IncrementalConstraintGradient

class _IncrementalConstraintLinearized(NamedTuple):
    value: _IncrementalConstraintValue
    jacobian: _IncrementalConstraintJacobian

class _IncrementalConstraint(Formula):
    """Incremental constraint.

        r_q = \\mathbf{t}_q\\cdot\\bigl(\\mathrm{d}\\mathbf{x}_m - (1-\\xi)\\,\\mathrm{d}\\mathbf{x}_1 - \\xi\\,\\mathrm{d}\\mathbf{x}_n\\bigr),\\quad \\xi = (\\mathbf{x}_m-\\mathbf{x}_1)\\cdot\\mathbf{n}/l,\\quad q = 1, 2

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)
        dx1: increment of the position of node 1 ([3], unit L; a finite number)
        dxn: increment of the position of node n ([3], unit L; a finite number)
        dxm: increment of the position of node m ([3], unit L; a finite number)

    Outputs:
        r1: residual of the first incremental condition (unit L; a finite number)
        r2: residual of the second incremental condition (unit L; a finite number)

    Accuracy: η at most 4 of the value, 6 of the Jacobian, by vectors, inputs from 1/1e50 to 1e50 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the derivatives of the constraints, reduced).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, out: Any = None) -> _IncrementalConstraintValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, out: Any = None) -> _IncrementalConstraintLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementalConstraintValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementalConstraintLinearized: ...

incremental_constraint: Final[_IncrementalConstraint]

class _IncrementValue(NamedTuple):
    dxmi: Numbers
    dxmj: Numbers

class _IncrementGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    dx1: Numbers
    dxn: Numbers
    dxmk: Numbers

class _IncrementJacobian(Jacobian):
    dxmi: _IncrementGradient
    dxmj: _IncrementGradient

class _IncrementLinearized(NamedTuple):
    value: _IncrementValue
    jacobian: _IncrementJacobian

class _Increment(Formula):
    """Eliminated increments.

        \\mathrm{d}x_{m,i} = w_i + \\frac{n_i}{n_k}(\\mathrm{d}x_{m,k}-w_k),\\quad \\mathrm{d}x_{m,j} = w_j + \\frac{n_j}{n_k}(\\mathrm{d}x_{m,k}-w_k),\\quad \\mathbf{w} = (1-\\xi)\\,\\mathrm{d}\\mathbf{x}_1 + \\xi\\,\\mathrm{d}\\mathbf{x}_n

    Inputs:
        x1: position of node 1, where the line begins ([3], unit L; a finite number)
        xn: position of node n, where the line ends ([3], unit L; a finite number)
        xm: position of node m, which must lie on the line ([3], unit L; a finite number)
        dx1: increment of the position of node 1 ([3], unit L; a finite number)
        dxn: increment of the position of node n ([3], unit L; a finite number)
        dxmk: increment of the retained coordinate of node m (unit L; a finite number)

    Outputs:
        dxmi: increment of the first eliminated coordinate of node m (unit L; a finite number)
        dxmj: increment of the second eliminated coordinate of node m (unit L; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the incremental constraints, solved for the eliminated increments).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, out: Any = None) -> _IncrementValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, out: Any = None) -> _IncrementLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementLinearized: ...

increment: Final[_Increment]

class _Constraint2dValue(NamedTuple):
    g: Numbers

class _Constraint2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers

class _Constraint2dJacobian(Jacobian):
    g: _Constraint2dGradient

class _Constraint2dLinearized(NamedTuple):
    value: _Constraint2dValue
    jacobian: _Constraint2dJacobian

class _Constraint2d(Formula):
    """Constraint in the plane.

        g = (\\mathbf{x}_m-\\mathbf{x}_1)\\cdot\\mathbf{t},\\quad \\mathbf{t} = \\mathbf{s}\\times\\mathbf{n} = (-n_2, n_1)

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)

    Outputs:
        g: distance of node m from the line along t, positive to the left of the line (unit L; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: in the plane one constraint remains).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _Constraint2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, out: Any = None) -> _Constraint2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Constraint2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Constraint2dLinearized: ...

constraint_2d: Final[_Constraint2d]

class _Eliminate2dValue(NamedTuple):
    xmi: Numbers

class _Eliminate2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xmk: Numbers

class _Eliminate2dJacobian(Jacobian):
    xmi: _Eliminate2dGradient

class _Eliminate2dLinearized(NamedTuple):
    value: _Eliminate2dValue
    jacobian: _Eliminate2dJacobian

class _Eliminate2d(Formula):
    """Elimination in the plane.

        x_{m,i} = x_{1,i} + \\frac{n_i}{n_k}(x_{m,k}-x_{1,k})

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xmk: coordinate of node m along the retained axis k (unit L; a finite number)

    Outputs:
        xmi: coordinate of node m along the eliminated axis i in the plane (unit L; a finite number)

    Accuracy: η at most 2 of the value, 2 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: Sliding constraint (ours: the condition is there, its symbols lost; to solve it for the larger component is ours).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, out: Any = None) -> _Eliminate2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, out: Any = None) -> _Eliminate2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Eliminate2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Eliminate2dLinearized: ...

eliminate_2d: Final[_Eliminate2d]

class _IncrementalConstraint2dValue(NamedTuple):
    r: Numbers

class _IncrementalConstraint2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    dx1: Numbers
    dxn: Numbers
    dxm: Numbers

class _IncrementalConstraint2dJacobian(Jacobian):
    r: _IncrementalConstraint2dGradient

class _IncrementalConstraint2dLinearized(NamedTuple):
    value: _IncrementalConstraint2dValue
    jacobian: _IncrementalConstraint2dJacobian

class _IncrementalConstraint2d(Formula):
    """Incremental constraint in the plane.

        r = \\mathbf{t}\\cdot\\bigl(\\mathrm{d}\\mathbf{x}_m - (1-\\xi)\\,\\mathrm{d}\\mathbf{x}_1 - \\xi\\,\\mathrm{d}\\mathbf{x}_n\\bigr),\\quad \\mathbf{t} = (-n_2, n_1)

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)
        dx1: increment of the position of node 1 in the plane ([2], unit L; a finite number)
        dxn: increment of the position of node n in the plane ([2], unit L; a finite number)
        dxm: increment of the position of node m in the plane ([2], unit L; a finite number)

    Outputs:
        r: residual of the incremental condition in the plane, positive to the left of the line (unit L; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e50 to 1e50 in size.
    Source: Sliding constraint (reconstructed: every symbol was lost; the words: the derivative of the one constraint).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, out: Any = None) -> _IncrementalConstraint2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, out: Any = None) -> _IncrementalConstraint2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementalConstraint2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxm: ArrayLike, *, number: Callable[[str], Any] = ...) -> _IncrementalConstraint2dLinearized: ...

incremental_constraint_2d: Final[_IncrementalConstraint2d]

class _Increment2dValue(NamedTuple):
    dxmi: Numbers

class _Increment2dGradient(Gradient):
    x1: Numbers
    xn: Numbers
    xm: Numbers
    dx1: Numbers
    dxn: Numbers
    dxmk: Numbers

class _Increment2dJacobian(Jacobian):
    dxmi: _Increment2dGradient

class _Increment2dLinearized(NamedTuple):
    value: _Increment2dValue
    jacobian: _Increment2dJacobian

class _Increment2d(Formula):
    """Eliminated increment in the plane.

        \\mathrm{d}x_{m,i} = w_i + \\frac{n_i}{n_k}(\\mathrm{d}x_{m,k}-w_k),\\quad \\mathbf{w} = (1-\\xi)\\,\\mathrm{d}\\mathbf{x}_1 + \\xi\\,\\mathrm{d}\\mathbf{x}_n,\\quad (i, k) = \\begin{cases} (2, 1) & \\lvert d_1\\rvert \\ge \\lvert d_2\\rvert
        (1, 2) & \\text{otherwise} \\end{cases},\\quad \\mathbf{d} = \\mathbf{x}_n-\\mathbf{x}_1

    Inputs:
        x1: position of node 1 in the plane, where the line begins ([2], unit L; a finite number)
        xn: position of node n in the plane, where the line ends ([2], unit L; a finite number)
        xm: position of node m in the plane, which must lie on the line ([2], unit L; a finite number)
        dx1: increment of the position of node 1 in the plane ([2], unit L; a finite number)
        dxn: increment of the position of node n in the plane ([2], unit L; a finite number)
        dxmk: increment of the retained coordinate of node m (unit L; a finite number)

    Outputs:
        dxmi: increment of the first eliminated coordinate of node m (unit L; a finite number)

    Accuracy: η at most 3 of the value, 5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: Sliding constraint (ours: the derivative is there, its symbols lost; to solve it for the larger component is ours).
    """
    def __call__(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, out: Any = None) -> _Increment2dValue: ...
    def linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, out: Any = None) -> _Increment2dLinearized: ...
    def exact(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Increment2dValue: ...
    def exact_linearize(self, x1: ArrayLike, xn: ArrayLike, xm: ArrayLike, dx1: ArrayLike, dxn: ArrayLike, dxmk: ArrayLike, *, number: Callable[[str], Any] = ...) -> _Increment2dLinearized: ...

increment_2d: Final[_Increment2d]
