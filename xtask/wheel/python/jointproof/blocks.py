"""Formulas over more points than one machine has room or time for: functions of a block, for whoever schedules blocks.

:func:`value` and :func:`linearize` take arrays of Dask and give such arrays; :func:`summary` keeps of every block only what
can be added up; :func:`arrow` is what Spark's ``mapInArrow`` and Ray's ``map_batches`` call. Every row has the bits that it
has alone, so that nothing depends on how rows are shared out.
"""

import json
import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from . import auditing
from .errors import InputError

if TYPE_CHECKING:
    from .formula import Formula, Linearized


class Summary:
    """What is kept of many rows: of every result by name how many numbers there are, the least and the greatest with their
    rows, and how many lie in each of narrow classes, from which quantiles come; and how many rows were refused, and the first.

    Summaries of blocks are added by ``+``, in any order and any groups, to the summary of all rows.
    """

    #: Numbers whose first bits agree, sign, exponent and eight bits of the fraction, are in one class.
    _CUT = 44

    def __init__(
        self, formula: str, columns: dict[str, Any], refused: int = 0, first_refused: int | None = None, rows: int = 0
    ) -> None:
        self.formula = formula
        self.columns = columns
        self.refused = refused
        self.first_refused = first_refused
        self.rows = rows

    @classmethod
    def of(cls, formula: "Formula", *inputs: Any, first_row: int = 0) -> "Summary":
        """Of the value and the entries of the Jacobian at these rows, of which the first has this number."""
        refused, first_refused = 0, None
        try:
            value, jacobian = formula.linearize(*inputs)
        except InputError as error:
            value, jacobian = error.results
            refused, first_refused = error.count, error.row + first_row
        packed = np.concatenate(
            [np.reshape(y, (-1, field.size)) for field, y in zip(formula.outputs, value)], axis=-1
        )
        entries = np.reshape(jacobian.array, (-1, formula.m, formula.n))
        named = {name: packed[:, k] for k, name in enumerate(component_names(formula.outputs))}
        outputs, by = component_names(formula.outputs), component_names(formula.inputs)
        named |= {f"∂{outputs[i]}/∂{by[j]}": entries[:, i, j] for i, j in formula.entries}
        columns = {name: cls._column(x, first_row) for name, x in named.items()}
        return cls(formula.id, columns, refused, first_refused, len(packed))

    @classmethod
    def _column(cls, x, first_row):
        known = ~np.isnan(x)
        if not known.any():
            return {"least": None, "greatest": None, "classes": {}}
        least, greatest = int(np.nanargmin(x)), int(np.nanargmax(x))
        keys, counts = np.unique(x[known].view(np.int64) >> cls._CUT, return_counts=True)
        return {
            "least": [float(x[least]), least + first_row],
            "greatest": [float(x[greatest]), greatest + first_row],
            "classes": dict(zip(keys.tolist(), counts.tolist())),
        }

    def __add__(self, other: "Summary") -> "Summary":
        if self.formula != other.formula:
            raise ValueError(f"summaries of two formulas: {self.formula}, {other.formula}")
        columns = {name: _joined(self.columns[name], other.columns[name]) for name in self.columns}
        firsts = [first for first in (self.first_refused, other.first_refused) if first is not None]
        rows = self.rows + other.rows
        return Summary(self.formula, columns, self.refused + other.refused, min(firsts, default=None), rows)

    def __eq__(self, other):
        return isinstance(other, Summary) and self.json() == other.json()

    def quantile(self, name: str, q: float) -> float:
        """A number that so large a share of the results of this name do not exceed, to a part in 256 of itself."""
        classes = self.columns[name]["classes"]
        if not classes:
            return float("nan")
        # A class is named by the first bits, of which the sign stands for itself: rising numbers come first.
        edges = sorted((_edge(key, self._CUT), key) for key in classes)
        wanted = q * sum(classes.values())
        seen = 0
        for edge, key in edges:
            seen += classes[key]
            if seen >= wanted:
                return edge
        return edges[-1][0]

    def json(self) -> str:
        """All of it as text: the same bytes, however the rows were shared out."""
        return json.dumps(
            {
                "formula": self.formula,
                "rows": self.rows,
                "refused": self.refused,
                "first_refused": self.first_refused,
                "columns": {
                    name: column | {"classes": {str(key): column["classes"][key] for key in sorted(column["classes"])}}
                    for name, column in self.columns.items()
                },
            },
            ensure_ascii=False,
        )

    def __repr__(self):
        lines = [f"{self.formula}: {self.rows} rows, {self.refused} refused"]
        for name, column in self.columns.items():
            if column["least"] is not None:
                (low, at_low), (high, at_high) = column["least"], column["greatest"]
                middle = self.quantile(name, 0.5)
                lines.append(f"  {name}: {low!r} in row {at_low}, median {middle:.3g}, {high!r} in row {at_high}")
        return "\n".join(lines)


def component_names(fields: Iterable[Any]) -> list[str]:
    """The names of all components in order: ``f2``, ``e1a[2]``, ``k[0,1]``."""
    names = []
    for field in fields:
        for index in np.ndindex(field.shape):
            names.append(field.name + (f"[{','.join(map(str, index))}]" if index else ""))
    return names


def _joined(one, other):
    classes = dict(one["classes"])
    for key, count in other["classes"].items():
        classes[key] = classes.get(key, 0) + count
    least = [x for x in (one["least"], other["least"]) if x is not None]
    greatest = [x for x in (one["greatest"], other["greatest"]) if x is not None]
    return {
        "least": min(least, default=None),
        # The first of several rows.
        "greatest": max(greatest, key=lambda x: (x[0], -x[1]), default=None),
        "classes": classes,
    }


def _edge(key, cut):
    """The number of a class that is nearest to zero."""
    return float(np.array([key << cut], np.int64).view(np.float64)[0])


def value(formula: "str | Formula", *args: Any, **kwargs: Any) -> Any:
    """The named results over arrays of Dask, block by block. Axes of vectors are in one block."""
    formula, inputs = _bound(formula, args, kwargs)
    return formula.Value(*_over_dask(formula, formula, inputs, [_core(field.shape) for field in formula.outputs]))


def linearize(formula: "str | Formula", *args: Any, **kwargs: Any) -> "Linearized":
    """Value and Jacobian over arrays of Dask, block by block."""
    from .formula import Linearized

    formula, inputs = _bound(formula, args, kwargs)
    cores = [*(_core(field.shape) for field in formula.outputs), "(m,n)"]
    *results, array = _over_dask(formula, _Flat(formula), inputs, cores)
    return Linearized(formula.Value(*results), formula.jacobian_of(array))


def summary(formula: "str | Formula", *args: Any, **kwargs: Any) -> Any:
    """The summary of all rows of arrays of Dask, to be computed: ``summary(…).compute()``. Rows are along the first axis."""
    import dask
    import dask.array as da

    formula, inputs = _bound(formula, args, kwargs)
    inputs = [da.asarray(x) for x in inputs]
    # Blocks of the first input that has rows are those of all.
    rows = next((x.chunks[0] for x in inputs if x.ndim), (1,))
    inputs = [x.rechunk({0: rows}) if x.ndim else x for x in inputs]
    firsts = np.concatenate([[0], np.cumsum(rows)[:-1]]).tolist()
    blocks = [x.to_delayed().ravel() if x.ndim else [x] * len(rows) for x in inputs]
    of = dask.delayed(Summary.of, pure=True)
    parts = [of(formula, *block, first_row=first) for first, *block in zip(firsts, *blocks)]
    while len(parts) > 1:
        parts = [dask.delayed(_sum)(parts[k : k + 8]) for k in range(0, len(parts), 8)]
    return parts[0]


def _sum(parts):
    first, *rest = parts
    for part in rest:
        first = first + part
    return first


def audit(*patterns: "str | Formula", shards: int, samples: int | None = None, seed: int | None = None) -> Any:
    """The audits of formulas, each in so many parts, to be computed by Dask: byte for byte those of one machine."""
    import dask

    part = dask.delayed(auditing.audit_part, pure=True)
    parts = [
        part(id, index, shards, samples=samples, seed=seed)
        for id in auditing.chosen(patterns)
        for index in range(1, shards + 1)
    ]
    return dask.delayed(auditing.merge)(parts)


class arrow:
    """A function of record batches, for Spark's ``mapInArrow`` and Ray's ``map_batches``: columns of the names of the inputs, by
    components as ``e1a[2]``, become columns of the results and of the entries of the Jacobian."""

    def __init__(self, formula: "str | Formula") -> None:
        self.id: str = _found(formula).id

    def __call__(self, batches: Iterable[Any]) -> Iterator[Any]:
        return map(self.one, batches)

    def schema(self) -> list[str]:
        """The names of the columns that come out, all of doubles."""
        formula = _found(self.id)
        outputs, by = component_names(formula.outputs), component_names(formula.inputs)
        return outputs + [f"∂{outputs[i]}/∂{by[j]}" for i, j in formula.entries]

    def one(self, batch: Any) -> Any:
        """Of one record batch."""
        import pyarrow

        formula = _found(self.id)
        columns = [batch.column(name).to_numpy(zero_copy_only=False) for name in component_names(formula.inputs)]
        inputs = [_stacked(columns[field.places], field.shape) for field in formula.inputs]
        value, jacobian = formula.linearize(*inputs)
        rows = batch.num_rows
        packed = [np.reshape(y, (rows, field.size)).T for field, y in zip(formula.outputs, value)]
        results = [*np.concatenate(packed), *(jacobian.array[:, i, j] for i, j in formula.entries)]
        return pyarrow.RecordBatch.from_arrays([pyarrow.array(x) for x in results], names=self.schema())


def _stacked(columns, shape):
    return np.stack(columns, axis=-1).reshape(-1, *shape) if shape else columns[0]


class _Flat:
    """The results of ``linearize`` in a row."""

    def __init__(self, formula):
        self.formula = formula

    def __call__(self, *inputs):
        results, jacobian = self.formula.linearize(*inputs)
        return (*results, jacobian.array)


def _over_dask(formula, function, inputs, outputs):
    import dask.array as da

    inputs = [da.asarray(x) for x in inputs]
    leading = [x.shape[: x.ndim - len(field.shape)] for field, x in zip(formula.inputs, inputs)]
    shape = formula._broadcast(leading)
    # Each block is told its rows, so that what it refuses is named by the row of the whole.
    rows = da.arange(math.prod(shape), chunks=-1).reshape(shape)
    chunked = [x.chunks[: len(one)] for x, one in zip(inputs, leading) if len(one) == len(shape) and one == shape]
    rows = rows.rechunk(chunked[0]) if chunked else rows
    signature = f"(),{','.join(_core(field.shape) for field in formula.inputs)}->{','.join(outputs)}"
    sizes = {f"d{size}": size for field in formula.outputs for size in field.shape} | {"m": formula.m, "n": formula.n}
    known = {name: size for name, size in sizes.items() if name in signature.split("->")[1]}
    given = {f"d{size}" for field in formula.inputs for size in field.shape}
    results = da.apply_gufunc(
        _Numbered(function, shape, len(outputs)),
        signature,
        rows,
        *inputs,
        output_dtypes=[float] * len(outputs) if len(outputs) > 1 else float,
        output_sizes={name: size for name, size in known.items() if name not in given},
        allow_rechunk=True,
    )
    return results if len(outputs) > 1 else (results,)


class _Numbered:
    """A function of a block; the only result if there is one. A row that it refuses is named by its number in the whole."""

    def __init__(self, function, shape, results):
        self.function, self.shape, self.results = function, shape, results

    def __call__(self, rows, *inputs):
        try:
            results = self.function(*inputs)
        except InputError as error:
            row = int(rows[error.index])
            raise error.renumbered(row, tuple(int(k) for k in np.unravel_index(row, self.shape))) from None
        return results if self.results > 1 else results[0]


def _core(shape):
    return f"({','.join(f'd{size}' for size in shape)})"


def _found(formula):
    from . import find

    return find(formula)


def _bound(formula, args, kwargs):
    formula = _found(formula)
    return formula, formula._bound(args, kwargs)
