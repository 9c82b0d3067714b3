"""A formula is a function that broadcasts, with named results, and copies nothing."""

import inspect
import pickle
import threading

import numpy as np
import pytest
from conftest import points, same

import jointproof


def test_every_formula_is_a_function_of_its_family():
    assert len(jointproof.formulas) > 100
    for id, formula in jointproof.formulas.items():
        family, name = id.split(".")
        assert getattr(getattr(jointproof, family), jointproof.formula.named(name)) is formula is jointproof.find(id)
        assert list(inspect.signature(formula).parameters) == [*(field.name for field in formula.inputs), "out"]


def test_a_family_is_a_module():
    from jointproof.slot import contact_force

    assert contact_force(3.0, 4.0).fc == 5.0


def test_numbers_in_numbers_out():
    value, jacobian = jointproof.slot.contact_force.linearize(f2=3, f3=4.0)
    assert type(value.fc) is float and value.fc == 5.0
    assert (jacobian.fc.f2, jacobian["fc"]["f3"]) == (0.6, 0.8)
    position = jointproof.slot.relative_position([1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0], [1.0, 2, 3], [4.0, 4, 4])
    assert tuple(position) == (3.0, 2.0, 1.0)


@pytest.mark.parametrize("id", list(jointproof.formulas))
def test_rows_are_points(id):
    """Every formula: the batch, its Jacobian with all zeros, single points and 237 bits agree."""
    formula = jointproof.find(id)
    drawn = points(formula, 5)
    value, jacobian = formula.linearize(**formula.unpack(drawn))
    assert jacobian.array.shape == (5, formula.m, formula.n)
    for row, point in enumerate(drawn):
        inputs = formula.unpack(point)
        one, by = formula.linearize(**inputs)
        assert all(same(a[row], b) for a, b in zip(value, one))
        assert same(jacobian.array[row], by.array)
        assert all(same(a, b) for a, b in zip(one, formula(**inputs)))
    exact, by = formula.exact_linearize(**formula.unpack(drawn[0]), number=float)
    scale = np.abs(jacobian.array[0]) @ np.abs(drawn[0])
    found = np.concatenate([np.ravel(x[0]) for x in value])
    assert np.all(np.abs(found - np.concatenate([np.ravel(x).astype(float) for x in exact])) <= 1e-9 * (np.abs(found) + scale))
    if by is not None:
        off = np.abs(by.array.astype(float) - jacobian.array[0])
        assert np.all(off <= 1e-6 * (np.abs(jacobian.array[0]).max() + 1e-300)), off.max()


def test_inputs_broadcast_as_those_of_a_ufunc(formula):
    drawn = points(formula, 12).reshape(3, 4, -1)
    inputs = formula.unpack(drawn)
    first, *rest = formula.inputs
    inputs[first.name] = inputs[first.name][:, :1]
    for field in rest[:1]:
        inputs[field.name] = inputs[field.name][0]
    value = formula(**inputs)
    full = [np.broadcast_to(inputs[field.name], (3, 4, *field.shape)) for field in formula.inputs]
    for index in np.ndindex(3, 4):
        one = formula(*(x[index] for x in full))
        assert all(same(a[index], b) for a, b in zip(value, one))


STRIDES = {
    "backwards": lambda x: x[::-1],
    "every third": lambda x: np.repeat(x, 3, axis=0)[::3],
    "by columns": np.asfortranarray,
    "turned": lambda x: np.ascontiguousarray(x.swapaxes(0, 1)).swapaxes(0, 1),
    "one for all": lambda x: np.broadcast_to(x[:1], x.shape),
}


@pytest.mark.parametrize("how", STRIDES)
def test_any_strides(formula, how):
    drawn = points(formula, 60).reshape(20, 3, -1)
    inputs = {name: STRIDES[how](np.ascontiguousarray(x)) for name, x in formula.unpack(drawn).items()}
    plain = {name: np.ascontiguousarray(x) for name, x in inputs.items()}
    value, jacobian = formula.linearize(**inputs)
    expected, by = formula.linearize(**plain)
    assert all(same(a, b) for a, b in zip(value, expected))
    assert same(jacobian.array, by.array)


@pytest.mark.parametrize("shape", [(0,), (3, 0), (1,), (1, 1), (2, 1, 3), (5000,), (2, 2000)])
def test_any_shape(shape):
    f2 = np.arange(np.prod(shape), dtype=float).reshape(shape) + 1
    value, jacobian = jointproof.slot.contact_force.linearize(f2, 1.0)
    assert value.fc.shape == shape and jacobian.fc.f3.shape == shape
    assert np.array_equal(value.fc, np.hypot(f2, 1.0)) or np.allclose(value.fc, np.hypot(f2, 1.0), rtol=4e-16)


def test_nothing_is_copied():
    """What a call takes of memory is what it returns: 10⁶ numbers here, of two inputs."""
    import tracemalloc

    x = np.linspace(1, 2, 2_000_000)[::2]
    y = np.ones(())
    tracemalloc.start()
    value = jointproof.slot.contact_force(x, y)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert value.fc.nbytes <= peak < value.fc.nbytes * 1.1


def test_results_are_views_of_one_table():
    value, jacobian = jointproof.slot.friction.linearize(*np.ones((len(jointproof.slot.friction.inputs), 100)))
    assert jacobian.array.base is not None
    for output in jointproof.slot.friction.outputs:
        for field in jointproof.slot.friction.inputs:
            assert np.shares_memory(jacobian[output.name][field.name], jacobian.array)


def test_out_is_written(formula):
    inputs = formula.unpack(points(formula, 50))
    expected = formula.linearize(**inputs)
    out = formula.linearize(**formula.unpack(points(formula, 50, seed=1)))
    value, jacobian = formula.linearize(**inputs, out=out)
    assert all(a is b for a, b in zip(value, out.value)) and jacobian.array is out.jacobian.array
    assert all(same(a, b) for a, b in zip(value, expected.value)) and same(jacobian.array, expected.jacobian.array)
    # An array of somebody else's, with numbers where the Jacobian is zero everywhere.
    other = np.full((formula.m, formula.n, 50), 7.0).transpose(2, 0, 1)
    _, jacobian = formula.linearize(**inputs, out=(value, other))
    assert jacobian.array is other and same(other, expected.jacobian.array)
    named = {field.name: np.empty((50, *field.shape)) for field in formula.outputs}
    formula(**inputs, out=named)
    assert all(same(named[name], getattr(expected.value, name)) for name in named)


def test_an_output_may_not_be_an_input():
    x = np.ones(10)
    with pytest.raises(TypeError, match="borrow"):
        jointproof.slot.contact_force(x, 1.0, out=x)


def test_integers_and_lists_are_numbers():
    assert jointproof.slot.contact_force([3, 5], np.array([4, 12], np.int32)).fc.tolist() == [5.0, 13.0]
    assert jointproof.slot.contact_force(np.float32(3), np.array([4], ">f8")).fc.tolist() == [5.0]


def test_exact_results_have_237_bits():
    mpmath = pytest.importorskip("mpmath")
    with mpmath.workprec(237):
        exact, by = jointproof.slot.contact_force.exact_linearize(1.0, [1.0, 2.0], number=mpmath.mpf)
        assert exact.fc[0] == mpmath.sqrt(2) and by.fc.f3[0] == 1 / mpmath.sqrt(2)
    text = jointproof.slot.contact_force.exact(1.0, 1.0).fc
    assert text.startswith("1.41421356237309504880168872420969807856967187537694807317667973799")


def test_the_lock_is_released():
    """Another thread of Python runs while a batch is computed."""
    formula = jointproof.find("ujoint.friction")
    inputs = formula.unpack(np.repeat(points(formula, 1), 300_000, axis=0))
    counted, done = 0, threading.Event()

    def batch():
        formula.linearize(**inputs)
        done.set()

    thread = threading.Thread(target=batch)
    thread.start()
    while not done.is_set():
        counted += 1
    thread.join()
    # Who holds the lock lets others run once at its beginning and end.
    assert counted > 100


def test_formulas_and_results_travel(formula):
    inputs = formula.unpack(points(formula, 3))
    assert pickle.loads(pickle.dumps(formula)) is formula
    value, jacobian = formula.linearize(**inputs)
    again, by = pickle.loads(pickle.dumps((value, jacobian)))
    assert type(again) is type(value) and all(same(a, b) for a, b in zip(again, value))
    assert same(by.array, jacobian.array)
