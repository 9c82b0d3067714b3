"""A formula as a function over arrays."""

import inspect
import keyword
import math
from collections import namedtuple
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from . import _jointproof
from .errors import InputError, ShapeError


def named(name):
    """A name of the documents in Python, whose own words get an underscore: ``lambda_``, ``yield_``."""
    return name + "_" * keyword.iskeyword(name)


def _refused_as_array(gradient, inputs):
    raise TypeError(f"{gradient!r} has blocks of several shapes; take one, as .{next(iter(inputs))}, or the Jacobian's .array")


class Field:
    """An input or an output: ``name``, ``latex``, ``shape``, ``unit``, ``allowed`` (in words), ``meaning``."""

    __slots__ = ("name", "latex", "shape", "unit", "allowed", "meaning", "size", "start")
    name: str
    latex: str
    shape: tuple[int, ...]
    unit: str
    allowed: str
    meaning: str
    size: int
    start: int

    def __init__(self, said, start):
        self.name = named(said["name"])
        self.latex = said["latex"]
        self.shape = tuple(said["shape"])
        self.unit = said["unit"]
        self.allowed = said["allowed"]
        self.meaning = said["meaning"]
        self.size = math.prod(self.shape)
        self.start = start

    def __repr__(self):
        return f"<{self.name}: {self.meaning}>"

    def __reduce__(self):
        return _field, tuple(getattr(self, name) for name in self.__slots__)

    @property
    def places(self):
        """The places of its components among those of all fields."""
        return slice(self.start, self.start + self.size)

    def misshapen(self, shape):
        """The error of an array of this shape."""
        return ShapeError(self.name, f"shape {list(shape)}; allowed is […, {', '.join(map(str, self.shape))}]")

    def of(self, packed):
        """Its part of an array whose last axis has the components of all fields: a view."""
        part = packed[..., self.places]
        return part.reshape(packed.shape[:-1] + self.shape)[()]


def _field(*parts):
    field = Field.__new__(Field)
    for name, part in zip(Field.__slots__, parts):
        setattr(field, name, part)
    return field


def fields_of(said):
    fields, start = [], 0
    for field in said:
        fields.append(Field(field, start))
        start += fields[-1].size
    return tuple(fields)


class Gradient:
    """The derivatives of an output, by the names of the inputs: ``jacobian.fc.f2``, of the shape of the call, then of the
    output, then of the input."""

    __slots__ = ("_rows", "_output", "_inputs")

    def __init__(self, rows, output, inputs):
        self._rows, self._output, self._inputs = rows, output, inputs

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name not in self._inputs:
            raise AttributeError(f"there is no input {name!r}; there are {', '.join(self._inputs)}")
        field = self._inputs[name]
        block = self._rows[..., field.places]
        return block.reshape(self._rows.shape[:-2] + self._output.shape + field.shape)[()]

    __getitem__ = __getattr__

    def __dir__(self):
        return list(self._inputs)

    def __repr__(self):
        return f"<Gradient of {self._output.name} by {', '.join(self._inputs)}>"

    def __array__(self, dtype=None, copy=None):
        return _refused_as_array(self, self._inputs)

    def __reduce__(self):
        return Gradient, (self._rows, self._output, self._inputs)


class Jacobian:
    """The derivatives of all outputs by all inputs. ``array`` is all of it, its last two axes the components of the outputs and
    of the inputs in order; ``jacobian.fc.f2`` is ∂fc/∂f2, a view of it."""

    __slots__ = ("array", "_outputs", "_inputs")
    array: Any

    def __init__(self, array, outputs, inputs):
        self.array, self._outputs, self._inputs = array, outputs, inputs

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if name not in self._outputs:
            raise AttributeError(f"there is no output {name!r}; there are {', '.join(self._outputs)}")
        field = self._outputs[name]
        return Gradient(self.array[..., field.places, :], field, self._inputs)

    __getitem__ = __getattr__

    def __dir__(self):
        return ["array", *self._outputs]

    def __repr__(self):
        return f"<Jacobian of {', '.join(self._outputs)} by {', '.join(self._inputs)}, {self.array.shape}>"

    def __array__(self, dtype=None, copy=None):
        array = np.asarray(self.array, dtype)
        return array.copy() if copy else array

    def __reduce__(self):
        return Jacobian, (self.array, self._outputs, self._inputs)


class Linearized(NamedTuple):
    """What ``linearize`` returns: the named results, and their derivatives."""

    value: Any
    jacobian: Any


class Formula:
    """A documented equation, proved. Call it with numbers or arrays, by place or by name.

    Inputs broadcast against each other as those of a ufunc do; the axes of a vector or a matrix are its last ones. Arrays of
    doubles are read where they are, whatever their strides. Numbers in, numbers out.
    """

    def __init__(self, place: int, said: dict[str, Any]) -> None:
        self._place = place
        self.id: str = said["id"]
        self.title: str = said["title"]
        self.source: str = said["source"]
        self.provenance: str = said["provenance"]
        self.latex: str = said["latex"]
        self.eta: float = said["eta"]
        self.eta_jacobian: float = said["eta_jacobian"]
        self.accuracy: str = said["accuracy"]
        self.sizes: str = said["sizes"]
        self.inputs: tuple[Field, ...] = fields_of(said["inputs"])
        self.outputs: tuple[Field, ...] = fields_of(said["outputs"])
        self.entries = tuple(map(tuple, said["entries"]))
        self.n = sum(field.size for field in self.inputs)
        self.m = sum(field.size for field in self.outputs)
        self._input_names = tuple(field.name for field in self.inputs)
        self._inputs = dict(zip(self._input_names, self.inputs))
        self._outputs = {field.name: field for field in self.outputs}
        family, name = self.id.split(".")
        name = named(name)
        self.__name__, self.__module__ = name, f"jointproof.{family}"
        parameters = [inspect.Parameter(field.name, inspect.Parameter.POSITIONAL_OR_KEYWORD) for field in self.inputs]
        out = inspect.Parameter("out", inspect.Parameter.KEYWORD_ONLY, default=None)
        self.__signature__ = inspect.Signature([*parameters, out])

    @cached_property
    def Value(self) -> Any:
        """The type of the named results, which takes longer to make than all else of a formula."""
        made: Any = namedtuple(f"{_capitals(self.__name__)}Value", self._outputs, module=self.__module__)
        made.__doc__ = f"The results of {self.id}."
        # A result that is pickled finds its type by the formula.
        made.__reduce__ = lambda value, rebuilt=_Rebuilt(self.id): (rebuilt, tuple(value))
        return made

    def __repr__(self):
        return f"<{self.id}({', '.join(self._input_names)}): {self.title}>"

    def __reduce__(self):
        from . import find

        return find, (self.id,)

    def __call__(self, *args: Any, out: Any = None, **kwargs: Any) -> Any:
        if out is None and _has_blocks(args, kwargs):
            from . import blocks

            return blocks.value(self, *args, **kwargs)
        arrays, shape = self._arrays(args, kwargs)
        if shape == () and out is None:
            value, told = _jointproof.value_at(self._place, _flat(arrays))
            return self._refused_or(self._value_of(value, self.m), told, ())
        outputs = self._new_value(shape) if out is None else self._given_value(out, shape)
        told = _jointproof.over_arrays(self._place, shape, arrays, list(outputs), None)
        return self._refused_or(outputs, told, shape)

    def linearize(self, *args: Any, out: Any = None, **kwargs: Any) -> Any:
        """Value and Jacobian together: ``value, jacobian = formula.linearize(…)``; ``jacobian.fc.f2`` is ∂fc/∂f2.

        ``out``: what an earlier call returned, or a value and an array for the Jacobian, to be written instead of new memory.
        """
        if out is None and _has_blocks(args, kwargs):
            from . import blocks

            return blocks.linearize(self, *args, **kwargs)
        arrays, shape = self._arrays(args, kwargs)
        if shape == () and out is None:
            results, told = _jointproof.linearize_at(self._place, _flat(arrays))
            value, entries = results or (None, None)
            array = _packed(entries, self.m * self.n).reshape(self.m, self.n)
            return self._refused_or(Linearized(self._value_of(value, self.m), self.jacobian_of(array)), told, ())
        if out is None:
            value, array = self._new_value(shape), _columns(np.zeros, self.m * self.n, shape)
            array = array.reshape(*shape, self.m, self.n)
        else:
            value, array = self._given_value(out[0], shape), self._given_jacobian(out[1], shape)
        told = _jointproof.over_arrays(self._place, shape, arrays, list(value), array)
        return self._refused_or(Linearized(value, self.jacobian_of(array)), told, shape)

    def exact(self, *args: Any, number: Any = str, **kwargs: Any) -> Any:
        """The named results in 237 bits, rounded nowhere else: strings with the fewest digits that identify them, or what
        ``number`` makes of these, as ``mpmath.mpf`` does (set ``mpmath.mp.prec = 237``)."""
        return self._exact(args, kwargs, number, False).value

    def exact_linearize(self, *args: Any, number: Any = str, **kwargs: Any) -> Any:
        """Value and Jacobian as :meth:`exact` has numbers, the Jacobian by automatic differentiation. It is None on a switch,
        where the formula has no derivative, and either side's are as good."""
        return self._exact(args, kwargs, number, True)

    def kinks(self) -> list[dict[str, Any]]:
        """Where there is no derivative: the ``condition`` in LaTeX, a point ``at`` it by components, a direction ``across``,
        and for every component of the outputs the derivatives on both sides, ``one_sided``."""
        import json

        return json.loads(_jointproof.kinks(self._place))

    def jacobian_of(self, array: Any) -> Jacobian:
        """The array of a Jacobian by names."""
        return Jacobian(array, self._outputs, self._inputs)

    def unpack(self, components: Any) -> dict[str, Any]:
        """Inputs from an array whose last axis has all their components in order, by names: views."""
        return {field.name: field.of(components) for field in self.inputs}

    def _exact(self, args, kwargs, number, with_jacobian):
        arrays, shape = self._arrays(args, kwargs)
        value, array = np.empty((*shape, self.m), object), np.empty((*shape, self.m, self.n), object)
        for index in np.ndindex(shape):
            results, told = _jointproof.exact(self._place, _flat([a[index] for a in arrays]), with_jacobian)
            if told is not None:
                told["row"] = int(np.ravel_multi_index(index, shape)) if shape else 0
                raise InputError(self.id, told, index, None)
            value[index] = [number(x) for x in results[0]]
            entries = results[1]
            if entries is not None:
                array[index] = np.array([number(x) for x in entries], object).reshape(self.m, self.n)
        has_one = with_jacobian and array.size and not (array == None).any()  # noqa: E711: element by element
        jacobian = self.jacobian_of(array) if has_one else None
        return Linearized(self.Value(*(field.of(value) for field in self.outputs)), jacobian)

    def _arrays(self, args, kwargs):
        """All inputs as arrays of doubles of the shape of the call, then of the field; and that shape."""
        given = self._bound(args, kwargs)
        arrays = [_array(field, x) for field, x in zip(self.inputs, given)]
        leading = [a.shape[: a.ndim - len(field.shape)] for field, a in zip(self.inputs, arrays)]
        shape = leading[0]
        if any(other != shape for other in leading):
            shape = self._broadcast(leading)
            arrays = [
                a if one == shape else np.broadcast_to(a, shape + field.shape)
                for field, a, one in zip(self.inputs, arrays, leading)
            ]
        return arrays, shape

    def _bound(self, args, kwargs):
        return bound(self.id, self._input_names, args, kwargs)

    def _broadcast(self, leading):
        return broadcast(self._input_names, leading, self.id)

    def _value_of(self, numbers, count):
        packed = _packed(numbers, count)
        return self.Value(*(packed[field.start].item() if field.size == 1 else field.of(packed) for field in self.outputs))

    def _new_value(self, shape):
        packed = _columns(np.empty, self.m, shape)
        return self.Value(*(field.of(packed) for field in self.outputs))

    def _given_value(self, out, shape):
        if isinstance(out, np.ndarray):
            out = (out,)
        elif isinstance(out, dict):
            out = tuple(out[name] for name in self._outputs)
        if len(out) != len(self.outputs):
            raise ShapeError("out", f"{len(out)} arrays; there are {len(self.outputs)} outputs")
        for field, array in zip(self.outputs, out):
            _expect(f"out.{field.name}", array, shape + field.shape)
        return self.Value(*out)

    def _given_jacobian(self, out, shape):
        if isinstance(out, Jacobian):
            _expect("out.jacobian", out.array, (*shape, self.m, self.n))
            return out.array
        _expect("out.jacobian", out, (*shape, self.m, self.n))
        # Only entries are written that are not zero everywhere.
        out.fill(0.0)
        return out

    def _refused_or(self, results, told, shape):
        if told is None:
            return results
        index = tuple(int(k) for k in np.unravel_index(told["row"], shape)) if shape else ()
        raise InputError(self.id, told, index, results)


def bound(id, names, args, kwargs):
    """Inputs in order, given by place or by name."""
    if len(args) > len(names):
        raise TypeError(f"{id} takes {len(names)} inputs, {', '.join(names)}; {len(args)} were given")
    given = dict(zip(names, args))
    for name, x in kwargs.items():
        if name not in names:
            raise TypeError(f"{id} has no input {name!r}; it has {', '.join(names)}")
        if name in given:
            raise TypeError(f"{id}: {name} is given twice")
        given[name] = x
    missing = [name for name in names if name not in given]
    if missing:
        raise TypeError(f"{id} needs {', '.join(missing)}")
    return [given[name] for name in names]


def broadcast(names, leading, what="inputs"):
    """The shape of arrays of these shapes together."""
    try:
        return np.broadcast_shapes(*leading)
    except ValueError:
        shapes = ", ".join(f"{name} {list(one)}" for name, one in zip(names, leading))
        raise ShapeError(what, f"the shapes of the inputs do not broadcast: {shapes}") from None


class _Rebuilt:
    """Makes the results of a formula again."""

    def __init__(self, id):
        self.id = id

    def __call__(self, *values):
        from . import find

        return find(self.id).Value(*values)


def _has_blocks(args, kwargs):
    """Whether an array of Dask is among the inputs, which is computed block by block."""
    return any(type(x).__module__.startswith("dask.") for x in (*args, *kwargs.values()))


def _capitals(name):
    return "".join(word.capitalize() for word in name.split("_"))


def _array(field, x):
    """An input as an array of doubles: itself if it is one."""
    array = x if type(x) is np.ndarray else _plain(field, x)
    if array.dtype != np.float64 or not array.flags.aligned:
        if not np.can_cast(array.dtype, np.float64, "same_kind"):
            raise TypeError(f"{field.name}: numbers of type {array.dtype} are no doubles")
        array = np.require(array, np.float64, "A")
    axes = len(field.shape)
    if axes and array.shape[array.ndim - axes :] != field.shape:
        raise field.misshapen(array.shape)
    return array


def _plain(field, x):
    """An array of what is a plain number, or has plain numbers. What would be lost is refused: units, and masks that hide something."""
    for name in ("units", "unit"):
        if (unit := getattr(x, name, None)) is not None and not inspect.isroutine(unit):
            raise TypeError(
                f"{field.name}: it has the unit {unit}, and formulas take plain numbers in consistent units (here {field.unit}); "
                "give its magnitude"
            )
    if np.ma.is_masked(x):
        raise TypeError(f"{field.name}: some elements are masked, and formulas know no masks; give x.compressed() or x.filled(…)")
    try:
        return np.asarray(x)
    except Exception as why:
        library = "torch" if type(x).__module__ == "torch" else "jax"
        if library == "jax" and not type(x).__module__.startswith("jax"):
            raise
        raise TypeError(
            f"{field.name}: {type(x).__name__} is being traced or derived from, and NumPy does neither; "
            f"jointproof.{library}.operation has the formula for that"
        ) from why


def _expect(name, array, shape):
    if not isinstance(array, np.ndarray) or array.dtype != np.float64:
        raise TypeError(f"{name}: an array of doubles is needed")
    if array.shape != shape:
        raise ShapeError(name, f"shape {list(array.shape)}; the shape of the call is {list(shape)}")
    if not array.flags.writeable:
        raise ValueError(f"{name}: cannot be written")


def _flat(arrays):
    numbers = []
    for array in arrays:
        numbers.extend(array.ravel().tolist() if array.ndim else [float(array)])
    return numbers


def _packed(numbers, count):
    return np.full(count, np.nan) if numbers is None else np.array(numbers)


def _columns(make, count, shape):
    """An array of this shape with a last axis of so many components, each a column in one piece: an odd number of lines of the
    cache apart, so that they do not share their places in it."""
    line = 8
    rows = math.prod(shape)
    width = (-(-rows // line) | 1) * line
    columns = make((count, width))[:, :rows].reshape(count, *shape)
    return np.moveaxis(columns, 0, -1)


def docstring(formula):
    """What is said of a formula: title, equation, inputs, outputs, source."""
    lines = [f"{formula.title}.", ""]
    lines += [f"    {line.strip()}" for line in formula.latex.split(r"\\")]
    for title, fields in (("Inputs", formula.inputs), ("Outputs", formula.outputs)):
        lines += ["", f"{title}:", *map(described, fields)]
    lines += ["", f"Accuracy: {formula.accuracy}, inputs {formula.sizes} in size."]
    lines += [f"Source: {formula.source} ({formula.provenance})."]
    return "\n".join(lines)


def described(field):
    """A field, as documentation has it."""
    shape = f"{list(field.shape)}, " if field.shape else ""
    return f"    {field.name}: {field.meaning} ({shape}unit {field.unit}; {field.allowed})"


def made(place, said):
    """The one instance of a class of its own, whose documentation is that of the formula."""
    family, name = said["id"].split(".")
    made = type(_capitals(name), (Formula,), {"__module__": f"jointproof.{family}"})(place, said)
    type(made).__doc__ = docstring(made)
    return made
