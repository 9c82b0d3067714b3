//! REVOLUTE and HINGE, statement by statement.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, outside};
use jointproof::connector::hinge::{self, Hinge};
use jointproof::connector::{join, revolute};
use jointproof::contact::coulomb;

pub(super) fn revolute() -> Document {
    Document {
        source: revolute::DOCUMENT,
        anchor: "revolute",
        about: "A page of the same library as SLOT's: the connection type REVOLUTE, which lets node b rotate about one axis.",
        found: "The page is titled REVOLUTE, in the connection-type library of the Abaqus 2017 documentation: `abaqus-docs.mit.edu/2017/English/SIMACAEELMRefMap/simaelm-c-connectiontypedesc-revolute.htm`.",
        sections: &["Description", "Friction", "Summary"],
        text: None,
        statements: vec![
            covered(
                "description-1",
                "Two rotations are constrained and one is free; the shared axis is the local 1-direction.",
            )
            .formulas(&[&revolute::Constraint])
            .law(&revolute::Constraint, "a rotation of b about the axis does no work"),
            covered("description-2", "The constraints are e1a·e2b = 0 and e1a·e3b = 0, that is e1a = e1b.")
                .formulas(&[&revolute::Constraint])
                .cases(&revolute::Constraint, &["aligned"])
                .outputs(&["revolute/G2", "revolute/G3"]),
            covered("description-3", "They are equivalent to second and third Cardan angles of zero.")
                .law(&revolute::Constraint, "they are −cos β sin γ"),
            covered(
                "description-4",
                "Where the axes do not align at the start, both angles keep their initial values.",
            )
            .cases(&revolute::Constraint, &["as-at-the-start"]),
            covered("description-5", "The constraint moment is m2 e2a + m3 e3a.")
                .formulas(&[&revolute::ConstraintMoment])
                .outputs(&["revolute/RM"]),
            covered("description-6", "The angle is α = −arctan of e2a·e3b over e3a·e3b, counted from e2a to e2b.")
                .formulas(&[&revolute::Angle])
                .law(&revolute::Angle, "it is the first Cardan angle")
                .outputs(&["revolute/ALPHA"]),
            covered(
                "description-7",
                "The available component is ur1 = α − α0 + nπ; n counts rotations about the axis.",
            )
            .formulas(&[&revolute::RelativeMotion])
            .chapter("hinge.md#revolute")
            .outputs(&["revolute/UR1"]),
            covered("description-8", "The constitutive rotation is α less the reference angle, with the same nπ.")
                .formulas(&[&revolute::RelativeMotion])
                .outputs(&["revolute/UR1MAT"]),
            covered("description-9", "The kinetic moment is m1 e1a.")
                .formulas(&[&revolute::KineticMoment])
                .outputs(&["revolute/KM"]),
            covered("friction", "By itself it has no predefined friction; with JOIN it has that of HINGE.")
                .chapter("hinge.md#friction"),
            outside(
                "products",
                "It cannot be used in two-dimensional or axisymmetric analysis.",
                "says where it does not exist",
            ),
        ],
    }
}

pub(super) fn hinge() -> Document {
    Document {
        source: hinge::DOCUMENT,
        anchor: "hinge",
        about: "A page of the same library as SLOT's: the connection type HINGE, which is JOIN and REVOLUTE together, with the friction of its pin.",
        found: "The page is titled HINGE, in the connection-type library of the Abaqus 2017 documentation: `abaqus-docs.mit.edu/2017/English/SIMACAEELMRefMap/simaelm-c-connectiontypedesc-hinge.htm`. Its equations are images.",
        sections: &["Description", "Friction", "Summary"],
        text: None,
        statements: [description(), friction(), summary()].into_iter().flatten().collect(),
    }
}

fn description() -> Vec<Statement> {
    vec![
        covered("description-1", "Its constraints and orientations are those of JOIN and REVOLUTE together.")
            .formulas(&[&hinge::Constraint, &join::Constraint, &revolute::Constraint])
            .law(&hinge::Constraint, "its residuals are those of JOIN")
            .method(Hinge::new)
            .method(Hinge::constraint)
            .outputs(&["hinge/G", "hinge/G2", "hinge/G3"]),
        covered("description-2", "The reported forces and moments are those that the constraints exert on node b.")
            .chapter("conventions.md#node-a-and-node-b")
            .outputs(&["hinge/RF", "hinge/RM"]),
        covered("description-3", "They are most meaningful with node b at the centre of the device; where friction follows from moments this is essential.")
            .chapter("conventions.md#node-a-and-node-b"),
    ]
}

fn friction() -> Vec<Statement> {
    vec![
        covered("friction-1", "Friction relates the constraint forces and moments to the friction moment CSM1 about the axis.")
            .formulas(&[&hinge::Friction, &coulomb::Response])
            .outputs(&["hinge/CSM1"]),
        covered("friction-2", "Φ = P − μ M_N; P is the moment of the tangential tractions, M_N the normal moment.")
            .formulas(&[&hinge::Friction, &coulomb::Yield])
            .cases(&hinge::Friction, &["running", "slip"])
            .law(&hinge::Friction, "at the friction moment")
            .method(Hinge::friction)
            .outputs(&["hinge/P", "hinge/MN", "hinge/PHI"]),
        covered("friction-3", "The normal moment is the size of the contact moment and that of the internal one.")
            .formulas(&[&hinge::Friction])
            .cases(&hinge::Friction, &["press-fit"]),
        covered("friction-4", "The contact moment is made of the axial force at R_a, the force across the pin at R_p, and bending over L_s.")
            .formulas(&[&hinge::ContactMoment])
            .cases(&hinge::ContactMoment, &["running", "no-arm", "no-overlap"])
            .law(&hinge::ContactMoment, "a couple of forces at both ends")
            .outputs(&["hinge/MC"]),
    ]
}

fn summary() -> Vec<Statement> {
    vec![
        covered("summary-1", "HINGE is an assembled connection: JOIN and REVOLUTE.").chapter("hinge.md#hinge"),
        covered("summary-2", "Reported are f1, f2, f3, m2 and m3; available is ur1; kinetic is m1.").outputs(&[
            "hinge/RF",
            "hinge/RM",
            "hinge/UR1",
            "hinge/KM",
        ]),
        covered("summary-3", "The stops are a least and a greatest α.")
            .formulas(&[&hinge::Stop])
            .method(Hinge::with_stops)
            .outputs(&["hinge/GAP1MIN", "hinge/GAP1MAX"]),
        covered("summary-4", "The constitutive reference is an angle.")
            .method(Hinge::with_reference_angle)
            .outputs(&["hinge/UR1MAT"]),
        covered("summary-5", "Friction requires R_p; R_a, L_s and the internal contact moment are optional.")
            .cases(&hinge::ContactMoment, &["no-arm", "no-overlap"])
            .method(Hinge::with_friction),
    ]
}
