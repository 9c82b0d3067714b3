"""What is wrong is said by name: the row, the input, its value, and what is allowed."""

import pickle

import numpy as np
import pytest

import jointproof
from jointproof import InputError, ShapeError

force = jointproof.slot.contact_force


def test_a_row_is_named():
    f2 = np.array([[3.0, np.nan], [np.inf, 8.0]])
    with pytest.raises(InputError) as caught:
        force.linearize(f2, 4.0)
    error = caught.value
    assert (error.row, error.index, error.input, error.count, error.kind) == (1, (0, 1), "f2", 2, "NonFinite")
    assert np.isnan(error.value) and error.allowed == "a finite number"
    assert str(error) == (
        "slot.contact_force: row 1 at [0, 1], the first of 2 that are refused: f2 is NaN; allowed is a finite number"
    )
    value, jacobian = error.results
    assert value.fc[0, 0] == 5.0 and np.isnan(value.fc).sum() == 2
    assert np.isnan(jacobian.fc.f2).sum() == 2


def test_the_row_is_the_first_whatever_the_strides():
    for turn in (lambda x: x, np.asfortranarray):
        f2 = turn(np.ones((300, 7000)))
        f2[200, 11], f2[11, 200] = np.nan, np.nan
        with pytest.raises(InputError) as caught:
            force(f2, 1.0)
        assert (caught.value.row, caught.value.index) == (11 * 7000 + 200, (11, 200))


def test_a_component_is_named():
    position = jointproof.slot.relative_position
    e1a, xb = np.tile([1.0, 0, 0], (4, 1)), np.zeros((4, 3))
    xb[2, 1] = np.inf
    with pytest.raises(InputError, match=r"row 2: xb\[1\] is inf") as caught:
        position(e1a, [0, 1.0, 0], [0, 0, 1.0], np.zeros(3), xb)
    assert caught.value.input == "xb[1]"
    with pytest.raises(InputError, match="^slot.relative_position: xa") as caught:
        position([1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0], [np.nan, 0, 0], [0, 0, 0])
    assert caught.value.index == ()


def test_inputs_that_are_wrong_together_are_named():
    with pytest.raises(InputError) as caught:
        jointproof.slot.stop(*[1.0] * (len(jointproof.slot.stop.inputs) - 2), 2.0, 1.0)
    assert caught.value.kind == "OutOfOrder" and caught.value.input is not None


def test_shapes_are_named():
    with pytest.raises(ShapeError, match=r"slot.contact_force: .* f2 \[3\], f3 \[4\]"):
        force(np.ones(3), np.ones(4))
    with pytest.raises(ShapeError, match=r"xa: shape \[2\]; allowed is \[…, 3\]") as caught:
        jointproof.slot.relative_position([1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0], [1.0, 2], [4.0, 4, 4])
    assert caught.value.name == "xa"
    with pytest.raises(ShapeError, match=r"out.fc: shape \[3\]"):
        force(np.ones(4), 1.0, out=np.empty(3))
    with pytest.raises(TypeError, match="out.fc: an array of doubles"):
        force(np.ones(4), 1.0, out=np.empty(4, np.float32))
    locked = np.empty(4)
    locked.flags.writeable = False
    with pytest.raises(ValueError, match="out.fc: cannot be written"):
        force(np.ones(4), 1.0, out=locked)


def test_inputs_are_named():
    with pytest.raises(TypeError, match="slot.contact_force has no input 'f4'; it has f2, f3"):
        force(f2=1.0, f4=2.0)
    with pytest.raises(TypeError, match="needs f3"):
        force(1.0)
    with pytest.raises(TypeError, match="f2 is given twice"):
        force(1.0, f2=2.0)
    with pytest.raises(TypeError, match="takes 2 inputs"):
        force(1.0, 2.0, 3.0)
    with pytest.raises(TypeError, match="f3: numbers of type complex128 are no doubles"):
        force(1.0, 2j)
    with pytest.raises(TypeError, match="f2: "):
        force("three", 4.0)
    with pytest.raises(AttributeError, match="no input 'f9'; there are f2, f3"):
        force.linearize(3.0, 4.0).jacobian.fc.f9
    with pytest.raises(KeyError, match="slot.nothing"):
        jointproof.find("slot.nothing")


def test_errors_travel():
    with pytest.raises(InputError) as caught:
        force([1.0, np.nan], 1.0)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value) and again.index == (1,) and np.isnan(again.results.fc[1])


def test_exact_points_are_named():
    with pytest.raises(InputError, match="row 1: f3 is NaN"):
        force.exact(1.0, [1.0, np.nan])
