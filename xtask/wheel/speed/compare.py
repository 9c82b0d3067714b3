#!/usr/bin/env python3
"""Value and Jacobian of a formula of every room at many points: the Python package beside Rust, JAX and CasADi, in one run.

Rust is a program that calls `batch` over the same inputs. JAX is jit(vmap) of value and jacfwd, in doubles on the processor,
with the derivatives as columns or as one array, whichever is faster. CasADi is `map`, on one thread or on all, whichever is
faster, from matrices of its own. All are timed in turns; a ratio is another's least time by our least, with the least and the
greatest ratio of a round. Ours writes into arrays that are there, as Rust and CasADi do; "fresh" is our time with new arrays by that
without. Before anything is timed, results are compared.

examples:
  python3 xtask/wheel/speed/compare.py
  python3 xtask/wheel/speed/compare.py --points 100000 --rounds 3 --only slot.friction

It needs the package installed, and requirements.txt beside the tests in tests/python/wheel.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import casadi
import jax
import jax.numpy as jnp
import numpy as np
from definitions import DEFINITIONS

import jointproof

#: So many must be faster than both. Those that check triads at every row, which the others do not, are shown all the same.
TEN = 10
HERE = Path(__file__).resolve().parent
TARGET = HERE.parents[2] / "target" / "speed"
jax.config.update("jax_enable_x64", True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--only", choices=list(DEFINITIONS), action="append")
    given = parser.parse_args()
    print(f"{given.points} points, {given.rounds} rounds, {os.cpu_count()} cores; ms, and the others' time by ours")
    print(f"{'':34}{'ours':>8}{'fresh':>7}" + "".join(f"{name:>20}" for name in ("Rust", "JAX", "CasADi")))
    found = []
    for id in given.only or DEFINITIONS:
        ours, fresh, ratios = compared(id, given.points, given.rounds)
        shown = "".join(f"{r:8.2f} ({min(all):.2f}–{max(all):.2f})".rjust(20) for r, all in ratios.values())
        print(f"{id:34}{1e3 * ours:8.1f}{fresh:7.2f}{shown}", flush=True)
        found.append({name: ratio for name, (ratio, _) in ratios.items()})
    faster = sum(ratios["JAX"] > 1 and ratios["CasADi"] > 1 for ratios in found)
    near = sum(ratios["Rust"] >= 0.8 for ratios in found)
    print(f"of {len(found)}: faster than JAX and CasADi {faster}, at 80 % of the speed of Rust or more {near}")
    return 0 if faster >= min(TEN, len(found)) and near == len(found) else 1


def compared(id, count, rounds):
    """Our least time, that of fresh arrays by it, and of each of the others the ratio of the least times and those of every
    round."""
    formula = jointproof.find(id)
    columns = valid(formula, count)
    inputs = {field.name: field.of(columns) for field in formula.inputs}
    out = formula.linearize(**inputs)
    ways = {
        "ours": lambda: timed(lambda: formula.linearize(**inputs, out=out)),
        "fresh": lambda: timed(lambda: formula.linearize(**inputs)),
    }
    with Rust(id, columns) as rust:
        ways["Rust"] = rust.round
        ways["JAX"] = fastest(in_jax(id, formula, columns, out))
        ways["CasADi"] = fastest(in_casadi(id, formula, columns, out))
        for way in ways.values():
            way()
        times = [{name: way() for name, way in ways.items()} for _ in range(rounds)]
    best = {name: min(time[name] for time in times) for name in ways}
    ratio = {name: best[name] / best["ours"] for name in ways}
    ratios = {name: (ratio[name], [t[name] / t["ours"] for t in times]) for name in ("Rust", "JAX", "CasADi")}
    return best["ours"], ratio["fresh"], ratios


def valid(formula, count):
    """Random points at which the formula is defined, a column for every component."""
    called = jointproof._jointproof.Called(formula._place, False, 2000, 1, False)
    drawn = called.points()[-2000:]
    return np.ascontiguousarray(np.resize(drawn.T, (formula.n, 2000)).repeat(-(-count // 2000), axis=1)[:, :count]).T


def timed(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def fastest(calls):
    """The call that takes least time, timed."""
    for call in calls:
        call()
    best = min(calls, key=lambda call: min(timed(call) for _ in range(2)))
    return lambda: timed(best)


class Rust:
    """A program that computes the same batch, whenever it is told to."""

    def __init__(self, id, columns):
        command = ["cargo", "build", "--quiet", "--release", "--manifest-path", HERE / "Cargo.toml"]
        subprocess.run([*command, "--target-dir", TARGET], check=True)
        self.file = tempfile.NamedTemporaryFile(suffix=".bin")
        columns.T.tofile(self.file.name)
        program = [TARGET / "release" / "batch-speed", id, self.file.name]
        self.program = subprocess.Popen(program, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def round(self):
        self.program.stdin.write("\n")
        self.program.stdin.flush()
        return float(self.program.stdout.readline())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.program.stdin.close()
        self.program.wait()
        self.file.close()


def in_jax(id, formula, columns, out):
    """Value and Jacobian, with derivatives as columns, and as one array."""
    define = DEFINITIONS[id]

    def value(*x):
        return tuple(define(jnp, *x))

    def stacked(x):
        return jnp.stack(define(jnp, *x))

    every = tuple(range(formula.n))
    by_columns = jax.jit(jax.vmap(lambda *x: (value(*x), jax.jacfwd(value, argnums=every)(*x))))
    in_one = jax.jit(jax.vmap(lambda x: (stacked(x), jax.jacfwd(stacked)(x))))
    apart, together = [jnp.asarray(x) for x in columns.T], jnp.asarray(columns)
    _, jacobian = in_one(together)
    agree(id, "JAX", packed(formula, out), np.asarray(in_one(together)[0]))
    agree(id, "JAX", out.jacobian.array, np.asarray(jacobian))
    return [
        lambda: jax.block_until_ready(by_columns(*apart)),
        lambda: jax.block_until_ready(in_one(together)),
    ]


class Casadi:
    """The functions that definitions ask for."""

    abs, sqrt, expm1, sign = casadi.fabs, casadi.sqrt, casadi.expm1, casadi.sign
    arctan2, arcsin, where = casadi.atan2, casadi.asin, casadi.if_else


def in_casadi(id, formula, columns, out):
    """`map` of value and Jacobian on one thread, and on all."""
    x = casadi.SX.sym("x", formula.n)
    y = casadi.vertcat(*DEFINITIONS[id](Casadi, *casadi.vertsplit(x)))
    function = casadi.Function("f", [x], [y, casadi.jacobian(y, x)])
    count = len(columns)
    matrix = casadi.DM(np.ascontiguousarray(columns.T))
    some = np.linspace(0, count - 1, 1000, dtype=int)
    values, jacobians = function.map(len(some))(np.ascontiguousarray(columns[some].T))
    jacobian = np.asarray(casadi.densify(jacobians)).reshape(formula.m, len(some), formula.n).transpose(1, 0, 2)
    agree(id, "CasADi", packed(formula, out)[some], np.asarray(values).T)
    agree(id, "CasADi", out.jacobian.array[some], jacobian)
    maps = [function.map(count), function.map(count, "thread", os.cpu_count())]
    return [lambda mapped=mapped: mapped(matrix) for mapped in maps]


def packed(formula, out):
    return np.concatenate([np.reshape(y, (-1, field.size)) for field, y in zip(formula.outputs, out.value)], axis=-1)


def agree(id, who, ours, theirs):
    """At every point but those on kinks, where a program that derives itself has NaN."""
    known = np.isfinite(theirs)
    assert known.mean() > 0.9, f"{id}: {who} has too few numbers"
    scale = np.abs(ours).max(axis=0, keepdims=True)
    # A product of perpendicular axes is zero but for roundings.
    scale = np.maximum(scale, 1e-6 * scale.max()) + np.zeros_like(ours)
    off = np.abs(ours - theirs)[known] / scale[known]
    assert np.quantile(off, 0.98) < 1e-9, f"{id}: {who} computes another number: {off.max()}"


if __name__ == "__main__":
    sys.exit(main())
