"""The Python package as it is installed. What a test needs beside it is skipped where it is absent, unless
JOINTPROOF_REQUIRE_PYTHON is set, as in .ci/run."""

import importlib
import os

import numpy as np
import pytest

import jointproof


def wanted(name):
    """A package that only some tests need."""
    if os.environ.get("JOINTPROOF_REQUIRE_PYTHON"):
        return importlib.import_module(name)
    return pytest.importorskip(name)


def points(formula, count, seed=0):
    """Valid inputs of a formula, by components, from its golden cases and random points."""
    called = jointproof._jointproof.Called(formula._place, False, count, seed, False)
    drawn = called.points()
    # Without those that are asked only for how large or small inputs may be.
    sizes = np.abs(drawn)
    usual = drawn[np.all((sizes == 0) | ((sizes > 1e-6) & (sizes < 1e6)), axis=1)]
    return usual[len(usual) - count :]


def same(one, other):
    """Whether arrays have the same bits, NaN included."""
    one, other = np.ascontiguousarray(one, float), np.ascontiguousarray(other, float)
    return one.shape == other.shape and one.tobytes() == other.tobytes()


@pytest.fixture(params=["slot.friction", "universal.angles", "element.arm", "ujoint.decomposition", "translator.radial_force"])
def formula(request):
    return jointproof.find(request.param)
