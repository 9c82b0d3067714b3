"""Bodies and joints as Exudyn has them, and our UJOINT in it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from unittest.mock import patch

import exudyn
import numpy as np
from exudyn.itemInterface import (
    Force,
    GenericJoint,
    MarkerBodyPosition,
    MarkerBodyRigid,
    NodeRigidBodyEP,
    ObjectGround,
    ObjectRigidBody,
    PrismaticJointX,
    SphericalJoint,
)
from exudyn.rigidBodyUtilities import EulerParameters2G, EulerParameters2RotationMatrix

from agreement import Comparison
from connectors import JOIN, SLOT, TRANSLATOR, UJOINT, UNIVERSAL, Node
from constraints import Constraint, Pair, Same, aligned_pairs, closed_pairs, product, turned
from export import Export, module
from motions import A, B
from runs import GRAVITY, STEP, STEPS

# What is exported is found once `export` has said where.
from exudyn_ujoint import UJoint  # isort: skip

NAME, PACKAGE = "Exudyn", "exudyn"
# A solver that fails says so, and raises; here it may fail, with an error that was planted.
exudyn.config.printToConsole = False
UNTURNED = np.array([1.0, 0.0, 0.0, 0.0])


class Bodies:
    """Two bodies in a system of Exudyn's, with nodes that count Euler parameters."""

    def __init__(self, places: np.ndarray, quaternions: np.ndarray):
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.nodes, self.bodies = [], []
        for body, place, quaternion in zip((A, B), places, quaternions, strict=True):
            node = NodeRigidBodyEP(referenceCoordinates=[*place, *quaternion], initialVelocities=[0.0] * 7)
            self.nodes.append(self.system.AddNode(node))
            rigid = ObjectRigidBody(mass=body.mass, inertia=[*body.inertia, 0, 0, 0], nodeNumber=self.nodes[-1])
            self.bodies.append(self.system.AddObject(rigid))

    def ends(self) -> list[int]:
        """Markers at the ends of the arms."""
        pairs = zip(self.bodies, (A, B), strict=True)
        return [self.system.AddMarker(MarkerBodyRigid(bodyNumber=n, localPosition=list(body.arm))) for n, body in pairs]


def settings() -> exudyn.SimulationSettings:
    """Nothing is printed, and no file is written."""
    found = exudyn.SimulationSettings()
    found.staticSolver.verboseMode = found.timeIntegration.verboseMode = 0
    found.solution.file.write = False
    return found


class Joint(Bodies):
    """A joint of Exudyn's between both bodies; `held` are the numbers of its equations that hold something."""

    def __init__(self, joint: Callable, held: list[int]):
        super().__init__(np.zeros((2, 3)), np.array([UNTURNED, UNTURNED]))
        self.system.AddObject(joint(markerNumbers=self.ends()))
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


#: Where body a hangs from the ground, in its axes, and how both are turned at the start, by rotation vectors.
HANGER = np.array([0.1, 0.0, 0.5])
#: What Newton's method of Exudyn leaves.
TOLERANCE = 1e-12


class Hung(Bodies):
    """Body a hangs from the ground by a ball joint, and body b on a by a universal joint: Exudyn's, or `ours`."""

    def __init__(self, ours: UJoint | None):
        # The first axis of a and the third of b are perpendicular: between the bodies are turns about these two.
        a = product(product(turn(0, 0.7), turn(1, 0.3)), turn(2, 0.5))
        b = product(product(a, turn(0, 0.4)), turn(2, -0.5))
        at_a = -turned(a, HANGER)
        super().__init__(np.array([at_a, at_a + turned(a, A.arm) - turned(b, B.arm)]), np.array([a, b]))
        system = self.system
        for number, body in zip(self.bodies, (A, B), strict=True):
            marker = system.AddMarker(MarkerBodyPosition(bodyNumber=number))
            system.AddLoad(Force(markerNumber=marker, loadVector=list(body.mass * GRAVITY)))
        ground = system.AddMarker(MarkerBodyPosition(bodyNumber=system.AddObject(ObjectGround())))
        hanger = system.AddMarker(MarkerBodyPosition(bodyNumber=self.bodies[0], localPosition=list(HANGER)))
        system.AddObject(SphericalJoint(markerNumbers=[ground, hanger]))
        if ours:
            ours.add(system, *self.nodes)
        else:
            system.AddObject(GenericJoint(markerNumbers=self.ends(), constrainedAxes=[1, 1, 1, 0, 1, 0]))
        system.Assemble()

    def run(self, steps: int) -> np.ndarray:
        """The coordinates of both bodies before every step and behind the last one."""
        track = []

        def keep(system, _: float) -> bool:
            track.append(system.systemData.GetODE2Coordinates())
            return True

        how = settings()
        how.timeIntegration.numberOfSteps, how.timeIntegration.endTime = steps, steps * STEP
        newton = how.timeIntegration.newton
        newton.relativeTolerance = newton.absoluteTolerance = TOLERANCE
        self.system.SetPreStepUserFunction(keep)
        self.system.SolveDynamic(how)
        keep(self.system, how.timeIntegration.endTime)
        return np.array(track)


#: The formulas that the user functions call, and what is seen of them.
CALLED = {"ujoint.constraint": None, "element.arm": ["m_node"]} | UJOINT.closed_rows()


@contextmanager
def called(export: Export) -> Iterator[None]:
    """Has the user functions call the formulas as exported, with the error that is planted there."""
    with ExitStack() as patches:
        for id in CALLED:
            exact = module(id).value
            wrong = lambda *inputs, id=id, exact=exact: export.with_error(id, exact(*inputs))  # noqa: E731
            patches.enter_context(patch.object(module(id), "value", wrong))
        yield


def run_error(export: Export, steps: int) -> float:
    """The largest difference of a coordinate, of order 1 all of them; infinite where Exudyn does not get through."""
    theirs = Hung(None).run(steps)
    with called(export):
        try:
            ours = Hung(UJoint(A.arm, B.arm)).run(steps)
        except (RuntimeError, ValueError):
            return math.inf
    return float(np.abs(ours - theirs).max()) if ours.shape == theirs.shape else math.inf


def comparisons() -> list[Comparison]:
    """Rows and residuals at poses, and a run with our rows beside one with Exudyn's joint."""
    run = Comparison(
        "UJOINT", "coordinates along a run", CALLED, run_error, STEPS, "steps", bound=1e-9, rounding=TOLERANCE, few=5
    )
    return [*(comparison for joint in joints() for comparison in joint.comparisons()), run]
