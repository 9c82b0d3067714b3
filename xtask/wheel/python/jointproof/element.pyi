# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _ArmValue(NamedTuple):
    m_node: Numbers
    k_arm: Numbers

class _ArmGradient(Gradient):
    r: Numbers
    f: Numbers
    m: Numbers

class _ArmJacobian(Jacobian):
    m_node: _ArmGradient
    k_arm: _ArmGradient

class _ArmLinearized(NamedTuple):
    value: _ArmValue
    jacobian: _ArmJacobian

class _Arm(Formula):
    """A rigid arm between node and connector.

        \\mathbf{m}_{\\mathrm{node}} = \\mathbf{m} + \\mathbf{r}\\times\\mathbf{f},\\quad \\mathbf{K}_{\\mathrm{arm}} = \\mathbf{r}\\otimes\\mathbf{f} - (\\mathbf{r}\\cdot\\mathbf{f})\\,\\mathbf{I}

    Inputs:
        r: rigid arm from a node to the point of the connector, in the global frame ([3], unit L; a finite number)
        f: force at the end of a rigid arm, in the global frame ([3], unit F; a finite number)
        m: moment at the end of a rigid arm, in the global frame ([3], unit FL; a finite number)

    Outputs:
        m_node: moment on the node from the force and the moment at the end of the arm, in the global frame ([3], unit FL; a finite number)
        k_arm: derivative of the moment of the force about the node by its spin, at constant force ([3, 3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page has the connector at its nodes; programs put rigid arms between).
    """
    def __call__(self, r: ArrayLike, f: ArrayLike, m: ArrayLike, *, out: Any = None) -> _ArmValue: ...
    def linearize(self, r: ArrayLike, f: ArrayLike, m: ArrayLike, *, out: Any = None) -> _ArmLinearized: ...
    def exact(self, r: ArrayLike, f: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ArmValue: ...
    def exact_linearize(self, r: ArrayLike, f: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ArmLinearized: ...

arm: Final[_Arm]

class _RotationVectorValue(NamedTuple):
    m_psi: Numbers

class _RotationVectorGradient(Gradient):
    psi: Numbers
    m: Numbers

class _RotationVectorJacobian(Jacobian):
    m_psi: _RotationVectorGradient

class _RotationVectorLinearized(NamedTuple):
    value: _RotationVectorValue
    jacobian: _RotationVectorJacobian

class _RotationVector(Formula):
    """A moment on a rotation vector.

        \\begin{aligned} \\mathbf{m}_\\psi &= A\\,\\mathbf{m} - B\\,\\boldsymbol{\\psi}\\times\\mathbf{m} + C\\,(\\boldsymbol{\\psi}\\cdot\\mathbf{m})\\,\\boldsymbol{\\psi},\\quad \\psi = \\lvert\\boldsymbol{\\psi}\\rvert,\\quad A = \\begin{cases} 1 & \\psi = 0
        \\frac{\\sin\\psi}{\\psi} & \\text{otherwise} \\end{cases},
        B &= \\begin{cases} \\tfrac12 & \\psi = 0
        \\frac{1-\\cos\\psi}{\\psi^2} & \\text{otherwise} \\end{cases},\\quad C = \\begin{cases} \\tfrac16 & \\psi = 0
        \\frac{\\psi-\\sin\\psi}{\\psi^3} & \\text{otherwise} \\end{cases} \\end{aligned}

    Inputs:
        psi: rotation vector of a node: it is turned by its length, in radians, about its direction ([3], unit 1; a finite number)
        m: moment on the node: what does its work on spins, in the global frame ([3], unit FL; a finite number)

    Outputs:
        m_psi: what does the work of the moment on the rotation vector ([3], unit FL; a finite number)

    Accuracy: η at most 4 of the value, 12 of the Jacobian, by vectors, inputs from 1/1e10 to 1e10 in size.
    Source: UJOINT, Description (ours: the page turns its nodes; programs have different unknowns for that).
    """
    def __call__(self, psi: ArrayLike, m: ArrayLike, *, out: Any = None) -> _RotationVectorValue: ...
    def linearize(self, psi: ArrayLike, m: ArrayLike, *, out: Any = None) -> _RotationVectorLinearized: ...
    def exact(self, psi: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RotationVectorValue: ...
    def exact_linearize(self, psi: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _RotationVectorLinearized: ...

rotation_vector: Final[_RotationVector]

class _EulerParametersValue(NamedTuple):
    m_q0: Numbers
    m_q: Numbers

class _EulerParametersGradient(Gradient):
    q0: Numbers
    q: Numbers
    m: Numbers

class _EulerParametersJacobian(Jacobian):
    m_q0: _EulerParametersGradient
    m_q: _EulerParametersGradient

class _EulerParametersLinearized(NamedTuple):
    value: _EulerParametersValue
    jacobian: _EulerParametersJacobian

class _EulerParameters(Formula):
    """A moment on Euler parameters.

        m_{q0} = -2\\,\\mathbf{q}\\cdot\\mathbf{m},\\quad \\mathbf{m}_q = 2\\,(q_0\\,\\mathbf{m} - \\mathbf{q}\\times\\mathbf{m})

    Inputs:
        q0: the first of the Euler parameters of a node: the cosine of half its turn (unit 1; a finite number)
        q: the other Euler parameters: the axis of the turn times the sine of half of it ([3], unit 1; a finite number)
        m: moment on the node: what does its work on spins, in the global frame ([3], unit FL; a finite number)

    Outputs:
        m_q0: what does the work of the moment on the first Euler parameter (unit FL; a finite number)
        m_q: what does the work of the moment on the other Euler parameters ([3], unit FL; a finite number)

    Accuracy: η at most 1.5 of the value, 1 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: UJOINT, Description (ours: the page turns its nodes; programs have different unknowns for that).
    """
    def __call__(self, q0: ArrayLike, q: ArrayLike, m: ArrayLike, *, out: Any = None) -> _EulerParametersValue: ...
    def linearize(self, q0: ArrayLike, q: ArrayLike, m: ArrayLike, *, out: Any = None) -> _EulerParametersLinearized: ...
    def exact(self, q0: ArrayLike, q: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _EulerParametersValue: ...
    def exact_linearize(self, q0: ArrayLike, q: ArrayLike, m: ArrayLike, *, number: Callable[[str], Any] = ...) -> _EulerParametersLinearized: ...

euler_parameters: Final[_EulerParameters]
