"""Runs of two bodies under gravity, a connector between them, by a program's own joints.

At every step our rows, velocity terms and the masses have to give its accelerations and the reaction of its joint.

The equations are M a = p + G^T lambda and G a = -(d(Gv)/dq)v, for two free bodies whose nodes are their centres of
mass.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial

import numpy as np

from agreement import ROUNDINGS, UNIT, Comparison, gap
from connectors import ALL, Connector, Node
from export import Export
from motions import A, B, Body, element

STEPS, STEP = 1000, 1e-3
GRAVITY = np.array([0.0, 0.0, -9.81])
#: The equations of these runs magnify roundings by their condition, which is below this.
CONDITION = 32


def start(velocities: int) -> np.ndarray:
    """The velocities at the start: of a, then of the joints."""
    return np.array([0.3, -0.2, 0.5, 1.0, -2.0, 1.5, 0.8, -1.2, 0.6, 0.9, -0.7])[:velocities]


@dataclass(frozen=True)
class State:
    """Both nodes at a step, their accelerations (translations, spins), and what the program's joint exerts on b."""

    a: Node
    b: Node
    accelerations: np.ndarray
    reaction: np.ndarray


def mass_and_load(body: Body, node: Node) -> tuple[np.ndarray, np.ndarray]:
    """Of a free body about its centre of mass: gravity, and what turns a spinning body."""
    inertia = node.triad @ np.diag(body.inertia) @ node.triad.T
    mass = np.block([[body.mass * np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), inertia]])
    return mass, np.hstack([body.mass * GRAVITY, -np.cross(node.spin, inertia @ node.spin)])


def error(connector: Connector, export: Export, state: State) -> float:
    """Of accelerations and reactions at a step, relative to the largest term of the equations."""
    held = element(connector, export, state.a, state.b)
    masses, loads = zip(*(mass_and_load(*pair) for pair in ((A, state.a), (B, state.b))), strict=True)
    rows, count = held.rows(), len(connector.held)
    matrix = np.zeros((12 + count, 12 + count))
    matrix[:6, :6], matrix[6:12, 6:12] = masses
    matrix[:12, 12:], matrix[12:, :12] = -rows.T, rows
    if np.linalg.cond(matrix) > CONDITION:
        raise ValueError("the run has left what CONDITION was stated for")
    right = np.hstack([*loads, -held.velocity_term()])
    found = np.linalg.solve(matrix, right)
    a, b = held.ends
    force, moment = state.reaction[:3], state.reaction[3:]
    on_a = [-force, -moment - np.cross(b.x - a.x, force)]
    expected = np.hstack([state.accelerations, *on_a, force, moment])
    reactions = connector.nodal_forces(export, a, b, found[12:])
    return gap(np.hstack([found[:12], reactions]), expected, max(np.abs(right).max(), np.abs(expected).max()))


def comparisons(tree: type) -> list[Comparison]:
    """With a program whose `tree(joints, a, b)` runs."""

    def worst(connector: Connector, joints: tuple[str, ...], export: Export, steps: int) -> float:
        states: Iterable[State] = tree(joints, A, B).run(steps, STEP)
        return max(error(connector, export, state) for state in states)

    found = []
    for connector in ALL:
        formulas = connector.rows() | connector.forces() | {"element.arm": ["m_node"]}
        measure = partial(worst, connector, connector.joints)
        bound = CONDITION * ROUNDINGS * UNIT
        found.append(
            Comparison(connector.name, "accelerations and reactions", formulas, measure, STEPS, "steps", bound)
        )
    return found
