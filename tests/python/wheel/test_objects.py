"""Results are ordinary objects; processes that are forked compute; what an array would lose is refused."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
from conftest import same, wanted

import jointproof

contact_force = jointproof.slot.contact_force


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda x: pickle.loads(pickle.dumps(x))])
def test_results_can_be_copied(copied):
    value, jacobian = contact_force.linearize(f2=[3.0, 5.0], f3=[4.0, 12.0])
    assert same(copied(value).fc, value.fc) and type(copied(value)) is type(value)
    assert same(copied(jacobian).array, jacobian.array)
    assert same(copied(jacobian.fc).f2, jacobian.fc.f2)
    assert copied(contact_force) is contact_force
    field = contact_force.inputs[0]
    assert (copied(field).name, copied(field).places) == (field.name, field.places)


def test_results_say_what_they_are():
    _, jacobian = contact_force.linearize(f2=3.0, f3=4.0)
    assert repr(jacobian.fc) == "<Gradient of fc by f2, f3>"
    assert same(np.asarray(jacobian), jacobian.array) and not np.shares_memory(np.array(jacobian), jacobian.array)
    with pytest.raises(TypeError, match="blocks of several shapes; take one, as .f2"):
        np.asarray(jacobian.fc)
    with pytest.raises(AttributeError, match="there is no input 'g'"):
        jacobian.fc.g


def total(k):
    x = np.linspace(1.0, 2.0, 200_000)
    return float(contact_force(x, k * x).fc.sum())


@pytest.mark.parametrize("start", ["fork", "spawn"])
def test_processes_compute_after_their_parent_did(start):
    expected = [total(k) for k in range(3)]
    with multiprocessing.get_context(start).Pool(2) as pool:
        assert pool.map_async(total, range(3)).get(timeout=100) == expected


def test_masks_are_refused_where_they_hide_something():
    f2 = np.ma.masked_array([3.0, 5.0], [False, True])
    with pytest.raises(TypeError, match="f2: some elements are masked"):
        contact_force(f2, 4.0)
    assert contact_force(np.ma.masked_array([3.0], [False]), 4.0).fc == [5.0]


def test_units_are_refused():
    newton = wanted("pint").UnitRegistry().newton
    with pytest.raises(TypeError, match="f2: it has the unit newton, and formulas take plain numbers"):
        contact_force(3.0 * newton, 4.0)
    with pytest.raises(TypeError, match="f3: it has the unit newton"):
        contact_force(3.0, np.array([4.0]) * newton)
    assert contact_force((3.0 * newton).magnitude, 4.0).fc == 5.0
