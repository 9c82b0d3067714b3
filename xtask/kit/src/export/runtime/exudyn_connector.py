"""Exported connectors in Exudyn: constraints between two rigid bodies, whose user functions are the
residuals and rows of the element.

    import jp_element_ujoint_smooth as ujoint
    Connector(ujoint, arm_a=[0, 0, -0.5], arm_b=[0, 0, 0.5]).add(mbs, node_a, node_b)

Arms and frames are in the axes of the bodies: where the connector is, and its axes as columns.
What the element takes at the start, as c0 or d0, is 0 unless it is given by its name.
Printed by jointproof; free of conditions (CC0-1.0)."""

import numpy as np
from exudyn.itemInterface import CoordinateVectorConstraint, MarkerNodeCoordinates
from exudyn.rigidBodyUtilities import EulerParameters2G, EulerParameters2RotationMatrix


# ANCHOR: exudyn
class Connector:
    """Between two nodes NodeRigidBodyEP, at the ends of arms."""

    def __init__(self, element, arm_a=(0, 0, 0), arm_b=(0, 0, 0), frame_a=np.eye(3), frame_b=np.eye(3), **start):
        self.element = element
        self.ends = [(np.array(arm_a), np.array(frame_a)), (np.array(arm_b), np.array(frame_b))]
        # Behind the triads and places of both nodes come multipliers, which do not act on rows.
        zeros = [(name, 0.0 if length == 1 else np.zeros(length)) for name, length in element.INPUTS[8:]]
        self.given = [start.get(name, zero) for name, zero in zeros]
        self.last = None

    def at(self, q):
        """Residuals and rows by translations and spins; the arms in the global frame."""
        if self.last and np.array_equal(self.last[0], q):
            return self.last[1]
        triads, places, arms = [], [], []
        for node, (arm, frame) in zip((q[:7], q[7:]), self.ends):
            turned = EulerParameters2RotationMatrix(node[3:])
            triads += [*(turned @ frame).T]
            arms.append(turned @ arm)
            places.append(node[:3] + arms[-1])
        residuals, rows, *_ = self.element.step(*triads, *places, *self.given)
        self.last = np.array(q), (residuals, rows, arms)
        return self.last[1]

    def jacobian(self, mbs, t, item, q, q_t, velocity_level):
        """Rows by coordinates: a spin is the matrix G times rates of Euler parameters."""
        _, rows, arms = self.at(q)
        by_coordinates = []
        for k, arm in enumerate(arms):
            by_place, by_spin = rows[:, 6 * k : 6 * k + 3], rows[:, 6 * k + 3 : 6 * k + 6]
            spins = (by_spin + np.cross(arm, by_place)) @ EulerParameters2G(q[7 * k + 3 : 7 * k + 7])
            by_coordinates += [by_place, spins]
        return np.hstack(by_coordinates)

    def constraint(self, mbs, t, item, q, q_t, velocity_level):
        """The residuals, or how fast they change."""
        if velocity_level:
            return self.jacobian(mbs, t, item, q, q_t, velocity_level) @ q_t
        return self.at(q)[0]

    def add(self, mbs, node_a, node_b):
        """Adds it to a system, and returns the number of the object."""
        nodes = (node_a, node_b)
        markers = [mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node)) for node in nodes]
        return mbs.AddObject(
            CoordinateVectorConstraint(
                markerNumbers=markers,
                # Says how many equations there are.
                scalingMarker0=np.zeros((dict(self.element.OUTPUTS)["residuals"], 1)),
                constraintUserFunction=self.constraint,
                jacobianUserFunction=self.jacobian,
            )
        )
# ANCHOR_END: exudyn
