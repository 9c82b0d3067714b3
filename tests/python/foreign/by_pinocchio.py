"""Bodies and joints as Pinocchio has them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pinocchio as pin

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

NAME, PACKAGE = "Pinocchio", "pin"
GLOBAL = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
JOINTS = {
    "slide x": pin.JointModelPX,
    "slide y": pin.JointModelPY,
    "slide z": pin.JointModelPZ,
    "hinge x": pin.JointModelRX,
    "hinge y": pin.JointModelRY,
    "hinge z": pin.JointModelRZ,
    "ball": pin.JointModelSpherical,
    "universal": lambda: pin.JointModelUniversal(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])),
}


def at(place=(0.0, 0.0, 0.0)) -> pin.SE3:
    return pin.SE3(np.eye(3), np.asarray(place, dtype=float))


class Model:
    """Joints one behind the other, and nodes that they carry."""

    def __init__(self):
        self.model, self.nodes = pin.Model(), []

    def joints(self, parent: int, names: tuple[str, ...], place=(0.0, 0.0, 0.0)) -> int:
        for k, name in enumerate(names):
            behind = at(place) if k == 0 else at()
            parent = self.model.addJoint(parent, JOINTS[name](), behind, f"{name} {k} {parent}")
        return parent

    def node(self, joint: int, place=(0.0, 0.0, 0.0)) -> None:
        frame = pin.Frame(f"node {len(self.nodes)}", joint, 0, at(place), pin.FrameType.OP_FRAME)
        self.nodes.append(self.model.addFrame(frame))

    def done(self) -> None:
        self.data = self.model.createData()

    def moving(self, q: np.ndarray, v: np.ndarray) -> list[Moving]:
        pin.computeJointJacobiansTimeVariation(self.model, self.data, q, v)
        pin.updateFramePlacements(self.model, self.data)
        found = []
        for frame in self.nodes:
            jacobian = pin.getFrameJacobian(self.model, self.data, frame, GLOBAL)
            rate = pin.getFrameJacobianTimeVariation(self.model, self.data, frame, GLOBAL)
            place, motion = self.data.oMf[frame], jacobian @ v
            node = Node(place.translation.copy(), place.rotation.copy(), motion[:3], motion[3:])
            found.append(Moving(node, jacobian, rate))
        return found


class Tree(Model):
    """A free body a, joints at the end of its arm, and a body b that they hold by an arm of its own."""

    def __init__(self, joints: tuple[str, ...], a: Body, b: Body):
        super().__init__()
        self.model.gravity.linear = GRAVITY
        first = self.model.addJoint(0, pin.JointModelFreeFlyer(), at(), "a")
        self.last = self.joints(first, joints, a.arm)
        for joint, body, place in ((first, a, np.zeros(3)), (self.last, b, -b.arm)):
            self.model.appendBodyToJoint(joint, pin.Inertia(body.mass, place, np.diag(body.inertia)), at())
            self.node(joint, place)
        self.done()

    def at(self, pose: Pose) -> list[Moving]:
        w, x, y, z = pose.quaternion
        return self.moving(np.hstack([pose.position, [x, y, z, w], pose.coordinates]), pose.velocity)

    def accelerations(self, q: np.ndarray, v: np.ndarray, acceleration: np.ndarray) -> np.ndarray:
        """Of both nodes, as derivatives of their velocities and spins."""
        pin.forwardKinematics(self.model, self.data, q, v, acceleration)
        found = [pin.getFrameClassicalAcceleration(self.model, self.data, frame, GLOBAL) for frame in self.nodes]
        return np.hstack([motion.vector for motion in found])

    def reaction(self, q: np.ndarray, v: np.ndarray, acceleration: np.ndarray) -> np.ndarray:
        """What the last joint transmits to b, in the global frame."""
        pin.rnea(self.model, self.data, q, v, acceleration)
        turned, transmitted = self.data.oMi[self.last].rotation, self.data.f[self.last]
        return np.hstack([turned @ transmitted.linear, turned @ transmitted.angular])

    def run(self, steps: int, step: float) -> Iterator[State]:
        """A motion under gravity, from where all joints are at zero."""
        q, v = pin.neutral(self.model), start(self.model.nv)
        for _ in range(steps):
            acceleration = pin.aba(self.model, self.data, q, v, np.zeros(self.model.nv)).copy()
            nodes = [moving.node for moving in self.moving(q, v)]
            yield State(*nodes, self.accelerations(q, v, acceleration), self.reaction(q, v, acceleration))
            v = v + step * acceleration
            q = pin.integrate(self.model, q, step * v)


class Line(Model):
    """Node 1 on three slides, a line turned by two hinges, and nodes n and m on slides along it."""

    def __init__(self):
        super().__init__()
        turned = self.joints(0, ("slide x", "slide y", "slide z", "hinge z", "hinge y"))
        for joint in (turned, self.joints(turned, ("slide x",)), self.joints(turned, ("slide x",))):
            self.node(joint)
        self.done()

    def at(self, pose: LinePose) -> list[Moving]:
        return self.moving(pose.coordinates, pose.velocity)


class Anchored(Model):
    """Two free bodies and Pinocchio's constraint of three translations between the ends of their arms."""

    def __init__(self):
        super().__init__()
        joints = [self.model.addJoint(0, pin.JointModelFreeFlyer(), at(), name) for name in "ab"]
        for joint in joints:
            self.node(joint)
        ends = [part for joint, body in zip(joints, (A, B), strict=True) for part in (joint, at(body.arm))]
        kind, frame = pin.ContactType.CONTACT_3D, pin.ReferenceFrame.LOCAL
        self.constraint = pin.RigidConstraintModel(kind, self.model, *ends, frame)
        self.done()

    def at(self, pair: Pair) -> Constraint:
        turns = np.roll(pair.quaternions, -1, axis=1)
        q = np.hstack([part for body in zip(pair.places, turns, strict=True) for part in body])
        a, b = self.moving(q, np.zeros(12))
        found = self.constraint.createData()
        self.constraint.calc(self.model, self.data, found)
        rows = pin.getConstraintJacobian(self.model, self.data, self.constraint, found)
        # The residuals are those of b less a, the rows those of a less b.
        return Constraint(-found.c1Mc2.translation, rows, (a.node, b.node), np.vstack([a.jacobian, b.jacobian]))


def comparisons() -> list[Comparison]:
    """Pinocchio's rows are those of what is on a less what is on b, in the frame of a; its residuals are ours."""
    anchored = constraints.Same(JOIN, Anchored().at, lambda triad: -np.eye(3), rows_at=constraints.closed_pairs)
    return [
        *motions.comparisons(Tree),
        *line.comparisons(Line),
        *runs.comparisons(Tree),
        *anchored.comparisons(),
    ]
