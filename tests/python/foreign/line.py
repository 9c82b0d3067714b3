"""SLIDER on a line that a program moves.

Nodes 1, n and m stay on the line, so that G J = 0 and J^T F = 0 at every pose, and so are their rates in time.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from agreement import POSES, Comparison, gap, terms
from export import Export
from motions import Moving

#: Translations of nodes 1, n and m.
DOFS = {"1": slice(0, 3), "n": slice(3, 6), "m": slice(6, 9)}
FORMULAS = {
    "rows": {"slider.rows": None},
    "forces": {"slider.nodal_forces": None},
    # Node 1 moves by slides alone: their rates do not turn, and what acts on it does not occur.
    "velocity term": {
        "slider.rows": ["g1_un", "g1_um", "g2_un", "g2_um"],
        "slider.geometric_stiffness": None,
    },
    "geometric stiffness": {"slider.nodal_forces": ["force_n", "force_m"], "slider.geometric_stiffness": None},
}


@dataclass(frozen=True)
class LinePose:
    """Node 1, the angles of two hinges, how far n and m are on the line; the rates of these, and two multipliers."""

    coordinates: np.ndarray
    velocity: np.ndarray
    multipliers: np.ndarray


def poses(count: int) -> list[LinePose]:
    """The same at every run; away from the x axis, where the directions across the line jump."""
    rng = np.random.default_rng(29)
    found = []
    for _ in range(count):
        angles = rng.uniform(0.4, 1.2, 2) * rng.choice([-1.0, 1.0], 2)
        lengths = [rng.uniform(1.0, 2.0), rng.uniform(-1.0, 3.0)]
        found.append(
            LinePose(np.hstack([rng.uniform(-2, 2, 3), angles, lengths]), rng.uniform(-2, 2, 7), rng.uniform(-2, 2, 2))
        )
    return found


@dataclass(frozen=True)
class OnLine:
    """SLIDER at a pose of a program's line."""

    export: Export
    pose: LinePose
    nodes: list[Moving]

    def stacked(self, of: str) -> np.ndarray:
        return np.vstack([getattr(node, of)[:3] for node in self.nodes])

    @property
    def places(self) -> dict[str, np.ndarray]:
        return {f"x{name}": moving.node.x for name, moving in zip(DOFS, self.nodes, strict=True)}

    @property
    def loads(self) -> dict[str, float]:
        return dict(lambda_1=self.pose.multipliers[0], lambda_2=self.pose.multipliers[1])

    def zero(self, *products: tuple[np.ndarray, ...]) -> float:
        """How far the sum of products is from zero, relative to what they add up."""
        total = sum(np.linalg.multi_dot(product) for product in products)
        return gap(total, 0.0, sum(terms(*product) for product in products))

    def rows_of(self, parts: dict[str, np.ndarray]) -> np.ndarray:
        rows = np.zeros((2, 9))
        for name, part in parts.items():
            rows[int(name[1]) - 1, DOFS[name[-1]]] = part
        return rows

    def rows(self) -> float:
        return self.zero((self.rows_of(self.export.value("slider.rows", **self.places)), self.stacked("jacobian")))

    def nodal_forces(self) -> np.ndarray:
        return np.hstack(list(self.export.value("slider.nodal_forces", **self.places, **self.loads).values()))

    def forces(self) -> float:
        return self.zero((self.stacked("jacobian").T, self.nodal_forces()))

    def velocity_term(self) -> float:
        """The rates of the rows by the velocities are the stiffness of each multiplier alone, by the velocities."""
        rows = self.rows_of(self.export.value("slider.rows", **self.places))
        jacobian, v = self.stacked("jacobian"), self.pose.velocity
        of_each = [self.stiffness(dict(lambda_1=one, lambda_2=other)) for one, other in np.eye(2)]
        changing = np.array([v @ jacobian.T @ stiffness for stiffness in of_each])
        return self.zero((changing, jacobian, v), (rows, self.stacked("rate"), v))

    def stiffness(self, loads: dict[str, float]) -> np.ndarray:
        """What acts on node m is opposite to what acts on 1 as 1 and n move alike, and blocks are transposed across."""
        k = self.export.value("slider.geometric_stiffness", **self.places, **loads)
        m_n, zero = k["k_um_un"], np.zeros((3, 3))
        return np.block(
            [
                [k["k_u1_u1"], k["k_u1_un"], -m_n.T],
                [k["k_u1_un"].T, k["k_un_un"], m_n.T],
                [-m_n, m_n, zero],
            ]
        )

    def geometric_stiffness(self) -> float:
        stiffness = self.stiffness(self.loads)
        jacobian, v = self.stacked("jacobian"), self.pose.velocity
        return self.zero((jacobian.T, stiffness, jacobian, v), (self.stacked("rate").T, self.nodal_forces()))


def comparisons(line: type) -> list[Comparison]:
    """With a program whose `line()` has nodes 1, n and m `at(pose)`."""
    moved = line()

    def worst(quantity: str, export: Export, count: int) -> float:
        method = quantity.replace(" ", "_")
        return max(getattr(OnLine(export, pose, moved.at(pose)), method)() for pose in poses(count))

    return [
        Comparison("SLIDER", quantity, formulas, partial(worst, quantity), POSES)
        for quantity, formulas in FORMULAS.items()
    ]
