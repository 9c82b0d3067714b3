"""A printed formula over arrays: what is called, and what it computes with."""

import math
from functools import cached_property, lru_cache
from typing import Any

import array_api_compat as compat
import numpy as np

from ..formula import Jacobian, Linearized, broadcast


class Library:
    """The functions that printed formulas call, of one library in one precision. None has NaN as a derivative where a formula has one,
    unless it is not ``derived``: then what a choice does not take may be NaN, which saves the choices that keep it finite."""

    def __init__(self, xp, dtype, derived=True):
        self.xp, self.dtype, self.derived, self.nan = xp, dtype, derived, math.nan
        self.is_jax, self.is_torch = compat.is_jax_namespace(xp), compat.is_torch_namespace(xp)
        #: 2^27 + 1 in doubles.
        self.splitter = 2.0 ** round(-math.log2(xp.finfo(dtype).eps) / 2 + 0.6) + 1.0
        for name in ("abs", "sqrt", "sin", "cos", "asin", "exp", "expm1", "atan2", "maximum", "where"):
            setattr(self, name, getattr(xp, name))

    @cached_property
    def plain(self):
        """The same for what nothing is derived from."""
        return Library(self.xp, self.dtype, derived=False) if self.derived else self

    def run(self, printed, numbers):
        """The results of printed lines, as arrays."""
        if self.derived and self.is_jax:
            from ..jax import plain_until_derived

            return plain_until_derived(printed)(self, *numbers)
        return full(self, printed(self, *numbers), numbers)

    def safe(self, needed, x, number):
        """An operand where its result is needed, and a safe number elsewhere."""
        return self.where(needed, x, number) if self.derived else x

    def constants(self, condition, yes, no):
        """One of two numbers, in this precision."""
        return self.xp.where(condition, self.xp.asarray(yes, dtype=self.dtype), self.xp.asarray(no, dtype=self.dtype))

    def norm(self, *parts):
        """The length of a vector, with the derivative 0 at the zero vector."""
        square = sum((x * x for x in parts[1:]), parts[0] * parts[0])
        if not self.derived:
            return self.sqrt(square)
        is_zero = square == 0.0
        return self.where(is_zero, 0.0, self.sqrt(self.where(is_zero, 1.0, square)))

    def multiply_add(self, x, y, z):
        """x y + z, where it is compared with 0: what rounding leaves of the product counts (Dekker)."""
        product = x * y
        (a, b), (c, d) = self._halves(x), self._halves(y)
        return (product + z) + (b * d - (((product - a * c) - b * c) - a * d))

    def _halves(self, x):
        large = x * self.splitter
        high = large - (large - x)
        return high, x - high

    def nearest_integer(self, x):
        """Of two that are equally near, the one farther from 0."""
        whole = self.xp.trunc(x)
        return self.where(self.abs(x - whole) < 0.5, whole, whole + self.sign(x))

    def sign(self, x):
        """−1, 0 or 1; NaN of NaN."""
        # That of PyTorch is 0 for NaN, and mended by writing into it, which cannot be mapped.
        return x.sign() + 0.0 * x if self.is_torch else self.xp.sign(x)

    def finite(self, x):
        """A number, NaN if it is not finite; its derivative is 1."""
        return x + 0.0 * self.still(x) if self.derived else x + 0.0 * x

    def still(self, x):
        """The same number, from which nothing is derived."""
        if self.is_jax:
            from jax.lax import stop_gradient

            return stop_gradient(x)
        return x.detach() if self.is_torch else x

    def reused(self, x):
        """A quotient that is used more than once, rounded to the precision that it has: XLA divides where that is used, and would keep
        the quotient itself in memory."""
        if not self.is_jax:
            return x
        from jax.lax import reduce_precision

        bits = self.xp.finfo(self.dtype)
        return reduce_precision(x, bits.nexp, bits.nmant)

    def are_finite(self, *x):
        """Whether all numbers are."""
        finite = self.xp.isfinite(x[0])
        for one in x[1:]:
            finite = finite & self.xp.isfinite(one)
        return finite

    def joined(self, parts):
        """Components along a last axis."""
        # Not stacked, for JAX maps that along another axis.
        return self.xp.concat([x[..., None] for x in parts], axis=-1)

    def parts(self, x):
        """The components along the last axis."""
        if not self.is_jax:
            return [x[..., k] for k in range(x.shape[-1])]
        # Backwards this joins what the components have; slices would add arrays with zeros beside each.
        return [self.xp.reshape(part, x.shape[:-1]) for part in self.xp.split(x, x.shape[-1], axis=-1)]


@lru_cache
def library(xp, dtype):
    is_plain = compat.is_numpy_namespace(xp) or compat.is_cupy_namespace(xp) or compat.is_dask_namespace(xp)
    return Library(xp, dtype, derived=not is_plain)


def in_one_library(names, given):
    """The library of inputs of these names, and these as its arrays in one precision, on one device; numbers and arrays of NumPy go along
    with arrays of others."""
    arrays = [x for x in given if compat.is_array_api_obj(x)]
    arrays = [x for x in arrays if not compat.is_numpy_array(x)] or arrays or [np.asarray(0.0)]
    xp = compat.array_namespace(*arrays)
    floating = [x.dtype for x in arrays if xp.isdtype(x.dtype, "real floating")]
    lib = library(xp, xp.result_type(*floating) if floating else xp.asarray(0.0).dtype)
    device = None if compat.is_jax_array(arrays[0]) else compat.device(arrays[0])

    def array(name, x):
        if isinstance(x, (int, float)):
            return xp.asarray(x, dtype=lib.dtype, device=device)
        if not any(x is one for one in arrays):
            x = xp.asarray(x, device=device)
        if not xp.isdtype(x.dtype, ("bool", "integral", "real floating")):
            raise TypeError(f"{name}: numbers of type {x.dtype} are not real")
        return x if x.dtype == lib.dtype else xp.astype(x, lib.dtype)

    return lib, [array(*one) for one in zip(names, given)]


def components(lib, fields, inputs):
    """The components of all fields, broadcast against each other, and the shape of each."""
    leading = []
    for field, x in zip(fields, inputs):
        axes = len(field.shape)
        if axes and tuple(x.shape[x.ndim - axes :]) != field.shape:
            raise field.misshapen(x.shape)
        leading.append(tuple(x.shape[: x.ndim - axes]))
    shape = leading[0]
    if any(other != shape for other in leading):
        shape = broadcast([field.name for field in fields], leading)
    numbers = []
    for field, x, own in zip(fields, inputs, leading):
        x = x if own == shape else lib.xp.broadcast_to(x, shape + field.shape)
        numbers += lib.parts(lib.xp.reshape(x, (*shape, field.size))) if field.shape else [x]
    return numbers, shape


def full(lib, results, numbers):
    """Results that are the same everywhere as arrays."""
    if isinstance(results, tuple):
        return tuple(full(lib, y, numbers) for y in results)
    return results + lib.xp.zeros_like(numbers[0]) if isinstance(results, float) else results


class Missing:
    """A formula that is not here, and why."""

    def __init__(self, id, why):
        self.id, self.why = id, why

    def error(self):
        return NotImplementedError(f"{self.id} over arrays: {self.why}; jointproof.{self.id} computes it in NumPy")

    def __call__(self, *args, **kwargs):
        raise self.error()

    linearize = __call__


class Function:
    """A formula over arrays of any library with the Array API: NumPy, JAX, PyTorch, CuPy and others, in the precision and on the
    device of its inputs. It is called as the formula is. What is not allowed gives NaN, or with ``checked=True`` the formula's error.

    Frameworks trace, map, compile and differentiate it. Numbers that over- or underflow when they are squared are left alone."""

    def __init__(self, id: str, value: Any, linearized: Any, accepted: Any, entries: tuple[tuple[int, int], ...]) -> None:
        from .. import find

        self.formula = find(id)
        self.id, self.__name__, self.__doc__ = id, self.formula.__name__, self.formula.__doc__
        self.__signature__ = self.formula.__signature__
        #: The places in the Jacobian, output and input, of the entries that are not always 0; None if the formula has none in closed form.
        self.entries = entries if linearized else None
        self._value, self._linearized, self._accepted = value, linearized, accepted

    def __repr__(self):
        return f"<{self.id} over arrays>"

    def __call__(self, *args: Any, checked: bool = False, **kwargs: Any) -> Any:
        lib, inputs = in_one_library(self.formula._input_names, self.formula._bound(args, kwargs))
        numbers, shape = self.components(lib, inputs, checked)
        with np.errstate(all="ignore"):
            return self.packed(lib, self.value(lib, *numbers), shape)

    def linearize(self, *args: Any, checked: bool = False, **kwargs: Any) -> Linearized:
        """Value and Jacobian together, as the formula has them, the Jacobian in closed form."""
        if self.entries is None:
            raise NotImplementedError(f"{self.id}: its Jacobian is automatic; let the library of your arrays derive it")
        lib, inputs = in_one_library(self.formula._input_names, self.formula._bound(args, kwargs))
        numbers, shape = self.components(lib, inputs, checked)
        with np.errstate(all="ignore"):
            values, entries = self.linearized(lib, *numbers)
            zero = lib.xp.zeros_like(numbers[0])
            dense = [zero] * (self.formula.m * self.formula.n)
            for (i, j), entry in zip(self.entries, entries):
                dense[i * self.formula.n + j] = zero + entry
            array = lib.xp.reshape(lib.joined(dense), (*shape, self.formula.m, self.formula.n))
            return Linearized(self.packed(lib, values, shape), Jacobian(array, self.formula._outputs, self.formula._inputs))

    def value(self, lib, *numbers):
        """The components of the outputs from those of the inputs, NaN where these are not allowed."""
        return lib.run(self._value, numbers)

    def linearized(self, lib, *numbers):
        """The same, and the entries of the Jacobian that are not always 0."""
        return lib.run(self._linearized, numbers)

    def components(self, lib, inputs, checked=False):
        """The components of all inputs, broadcast against each other, and the shape of each."""
        numbers, shape = components(lib, self.formula.inputs, inputs)
        if checked:
            self.check(lib, numbers)
        return numbers, shape

    def check(self, lib, numbers):
        """Raises the formula's error for what is not allowed."""
        holds = lib.xp.all(self._accepted(lib, *numbers))
        if lib.is_jax:
            from ..jax import check_traced

            if check_traced(self, holds):
                return
        try:
            holds = bool(holds)
        except RuntimeError:
            why = "checked=True looks at numbers, which torch.func.vmap does not show; without it, what is not allowed gives NaN"
            raise TypeError(f"{self.id}: {why}") from None
        if not holds:
            told = [np.asarray(x.cpu() if lib.is_torch else x) for x in map(lib.still, numbers)]
            self.formula(**self.formula.unpack(np.stack(told, axis=-1)))
            raise ValueError(f"{self.id}: what is allowed in doubles is not in {lib.dtype}")

    def packed(self, lib, numbers, shape):
        """The results by names, from their components."""
        results = []
        for field in self.formula.outputs:
            parts = numbers[field.places]
            results.append(lib.xp.reshape(lib.joined(parts), (*shape, *field.shape)) if field.shape else parts[0])
        return self.formula.Value(*results)
