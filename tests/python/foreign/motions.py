"""Comparisons with any program that computes with joints' coordinates, and so has bodies, Jacobians and their rates.

Between a free body a and a body b stand three slides along the axes of a and three hinges about the axes of what the
hinge before has turned: the coordinates that our connectors hold, at any of their values. So J^T F = (dg/dq)^T
lambda, whatever the pose, and its rate in time too. Nodes are the bodies' centres of mass, which carry the connector
by rigid arms.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from agreement import Comparison, gap, terms
from connectors import ALL, Connector, Element, Node
from export import Export

JOINTS = ("slide x", "slide y", "slide z", "hinge x", "hinge y", "hinge z")
#: The coordinates of a chain behind the six of body a.
FREE = 6


@dataclass(frozen=True)
class Body:
    """Mass, principal moments of inertia, and the arm from the centre of mass to the connector, in its own axes."""

    mass: float = 1.0
    inertia: tuple[float, float, float] = (1.0, 1.0, 1.0)
    arm: np.ndarray = field(default_factory=lambda: np.zeros(3))


A = Body(2.0, (0.3, 0.5, 0.4), np.array([0.5, 0.25, -0.125]))
B = Body(1.5, (0.2, 0.25, 0.375), np.array([-0.75, 0.125, 0.25]))


def element(connector: Connector, export: Export, a: Node, b: Node) -> Element:
    """The connector between both bodies."""
    return Element(connector, export, a, b, dict(a=a.triad @ A.arm, b=b.triad @ B.arm))


@dataclass(frozen=True)
class Moving:
    """A node, how it moves by the program's velocities, and how fast that changes (translations, then spins)."""

    node: Node
    jacobian: np.ndarray
    rate: np.ndarray


@dataclass(frozen=True)
class Pose:
    """Where the chain is and how it moves, and multipliers."""

    position: np.ndarray
    quaternion: np.ndarray
    coordinates: np.ndarray
    velocity: np.ndarray
    multipliers: np.ndarray


def poses(count: int) -> list[Pose]:
    """The same at every run. The middle angle stays away from 90 degrees, where the others have no meaning."""
    rng = np.random.default_rng(17)
    found = []
    for _ in range(count):
        quaternion = rng.normal(size=4)
        position, slides = rng.uniform(-2, 2, (2, 3))
        angles = rng.uniform(-1, 1, 3) * (np.pi, 1.2, np.pi)
        velocity, multipliers = rng.uniform(-2, 2, 12), rng.uniform(-2, 2, 5)
        coordinates = np.hstack([slides, angles])
        found.append(Pose(position, quaternion / np.linalg.norm(quaternion), coordinates, velocity, multipliers))
    return found


class Chained:
    """A connector at a pose of a chain, as a program has it. Each method is an error."""

    def __init__(self, connector: Connector, export: Export, pose: Pose, a: Moving, b: Moving):
        self.connector, self.pose = connector, pose
        self.element = element(connector, export, a.node, b.node)
        self.jacobian, self.rate = np.vstack([a.jacobian, b.jacobian]), np.vstack([a.rate, b.rate])
        self.multipliers = pose.multipliers[: len(connector.held)]

    def expected(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """The residuals, their derivatives by all coordinates, and the rates of these."""
        c, held = self.pose.coordinates, list(self.connector.held)
        residuals, rows = c[held], np.zeros((len(held), FREE + len(JOINTS)))
        rates = np.zeros_like(rows)
        for row, coordinate in enumerate(held):
            rows[row, FREE + coordinate] = 1.0
        for row, product in self.connector.products:
            angles = slice(FREE + 3, FREE + 6)
            residuals[row], rows[row] = product.value(c[3:]), 0.0
            rows[row, angles] = product.gradient(c[3:])
            rates[row, angles] = product.second(c[3:]) @ self.pose.velocity[angles]
        return residuals, rows, rates

    def residuals(self) -> float:
        expected = self.expected()[0]
        size = max(np.abs(place).max() for end in self.element.ends for place in (end.x, end.triad))
        return gap(self.element.residuals(), expected, max(size, np.abs(expected).max()))

    def rows(self) -> float:
        rows = self.element.rows()
        return gap(rows @ self.jacobian, self.expected()[1], terms(rows, self.jacobian))

    def forces(self) -> float:
        forces = self.element.forces(self.multipliers)
        return gap(self.jacobian.T @ forces, self.expected()[1].T @ self.multipliers, terms(self.jacobian.T, forces))

    def velocity_term(self) -> float:
        rows, term, v = self.element.rows(), self.element.velocity_term(), self.pose.velocity
        size = np.abs(term).max() + terms(rows, self.rate, v)
        return gap(term + rows @ (self.rate @ v), self.expected()[2] @ v, size)

    def geometric_stiffness(self) -> float:
        """The rate of J^T F is J^T K J v and what the rate of J does to F."""
        forces, stiffness = self.element.forces(self.multipliers), self.element.stiffness(self.multipliers)
        v = self.pose.velocity
        found = self.jacobian.T @ (stiffness @ (self.jacobian @ v)) + self.rate.T @ forces
        size = terms(self.jacobian.T, stiffness, self.jacobian, v) + terms(self.rate.T, forces)
        return gap(found, self.expected()[2].T @ self.multipliers, size)


def comparisons(tree: type) -> list[Comparison]:
    """With a program whose `tree(joints, a, b)` has both bodies `at(pose)`."""
    chain = tree(JOINTS, A, B)
    arm = {"element.arm": ["m_node"]}

    def worst(connector: Connector, quantity: str, export: Export, count: int) -> float:
        method = quantity.replace(" ", "_")
        return max(getattr(Chained(connector, export, pose, *chain.at(pose)), method)() for pose in poses(count))

    found = []
    for connector in ALL:
        uses = {
            "residuals": {connector.residuals: None},
            "rows": connector.rows() | arm,
            "forces": connector.forces() | arm,
            "velocity term": connector.stiffness() | arm,
            "geometric stiffness": connector.forces() | connector.stiffness() | {"element.arm": None},
        }
        for quantity, formulas in uses.items():
            found.append(Comparison.at_poses(connector.name, quantity, formulas, worst, connector, connector.count))
    return found
