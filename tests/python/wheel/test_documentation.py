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


USES = """\
import numpy as np
from jointproof.slot import contact_force
value, jacobian = contact_force.linearize(f2=np.ones(3), f3=4.0)
value.fc.shape, jacobian.fc.f2.shape
value.fd
contact_force(f4=1.0)
import jointproof
number: float = jointproof.slot.contact_force(f2=3.0, f3=4.0).fc
slope: float = contact_force.linearize(3.0, 4.0).jacobian.fc.f2
jointproof.find('slot.yield').inputs[0].name, jointproof.arrays.slot.friction.id
jointproof.slott
wrong: float = value.fc
"""


@pytest.fixture(scope="module")
def typed(tmp_path_factory):
    """What mypy says, strictly, of these uses and of the examples of the chapter: in one run, since it reads everything anew in each."""
    api = wanted("mypy.api")
    examples = re.findall(r"^```python\n(.*?)^```", CHAPTER.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert len(examples) > 9
    folder = tmp_path_factory.mktemp("typed")
    programs = {"uses": USES, "chapter": "\n".join(examples)}
    for name, program in programs.items():
        (folder / f"{name}.py").write_text(program, encoding="utf-8")
    # What JAX and Dask leave untyped is theirs.
    theirs = ["--untyped-calls-exclude=jax", "--untyped-calls-exclude=dask"]
    options = ["--strict", *theirs, "--no-incremental", "--follow-imports", "silent", "--cache-dir", str(folder)]
    with pytest.MonkeyPatch.context() as patch:
        # mypy finds what is installed where Python looks by itself, and refuses to be told of it.
        if PACKAGE.parent.name != "site-packages":
            patch.setenv("MYPYPATH", str(PACKAGE.parent))
        found, wrong, _ = api.run([*options, *(str(folder / f"{name}.py") for name in programs)])
    assert not wrong
    said = [re.search(r"(uses|chapter)\.py:(.*)", line).groups() for line in found.splitlines()[:-1]]
    return {name: [line for of, line in said if of == name] for name in programs}


def test_a_type_checker_sees_names_and_shapes(typed):
    said = typed["uses"]
    for line, found in zip(
        ["5", "6", "11", "12"], ['_ContactForceValue.* has no attribute "fd"', "No overload variant|f4", 'no attribute "slott"', "Incompatible types"]
    ):
        assert any(one.startswith(f"{line}:") and re.search(found, one) for one in said), said
    assert {one.split(":")[0] for one in said if "error" in one} == {"5", "6", "11", "12"}, said


def test_the_chapter_is_typed(typed):
    assert typed["chapter"] == []


@pytest.mark.parametrize("family", sorted({id.split(".")[0] for id in jointproof.formulas}))
def test_a_stub_has_what_is_there(family):
    tree = ast.parse((PACKAGE / f"{family}.pyi").read_text(encoding="utf-8"))
    named = {node.target.id: ast.unparse(node.annotation) for node in tree.body if isinstance(node, ast.AnnAssign)}
    elements = {name for name, kind in named.items() if kind == "Final[Element]"}
    assert set(named) - elements - {"Array"} == set(getattr(jointproof, family).__all__)
    assert (family == "element") == bool(elements) and all(hasattr(jointproof.element, name) for name in elements)
