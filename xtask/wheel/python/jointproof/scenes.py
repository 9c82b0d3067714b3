"""Scenes: connectors together, over a history of states, as columns."""

import json
import os
import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _jointproof

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Scene:
    """The results of a scene: ``title``, ``times``, ``counts`` (how often each formula was evaluated), ``warnings``, ``notes``
    (columns of tables that were ignored), and a column for every output of every element: ``scene["guide", "FN"]``, a row for every state, NaN where the output is not there."""

    def __init__(self, results: Any) -> None:
        import numpy as np

        self.title: str = results.title
        self.times: NDArray[np.float64] = np.array(results.times)
        self.counts: dict[str, int] = dict(results.counts)
        self.warnings: list[str] = results.warnings
        self.notes: list[str] = results.notes
        self.columns: dict[tuple[str, str], NDArray[np.float64]] = {(series.element, series.output): series.values for series in results.series}

    def __getitem__(self, element_and_output: tuple[str, str]) -> "NDArray[np.float64]":
        values = self.columns[element_and_output]
        return values[:, 0] if values.shape[1] == 1 else values

    def __repr__(self):
        return f"<scene {self.title!r}: {len(self.times)} states, {len(self.columns)} outputs>"

    def frame(self) -> Any:
        """A frame of pandas: the times as its index, a column for every component of an output of an element."""
        import pandas as pd

        columns = {
            (element, output, component): values[:, component]
            for (element, output), values in self.columns.items()
            for component in range(values.shape[1])
        }
        index = pd.Index(self.times, name="time")
        frame = pd.DataFrame(columns, index=index)
        frame.columns = pd.MultiIndex.from_tuples(columns, names=["element", "output", "component"])
        return frame

    def _repr_html_(self):
        return self.frame()._repr_html_()


def scene(
    source: str | os.PathLike[str] | Mapping[str, Any],
    *,
    exact: bool = False,
    nodes: Any = None,
    loads: Any = None,
    pressures: Any = None,
) -> Scene:
    """Evaluates a scene: the path of a file, its text, or a dict, in which arrays of NumPy are lists; in doubles, or in 237 bits rounded once.
    A file may name one of arrays beside it, as ``numpy.savez`` writes it.

    Tables may be its history, each a frame of pandas or the path of a CSV file, with a row for each state and node or element: ``nodes``
    with ``time``, ``node`` and some of ``u1`` … ``ur3``, ``loads`` with ``time``, ``element`` and some of ``f1`` … ``m3``, and ``pressures`` with
    ``time``, ``node`` and ``pressure``."""
    folder = None
    if isinstance(source, Mapping):
        text = json.dumps(source, default=_plain)
    elif isinstance(source, str) and source.lstrip().startswith("{"):
        text = source
    else:
        path = os.fspath(source)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        folder = os.path.dirname(path)
    tables = [_table(name, table) for name, table in [("nodes", nodes), ("loads", loads), ("pressures", pressures)]]
    results = Scene(_jointproof.Scene(text, exact, folder, tables))
    for warning in results.warnings:
        warnings.warn(warning, stacklevel=2)
    return results


def _table(name, table):
    """The name and the text of a frame, or the path of a file."""
    if not hasattr(table, "to_csv"):
        return table
    named = [level for level in table.index.names if level is not None]
    return name, (table.reset_index(level=named) if named else table).to_csv(index=False).encode()


def _plain(x):
    """An array or a number of NumPy as JSON has it."""
    if hasattr(x, "tolist"):
        return x.tolist()
    raise TypeError(f"a scene has no {type(x).__name__}")
