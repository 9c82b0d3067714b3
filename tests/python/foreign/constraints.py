"""Comparisons with joints that a program, too, has as constraints between two bodies.

Its residuals and rows, which are in its own velocities, are ours but for a matrix: most have JOIN's in the global
frame, or the opposite ones. JOIN's rows are compared where the joint is closed, since elsewhere the derivative of its
components differs by the turning frame.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from agreement import Comparison, gap, terms
from connectors import Connector, Node
from export import Export
from motions import A, B, element


@dataclass(frozen=True)
class Pair:
    """Two bodies at their centres of mass: positions, and rotations as unit quaternions (real part first)."""

    places: np.ndarray
    quaternions: np.ndarray


@dataclass(frozen=True)
class Constraint:
    """What the program has: its residuals and rows, both nodes, and how they move by its velocities (12 x n)."""

    residuals: np.ndarray
    rows: np.ndarray
    nodes: tuple[Node, Node]
    motions: np.ndarray


def product(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Of two quaternions."""
    return np.hstack([p[0] * q[0] - p[1:] @ q[1:], p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def turned(q: np.ndarray, vector: np.ndarray) -> np.ndarray:
    return product(product(q, np.hstack([0.0, vector])), q * (1, -1, -1, -1))[1:]


def open_pairs(count: int) -> list[Pair]:
    """Anywhere; the same at every run."""
    rng = np.random.default_rng(41)
    found = []
    for _ in range(count):
        quaternions = rng.normal(size=(2, 4))
        quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
        found.append(Pair(rng.uniform(-2, 2, (2, 3)), quaternions))
    return found


def moved(pair: Pair, quaternion: np.ndarray) -> Pair:
    """Body b turned so, and moved to where both ends of the arms meet."""
    a = pair.quaternions[0]
    meeting = pair.places[0] + turned(a, A.arm)
    return Pair(np.array([pair.places[0], meeting - turned(quaternion, B.arm)]), np.array([a, quaternion]))


def closed_pairs(count: int) -> list[Pair]:
    """The ends of the arms meet."""
    return [moved(pair, pair.quaternions[1]) for pair in open_pairs(count)]


def aligned_pairs(count: int) -> list[Pair]:
    """Triads agree."""
    return [Pair(pair.places, pair.quaternions[[0, 0]]) for pair in open_pairs(count)]


#: From our residuals to the program's, by the triad of a.
Change = Callable[[np.ndarray], np.ndarray]


@dataclass(frozen=True)
class Same:
    """A connector and the program's constraint, which is `at(pair)`."""

    connector: Connector
    at: Callable[[Pair], Constraint]
    change: Change
    rows_at: Callable[[int], list[Pair]] = open_pairs
    residuals_at: Callable[[int], list[Pair]] = open_pairs
    #: The residuals that are not zero at all of these places, where only some are.
    varied: list[str] | None = None

    def residuals(self, export: Export, count: int) -> float:
        worst = 0.0
        for pair in self.residuals_at(count):
            theirs = self.at(pair)
            held = element(self.connector, export, *theirs.nodes)
            ours = self.change(theirs.nodes[0].triad) @ held.residuals()
            size = max(np.abs(place).max() for end in held.ends for place in (end.x, end.triad))
            worst = max(worst, gap(ours, theirs.residuals, size))
        return worst

    def rows(self, export: Export, count: int) -> float:
        worst = 0.0
        for pair in self.rows_at(count):
            theirs = self.at(pair)
            change, rows = self.change(theirs.nodes[0].triad), element(self.connector, export, *theirs.nodes).rows()
            worst = max(worst, gap(change @ rows @ theirs.motions, theirs.rows, terms(change, rows, theirs.motions)))
        return worst

    def comparisons(self) -> list[Comparison]:
        connector = self.connector
        rows = connector.rows() | {"element.arm": ["m_node"]}
        return [
            Comparison(
                connector.name, "residuals of a constraint", {connector.residuals: self.varied}, self.residuals, connector.count
            ),
            Comparison(connector.name, "rows of a constraint", rows, self.rows, connector.count),
        ]
