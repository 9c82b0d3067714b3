#!/usr/bin/env python3
"""Times formulas as operations of JAX beside their equations written by hand, compiled for the CPU, in turns, after their results are compared:
the value, the gradient of a sum, value and Jacobian point by point, and a loop of many steps. Of an element the value is the residual, and in
place of the Jacobian is the matrix of Newton's method, which by hand is the Jacobian of the residual by the unknowns.

    python3 xtask/wheel/speed/differentiate.py
"""

import argparse
import sys

import jax
import jax.numpy as jnp
import numpy as np
from compare import timed, valid
from definitions import DEFINITIONS, ELEMENTS

import jointproof
import jointproof.jax

jax.config.update("jax_enable_x64", True)
WAYS = ("value", "grad", "vmap(jacfwd)")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=1_000_000)
    parser.add_argument("--steps", type=int, default=10_000)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--only", choices=[*DEFINITIONS, *ELEMENTS], action="append")
    given = parser.parse_args()
    print(f"{given.points} points, {given.rounds} rounds; ms of the operation, and its time by that of what is written by hand")
    print(f"{'':34}" + "".join(f"{name:>20}" for name in WAYS))
    for id in given.only or [*DEFINITIONS, *ELEMENTS]:
        shown = ""
        for runs, columns in (of_element if id in ELEMENTS else of_formula)(id, given.points):
            agree(id, *(jax.tree.leaves(run(*columns)) for run in runs))
            ours, theirs = least(runs, columns, given.rounds)
            shown += f"{1e3 * ours:12.1f} {ours / theirs:6.2f} "
        print(f"{id:34}{shown}", flush=True)
    ours, theirs = looped(given.steps, given.rounds)
    print(f"coulomb.response, a loop of {given.steps} steps: {1e3 * ours:.2f} ms, {ours / theirs:.2f} times")
    return 0


def of_formula(id, count):
    """The operation and what is written by hand, compiled in every way, and their inputs."""
    formula = jointproof.find(id)
    operation = jointproof.jax.operation(id)
    drawn = valid(formula, 2000)
    # Without those that are drawn for how large or small inputs may be.
    drawn = drawn[((drawn == 0) | ((np.abs(drawn) > 1e-6) & (np.abs(drawn) < 1e6))).all(axis=1)]
    columns = [jnp.asarray(np.resize(x, count)) for x in drawn.T]

    def by_formula(*x):
        return [y for part in operation(*packed(formula.inputs, x)) for y in jnp.ravel(part)]

    def by_hand(*x):
        return DEFINITIONS[id](jnp, *x)

    every = tuple(range(formula.n))

    def derived(value):
        return lambda *x: (value(*x), jax.jacfwd(value, argnums=every)(*x))

    return compiled((by_formula, by_hand), (derived(by_formula), derived(by_hand)), columns)


def of_element(id, count):
    residual, unknowns, points = ELEMENTS[id]
    element = getattr(jointproof.element, id)
    columns = list(map(jnp.asarray, points(np.random.default_rng(1), count)))

    def contribution(*x):
        return element(*packed(element.inputs, x))

    def by_element(*x):
        return list(contribution(*x).residual)

    def matrix_by_element(*x):
        found = contribution(*x)
        return list(found.residual), found.matrix

    def by_hand(*x):
        return residual(jnp, unknowns(x), *x)

    def matrix_by_hand(*x):
        def of(u):
            return jnp.stack(residual(jnp, u, *x))

        here = jnp.stack(unknowns(x))
        return list(of(here)), jax.jacfwd(of)(here)

    return compiled((by_element, by_hand), (matrix_by_element, matrix_by_hand), columns)


def packed(fields, x):
    """The inputs from their components."""
    starts = iter(x)
    return [jnp.stack([next(starts) for _ in range(f.size)]).reshape(f.shape) if f.shape else next(starts) for f in fields]


def compiled(values, derived, columns):
    every = tuple(range(len(columns)))
    grads = [jax.grad(lambda *x, value=value: sum(value(*x)), argnums=every) for value in values]
    for some in (values, grads, derived):
        yield [jax.jit(jax.vmap(one)) for one in some], columns


def least(runs, inputs, rounds):
    times = [[timed(lambda run=run: jax.block_until_ready(run(*inputs))) for run in runs] for _ in range(rounds)]
    return [min(of) for of in zip(*times)]


def agree(id, ours, theirs):
    """At nearly every point: on kinks a program that derives itself has other numbers, or none."""
    ours, theirs = ([np.asarray(x) for x in of] for of in (ours, theirs))
    # A product of perpendicular axes is zero but for roundings.
    least = 1e-6 * max(np.nanmax(np.abs(x), initial=0.0, where=np.isfinite(x)) for x in ours)
    for one, other in zip(ours, theirs, strict=True):
        known = np.isfinite(one) & np.isfinite(other)
        scale = max(np.abs(one[known]).max(), least)
        assert known.mean() > 0.9 and np.quantile(np.abs(one - other)[known], 0.9) <= 1e-9 * scale, id


def looped(steps, rounds):
    """A force that follows a displacement by steps, with friction."""
    response = jointproof.jax.operation("coulomb.response")

    def loop(value):
        def step(force, du):
            force = value(du, force, 100.0, 0.3, 5.0)
            return force, force

        return jax.jit(lambda increments: jax.lax.scan(step, 0.0, increments)[1])

    runs = [loop(lambda *x: response(*x).f), loop(lambda *x: DEFINITIONS["coulomb.response"](jnp, *x)[0])]
    increments = jnp.sin(jnp.linspace(0.0, 100.0, steps)) * 0.01
    agree("coulomb.response", *([run(increments)] for run in runs))
    return least(runs, [increments], rounds)


if __name__ == "__main__":
    sys.exit(main())
