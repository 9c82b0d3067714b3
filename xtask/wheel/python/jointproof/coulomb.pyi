# Generated from the catalog by xtask/wheel/stubs.py; do not edit.
from typing import Any, Callable, Final, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from .formula import Formula, Gradient, Jacobian

Numbers: TypeAlias = float | np.ndarray[Any, np.dtype[np.float64]]

class _YieldValue(NamedTuple):
    phi: Numbers

class _YieldGradient(Gradient):
    p: Numbers
    mu: Numbers
    fn: Numbers

class _YieldJacobian(Jacobian):
    phi: _YieldGradient

class _YieldLinearized(NamedTuple):
    value: _YieldValue
    jacobian: _YieldJacobian

class _Yield(Formula):
    """Yield function.

        \\Phi = P - \\mu F_N

    Inputs:
        p: magnitude of the frictional tangential tractions (unit F; a finite number ≥ 0)
        mu: friction coefficient (unit 1; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)

    Outputs:
        phi: yield function: stick below 0, slip at 0 (unit F; a finite number)

    Accuracy: η at most 2 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Friction (printed).
    """
    def __call__(self, p: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _YieldValue: ...
    def linearize(self, p: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _YieldLinearized: ...
    def exact(self, p: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _YieldValue: ...
    def exact_linearize(self, p: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _YieldLinearized: ...

yield_: Final[_Yield]

class _ReturnMapValue(NamedTuple):
    f: Numbers

class _ReturnMapGradient(Gradient):
    f_trial: Numbers
    mu: Numbers
    fn: Numbers

class _ReturnMapJacobian(Jacobian):
    f: _ReturnMapGradient

class _ReturnMapLinearized(NamedTuple):
    value: _ReturnMapValue
    jacobian: _ReturnMapJacobian

class _ReturnMap(Formula):
    """Return map.

        f = \\begin{cases} f^{\\mathrm{trial}} & \\lvert f^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N \\operatorname{sign} f^{\\mathrm{trial}} & \\text{otherwise}\\end{cases}

    Inputs:
        f_trial: trial force: the tangential force if the contact sticks (unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)

    Outputs:
        f: friction force, positive where it resists positive motion (unit F; a finite number)

    Accuracy: η at most 1 of the value, 0 of the Jacobian, inputs from 1/1e250 to 1e250 in size.
    Source: SLOT, Friction (ours: the page says when it sticks and that the force is then μ F_N; the return of a trial force is the usual one).
    """
    def __call__(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ReturnMapValue: ...
    def linearize(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ReturnMapLinearized: ...
    def exact(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReturnMapValue: ...
    def exact_linearize(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReturnMapLinearized: ...

return_map: Final[_ReturnMap]

class _ReturnMap2dValue(NamedTuple):
    f: Numbers

class _ReturnMap2dGradient(Gradient):
    f_trial: Numbers
    mu: Numbers
    fn: Numbers

class _ReturnMap2dJacobian(Jacobian):
    f: _ReturnMap2dGradient

class _ReturnMap2dLinearized(NamedTuple):
    value: _ReturnMap2dValue
    jacobian: _ReturnMap2dJacobian

class _ReturnMap2d(Formula):
    """Return map on a surface.

        \\mathbf{f} = \\begin{cases} \\mathbf{f}^{\\mathrm{trial}} & \\lvert\\mathbf{f}^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N\\,\\mathbf{f}^{\\mathrm{trial}}/\\lvert\\mathbf{f}^{\\mathrm{trial}}\\rvert & \\text{otherwise}\\end{cases}

    Inputs:
        f_trial: trial force on a surface: the tangential force if the contact sticks ([2], unit F; a finite number)
        mu: friction coefficient (unit 1; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)

    Outputs:
        f: friction force on a surface, in the direction of the motion that it resists ([2], unit F; a finite number)

    Accuracy: η at most 2.5 of the value, 4 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Friction (ours: the page has one direction of sliding; on a surface the force has the direction of the trial force).
    """
    def __call__(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ReturnMap2dValue: ...
    def linearize(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ReturnMap2dLinearized: ...
    def exact(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReturnMap2dValue: ...
    def exact_linearize(self, f_trial: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ReturnMap2dLinearized: ...

return_map_2d: Final[_ReturnMap2d]

class _ResponseValue(NamedTuple):
    f: Numbers
    slip: Numbers

class _ResponseGradient(Gradient):
    u: Numbers
    slip_before: Numbers
    k_el: Numbers
    mu: Numbers
    fn: Numbers

class _ResponseJacobian(Jacobian):
    f: _ResponseGradient
    slip: _ResponseGradient

class _ResponseLinearized(NamedTuple):
    value: _ResponseValue
    jacobian: _ResponseJacobian

class _Response(Formula):
    """Friction after a motion.

        f = \\begin{cases} f^{\\mathrm{trial}} & \\lvert f^{\\mathrm{trial}}\\rvert < \\mu F_N
        \\mu F_N \\operatorname{sign} f^{\\mathrm{trial}} & \\text{otherwise}\\end{cases},\\quad f^{\\mathrm{trial}} = k_{\\mathrm{el}}(u-u_0^{\\mathrm{slip}}),\\quad u^{\\mathrm{slip}} = u - \\frac{f}{k_{\\mathrm{el}}}

    Inputs:
        u: relative motion in the direction of the tangential force (unit L; a finite number)
        slip_before: slip before the increment: the motion at which the tangential force would be 0 (unit L; a finite number)
        k_el: stiffness in stick (unit F/L; a finite number > 0)
        mu: friction coefficient (unit 1; a finite number ≥ 0)
        fn: normal force that produces friction (unit F; a finite number ≥ 0)

    Outputs:
        f: friction force, positive where it resists positive motion (unit F; a finite number)
        slip: slip after the increment: the motion at which the tangential force would be 0 (unit L; a finite number)

    Accuracy: η at most 1.5 of the value, 1.5 of the Jacobian, inputs from 1/1e120 to 1e120 in size.
    Source: SLOT, Friction (ours: the page says when it sticks; stick at a finite stiffness, from the motion and what has slipped before, is the usual one).
    """
    def __call__(self, u: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ResponseValue: ...
    def linearize(self, u: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, out: Any = None) -> _ResponseLinearized: ...
    def exact(self, u: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ResponseValue: ...
    def exact_linearize(self, u: ArrayLike, slip_before: ArrayLike, k_el: ArrayLike, mu: ArrayLike, fn: ArrayLike, *, number: Callable[[str], Any] = ...) -> _ResponseLinearized: ...

response: Final[_Response]
