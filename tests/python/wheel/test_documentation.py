"""Documentation and type stubs, as they are in the wheel, are what the catalog says."""

import ast
import pathlib
import re

import pytest
from conftest import wanted

import jointproof

PACKAGE = pathlib.Path(jointproof.__file__).parent
CHAPTER = pathlib.Path(__file__).resolve().parents[3] / "book" / "src" / "python.md"


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


@pytest.fixture
def typed(tmp_path, monkeypatch):
    """What mypy says of a program, strictly."""
    api = wanted("mypy.api")
    folder = PACKAGE.parent
    # mypy finds what is installed where Python looks by itself, and refuses to be told of it.
    if folder.name != "site-packages":
        monkeypatch.setenv("MYPYPATH", str(folder))

    def said(program):
        source = tmp_path / "uses.py"
        source.write_text(program, encoding="utf-8")
        # What JAX and Dask leave untyped is theirs.
        theirs = ["--untyped-calls-exclude=jax", "--untyped-calls-exclude=dask"]
        options = ["--strict", *theirs, "--no-incremental", "--follow-imports", "silent", "--cache-dir", str(tmp_path)]
        found, wrong, _ = api.run([*options, str(source)])
        assert not wrong
        return [line.split(":", 1)[1] for line in found.split("\n")[:-2]]

    return said


def test_a_type_checker_sees_names_and_shapes(typed):
    said = typed(
        "import numpy as np\n"
        "from jointproof.slot import contact_force\n"
        "value, jacobian = contact_force.linearize(f2=np.ones(3), f3=4.0)\n"
        "value.fc.shape, jacobian.fc.f2.shape\n"
        "value.fd\n"
        "contact_force(f4=1.0)\n"
        "import jointproof\n"
        "number: float = jointproof.slot.contact_force(f2=3.0, f3=4.0).fc\n"
        "slope: float = contact_force.linearize(3.0, 4.0).jacobian.fc.f2\n"
        "jointproof.find('slot.yield').inputs[0].name, jointproof.arrays.slot.friction.id\n"
        "jointproof.slott\n"
        "wrong: float = value.fc\n"
    )
    for line, found in zip(
        ["5", "6", "11", "12"], ['_ContactForceValue.* has no attribute "fd"', "No overload variant|f4", 'no attribute "slott"', "Incompatible types"]
    ):
        assert any(one.startswith(f"{line}:") and re.search(found, one) for one in said), said
    assert {one.split(":")[0] for one in said if "error" in one} == {"5", "6", "11", "12"}, said


def test_the_chapter_is_typed(typed):
    examples = re.findall(r"^```python\n(.*?)^```", CHAPTER.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert len(examples) > 9 and typed("\n".join(examples)) == []


@pytest.mark.parametrize("family", sorted({id.split(".")[0] for id in jointproof.formulas}))
def test_a_stub_has_what_is_there(family):
    tree = ast.parse((PACKAGE / f"{family}.pyi").read_text(encoding="utf-8"))
    named = {node.target.id: ast.unparse(node.annotation) for node in tree.body if isinstance(node, ast.AnnAssign)}
    elements = {name for name, kind in named.items() if kind == "Final[Element]"}
    assert set(named) - elements - {"Array"} == set(getattr(jointproof, family).__all__)
    assert (family == "element") == bool(elements) and all(hasattr(jointproof.element, name) for name in elements)
