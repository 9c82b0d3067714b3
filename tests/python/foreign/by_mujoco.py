"""Bodies and joints as MuJoCo has them."""

from __future__ import annotations

from collections.abc import Iterator

import mujoco
import numpy as np

import constraints
import line
import motions
import runs
from agreement import Comparison
from connectors import JOIN, Node
from constraints import Constraint, Pair
from line import LinePose
from motions import A, B, Body, Moving, Pose
from runs import GRAVITY, State, start

NAME, PACKAGE = "MuJoCo", "mujoco"
AXES = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}
#: Joints that MuJoCo has not as one.
IN_TURN = {"universal": ("hinge x", "hinge z")}


def text(numbers) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def joints(names: tuple[str, ...]) -> str:
    found = ""
    for name in (part for whole in names for part in IN_TURN.get(whole, (whole,))):
        kind, _, axis = name.partition(" ")
        found += f'<joint type="{kind}" axis="{AXES[axis]}"/>' if axis else f'<joint type="{kind}"/>'
    return found


def inertial(body: Body, place) -> str:
    return f'<inertial pos="{text(place)}" mass="{body.mass!r}" diaginertia="{text(body.inertia)}"/>'


class Model:
    """Bodies, and nodes at places of theirs."""

    def __init__(self, bodies: str, nodes: list[tuple[int, np.ndarray]], equality: str = ""):
        option = f'<option gravity="{text(GRAVITY)}" jacobian="dense"/>'
        worldbody = f"<worldbody>{bodies}</worldbody><equality>{equality}</equality>"
        self.nodes = nodes
        self.model = mujoco.MjModel.from_xml_string(f"<mujoco>{option}{worldbody}</mujoco>")
        self.data = mujoco.MjData(self.model)

    def node(self, body: int, local: np.ndarray) -> Moving:
        model, data = self.model, self.data
        triad = data.xmat[body].reshape(3, 3).copy()
        place = data.xpos[body] + triad @ local
        jacobian, rate = np.zeros((6, model.nv)), np.zeros((6, model.nv))
        mujoco.mj_jac(model, data, jacobian[:3], jacobian[3:], place, body)
        mujoco.mj_jacDot(model, data, rate[:3], rate[3:], place, body)
        motion = jacobian @ data.qvel
        return Moving(Node(place, triad, motion[:3], motion[3:]), jacobian, rate)

    def moving(self) -> list[Moving]:
        return [self.node(*node) for node in self.nodes]

    def placed(self, q: np.ndarray, v: np.ndarray) -> list[Moving]:
        self.data.qpos[:], self.data.qvel[:] = q, v
        mujoco.mj_forward(self.model, self.data)
        return self.moving()


class Tree(Model):
    """A free body a, joints at the end of its arm, and a body b that they hold by an arm of its own."""

    def __init__(self, held: tuple[str, ...], a: Body, b: Body):
        second = f'<body name="b" pos="{text(a.arm)}">{joints(held)}{inertial(b, -b.arm)}</body>'
        super().__init__(
            f'<body name="a"><freejoint/>{inertial(a, np.zeros(3))}{second}</body>', [(1, np.zeros(3)), (2, -b.arm)]
        )

    def at(self, pose: Pose) -> list[Moving]:
        return self.placed(np.hstack([pose.position, pose.quaternion, pose.coordinates]), pose.velocity)

    def reaction(self) -> np.ndarray:
        """What is transmitted to b. MuJoCo has the moment before the force, about the centre of mass of all bodies."""
        mujoco.mj_rnePostConstraint(self.model, self.data)
        moment, force = self.data.cfrc_int[2][:3], self.data.cfrc_int[2][3:]
        lever = self.data.subtree_com[1] - self.data.xpos[2]
        return np.hstack([force, moment + np.cross(lever, force)])

    def run(self, steps: int, step: float) -> Iterator[State]:
        """A motion under gravity, from where all joints are at zero."""
        model, data = self.model, self.data
        model.opt.timestep = step
        mujoco.mj_resetData(model, data)
        data.qvel[:] = start(model.nv)
        for _ in range(steps):
            mujoco.mj_forward(model, data)
            a, b = self.moving()
            accelerations = np.hstack([m.jacobian @ data.qacc + m.rate @ data.qvel for m in (a, b)])
            yield State(a.node, b.node, accelerations, self.reaction())
            mujoco.mj_step(model, data)


class Line(Model):
    """Node 1 on three slides, a line turned by two hinges, and nodes n and m on slides along it."""

    def __init__(self):
        mass = inertial(Body(), np.zeros(3))
        others = "".join(f"<body>{joints(('slide x',))}{mass}</body>" for _ in range(2))
        turned = joints(("slide x", "slide y", "slide z", "hinge z", "hinge y"))
        super().__init__(f"<body>{turned}{mass}{others}</body>", [(body, np.zeros(3)) for body in (1, 2, 3)])

    def at(self, pose: LinePose) -> list[Moving]:
        return self.placed(pose.coordinates, pose.velocity)


class Connect(Model):
    """Two free bodies and MuJoCo's equality constraint `connect` between the ends of their arms."""

    def __init__(self):
        pairs = (("a", A), ("b", B))
        free = "".join(f'<body name="{n}"><freejoint/>{inertial(b, np.zeros(3))}</body>' for n, b in pairs)
        held = f'<connect body1="a" body2="b" anchor="{text(A.arm)}"/>'
        super().__init__(free, [(1, np.zeros(3)), (2, np.zeros(3))], held)
        self.model.eq_data[0, :6] = [*A.arm, *B.arm]

    def at(self, pair: Pair) -> Constraint:
        q = np.hstack([part for body in zip(pair.places, pair.quaternions, strict=True) for part in body])
        a, b = self.placed(q, np.zeros(12))
        rows = self.data.efc_J.reshape(-1, 12)[:3].copy()
        return Constraint(self.data.efc_pos[:3].copy(), rows, (a.node, b.node), np.vstack([a.jacobian, b.jacobian]))


def comparisons() -> list[Comparison]:
    """MuJoCo has what is on a less what is on b, in the global frame."""
    connect = constraints.Same(JOIN, Connect().at, lambda triad: -triad, rows_at=constraints.closed_pairs)
    return [
        *motions.comparisons(Tree),
        *line.comparisons(Line),
        *runs.comparisons(Tree),
        *connect.comparisons(),
    ]
