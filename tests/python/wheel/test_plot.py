"""An output and its derivative are drawn, as SVG and with Matplotlib."""

import numpy as np
import pytest

import jointproof


class Axes:
    """What a drawing calls of axes of Matplotlib."""

    def __init__(self):
        self.lines, self.jumps, self.labels = [], [], []

    def plot(self, x, y, color):
        self.lines.append((x, y))

    def axvline(self, x, color, linestyle):
        self.jumps.append(x)

    def set_ylabel(self, label):
        self.labels.append(label)

    set_xlabel = set_ylabel


def test_a_curve_is_broken_where_its_derivative_jumps():
    plot = jointproof.plot("coulomb.return_map", "f", along="f_trial", between=(-3, 3), mu=0.5, fn=4.0)
    assert plot.svg.count("<polyline") == 4 and plot.svg == plot._repr_svg_()
    value, slope = plot.draw([Axes(), Axes()])
    assert [len(axes.lines) for axes in (value, slope)] == [1, 3] and np.allclose(value.jumps, [-2, 2], atol=0.02)
    assert value.labels == ["f"] and slope.labels == ["∂f/∂f_trial", "f_trial"]
    x, y = value.lines[0]
    assert np.array_equal(y, np.clip(x, -2, 2)) and [set(y) for _, y in slope.lines] == [{0.0}, {1.0}, {0.0}]


def test_what_is_not_there_is_named():
    with pytest.raises(ValueError, match="coulomb.return_map has no output 'g'; it has f$"):
        jointproof.plot("coulomb.return_map", "g", along="f_trial", between=(-3, 3), mu=0.5, fn=4.0)
    with pytest.raises(ValueError, match="has no input 'x'"):
        jointproof.plot("coulomb.return_map", "f", along="x", between=(-3, 3), mu=0.5, fn=4.0)
