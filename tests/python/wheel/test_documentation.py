"""Documentation and type stubs, as they are in the wheel, are what the catalog says."""

import ast
import pathlib

import pytest
from conftest import wanted

import jointproof

PACKAGE = pathlib.Path(jointproof.__file__).parent


def test_every_formula_says_what_it_is():
    for formula in jointproof.formulas.values():
        said = formula.__doc__
        assert formula.title in said and str(formula.source) in said
        for field in (*formula.inputs, *formula.outputs):
            line = next(line for line in said.split("\n") if line.strip().startswith(f"{field.name}: {field.meaning}"))
            assert field.allowed in line and f"unit {field.unit}" in line
            assert not field.shape or str(list(field.shape)) in line


def test_what_is_documented_is_what_runs():
    """The examples of the package's own documentation."""
    import doctest

    failed, tried = doctest.testmod(jointproof)
    assert tried > 3 and failed == 0


def test_a_type_checker_sees_names(tmp_path, monkeypatch):
    api = wanted("mypy.api")
    source = tmp_path / "uses.py"
    source.write_text(
        "import numpy as np\n"
        "from jointproof.slot import contact_force\n"
        "value, jacobian = contact_force.linearize(f2=np.ones(3), f3=4.0)\n"
        "value.fc, jacobian.fc.f2\n"
        "value.fd\n"
        "contact_force(f4=1.0)\n"
        "import jointproof\n"
        "jointproof.slot.contact_force(f2=3.0, f3=4.0).fc, jointproof.find('slot.yield').inputs\n"
        "jointproof.slott\n"
    )
    folder = PACKAGE.parent
    # mypy finds what is installed where Python looks by itself, and refuses to be told of it.
    if folder.name != "site-packages":
        monkeypatch.setenv("MYPYPATH", str(folder))
    said, wrong, _ = api.run(["--no-incremental", "--follow-imports", "silent", "--cache-dir", str(tmp_path), str(source)])
    assert not wrong
    assert '_ContactForceValue" has no attribute "fd"' in said
    assert 'Unexpected keyword argument "f4"' in said
    assert 'Module has no attribute "slott"' in said
    places = {line.split(":")[1] for line in said.split("\n")[:-2]}
    assert places == {"5", "6", "9"}, said


@pytest.mark.parametrize("family", sorted({id.split(".")[0] for id in jointproof.formulas}))
def test_a_stub_has_what_is_there(family):
    tree = ast.parse((PACKAGE / f"{family}.pyi").read_text(encoding="utf-8"))
    named = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)} - {"Numbers"}
    assert named == set(getattr(jointproof, family).__all__)
