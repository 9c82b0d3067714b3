"""Connectors as elements, put together from exported formulas: twelve degrees of freedom u_a, theta_a, u_b, theta_b.

A spin is a turn in the global frame, de = dtheta x e; forces on the nodes are Rows^T lambda, positive ones act on b.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from agreement import POSES
from export import Export, outputs

DOFS = {"ua": slice(0, 3), "ta": slice(3, 6), "ub": slice(6, 9), "tb": slice(9, 12)}
ZERO = np.zeros(3)


@dataclass(frozen=True)
class Node:
    """A body's node: where it is, its triad as columns, and how both move."""

    x: np.ndarray
    triad: np.ndarray
    velocity: np.ndarray = field(default_factory=lambda: ZERO)
    spin: np.ndarray = field(default_factory=lambda: ZERO)

    def at(self, arm: np.ndarray) -> Node:
        """The end of a rigid arm, which is given in the global frame."""
        return Node(self.x + arm, self.triad, self.velocity + np.cross(self.spin, arm), self.spin)


def inputs(a: Node, b: Node) -> dict[str, np.ndarray]:
    triads = {f"e{k + 1}{name}": node.triad[:, k] for name, node in (("a", a), ("b", b)) for k in range(3)}
    return triads | dict(xa=a.x, xb=b.x)


@dataclass(frozen=True)
class Product:
    """A scalar product of axes as a function of the Cardan angles: its value, its gradient, and its second derivatives."""

    value: Callable[[np.ndarray], float]
    gradient: Callable[[np.ndarray], np.ndarray]
    second: Callable[[np.ndarray], np.ndarray]


def sine() -> Product:
    """e1a.e3b = sin beta."""
    middle = np.eye(3)[1]
    return Product(
        lambda angles: np.sin(angles[1]),
        lambda angles: np.cos(angles[1]) * middle,
        lambda angles: -np.sin(angles[1]) * np.outer(middle, middle),
    )


@dataclass(frozen=True)
class Block:
    """What connectors are made of, by the names of its formulas and of its multipliers."""

    rows: str
    forces: str
    stiffness: str
    multipliers: tuple[str, ...]
    #: Axes of the formulas that are others here.
    renamed: tuple[tuple[str, str], ...] = ()

    def inputs(self, a: Node, b: Node) -> dict[str, np.ndarray]:
        found = inputs(a, b)
        return found | {name: found[other] for name, other in self.renamed}

    def matrix(self, parts: dict[str, np.ndarray]) -> np.ndarray:
        """Rows in their places. Where turning both nodes alike changes nothing, only the spin of b is written."""
        names = list(dict.fromkeys(name.rpartition("_")[0] for name in parts))
        rows = np.zeros((len(names), 12))
        for name, part in parts.items():
            residual, _, motion = name.rpartition("_")
            rows[names.index(residual), DOFS[motion]] = part
            if f"{residual}_ta" not in parts:
                rows[names.index(residual), DOFS["ta"]] = -part
        return rows

    def row_matrix(self, export: Export, a: Node, b: Node) -> np.ndarray:
        return self.matrix(export.value(self.rows, **self.inputs(a, b)))

    def loads(self, multipliers: np.ndarray) -> dict[str, float]:
        return dict(zip(self.multipliers, multipliers, strict=True))

    def nodal_forces(self, export: Export, a: Node, b: Node, multipliers: np.ndarray) -> np.ndarray:
        forces = np.zeros(12)
        for name, part in export.value(self.forces, **self.inputs(a, b), **self.loads(multipliers)).items():
            forces[DOFS[{"f": "u", "m": "t"}[name[0]] + name[1]]] = part
        return forces

    def geometric_stiffness(self, export: Export, a: Node, b: Node, multipliers: np.ndarray) -> np.ndarray:
        """Blocks that are not written are the transposed ones, and what acts on b's translation is opposite to a's.

        What depends on the difference of both spins has its block for b alone.
        """
        stiffness = np.zeros((12, 12))
        blocks = export.value(self.stiffness, **self.inputs(a, b), **self.loads(multipliers))
        if "k_tb_tb" in blocks and "k_ta_tb" not in blocks:
            blocks = {"k_ta_ta": blocks["k_tb_tb"].T, "k_ta_tb": -blocks["k_tb_tb"]} | blocks
        for name, block in blocks.items():
            row, column = name.split("_")[1:]
            stiffness[DOFS[row], DOFS[column]] = block
            if row != column:
                stiffness[DOFS[column], DOFS[row]] = block.T
            if row == "ua":
                stiffness[DOFS["ub"], DOFS[column]] = -block
                stiffness[DOFS[column], DOFS["ub"]] = -block.T
        return stiffness


@dataclass(frozen=True)
class Connector:
    """A connector by the formula of its residuals, and the blocks that it is a sum of, each with the rows that it takes.

    `held` are the coordinates that its residuals are, of three translations along e1a, e2a, e3a and three Cardan
    angles; `products` names residuals that are scalar products of axes instead, by their places. `joints` are those of
    programs that have coordinates, in order, and `count` is how many poses it is compared at.
    """

    name: str
    residuals: str
    blocks: tuple[tuple[Block, tuple[int, ...]], ...]
    held: tuple[int, ...]
    products: tuple[tuple[int, Product], ...] = ()
    joints: tuple[str, ...] = ()
    count: int = POSES

    def rows(self) -> dict[str, list[str]]:
        """The outputs of every block that are rows of it."""
        taken = {}
        for block, rows in self.blocks:
            names = [name for name, _ in outputs(block.rows)]
            residuals = list(dict.fromkeys(name.rpartition("_")[0] for name in names))
            of_connector = [residuals[row] for row in rows]
            mine = [name for name in names if name.rpartition("_")[0] in of_connector]
            taken[block.rows] = list(dict.fromkeys(taken.get(block.rows, []) + mine))
        return taken

    def forces(self) -> dict[str, None]:
        return dict.fromkeys(block.forces for block, _ in self.blocks)

    def stiffness(self) -> dict[str, None]:
        return dict.fromkeys(block.stiffness for block, _ in self.blocks)

    def residual(self, export: Export, a: Node, b: Node) -> np.ndarray:
        """With all initial values zero, so that it is the connector's coordinate."""
        initial = dict(d0=ZERO) | dict.fromkeys(["y0", "z0", "c0", "c2", "c3", "alpha0", "beta0", "gamma0"], 0.0)
        return np.hstack(list(export.value(self.residuals, **inputs(a, b), **initial).values()))

    def shares(self, multipliers: np.ndarray) -> list[tuple[Block, np.ndarray]]:
        """The multipliers of every block; of rows that the connector does not take, zero."""
        found, first = [], 0
        for block, rows in self.blocks:
            share = np.zeros(len(block.multipliers))
            share[list(rows)] = multipliers[first : first + len(rows)]
            first += len(rows)
            found.append((block, share))
        return found

    def row_matrix(self, export: Export, a: Node, b: Node) -> np.ndarray:
        return np.vstack([block.row_matrix(export, a, b)[list(rows)] for block, rows in self.blocks])

    def nodal_forces(self, export: Export, a: Node, b: Node, multipliers: np.ndarray) -> np.ndarray:
        return sum(block.nodal_forces(export, a, b, share) for block, share in self.shares(multipliers))

    def geometric_stiffness(self, export: Export, a: Node, b: Node, multipliers: np.ndarray) -> np.ndarray:
        return sum(block.geometric_stiffness(export, a, b, share) for block, share in self.shares(multipliers))


def carried(export: Export, forces: np.ndarray, arms: dict[str, np.ndarray]) -> np.ndarray:
    """Forces or a row, brought from the ends of rigid arms to the nodes that carry them."""
    found = forces.copy()
    for node, arm in arms.items():
        u, t = DOFS["u" + node], DOFS["t" + node]
        found[t] = export.value("element.arm", r=arm, f=forces[u], m=forces[t])["m_node"]
    return found


@dataclass(frozen=True)
class Element:
    """A connector between the ends of rigid arms (in the global frame) of two nodes."""

    connector: Connector
    export: Export
    a: Node
    b: Node
    arms: dict[str, np.ndarray]

    @property
    def ends(self) -> tuple[Node, Node]:
        return self.a.at(self.arms["a"]), self.b.at(self.arms["b"])

    def residuals(self) -> np.ndarray:
        return self.connector.residual(self.export, *self.ends)

    def rows(self) -> np.ndarray:
        rows = self.connector.row_matrix(self.export, *self.ends)
        return np.array([carried(self.export, row, self.arms) for row in rows])

    def velocity_term(self) -> np.ndarray:
        """(d(Gv)/dq)v: how fast the residuals' rates change where nodes have no acceleration.

        The ends then have that of a turning arm.
        """
        ends = self.ends
        velocities = np.ravel([[end.velocity, end.spin] for end in ends])
        turning = [
            np.cross(end.spin, np.cross(end.spin, arm)) for end, arm in zip(ends, self.arms.values(), strict=True)
        ]
        accelerations = np.hstack([turning[0], ZERO, turning[1], ZERO])
        of_each = [self.connector.geometric_stiffness(self.export, *ends, one) for one in np.eye(len(self.connector.held))]
        turning_rows = np.array([velocities @ stiffness @ velocities for stiffness in of_each])
        return turning_rows + self.connector.row_matrix(self.export, *ends) @ accelerations

    def forces(self, multipliers: np.ndarray) -> np.ndarray:
        return carried(self.export, self.connector.nodal_forces(self.export, *self.ends, multipliers), self.arms)

    def stiffness(self, multipliers: np.ndarray) -> np.ndarray:
        """What a spin does through the arm, and how the moment of the force changes as the arm turns."""
        forces = self.connector.nodal_forces(self.export, *self.ends, multipliers)
        at_ends = self.connector.geometric_stiffness(self.export, *self.ends, multipliers)
        to_ends, turning = np.eye(12), np.zeros((12, 12))
        for node, arm in self.arms.items():
            u, t = DOFS["u" + node], DOFS["t" + node]
            to_ends[u, t] = np.cross(np.eye(3), arm).T
            turning[t, t] = self.export.value("element.arm", r=arm, f=forces[u], m=forces[t])["k_arm"]
        return to_ends.T @ at_ends @ to_ends + turning


LINE = Block("join.rows", "join.nodal_forces", "join.geometric_stiffness", ("f1", "f2", "f3"))
ANGLES = Block(
    "align.rows", "align.nodal_moments", "align.geometric_stiffness", ("lambda_r1", "lambda_r2", "lambda_r3")
)
CROSS = Block("universal.rows", "universal.nodal_moments", "universal.geometric_stiffness", ("lambda_rot",))



def tilt() -> Product:
    """e1a.e2b = -cos beta sin gamma."""

    def gradient(angles: np.ndarray) -> np.ndarray:
        (b, c), (sb, sc) = np.cos(angles[1:]), np.sin(angles[1:])
        return np.array([0.0, sb * sc, -b * c])

    def second(angles: np.ndarray) -> np.ndarray:
        (b, c), (sb, sc) = np.cos(angles[1:]), np.sin(angles[1:])
        return np.array([[0.0, 0.0, 0.0], [0.0, b * sc, sb * c], [0.0, sb * c, b * sc]])

    return Product(lambda angles: -np.cos(angles[1]) * np.sin(angles[2]), gradient, second)


#: UNIVERSAL's block with another axis of b.
TILT = Block(CROSS.rows, CROSS.forces, CROSS.stiffness, CROSS.multipliers, (("e3b", "e2b"),))
SLIDES = ("slide x", "slide y", "slide z")

JOIN = Connector("JOIN", "join.constraint", ((LINE, (0, 1, 2)),), (0, 1, 2), joints=("ball",))
UNIVERSAL = Connector(
    "UNIVERSAL", "universal.constraint", ((CROSS, (0,)),), (4,), ((0, sine()),), (*SLIDES, "universal")
)
UJOINT = Connector(
    "UJOINT",
    "ujoint.constraint",
    ((LINE, (0, 1, 2)), (CROSS, (0,))),
    (0, 1, 2, 4),
    ((3, sine()),),
    ("universal",),
)
SLOT = Connector("SLOT", "slot.constraint", ((LINE, (1, 2)),), (1, 2), joints=("slide x", "ball"))
ALIGN = Connector("ALIGN", "align.constraint", ((ANGLES, (0, 1, 2)),), (3, 4, 5), joints=SLIDES)
TRANSLATOR = Connector(
    "TRANSLATOR",
    "translator.constraint",
    ((LINE, (1, 2)), (ANGLES, (0, 1, 2))),
    (1, 2, 3, 4, 5),
    joints=("slide x",),
)
HINGE = Connector(
    "HINGE",
    "hinge.constraint",
    ((LINE, (0, 1, 2)), (TILT, (0,)), (CROSS, (0,))),
    (0, 1, 2, 5, 4),
    ((3, tilt()), (4, sine())),
    ("hinge x",),
    count=1000,
)
ALL = (JOIN, SLOT, ALIGN, TRANSLATOR, UNIVERSAL, UJOINT, HINGE)
