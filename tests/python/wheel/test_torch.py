"""A formula is an operation of PyTorch, with its own derivative, in every transformation and at every order."""

import os

import numpy as np
import pytest
from conftest import points

import jointproof
from jointproof import arrays

if os.environ.get("JOINTPROOF_REQUIRE_TORCH"):
    import torch
else:
    # Its wheel has 200 MB and more: tested where it is installed.
    torch = pytest.importorskip("torch")
from exact import Golden
from test_arrays import BENT, DOUBLE, THERE, bent, judged, linearized, off_by
from torch.func import grad, hessian, jacfwd, jacrev, jvp, vmap

from jointproof import torch as operations

contact_force = operations.operation("slot.contact_force")


def near(one, other):
    return np.allclose(one, other, rtol=1e-13, atol=1e-15 * np.abs(other).max(initial=0.0))


@pytest.mark.parametrize("id", ["slot.friction", "slot.relative_position", "element.arm", "universal.angles"])
def test_derivatives_are_the_formulas(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = [torch.tensor(x, requires_grad=True) for x in formula.unpack(points(formula, 5)).values()]
    value, jacobian = formula.linearize(*(x.detach().numpy() for x in inputs))
    results = operation(*inputs)
    assert all(near(a.detach().numpy(), b) for a, b in zip(results, value))
    weights = [torch.rand_like(y) for y in results]
    sum((w * y).sum() for w, y in zip(weights, results)).backward()
    packed = np.concatenate([w.reshape(5, -1) for w in weights], axis=-1)
    expected = np.einsum("rm,rmn->rn", packed, jacobian.array)
    for field, x in zip(formula.inputs, inputs):
        assert near(x.grad.reshape(5, -1).numpy(), expected[:, field.places])


def test_its_own_checks_pass():
    f2 = torch.tensor([3.0, 5.0], dtype=torch.float64, requires_grad=True)
    f3 = torch.tensor(4.0, dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(lambda *x: contact_force(*x).fc, (f2, f3), check_forward_ad=True)
    assert torch.autograd.gradgradcheck(lambda *x: contact_force(*x).fc, (f2, f3))


def total(x):
    return contact_force(x, 4.0).fc.sum()


def test_a_hessian_is_the_same_in_every_way():
    x = torch.tensor([3.0, 5.0], dtype=torch.float64)
    exact = (16.0 / (x**2 + 16.0) ** 1.5).numpy()
    ways = [hessian(total), *(a(b(total)) for a in (jacfwd, jacrev) for b in (jacfwd, jacrev))]
    for way in [*ways, lambda x: torch.autograd.functional.hessian(total, x)]:
        assert near(way(x).numpy(), np.diag(exact))
    assert near(vmap(hessian(total))(x).numpy(), exact)
    assert near(vmap(grad(total))(x).numpy(), (x / (x**2 + 16.0) ** 0.5).numpy())
    one = torch.tensor(3.0, dtype=torch.float64)
    assert near(jacfwd(jacfwd(jacfwd(total)))(one).numpy(), -48.0 * 3.0 / 25.0**2.5)


@pytest.mark.parametrize("id", THERE)
def test_golden_cases(id):
    function, operation = arrays.find(id), operations.operation(id)
    golden = Golden(function.formula, DOUBLE)
    inputs = [torch.tensor(x) for x in golden.inputs]
    value, jacobian = linearized(function)(*inputs)
    value = [y.numpy() for y in value]
    assert not judged(function.formula, golden, value, jacobian, 2.0**-53)
    assert all(np.array_equal(y, x, equal_nan=True) for y, x in zip(operation(*inputs), value))


def by_hessian(rows, x, along):
    return torch.einsum("rmjk,rk->rmj", vmap(hessian(lambda x: rows(x[None])[0]))(x), along)


def twice_backwards(rows, x, along):
    x = x.clone().requires_grad_()
    changes = []
    for result in rows(x).T:
        (slope,) = torch.autograd.grad(result.sum(), x, create_graph=True)
        (change,) = torch.autograd.grad((slope * along).sum(), x, retain_graph=True, materialize_grads=True) if slope.requires_grad else (torch.zeros_like(x),)
        changes.append(change)
    return torch.stack(changes, dim=1)


def forwards_over_backwards(rows, x, along):
    return vmap(lambda x, d: jvp(jacrev(lambda x: rows(x[None])[0]), (x,), (d,))[1])(x, along)


def off(id, operation=None):
    """By how much second derivatives differ from the exact ones at most, in each way."""
    formula = jointproof.find(id)
    operation = operation or operations.operation(id)
    inputs, along, exact = bent(formula)
    assert len(inputs) == 100

    def rows(x):
        return torch.cat([y.reshape(len(x), -1) for y in operation(**formula.unpack(x))], dim=-1)

    ways = [way(rows, torch.tensor(inputs), torch.tensor(along)) for way in (by_hessian, twice_backwards, forwards_over_backwards)]
    return [off_by(found.detach().numpy(), exact) for found in ways]


@pytest.mark.parametrize("id", BENT)
def test_second_derivatives_are_exact(id):
    assert max(off(id)) < 1e-9


def test_a_wrong_sign_in_a_rule_is_noticed():
    right = arrays.slot.contact_force

    def planted(lib, *numbers):
        value, (by_f2, by_f3) = right._linearized(lib, *numbers)
        return value, (by_f2, -by_f3)

    wrong = arrays.Function(right.id, right._value, planted, right._accepted, right.entries)
    assert min(off(right.id, operations.ruled(wrong))) > 1e-2


@pytest.mark.parametrize("backend", ["aot_eager", "inductor"])
@pytest.mark.parametrize("id", ["slot.friction", "cardan.angles", "hinge.friction", "slide_line.torque_linear", "interaction.pressure_exponential"])
def test_it_is_compiled(id, backend):
    """From the first call on, at which no type of its results has been made."""
    formula = jointproof.find(id)
    x = torch.tensor(bent(formula, 20)[0])
    vars(formula).pop("Value", None)
    operation = operations.ruled(arrays.find(id))

    def total(x):
        return sum(y.sum() for y in operation(**formula.unpack(x)))

    torch.compiler.reset()
    inputs = x.clone().requires_grad_()
    value = torch.compile(total, backend=backend, fullgraph=True)(inputs)
    value.backward()
    assert near(value.detach().numpy(), total(x).numpy()) and near(inputs.grad.numpy(), grad(total)(x).numpy())
    mapped = torch.compile(vmap(grad(total)), backend=backend, fullgraph=True)(x)
    assert near(mapped.numpy(), grad(total)(x).numpy())


def test_it_is_exported():
    class Loads(torch.nn.Module):
        def forward(self, f2):
            return contact_force(f2, 4.0).fc

    x = torch.tensor([3.0, 5.0], dtype=torch.float64)
    assert torch.equal(torch.export.export(Loads(), (x,)).module()(x), contact_force(x, 4.0).fc)


def test_precision_is_kept_and_what_is_not_allowed_is_nan():
    single = torch.tensor([3.0, 0.0], requires_grad=True)
    assert contact_force(single, 4.0).fc.dtype == torch.float32
    friction = operations.operation("slot.friction")
    mu = torch.tensor([0.25, -1.0], dtype=torch.float64)
    assert torch.isnan(friction(1.0, 3.0, 4.0, 0.0, mu).phi).tolist() == [False, True]
    with pytest.raises(jointproof.InputError, match="row 1: mu is -1.0"):
        operations.operation("slot.friction", checked=True)(1.0, 3.0, 4.0, 0.0, mu)
    with pytest.raises(TypeError, match="slot.friction: checked=True looks at numbers"):
        vmap(lambda mu: operations.operation("slot.friction", checked=True)(1.0, 3.0, 4.0, 0.0, mu).phi)(mu)


def test_numbers_are_exact_and_errors_name_the_input():
    single = torch.tensor([3.0])
    assert contact_force(0.1, torch.zeros(1, dtype=torch.float64)).fc == contact_force([0.1], 0.0).fc == 0.1
    assert contact_force(single, np.array([4.0])).fc.dtype == torch.float32
    for wrong in (torch.tensor([1j]), np.array([1j]), "a", None):
        with pytest.raises(TypeError, match="^f3: "):
            contact_force(single, wrong)
    with pytest.raises(TypeError, match="f2: .* jointproof.torch.operation has the formula for that"):
        jointproof.slot.contact_force(single.requires_grad_(), 4.0)


class Forces(torch.utils.data.Dataset):
    def __len__(self):
        return 4

    def __getitem__(self, k):
        return float(jointproof.slot.contact_force(np.linspace(1, 2, 200_000), float(k)).fc.sum())


def test_a_loader_with_processes_ends():
    before = [Forces()[k] for k in range(4)]
    loader = torch.utils.data.DataLoader(Forces(), num_workers=2, multiprocessing_context="fork", timeout=60)
    assert [float(x) for x in loader] == before
