"""A formula is an operation of PyTorch, with its own derivative."""

import numpy as np
import pytest
from conftest import points, same

import jointproof

# Its wheel has 200 MB and more: tested where it is installed.
torch = pytest.importorskip("torch")
operations = pytest.importorskip("jointproof.torch")


@pytest.mark.parametrize("id", ["slot.friction", "slot.relative_position", "element.arm", "universal.angles"])
def test_derivatives_are_the_formulas(id):
    formula, operation = jointproof.find(id), operations.operation(id)
    inputs = [torch.tensor(x, requires_grad=True) for x in formula.unpack(points(formula, 5)).values()]
    value, jacobian = formula.linearize(*(x.detach().numpy() for x in inputs))
    results = operation(*inputs)
    assert all(same(a.detach(), b) for a, b in zip(results, value))
    weights = [torch.rand_like(y) for y in results]
    sum((w * y).sum() for w, y in zip(weights, results)).backward()
    packed = np.concatenate([w.reshape(5, -1) for w in weights], axis=-1)
    expected = np.einsum("rm,rmn->rn", packed, jacobian.array)
    for field, x in zip(formula.inputs, inputs):
        assert np.allclose(x.grad.reshape(5, -1), expected[:, field.places], rtol=1e-13, atol=1e-300)


def test_its_own_check_passes():
    operation = operations.operation("slot.contact_force")
    f2 = torch.tensor([3.0, 5.0], dtype=torch.float64, requires_grad=True)
    f3 = torch.tensor(4.0, dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(lambda *x: operation(*x).fc, (f2, f3))


def test_a_second_derivative_is_refused():
    operation = operations.operation("slot.contact_force")
    x = torch.tensor([3.0, 5.0], dtype=torch.float64, requires_grad=True)
    (first,) = torch.autograd.grad((x**2 + operation(x, 4.0).fc).sum(), x, create_graph=True)
    assert torch.allclose(first, 2 * x + x / torch.hypot(x, torch.tensor(4.0, dtype=torch.float64)))
    wanted = [
        lambda: torch.autograd.grad(first.sum(), x),
        lambda: torch.autograd.functional.hessian(lambda x: operation(x, 4.0).fc.sum(), x),
        lambda: torch.autograd.gradgradcheck(lambda x: operation(x, 4.0).fc, (x,)),
    ]
    for second in wanted:
        with pytest.raises(NotImplementedError, match="slot.contact_force: its second derivative is wanted"):
            second()


class Forces(torch.utils.data.Dataset):
    def __len__(self):
        return 4

    def __getitem__(self, k):
        return float(jointproof.slot.contact_force(np.linspace(1, 2, 200_000), float(k)).fc.sum())


def test_a_loader_with_processes_ends():
    before = [Forces()[k] for k in range(4)]
    loader = torch.utils.data.DataLoader(Forces(), num_workers=2, multiprocessing_context="fork", timeout=60)
    assert [float(x) for x in loader] == before
