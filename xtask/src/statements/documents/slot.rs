//! SLOT, statement by statement.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, mended, outside};
use jointproof::connector::slot::{self, Slot, Slot2d};
use jointproof::contact::coulomb;
use jointproof::formula;

pub(super) fn document() -> Document {
    Document {
        source: formula::Document::SLOT,
        anchor: "slot",
        about: "A page of a library of connector elements: the constraint of the connection type SLOT, its forces, its friction, \
                and a summary of inputs and outputs.",
        found: "The page is titled SLOT. It names the products Abaqus/Standard, Abaqus/Explicit and Abaqus/CAE, and refers to \
                *Connector Elements* and *Connector Element Library*.",
        sections: &["Description", "Friction", "Summary"],
        text: Some((3387, "3eef9d37b735278658ac0aa3ef3102fc12f60a6f2bf2f418f69bbeec13ecda63")),
        statements: [position(), friction(), summary()].into_iter().flatten().collect(),
    }
}

fn position() -> Vec<Statement> {
    vec![
        covered("L3-s1", "Node b stays on a line that a's orientation and b's initial position define.")
            .formulas(&[&slot::Constraint])
            .method(Slot::new)
            .method(Slot::constraint)
            .outputs(&["slot/GY", "slot/GZ"])
            .chapter("slot.md#slot"),
        covered("L3-s2", "The line of action is e1a.")
            .formulas(&[&slot::RelativePosition, &slot::KineticForce])
            .chapter("slot.md#slot"),
        covered("L5-s1", "In space b cannot move along e3a, normal to the slot.")
            .formulas(&[&slot::Constraint])
            .law(&slot::Constraint, "moving b along the slot")
            .cases(&slot::Constraint, &["running"])
            .outputs(&["slot@3d/GZ"]),
        covered("L5-s2", "If b is free in the normal direction, use SLIDE-PLANE.").chapter("slot.md#neighbours"),
        outside("L7-14", "Cross references.", "refers to other pages"),
        outside("L16", "The products that support it.", "names of programs"),
        covered("L20", "A figure of the slot.").chapter("slot.md#slot"),
        covered("L22-s1", "The first direction of a and the initial position of b give the line.")
            .method(Slot::new)
            .chapter("slot.md#slot"),
        covered("L22-s2", "The position of b stays on that line.")
            .formulas(&[&slot::Constraint])
            .method(Slot::constraint)
            .cases(&slot::Constraint, &["on-the-slot"]),
        covered("L22-s3", "So the relative position is fixed in both directions normal to the slot.")
            .formulas(&[&slot::Constraint])
            .law(&slot::Constraint, "moving b along the slot"),
        covered("L24", "y = e2a·(xb − xa) stays at y0.")
            .formulas(&[&slot::RelativePosition, &slot::Constraint, &slot::Constraint2d])
            .law(&slot::Constraint2d, "it is gy")
            .outputs(&["slot/Y", "slot/GY"]),
        covered("L26", "y0 is the initial distance in the local 2-direction.")
            .formulas(&[&slot::RelativePosition])
            .method(Slot::new)
            .chapter("scenes.md#a-first-scene"),
        covered("L28", "In space, z = e3a·(xb − xa) stays at z0.")
            .formulas(&[&slot::RelativePosition, &slot::Constraint])
            .outputs(&["slot@3d/Z", "slot@3d/GZ"]),
        covered("L30", "z0 is the initial distance in the local 3-direction.")
            .formulas(&[&slot::RelativePosition])
            .method(Slot::new),
        covered("L32", "The constraint force is f2 e2a + f3 e3a.")
            .formulas(&[&slot::ConstraintForce])
            .law(&slot::Constraint, "the constraint force is Jacobianᵀ")
            .cases(&slot::ConstraintForce, &["running"])
            .method(Slot::constraint_force)
            .outputs(&["slot/RF"]),
        covered("L34", "In the plane f3 = 0.")
            .formulas(&[&slot::ConstraintForce])
            .cases(&slot::ConstraintForce, &["plane"])
            .cases(&slot::ContactForce, &["plane"])
            .method(Slot2d::friction)
            .test("scenes::no_third_axis_in_the_plane"),
        covered("L36-s1", "Node b can move along the line.")
            .formulas(&[&slot::RelativeMotion])
            .law(&slot::ConstraintForce, "it does no work along the slot")
            .chapter("slot.md#position-in-the-slot"),
        covered("L36-s2", "The relative position is the distance along e1a, x = e1a·(xb − xa), with its sign.")
            .formulas(&[&slot::RelativePosition])
            .cases(&slot::RelativePosition, &["running", "quarter-turn"])
            .method(Slot::relative_position)
            .outputs(&["slot/X"]),
        covered("L40", "The available component is u1 = x − x0.")
            .formulas(&[&slot::RelativeMotion])
            .cases(&slot::RelativeMotion, &["start"])
            .method(Slot::relative_motion)
            .outputs(&["slot/U1"]),
        covered("L44", "x0 is the initial distance along the slot.")
            .formulas(&[&slot::RelativeMotion])
            .method(Slot::new),
        covered("L46", "The constitutive displacement is u1mat = x − l1ref.")
            .formulas(&[&slot::RelativeMotion])
            .law(&slot::RelativeMotion, "both displacements grow")
            .method(Slot::with_reference_length)
            .outputs(&["slot/U1MAT"]),
        covered("L50", "The kinetic force is f1 e1a.")
            .formulas(&[&slot::KineticForce])
            .law(&slot::KineticForce, "its power is f1")
            .method(Slot::kinetic_force)
            .outputs(&["slot/KF"])
            .test("scene_friction::a_load_and_friction_make_the_kinetic_force_together"),
    ]
}

fn friction() -> Vec<Statement> {
    vec![
        covered("L54", "Friction relates the constraint forces to the friction force CSF1 along the slot.")
            .formulas(&[&slot::Friction, &coulomb::ReturnMap])
            .outputs(&["slot/CSF1", "slot/SLIP1"])
            .chapter("scenes.md#histories"),
        covered("L58", "Φ = P − μFN, at most 0.")
            .formulas(&[&slot::Friction, &coulomb::Yield])
            .law(&slot::Friction, "at the friction force μ F_N")
            .method(Slot::friction)
            .outputs(&["slot/PHI"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .erratum("lost-sign"),
        covered(
            "L60-s1",
            "P is the size of the tangential tractions, FN the normal force, μ the friction coefficient.",
        )
        .formulas(&[&slot::Friction])
        .outputs(&["slot/P", "slot/FN"])
        .chapter("coulomb.md#stick-and-slip"),
        covered("L60-s2", "It sticks if Φ < 0, and slips if Φ = 0, with the friction force μFN.")
            .formulas(&[&coulomb::ReturnMap])
            .law(&coulomb::ReturnMap, "what is transmitted never exceeds")
            .cases(&coulomb::ReturnMap, &["stick", "slip"])
            .outputs(&["slot/PHI", "slot/CSF1", "slot/SLIP1"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .test("scene_friction::golden_scenes_agree_with_themselves")
            .chapter("coulomb.md#stick-and-slip"),
        covered("L62", "FN = |FC + FCint|: the contact force, and one that is in equilibrium with itself.")
            .formulas(&[&slot::NormalForce])
            .cases(&slot::NormalForce, &["running", "tension"])
            .method(Slot::with_friction)
            .outputs(&["slot/FN"])
            .erratum("two-normal-forces"),
        mended("L66", "FC is the root of f2² + f3²; the root is lost in our copy.", "lost-roots")
            .formulas(&[&slot::ContactForce])
            .law(&slot::ContactForce, "turning the slot about its axis")
            .cases(&slot::ContactForce, &["running"])
            .outputs(&["slot/FC"]),
        covered("L70", "P = |f1|.")
            .formulas(&[&slot::Friction])
            .law(&slot::Friction, "reversing f1")
            .outputs(&["slot/P"]),
        covered("L72-s1", "Combined with REVOLUTE or ALIGN, friction is computed in another way.")
            .chapter("slot.md#neighbours"),
        covered("L72-s2", "See CYLINDRICAL and TRANSLATOR for it.")
            .chapter("slot.md#neighbours")
            .chapter("translator.md#friction"),
    ]
}

fn summary() -> Vec<Statement> {
    vec![
        covered("L77", "SLOT is a basic connection.").chapter("slot.md#neighbours"),
        covered("L78", "Constraints: y = y0, z = z0.").formulas(&[&slot::Constraint]).outputs(&["slot/GY", "slot/GZ"]),
        covered("L79", "Constraint forces reported: f2, f3.")
            .formulas(&[&slot::ConstraintForce])
            .outputs(&["slot/RF"])
            .chapter("scenes.md#in-space"),
        covered("L80", "Available component: u1.").formulas(&[&slot::RelativeMotion]).outputs(&["slot/U1"]),
        covered("L81", "Kinetic force reported: f1.")
            .formulas(&[&slot::KineticForce])
            .outputs(&["slot/KF"])
            .chapter("scenes.md#histories"),
        covered("L82", "Orientation at a: required.")
            .method(Slot::new)
            .test("scene_faults::a_required_triad_is_required_and_the_second_is_the_first")
            .chapter("scenes.md#the-file"),
        covered("L83", "Orientation at b: ignored.").item::<slot::Pose>().formulas(&[&slot::Constraint]),
        covered("L84", "Stops bound l between l1min and l1max.")
            .formulas(&[&slot::Stop])
            .law(&slot::Stop, "the gaps add up")
            .cases(&slot::Stop, &["at-lower", "at-upper", "beyond"])
            .method(Slot::with_stops)
            .method(Slot::with_lower_stop)
            .method(Slot::with_upper_stop)
            .test("scene_parts::a_stop_on_one_side_needs_nothing_of_the_other")
            .outputs(&["slot/GAPMIN", "slot/GAPMAX"])
            .erratum("length-at-the-stops"),
        covered("L85", "Constitutive reference length: l1ref.")
            .method(Slot::with_reference_length)
            .outputs(&["slot/U1MAT"]),
        covered("L86", "Friction parameter, optional: FCint.")
            .method(Slot::with_friction)
            .cases(&slot::NormalForce, &["no-internal-force"]),
        covered("L87", "Contact force reported: FC.").formulas(&[&slot::ContactForce]).outputs(&["slot/FC"]),
    ]
}
