"""Functions of others, judged as `cargo xtask check` judges programs."""

import html
import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _jointproof

if TYPE_CHECKING:
    from .formula import Formula

_COLOURS = {"right": "#cfe8cf", "inaccurate": "#f6e3a1", "wrong": "#f0b4ae"}


class Checked:
    """What a function is worth. ``is_well`` says whether it is the formula: the same function at ordinary points, and right on kinks;
    if it was judged strictly, within our bounds at all sizes. ``parts`` are the parts of the verdict in order, each with its
    ``title``, its ``conclusion`` (right, limited, wrong, not asked), how many points are ``right`` of how many (``of``), what
    it ``says``, ``details``, and the simplest ``point`` that is not right; ``causes`` has the mistakes that explain what is wrong,
    ``text`` everything, and ``numbers`` every output and every entry of the Jacobian, with its ``name``, its ``grade`` (right,
    inaccurate, wrong), how often it was ``checked`` at ordinary points and ``off`` there, its ``bound``, and the ``worst`` η, with what
    was found and what is exact at ``inputs``; ``noticed`` are remarks on how the function was called. It prints as text, and a
    notebook shows the parts and the map of entries."""

    def __init__(self, formula: "Formula", judged: Any, noticed: list[str]) -> None:
        self.formula: str = formula.id
        self.is_well: bool = judged.is_well
        self.text: str = judged.text
        self.causes: list[str] = judged.causes
        self.parts: list[Any] = judged.parts
        self.numbers: list[Any] = judged.numbers
        self.noticed = noticed
        self._formula = formula

    def __repr__(self):
        return self.text.rstrip()

    def __bool__(self) -> bool:
        return self.is_well

    def _repr_html_(self):
        causes = "".join(f"<li>{html.escape(cause)}</li>" for cause in [*self.noticed, *self.causes])
        rows = "".join(
            f"<tr><td>{html.escape(part.title)}</td><td>{html.escape(part.says)}</td></tr>" for part in self.parts
        )
        return (
            f"<h4>{html.escape(self.formula)}: {'right' if self.is_well else 'not right'}</h4><table>{rows}</table>"
            f"{f'<ul>{causes}</ul>' if causes else ''}{self._map()}"
            f"<details><summary>everything</summary><pre>{html.escape(self.text)}</pre></details>"
        )

    def _map(self):
        """A row for every output: its value, then its derivatives, coloured by their grades, with the share of ordinary points at
        which each is another number."""
        m, n = self._formula.m, self._formula.n
        values, entries = self.numbers[:m], self.numbers[m:]
        rows = []
        for k, value in enumerate(values):
            cells = [_cell(number) for number in [value, *entries[k * n : k * n + n if entries else k * n]]]
            rows.append(f"<tr>{''.join(cells)}</tr>")
        named = {"right": "right", "inaccurate": "right with limits", "wrong": "wrong, with the share of ordinary points"}
        legend = " ".join(f'<span style="background:{_COLOURS[grade]};color:#222">{named[grade]}</span>' for grade in _COLOURS)
        return f"<table>{''.join(rows)}</table><p>{legend}</p>"


def _cell(number):
    title = f"{number.name}: {number.grade}, another number at {number.off} of {number.checked} ordinary points"
    if number.worst is not None:
        eta, found, exact = number.worst
        title += f"; η {eta:.2g} (bound {number.bound:g}): {found!r} for {exact!r} at {number.inputs}"
    share = f" {number.off}/{number.checked}" if number.off else ""
    colour = _COLOURS[number.grade]
    return f'<td style="background:{colour};color:#222" title="{html.escape(title)}">{html.escape(number.name + share)}</td>'


def check(
    formula: "str | Formula",
    function: Callable[..., Any],
    jacobian: Any = None,
    *,
    samples: int | None = None,
    seed: int | None = None,
    invalid: bool = True,
    vectorized: bool = False,
    strict: bool = False,
) -> Checked:
    """Judges a function that computes a formula: at golden points, on kinks and beside them, and at random, each twice.

    ``function`` is called with the inputs by name, if its parameters have the names of the formula's inputs, else by place, in
    the order of the formula: numbers, and arrays for vectors. It returns the outputs: a number, an array, a tuple in order, or
    a mapping by names.

    ``jacobian`` is a function of the same inputs that returns the derivatives: an array of the components of the outputs by
    those of the inputs; for every output, in order or by names, those by every input; or for the one output there is, those by
    every input. ``True`` says that ``function`` returns outputs and derivatives; ``"jax"`` has ``jax.jacfwd`` derive it, for all
    points at once by ``jax.vmap`` if the function can be mapped. Whether JAX may use 64 bits is the caller's: if its switch
    ``jax_enable_x64`` is off, the verdict says so first.

    Inputs that the formula refuses are asked for too, unless ``invalid`` is false: a function refuses them by a ValueError or an
    ArithmeticError, or by NaN or infinity. A NotImplementedError leaves a point out.

    A function is right if it is the formula at ordinary points and on kinks, where any one-sided derivative is right; its limits are
    listed. With ``strict`` our bounds are asked for at all sizes, our convention on kinks, and refusals of what is not allowed.

    With ``vectorized`` the function is called with all points at once, which are the first axis of all arrays, also of those
    that it returns; it refuses by NaN.
    """
    from . import find

    formula = find(formula)
    called = _jointproof.Called(formula._place, jacobian is not None, samples, seed, invalid)
    points, order = called.points(), np.array(called.other_order(), dtype=int)
    if jacobian == "jax":
        ask, noticed = _by_jax(formula, function, vectorized)
    else:
        asked, noticed = _asked(formula, function, jacobian), []
        ask = lambda points: (_all_at_once if vectorized else _one_by_one)(formula, asked, points)  # noqa: E731
    first = ask(points)
    second = [None] * len(points)
    for place, answer in zip(order, ask(points[order])):
        second[place] = answer
    name = getattr(function, "__name__", type(function).__name__)
    return Checked(formula, called.judge(name, first, second, strict, noticed), noticed)


def _asked(formula, function, jacobian):
    """What takes inputs in order and returns outputs, and derivatives or None."""
    function = _by_name_or_place(formula, function)
    if jacobian is None:
        return lambda inputs: (function(inputs), None)
    if jacobian is True:
        return lambda inputs: function(inputs)
    derivatives = _by_name_or_place(formula, jacobian)
    return lambda inputs: (function(inputs), derivatives(inputs))


_SINGLE = "JAX computes with 32 bits, since jax_enable_x64 is off: jax.config.update('jax_enable_x64', True) before anything else"


def _by_jax(formula, function, vectorized):
    """What answers points by a function of JAX, its derivatives and what is to be said about them."""
    import jax

    called = _by_name_or_place(formula, function)
    of_point = lambda *inputs: _outputs(formula, called(inputs))  # noqa: E731
    derived = jax.jacfwd(of_point, argnums=tuple(range(len(formula.inputs))))
    noticed = [] if jax.config.jax_enable_x64 else [_SINGLE]

    def mapped(inputs):
        # A function of all points at once is mapped over rows of one point.
        alone = (lambda *one: tuple(x[0] for x in of_point(*(x[None] for x in one)))) if vectorized else of_point
        by = jax.jacfwd(alone, argnums=tuple(range(len(formula.inputs)))) if vectorized else derived
        return jax.vmap(lambda *one: (alone(*one), by(*one)))(*inputs)

    def ask(points):
        try:
            return _all_at_once(formula, mapped, points)
        except Exception:  # noqa: BLE001: what cannot be mapped, by branches on values for instance, is asked point by point
            return _one_by_one(formula, lambda inputs: (called(inputs), derived(*inputs)), points)

    return ask, noticed


def _by_name_or_place(formula, function):
    names = [field.name for field in formula.inputs]
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        parameters = []
    if {parameter.name for parameter in parameters if parameter.default is parameter.empty} >= set(names):
        return lambda inputs: function(**dict(zip(names, inputs)))
    return lambda inputs: function(*inputs)


def _one_by_one(formula, asked, points):
    return [_answer(formula, asked, point) for point in points]


def _answer(formula, asked, point):
    """What a function answers at a point: its numbers, or in words that it does not."""
    inputs = [field.of(point) for field in formula.inputs]
    try:
        with np.errstate(all="ignore"):
            value, derivatives = asked(inputs)
    except (ValueError, ArithmeticError):
        return ("refused", "")
    except NotImplementedError as error:
        return ("skipped", str(error))
    except Exception as error:  # noqa: BLE001: whatever a function does is an answer
        return ("bad", f"{type(error).__name__}: {error}")
    try:
        return _numbers(formula, value, derivatives, ()).tolist()
    except (TypeError, ValueError, KeyError, IndexError) as error:
        return ("bad", str(error))


def _all_at_once(formula, asked, points):
    with np.errstate(all="ignore"):
        value, derivatives = asked([field.of(points) for field in formula.inputs])
    return _numbers(formula, value, derivatives, (len(points),)).tolist()


def _numbers(formula, value, derivatives, shape):
    """All numbers of an answer in order: outputs, then the Jacobian row by row."""
    value = _outputs(formula, value)
    parts = [_part(field.name, x, shape, (field.size,)) for field, x in zip(formula.outputs, value)]
    if derivatives is not None:
        parts.append(_dense(formula, derivatives, shape).reshape(*shape, -1))
    return np.concatenate(parts, axis=-1)


def _outputs(formula, value):
    """The outputs in order, a part each."""
    outputs = formula.outputs
    if hasattr(value, "keys"):
        return tuple(value[field.name] for field in outputs)
    if len(outputs) == 1 and not isinstance(value, tuple):
        return (value,)
    if not isinstance(value, (tuple, list)):
        # All components in an array.
        return tuple(value[..., field.places] for field in outputs)
    if len(value) != len(outputs):
        raise ValueError(f"{len(value)} outputs instead of {len(outputs)}")
    return tuple(value)


def _dense(formula, derivatives, shape):
    """The Jacobian: components of the outputs by those of the inputs."""
    outputs, inputs = formula.outputs, formula.inputs
    array = getattr(derivatives, "array", derivatives)
    if not hasattr(derivatives, "keys") and not isinstance(derivatives, (tuple, list)):
        return _part("the Jacobian", array, shape, (formula.m, formula.n))
    rows = _of_outputs(outputs, inputs, derivatives)
    blocks = []
    for output, row in zip(outputs, rows, strict=True):
        by = [row[field.name] for field in inputs] if hasattr(row, "keys") else row
        if not isinstance(by, (tuple, list)):
            blocks.append(_part(f"∂{output.name}", by, shape, (output.size, formula.n)))
            continue
        named = zip(inputs, by, strict=True)
        blocks.append(
            np.concatenate([_part(f"∂{output.name}/∂{x.name}", b, shape, (output.size, x.size)) for x, b in named], axis=-1)
        )
    return np.concatenate(blocks, axis=-2)


def _of_outputs(outputs, inputs, derivatives):
    """The derivatives of every output, in order."""
    if hasattr(derivatives, "keys"):
        is_of_one = len(outputs) == 1 and outputs[0].name not in derivatives
        return [derivatives] if is_of_one else [derivatives[field.name] for field in outputs]
    is_of_one = len(outputs) == 1 and len(derivatives) == len(inputs)
    is_nested = len(derivatives) == 1 and isinstance(derivatives[0], (tuple, list, dict))
    return [derivatives] if is_of_one and not is_nested else derivatives


def _part(name, x, shape, wanted):
    """A part of an answer as an array of this many components."""
    array = np.asarray(x, dtype=float)
    if array.size != np.prod(shape + wanted, dtype=int):
        raise ValueError(f"{name} has the shape {list(array.shape)}")
    return array.reshape(shape + wanted)
