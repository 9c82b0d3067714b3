"""Bodies and joints as Exudyn has them, and our elements in it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from unittest.mock import patch

import exudyn
import numpy as np
from exudyn.itemInterface import (
    Force,
    GenericJoint,
    MarkerBodyRigid,
    NodeRigidBodyEP,
    ObjectGround,
    ObjectRigidBody,
    PrismaticJointX,
    SphericalJoint,
    Torque,
)
from exudyn.rigidBodyUtilities import EulerParameters2G, EulerParameters2RotationMatrix

from agreement import Comparison
from connectors import JOIN, SLOT, TRANSLATOR, UJOINT, UNIVERSAL, Node
from constraints import Constraint, Pair, Same, aligned_pairs, closed_pairs, product, turned
from export import Export, module
from motions import A, B, Body
from runs import STEP, STEPS

# What is exported is found once `export` has said where.
from exudyn_connector import Connector  # isort: skip

NAME, PACKAGE = "Exudyn", "exudyn"
# A solver that fails says so, and raises; here it may fail, with an error that was planted.
exudyn.config.printToConsole = False
UNTURNED = np.array([1.0, 0.0, 0.0, 0.0])


class Bodies:
    """Bodies in a system of Exudyn's, with nodes that count Euler parameters."""

    def __init__(self, places: np.ndarray, quaternions: np.ndarray, bodies: list[Body]):
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.nodes, self.bodies = [], []
        for body, place, quaternion in zip(bodies, places, quaternions, strict=True):
            node = NodeRigidBodyEP(referenceCoordinates=[*place, *quaternion], initialVelocities=[0.0] * 7)
            self.nodes.append(self.system.AddNode(node))
            rigid = ObjectRigidBody(mass=body.mass, inertia=[*body.inertia, 0, 0, 0], nodeNumber=self.nodes[-1])
            self.bodies.append(self.system.AddObject(rigid))


def settings() -> exudyn.SimulationSettings:
    """Nothing is printed, and no file is written."""
    found = exudyn.SimulationSettings()
    found.staticSolver.verboseMode = found.timeIntegration.verboseMode = 0
    found.solution.file.write = False
    return found


class Joint(Bodies):
    """A joint of Exudyn's between both bodies; `held` are the numbers of its equations that hold something."""

    def __init__(self, joint: Callable, held: list[int]):
        super().__init__(np.zeros((2, 3)), np.array([UNTURNED, UNTURNED]), [A, B])
        ends = zip(self.bodies, (A, B), strict=True)
        ends = [self.system.AddMarker(MarkerBodyRigid(bodyNumber=n, localPosition=list(body.arm))) for n, body in ends]
        self.system.AddObject(joint(markerNumbers=ends))
        self.system.Assemble()
        self.solver = exudyn.MainSolverStatic()
        self.solver.InitializeSolver(self.system, settings())
        # Before the joint's equations come those of both nodes: Euler parameters are of length 1.
        self.rows = self.solver.GetODE2size() + 2 + np.array(held)

    def at(self, pair: Pair) -> Constraint:
        data, solver = self.system.systemData, self.solver
        coordinates = np.hstack([part for body in zip(pair.places, pair.quaternions, strict=True) for part in body])
        data.SetODE2Coordinates(coordinates - data.GetODE2Coordinates(configuration=exudyn.ConfigurationType.Reference))
        solver.ComputeAlgebraicEquations(self.system)
        residuals = solver.GetSystemResidual()[self.rows]
        # The one sets the matrix, the other adds to it.
        solver.ComputeJacobianODE2RHS(self.system)
        solver.ComputeJacobianAE(self.system)
        jacobian = solver.GetSystemJacobian()[self.rows, : len(coordinates)]
        return Constraint(residuals, jacobian, *self.nodes_at(pair))

    @staticmethod
    def nodes_at(pair: Pair) -> tuple[tuple[Node, Node], np.ndarray]:
        """Nodes, and how translations and spins follow from rates of coordinates."""
        motions, found = np.zeros((12, 14)), []
        for k, (place, quaternion) in enumerate(zip(pair.places, pair.quaternions, strict=True)):
            found.append(Node(place, EulerParameters2RotationMatrix(quaternion)))
            motions[6 * k : 6 * k + 3, 7 * k : 7 * k + 3] = np.eye(3)
            motions[6 * k + 3 : 6 * k + 6, 7 * k + 3 : 7 * k + 7] = EulerParameters2G(quaternion)
        return tuple(found), motions


def joints() -> list[Same]:
    """Where three translations are held, residuals are in the global frame; TRANSLATOR's angles are products."""

    def generic(*axes: int) -> Callable:
        flags = [int(axis in axes) for axis in range(6)]
        return lambda markerNumbers: GenericJoint(markerNumbers=markerNumbers, constrainedAxes=flags)

    def ujoint(triad: np.ndarray) -> np.ndarray:
        return np.block([[triad, np.zeros((3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])

    slider = Joint(lambda markerNumbers: PrismaticJointX(markerNumbers=markerNumbers), [0, 1, 2, 3, 4])
    spherical = Joint(lambda markerNumbers: SphericalJoint(markerNumbers=markerNumbers), [0, 1, 2])
    translator = np.diag([1.0, 1.0, 1.0, -1.0, -1.0])
    return [
        Same(JOIN, spherical.at, lambda triad: triad, rows_at=closed_pairs),
        Same(SLOT, Joint(generic(1, 2), [1, 2]).at, lambda _: np.eye(2)),
        Same(TRANSLATOR, slider.at, lambda _: translator, aligned_pairs, aligned_pairs, varied=["gy", "gz"]),
        Same(UNIVERSAL, Joint(generic(4), [4]).at, lambda _: np.eye(1)),
        Same(UJOINT, Joint(generic(0, 1, 2, 4), [0, 1, 2, 4]).at, ujoint, rows_at=closed_pairs),
    ]


def turn(axis: int, angle: float) -> np.ndarray:
    """The quaternion of a turn about an axis."""
    return np.hstack([np.cos(angle / 2), np.sin(angle / 2) * np.eye(3)[axis]])


#: What Newton's method of Exudyn leaves.
TOLERANCE = 1e-12
#: What acts on every body, in no special direction, and what drives the first one.
FORCE, TORQUE = A.mass * np.array([3.0, -2.0, -9.81]), 20.0
#: Where a body hangs from the ground.
HANGER = np.array([0.1, 0.0, 0.5])
#: The end of a shaft, of a crank and of a rod, from its middle.
SHAFT, CRANK, ROD = np.array([0.0, 1.0, 0.0]), np.array([0.5, 0.0, 0.0]), np.array([1.5, 0.0, 0.0])
#: The axes of a joint whose first one is across the plane of a crank.
ACROSS = np.eye(3)[:, [2, 0, 1]]
#: How mechanisms stand in the global frame, so that no component of a row is always 0.
STAND = product(product(turn(0, 0.7), turn(1, 0.3)), turn(2, 0.5))
WORLD = EulerParameters2RotationMatrix(STAND)


class Mechanism(Bodies):
    """Bodies like A, driven by a torque on the first one, all given before they are turned to STAND.

    Joints to the ground are Exudyn's, and others may be `ours`.
    """

    def __init__(self, ours: bool, places: np.ndarray, quaternions: list[np.ndarray], about: int):
        places, quaternions = places @ WORLD.T, [product(STAND, quaternion) for quaternion in quaternions]
        super().__init__(places, quaternions, [A] * len(places))
        self.ours, self.places, self.quaternions = ours, places, quaternions
        markers = [self.marker(body, np.zeros(3)) for body in self.bodies]
        loads = [Force(markerNumber=marker, loadVector=list(FORCE)) for marker in markers]
        loads.append(Torque(markerNumber=markers[0], loadVector=list(TORQUE * WORLD[:, about])))
        for load in loads:
            self.system.AddLoad(load)

    def marker(self, body: int, place: np.ndarray) -> int:
        return self.system.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=list(place)))

    def hold(self, number: int, axes: list[int], arm: np.ndarray | None = None) -> None:
        """Translations along and turns about three axes, at the end of an arm of a body."""
        arm = np.zeros(3) if arm is None else arm
        place = self.places[number] + turned(self.quaternions[number], arm)
        markers = [self.marker(self.system.AddObject(ObjectGround()), place), self.marker(self.bodies[number], arm)]
        triad = EulerParameters2RotationMatrix(self.quaternions[number])
        frames = dict(rotationMarker0=WORLD, rotationMarker1=triad.T @ WORLD)
        self.system.AddObject(GenericJoint(markerNumbers=markers, constrainedAxes=axes, **frames))

    def join(self, element: str, axes: list[int], numbers: list[int], arms: list[np.ndarray], frame: np.ndarray) -> None:
        """An element between the ends of arms of two bodies, or what Exudyn has for it."""
        if self.ours:
            nodes = [self.nodes[number] for number in numbers]
            Connector(module(element), *arms, frame, frame).add(self.system, *nodes)
            return
        markers = [self.marker(self.bodies[number], arm) for number, arm in zip(numbers, arms, strict=True)]
        frames = dict(rotationMarker0=frame, rotationMarker1=frame)
        self.system.AddObject(GenericJoint(markerNumbers=markers, constrainedAxes=axes, **frames))

    def run(self, steps: int) -> np.ndarray:
        """The coordinates of all bodies before every step and behind the last one."""
        track = []

        def keep(system, _: float) -> bool:
            track.append(system.systemData.GetODE2Coordinates())
            return True

        self.system.Assemble()
        how = settings()
        how.timeIntegration.numberOfSteps, how.timeIntegration.endTime = steps, steps * STEP
        newton = how.timeIntegration.newton
        newton.relativeTolerance = newton.absoluteTolerance = TOLERANCE
        self.system.SetPreStepUserFunction(keep)
        self.system.SolveDynamic(how)
        keep(self.system, how.timeIntegration.endTime)
        return np.array(track)


def two_hung_bodies(ours: bool) -> Mechanism:
    """A body hangs from the ground by a ball joint, and another on it by a universal joint."""
    other = product(turn(0, 0.4), turn(2, -0.5))
    places = np.array([-HANGER, A.arm - HANGER - turned(other, B.arm)])
    bodies = Mechanism(ours, places, [UNTURNED, other], about=0)
    bodies.hold(0, [1, 1, 1, 0, 0, 0], HANGER)
    bodies.join("element.ujoint.smooth", [1, 1, 1, 0, 1, 0], [0, 1], [A.arm, B.arm], np.eye(3))
    return bodies


def a_double_cardan_shaft(ours: bool) -> Mechanism:
    """Universal joints join a shaft, inclined by 40 degrees, to two parallel ones."""
    inclined = turn(0, 2 * np.pi / 9)
    end = turned(inclined, 2 * SHAFT)
    shafts = Mechanism(ours, np.array([-SHAFT, end / 2, end + SHAFT]), [UNTURNED, inclined, UNTURNED], about=1)
    shafts.hold(0, [1, 1, 1, 1, 0, 1])
    shafts.hold(2, [1, 0, 1, 1, 0, 1])
    # The first pin is on the outer shafts: the yokes of the inclined one are in phase.
    for outer, arms in (0, [SHAFT, -SHAFT]), (2, [-SHAFT, SHAFT]):
        shafts.join("element.ujoint.smooth", [1, 1, 1, 0, 1, 0], [outer, 1], arms, np.eye(3))
    return shafts


def a_slider_crank(ours: bool) -> Mechanism:
    """A crank, a rod on a hinge at its end, and a slider, in whose slot across the plane the end of the rod is held."""
    angle = 1.0
    sine = -CRANK[0] / ROD[0] * math.sin(angle)
    crank, rod = turn(2, angle), turn(2, math.asin(sine))
    pin = turned(crank, 2 * CRANK)
    end = pin + turned(rod, 2 * ROD)
    links = Mechanism(ours, np.array([pin / 2, (pin + end) / 2, end]), [crank, rod, UNTURNED], about=2)
    links.hold(0, [1, 1, 1, 1, 1, 0], -CRANK)
    links.hold(2, [0, 1, 1, 1, 1, 1])
    links.join("element.hinge.smooth", [1, 1, 1, 0, 1, 1], [0, 1], [CRANK, -ROD], ACROSS)
    links.join("element.slot.smooth", [0, 1, 1, 0, 0, 0], [2, 1], [np.zeros(3), ROD], ACROSS)
    return links


@contextmanager
def called(export: Export, elements: list[str]) -> Iterator[None]:
    """Has the user functions call the elements as exported, with the error that is planted there."""
    with ExitStack() as patches:
        for id in elements:

            def wrong(*inputs, id=id, exact=module(id).step):
                found = exact(*inputs)
                numbers = export.with_error(id, np.hstack([part.ravel() for part in found]))
                ends = np.cumsum([part.size for part in found])
                return [part.reshape(old.shape) for part, old in zip(np.split(numbers, ends[:-1]), found, strict=True)]

            patches.enter_context(patch.object(module(id), "step", wrong))
        yield


def run_error(mechanism: Callable, elements: list[str], export: Export, steps: int) -> float:
    """The largest difference of a coordinate, of order 1 all of them; infinite where Exudyn does not get through."""
    theirs = mechanism(False).run(steps)
    with called(export, elements):
        try:
            ours = mechanism(True).run(steps)
        except (RuntimeError, ValueError):
            return math.inf
    return float(np.abs(ours - theirs).max()) if ours.shape == theirs.shape else math.inf


def comparisons() -> list[Comparison]:
    """Rows and residuals at poses, and runs with our elements beside those with Exudyn's joints."""

    def run(name: str, mechanism: Callable, ids: list[str], seen: list[str]) -> Comparison:
        """What is seen of elements: not every row where bodies are held by the ground, too."""
        elements = [f"element.{id}.smooth" for id in ids]
        outputs, measure = dict.fromkeys(elements, seen), partial(run_error, mechanism, elements)
        quantity = f"coordinates of {mechanism.__name__.replace('_', ' ')}"
        return Comparison(name, quantity, outputs, measure, STEPS, "steps", bound=1e-9, rounding=TOLERANCE, few=5)

    return [
        *(comparison for joint in joints() for comparison in joint.comparisons()),
        run("UJOINT", two_hung_bodies, ["ujoint"], ["residuals", "rows"]),
        run("UJOINT", a_double_cardan_shaft, ["ujoint"], ["residuals"]),
        run("HINGE and SLOT", a_slider_crank, ["hinge", "slot"], ["residuals"]),
    ]
