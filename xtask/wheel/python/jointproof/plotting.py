"""An output and its derivative along an input, drawn as SVG: no other package is needed, and the bytes are the same everywhere."""

import os
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .formula import Formula

_WIDTH, _HEIGHT, _LEFT, _RIGHT, _TOP, _BETWEEN, _BELOW = 640, 170, 70, 20, 24, 34, 44
_POINTS = 401


class Plot:
    """A drawing. A notebook shows it; :meth:`save` writes it; ``svg`` is its text; :meth:`draw` draws it with Matplotlib."""

    def __init__(self, svg: str, along: str, x: Any, panels: list[Any]) -> None:
        self.svg = svg
        self._along, self._x, self._panels = along, x, panels

    def _repr_svg_(self):
        return self.svg

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the drawing to a file."""
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(self.svg)

    def draw(self, axes: Any = None) -> Any:
        """The same with Matplotlib: into two axes, the output's and its derivative's, or into a new figure. Returns the axes."""
        if axes is None:
            from matplotlib import pyplot

            _, axes = pyplot.subplots(2, sharex=True)
        for one, (name, y, breaks) in zip(axes, self._panels, strict=True):
            for start, end in zip([0, *breaks], [*breaks, len(y)]):
                one.plot(self._x[start:end], y[start:end], color="C0")
            for k in self._panels[1][2]:
                one.axvline((self._x[k - 1] + self._x[k]) / 2, color="C3", linestyle="--")
            one.set_ylabel(name)
        axes[1].set_xlabel(self._along)
        return axes


def plot(formula: "str | Formula", output: str, along: str, between: tuple[float, float], **inputs: "ArrayLike") -> Plot:
    """An output, and its derivative with respect to the input ``along``, which goes from the first to the second of ``between``; the other
    inputs stay as they are given. Lines are broken where the derivative jumps."""
    from . import find

    formula = find(formula)
    for name, known, what in ((output, formula._outputs, "output"), (along, formula._inputs, "input")):
        if name not in known:
            raise ValueError(f"{formula.id} has no {what} {name!r}; it has {', '.join(known)}")
    x = np.linspace(*map(float, between), _POINTS)
    value, jacobian = formula.linearize(**inputs, **{along: x})
    y, slope = getattr(value, output), jacobian[output][along]
    if y.shape != x.shape or slope.shape != x.shape:
        raise ValueError(f"{output} along {along} is no curve: both must be numbers")
    jumps = _jumps(slope)
    panels = [(output, y, []), (f"∂{output}/∂{along}", slope, jumps)]
    height = _TOP + 2 * _HEIGHT + _BETWEEN + _BELOW
    title = f"{output} of {formula.id} and its derivative with respect to {along}"
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}" role="img" aria-label="{title}">',
        "<style>text{font:13px sans-serif;fill:#222}.axis{stroke:#888;fill:none}"
        ".curve{stroke:#1b6ca8;fill:none;stroke-width:2}.jump{stroke:#b03a2e;stroke-dasharray:4 3}</style>",
        f'<rect width="{_WIDTH}" height="{height}" fill="#fff"/>',
    ]
    for k, (name, numbers, breaks) in enumerate(panels):
        parts += _panel(x, numbers, breaks, jumps, _TOP + k * (_HEIGHT + _BETWEEN), name)
    parts += _labels(x, _TOP + 2 * _HEIGHT + _BETWEEN, along)
    return Plot("\n".join([*parts, "</svg>", ""]), along, x, panels)


def _jumps(slope):
    """Before which points the derivative changes by far more than it does beside."""
    change = np.abs(np.diff(slope))
    usual = np.median(change)
    most = np.ptp(slope[np.isfinite(slope)])
    return [int(k) + 1 for k in np.flatnonzero(change > max(20 * usual, 0.05 * most))] if most > 0 else []


def _panel(x, numbers, breaks, jumps, top, name):
    low, high = float(np.nanmin(numbers)), float(np.nanmax(numbers))
    room = 0.08 * (high - low) or 1.0
    low, high = low - room, high + room

    def place(k):
        return f"{_across(x, x[k]):.2f},{top + _HEIGHT * (high - numbers[k]) / (high - low):.2f}"

    yield f'<rect class="axis" x="{_LEFT}" y="{top}" width="{_WIDTH - _LEFT - _RIGHT}" height="{_HEIGHT}"/>'
    for k in jumps:
        at = _across(x, (x[k - 1] + x[k]) / 2)
        yield f'<line class="jump" x1="{at:.2f}" x2="{at:.2f}" y1="{top}" y2="{top + _HEIGHT}"/>'
    edges = [0, *breaks, len(x)]
    for start, end in zip(edges, edges[1:]):
        yield f'<polyline class="curve" points="{" ".join(place(k) for k in range(start, end))}"/>'
    yield f'<text x="{_LEFT}" y="{top - 7}">{name}</text>'
    for y in (low + room, high - room):
        at = top + _HEIGHT * (high - y) / (high - low)
        yield f'<text x="{_LEFT - 6}" y="{at + 4:.2f}" text-anchor="end">{y:.4g}</text>'


def _labels(x, bottom, along):
    for at in (x[0], (x[0] + x[-1]) / 2, x[-1]):
        yield f'<text x="{_across(x, at):.2f}" y="{bottom + 18}" text-anchor="middle">{at:.4g}</text>'
    yield f'<text x="{_LEFT + (_WIDTH - _LEFT - _RIGHT) / 2:.2f}" y="{bottom + 36}" text-anchor="middle">{along}</text>'


def _across(x, at):
    return _LEFT + (_WIDTH - _LEFT - _RIGHT) * (at - x[0]) / (x[-1] - x[0])
