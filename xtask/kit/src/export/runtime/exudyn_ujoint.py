"""UJOINT in Exudyn: a constraint between two rigid bodies, whose user functions are the exported
residuals and rows.

    UJoint(arm_a=[0, 0, -0.5], arm_b=[0, 0, 0.5]).add(mbs, node_a, node_b)

The arms of the cross are the first axis of body a and the third of body b. They are perpendicular
where the joint is in its place. Multipliers are the forces on b along the axes of a, and the moment
about the cross product of both arms.
Printed by jointproof; free of conditions (CC0-1.0)."""

import jp_element_arm
import jp_join_rows
import jp_ujoint_constraint
import jp_universal_rows
import numpy as np
from exudyn.itemInterface import CoordinateVectorConstraint, MarkerNodeCoordinates
from exudyn.rigidBodyUtilities import EulerParameters2G, EulerParameters2RotationMatrix


# ANCHOR: exudyn
class UJoint:
    """Between two nodes NodeRigidBodyEP, at the ends of arms in the axes of their bodies."""

    def __init__(self, arm_a=(0.0, 0.0, 0.0), arm_b=(0.0, 0.0, 0.0)):
        self.arm_a, self.arm_b = np.array(arm_a), np.array(arm_b)

    def places(self, q):
        """The arms in the global frame, and what the formulas are given."""
        triad_a = EulerParameters2RotationMatrix(q[3:7])
        triad_b = EulerParameters2RotationMatrix(q[10:14])
        r_a, r_b = triad_a @ self.arm_a, triad_b @ self.arm_b
        return r_a, r_b, [*triad_a.T, triad_b[:, 2], q[:3] + r_a, q[7:10] + r_b]

    def jacobian(self, mbs, t, item, q, q_t, velocity_level):
        """Rows by coordinates: a spin is the matrix G times rates of Euler parameters."""
        r_a, r_b, places = self.places(q)
        g_a, g_b = EulerParameters2G(q[3:7]), EulerParameters2G(q[10:14])
        e1a, e2a, e3a, e3b, x_a, x_b = places
        # JOIN's rows have no spin of b, and UNIVERSAL's no translations.
        zero = np.zeros(3)
        by_motions = [[*row, zero] for row in jp_join_rows.value(e1a, e2a, e3a, x_a, x_b).reshape(3, 3, 3)]
        spin_of_a, spin_of_b = jp_universal_rows.value(e1a, e3b).reshape(2, 3)
        by_motions.append([zero, spin_of_a, zero, spin_of_b])
        jacobian = []
        for u_a, t_a, u_b, t_b in by_motions:
            spin_a = jp_element_arm.value(r_a, u_a, t_a)[:3]
            spin_b = jp_element_arm.value(r_b, u_b, t_b)[:3]
            jacobian.append(np.hstack([u_a, spin_a @ g_a, u_b, spin_b @ g_b]))
        return np.array(jacobian)

    def constraint(self, mbs, t, item, q, q_t, velocity_level):
        """The residuals, or how fast they change."""
        if velocity_level:
            return self.jacobian(mbs, t, item, q, q_t, velocity_level) @ q_t
        *_, places = self.places(q)
        return jp_ujoint_constraint.value(*places, np.zeros(3), 0.0)

    def add(self, mbs, node_a, node_b):
        """Adds it to a system, and returns the number of the object."""
        nodes = (node_a, node_b)
        markers = [mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node)) for node in nodes]
        return mbs.AddObject(
            CoordinateVectorConstraint(
                markerNumbers=markers,
                scalingMarker0=np.zeros((4, 1)),  # says that there are four equations
                constraintUserFunction=self.constraint,
                jacobianUserFunction=self.jacobian,
            )
        )
# ANCHOR_END: exudyn
