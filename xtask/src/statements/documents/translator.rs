//! TRANSLATOR, statement by statement.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, mended, outside};
use jointproof::connector::translator::{self, Translator};
use jointproof::connector::{align, slot};
use jointproof::contact::coulomb;
use jointproof::element::cardan;
use jointproof::formula;

pub(super) fn document() -> Document {
    Document {
        source: formula::Document::TRANSLATOR,
        anchor: "translator",
        about: "A page of the same library as SLOT's: the connection type TRANSLATOR, which is SLOT and ALIGN together, and the \
                three sources of its contact force.",
        found: "The page is titled TRANSLATOR. It names the products Abaqus/Standard, Abaqus/Explicit and Abaqus/CAE, and refers \
                to *Connector elements* and *Connector element library*.",
        sections: &["Description", "Friction", "Summary"],
        text: Some((3594, "9eeac7fb0b5aa274554c5736a9b77332875f2fa8ec0ea03fb1b3a0cc3cf6c119")),
        statements: [description(), friction(), summary()].into_iter().flatten().collect(),
    }
}

const NODES: &str = "conventions.md#node-a-and-node-b";

fn description() -> Vec<Statement> {
    vec![
        covered("L3", "It is a slot between two nodes whose directions it keeps aligned.")
            .formulas(&[&translator::Constraint])
            .method(Translator::new)
            .method(Translator::constraint)
            .outputs(&["translator/GY", "translator/GZ", "translator/UR1", "translator/UR2", "translator/UR3"]),
        outside("L5-12", "Cross references, and the products that support it.", "refers to other pages"),
        covered("L16", "A figure of it.").chapter("translator.md#friction"),
        covered("L18", "Its constraints and orientations are those of SLOT and ALIGN together.")
            .formulas(&[
                &translator::Constraint,
                &align::Constraint,
                &align::ConstraintMoment,
                &cardan::CardanAngles,
                &cardan::BetaTwoArgument,
            ])
            .law(&translator::Constraint, "assembly")
            .test("translator::it_is_slot_and_align_assembled")
            .chapter("cardan.md#convention"),
        covered("L20-s1", "The reported forces depend strongly on order and position of the nodes.").chapter(NODES),
        covered("L20-s2", "The constraints are enforced at node b, and the reported forces and moments act on b.")
            .law(&translator::Constraint, "aligned, Jacobianᵀ")
            .chapter(NODES),
        covered("L20-s3", "The reported values are most meaningful with b at the centre of the device.").chapter(NODES),
        covered("L20-s4", "This is essential where friction follows from moments.").chapter(NODES),
        covered("L20-s5", "The enforcement does not depend on order and position of the nodes.")
            .law(&translator::Constraint, "aligned, the exchanged nodes are held")
            .test("virtual_work::the_order_of_the_nodes_changes_no_enforcement")
            .chapter(NODES),
    ]
}

fn friction() -> Vec<Statement> {
    vec![
        covered("L24", "Friction relates constraint forces and moments to the friction force CSF1.")
            .formulas(&[&translator::Friction, &coulomb::ReturnMap])
            .outputs(&["translator/CSF1"]),
        covered("L28", "Φ = P − μFN, at most 0.")
            .formulas(&[&translator::Friction, &coulomb::Yield])
            .law(&translator::Friction, "at the friction force μ F_N")
            .method(Translator::friction)
            .outputs(&["translator/PHI"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .erratum("lost-sign"),
        covered("L30", "The meaning of P, FN and μ; stick if Φ < 0, slip if Φ = 0, with the force μFN.")
            .formulas(&[&translator::Friction, &coulomb::ReturnMap])
            .cases(&translator::Friction, &["running", "slip"])
            .outputs(&["translator/P", "translator/FN", "translator/PHI", "translator/CSF1", "translator/SLIP1"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .test("scene_friction::golden_scenes_agree_with_themselves")
            .chapter("coulomb.md#stick-and-slip"),
        covered("L32", "FN = |FC + FCint|.")
            .formulas(&[&slot::NormalForce])
            .outputs(&["translator/FN"])
            .erratum("two-normal-forces"),
        covered("L36", "FC is the sum of three contributions.")
            .formulas(&[&translator::ContactForce])
            .test("translator::each_part_adds_to_the_contact_force")
            .chapter("translator.md#friction"),
        covered("L38", "The torque is Mtorq = |m1|.")
            .formulas(&[&translator::TorqueForce])
            .law(&translator::TorqueForce, "reversing the torque")
            .outputs(&["translator/MTORQ"]),
        mended("L41", "Ftorq is Mtorq over Rr; the quotient is lost in our copy.", "lost-quotients")
            .formulas(&[&translator::TorqueForce])
            .law(&translator::TorqueForce, "the contact force at its lever")
            .outputs(&["translator/FTORQ"]),
        covered("L43", "Rr is the radius of the shaft; if it is 0, the torque is omitted.")
            .formulas(&[&translator::TorqueForce])
            .cases(&translator::TorqueForce, &["no-radius"])
            .cases(&translator::ContactForce, &["no-radius"])
            .test("translator::a_lever_of_zero_drops_its_moment_and_a_short_one_does_not"),
        mended("L45", "Fr is the root of f2² + f3²; the root is lost in our copy.", "lost-roots")
            .formulas(&[&translator::RadialForce])
            .law(&translator::RadialForce, "it is the contact force of a SLOT")
            .outputs(&["translator/FR"]),
        mended("L51", "Mbend is the root of m2² + m3²; Fbend = 2 Mbend over L.", "lost-roots")
            .formulas(&[&translator::BendingForce])
            .law(&translator::BendingForce, "two opposite forces")
            .cases(&translator::BendingForce, &["running"])
            .outputs(&["translator/MBEND", "translator/FBEND"])
            .erratum("lost-quotients"),
        covered("L56", "L is the overlap along the slot; if it is 0, bending is omitted.")
            .formulas(&[&translator::BendingForce])
            .cases(&translator::BendingForce, &["no-length"])
            .cases(&translator::ContactForce, &["no-length"]),
        covered("L60", "FC = |m1/Rr| + the root of f2² + f3² + the root of (βm2)² + (βm3)².")
            .formulas(&[&translator::ContactForce])
            .law(&translator::ContactForce, "without moments")
            .cases(&translator::ContactForce, &["running", "slot"])
            .outputs(&["translator/FC"]),
        mended("L62", "β = 2/L; β is also the letter of an angle.", "two-meanings-of-beta")
            .formulas(&[&translator::BendingForce, &translator::ContactForce]),
        covered("L64", "P = |f1|.").formulas(&[&translator::Friction]).outputs(&["translator/P"]),
    ]
}

fn summary() -> Vec<Statement> {
    vec![
        covered("L69", "TRANSLATOR is an assembled connection.").chapter("translator.md#translator"),
        covered("L70", "Constraints: SLOT and ALIGN.")
            .formulas(&[&translator::Constraint])
            .law(&translator::Constraint, "assembly"),
        covered("L71", "Constraint forces and moments reported: f2, f3, m1, m2, m3.")
            .formulas(&[&slot::ConstraintForce, &align::ConstraintMoment])
            .law(&align::ConstraintMoment, "its components along a's axes")
            .method(Translator::constraint_force)
            .method(Translator::constraint_moment)
            .outputs(&["translator/RF", "translator/RM"]),
        covered("L72", "Available component: u1.").formulas(&[&slot::RelativeMotion]).outputs(&["translator/U1"]),
        covered("L73", "Kinetic force reported: f1.")
            .formulas(&[&slot::KineticForce])
            .outputs(&["translator/KF"])
            .chapter("scenes.md#histories"),
        covered("L74", "Orientation at a: required.")
            .method(Translator::new)
            .test("scene_faults::a_required_triad_is_required_and_the_second_is_the_first"),
        covered("L75", "Orientation at b: optional.")
            .method(Translator::new)
            .test("scene_faults::a_required_triad_is_required_and_the_second_is_the_first")
            .chapter("scenes.md#the-file"),
        covered("L76", "Stops bound l between l1min and l1max.")
            .formulas(&[&slot::Stop])
            .method(Translator::with_stops)
            .method(Translator::with_lower_stop)
            .method(Translator::with_upper_stop)
            .test("scene_parts::a_stop_on_one_side_needs_nothing_of_the_other")
            .outputs(&["translator/GAPMIN", "translator/GAPMAX"])
            .erratum("length-at-the-stops"),
        covered("L77", "Constitutive reference length: l1ref.")
            .method(Translator::with_reference_length)
            .outputs(&["translator/U1MAT"]),
        covered("L78", "Friction parameters, all optional: Rr, L, FCint.")
            .method(Translator::with_friction)
            .test("translator::without_friction_parameters_there_is_no_friction"),
        covered("L79", "Contact force reported: FC.")
            .formulas(&[&translator::ContactForce])
            .outputs(&["translator/FC"]),
    ]
}
