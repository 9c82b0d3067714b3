"""A formula is an operation of PyTorch, with its own derivative, in every transformation and at every order."""

import numpy as np
import pytest
from conftest import points

import jointproof

# Its wheel has 200 MB and more: tested where it is installed.
torch = pytest.importorskip("torch")
operations = pytest.importorskip("jointproof.torch")
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
    from torch.func import grad, hessian, jacfwd, jacrev, vmap

    x = torch.tensor([3.0, 5.0], dtype=torch.float64)
    exact = (16.0 / (x**2 + 16.0) ** 1.5).numpy()
    ways = [hessian(total), *(a(b(total)) for a in (jacfwd, jacrev) for b in (jacfwd, jacrev))]
    for way in [*ways, lambda x: torch.autograd.functional.hessian(total, x)]:
        assert near(way(x).numpy(), np.diag(exact))
    assert near(vmap(hessian(total))(x).numpy(), exact)
    assert near(vmap(grad(total))(x).numpy(), (x / (x**2 + 16.0) ** 0.5).numpy())
    one = torch.tensor(3.0, dtype=torch.float64)
    assert near(jacfwd(jacfwd(jacfwd(total)))(one).numpy(), -48.0 * 3.0 / 25.0**2.5)


@pytest.mark.parametrize("id", ["slot.friction", "universal.angles", "ujoint.hinge_bending", "slide_line.torque_linear", "hinge.contact_moment"])
def test_second_derivatives_are_exact(id):
    from test_arrays import bent, off_by

    formula, operation = jointproof.find(id), operations.operation(id)
    inputs, ways, exact = bent(formula)

    def value(x):
        return torch.cat([y.reshape(-1) for y in operation(**formula.unpack(x))])

    along = torch.func.vmap(lambda x, d: torch.func.jvp(torch.func.jacrev(value), (x,), (d,))[1])
    assert off_by(along(torch.tensor(inputs), torch.tensor(ways)).numpy(), exact) < 1e-9


@pytest.mark.parametrize("backend", ["aot_eager", "inductor"])
def test_it_is_compiled(backend):
    x = torch.tensor([3.0, 5.0], dtype=torch.float64, requires_grad=True)
    value = torch.compile(total, backend=backend, fullgraph=True)(x)
    value.backward()
    assert near(value.detach().numpy(), 5.0 + 41.0**0.5) and near(x.grad.numpy(), (x / (x**2 + 16.0) ** 0.5).detach().numpy())


def test_precision_is_kept_and_what_is_not_allowed_is_nan():
    single = torch.tensor([3.0, 0.0], requires_grad=True)
    assert contact_force(single, 4.0).fc.dtype == torch.float32
    friction = operations.operation("slot.friction")
    mu = torch.tensor([0.25, -1.0], dtype=torch.float64)
    assert torch.isnan(friction(1.0, 3.0, 4.0, 0.0, mu).phi).tolist() == [False, True]
    with pytest.raises(jointproof.InputError, match="row 1: mu is -1.0"):
        operations.operation("slot.friction", checked=True)(1.0, 3.0, 4.0, 0.0, mu)


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
