//! UJOINT, statement by statement.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, mended, outside};
use jointproof::connector::ujoint::{self, Cross, UJoint};
use jointproof::connector::{join, universal};
use jointproof::contact::coulomb;
use jointproof::formula;

pub(super) fn document() -> Document {
    Document {
        source: formula::Document::UJOINT,
        anchor: "ujoint",
        about: "A page of the same library as SLOT's: the connection type UJOINT, which is JOIN and UNIVERSAL together, and how \
                the loads at the centre of the cross cause friction in its four hinges.",
        found: "The page is titled UJOINT. It names the products Abaqus/Standard, Abaqus/Explicit and Abaqus/CAE, and refers to \
                *Connector Elements* and *Connector Element Library*.",
        sections: &["Description", "Friction", "Summary"],
        text: Some((8134, "2cd619fd7d0ccc2a53ca2df84f55ef3766d548a865b16d90d3d47453e8d7141f")),
        statements: [description(), loads(), decomposition(), friction(), contact_moments(), summary()]
            .into_iter()
            .flatten()
            .collect(),
    }
}

const NODES: &str = "conventions.md#node-a-and-node-b";

fn description() -> Vec<Statement> {
    vec![
        covered(
            "L3-s1",
            "It joins the positions of two nodes and constrains their rotations as a universal joint does.",
        )
        .formulas(&[&join::Constraint, &universal::Constraint, &ujoint::Constraint])
        .method(UJoint::new)
        .method(UJoint::constraint)
        .outputs(&["ujoint/G", "ujoint/GROT"]),
        covered("L3-s2", "It cannot be used in two-dimensional or axisymmetric analysis.").chapter("ujoint.md#ujoint"),
        outside("L5-16", "Cross references, and the products that support it.", "refers to other pages"),
        covered("L18", "A figure of it.").chapter("ujoint.md#ujoint"),
        covered("L20", "Its constraints and orientations are those of JOIN and UNIVERSAL together.")
            .formulas(&[&ujoint::Constraint])
            .law(&ujoint::Constraint, "its residuals and their derivatives")
            .test("ujoint::it_is_join_and_universal_assembled"),
        covered("L22-s1", "The reported forces depend strongly on order and position of the nodes.").chapter(NODES),
        covered("L22-s2", "The constraints are enforced at node b, and the reported forces and moments act on b.")
            .formulas(&[&universal::ConstraintMoment])
            .law(&join::Constraint, "the force on b is Jacobianᵀ")
            .method(UJoint::constraint_force)
            .chapter(NODES),
        covered("L22-s3", "The reported values are most meaningful with b at the centre of the device.").chapter(NODES),
        covered("L22-s4", "This is essential where friction follows from moments.").chapter(NODES),
        covered("L22-s5", "The enforcement does not depend on order and position of the nodes.")
            .law(&ujoint::Constraint, "exchanging the nodes and the arms")
            .test("virtual_work::the_order_of_the_nodes_changes_no_enforcement")
            .chapter(NODES),
    ]
}

fn loads() -> Vec<Statement> {
    vec![
        covered("L26-s1", "Friction makes moments about the two directions of the cross.")
            .formulas(&[&ujoint::Friction, &coulomb::ReturnMap])
            .outputs(&["ujoint/CSM1", "ujoint/CSM3"]),
        covered("L26-s2", "The joint has four hinges, at the ends of the cross.").chapter("ujoint.md#ujoint"),
        covered("L26-s3", "The moments in the hinges are computed similarly to those of HINGE.")
            .chapter("ujoint.md#on-a-hinge"),
        mended("L28", "Fr is the root of f1² + f2² + f3²; the root is lost in our copy.", "lost-roots")
            .formulas(&[&ujoint::Reaction])
            .law(&ujoint::Reaction, "it is the length of")
            .cases(&ujoint::Reaction, &["pythagoras"])
            .method(UJoint::reaction)
            .outputs(&["ujoint/FR"]),
        covered("L31", "Mtwist = |m2|.")
            .formulas(&[&ujoint::HingeTwist])
            .law(&ujoint::HingeTwist, "moments about the centre")
            .outputs(&["ujoint/MTWIST"])
            .test("scene_ujoint::the_twisting_moment_is_the_documented_one_and_the_hinge_has_its_share"),
        covered("L33-s1", "The directions of the cross are e1a and e3b.")
            .formulas(&[&universal::Constraint, &ujoint::CrossDirection])
            .chapter("universal.md#what-universal-holds"),
        covered("L33-s2", "Mtwist acts about e1a × e3b.")
            .formulas(&[&ujoint::CrossDirection, &universal::ConstraintMoment])
            .law(&ujoint::CrossDirection, "it is perpendicular")
            .law(&universal::ConstraintMoment, "on perpendicular shafts")
            .erratum("sense-of-the-cross-direction"),
        covered("L33-s3", "Fr and Mtwist act at the centre of the cross.").chapter("ujoint.md#at-the-centre"),
        covered("L35", "Mtwist bends each hinge with the moment αtwist Mtwist.")
            .formulas(&[&ujoint::HingeTwist, &ujoint::TwistFactors])
            .cases(&ujoint::HingeTwist, &["lambda-6.6"])
            .outputs(&["ujoint/MTWISTH", "ujoint/ALPHATWIST"]),
        mended(
            "L39",
            "It acts on each hinge with the force βtwist Mtwist over La; the quotient is lost in our copy.",
            "lost-quotients",
        )
        .formulas(&[&ujoint::HingeTwist])
        .law(&ujoint::HingeTwist, "moments about the centre")
        .outputs(&["ujoint/FTWIST", "ujoint/BETATWIST"]),
        covered("L41-s1", "La is the length from the centre to the ends of the cross.")
            .item::<Cross>()
            .chapter("ujoint.md#ujoint"),
        covered(
            "L41-s2",
            "The factors depend on La/Rp: rigid arms at 0, Timoshenko beams below 20, Euler–Bernoulli beams above.",
        )
        .formulas(&[&ujoint::TwistFactors])
        .law(&ujoint::TwistFactors, "the Timoshenko arm is met")
        .law(&ujoint::TwistFactors, "an Euler–Bernoulli arm")
        .chapter("arm-model.md#the-twisting-moment"),
        covered("L41-s3", "They are chosen from La and Rp alone.")
            .formulas(&[&ujoint::TwistFactors])
            .method(UJoint::with_friction),
        covered("L41-s4", "At La/Rp → 0 they tend to 0 and 1/4; for large La/Rp to 1/8 and 3/8.")
            .formulas(&[&ujoint::TwistFactors])
            .law(&ujoint::TwistFactors, "α grows with λ")
            .cases(&ujoint::TwistFactors, &["stubby", "long"]),
        covered("L43", "A figure of both factors.").chapter("arm-model.md#the-twisting-moment"),
    ]
}

fn decomposition() -> Vec<Statement> {
    vec![
        covered("L45", "The force has the parts Fr·e1a and Fr·e3b along the arms, and Fr·ecross.")
            .formulas(&[&ujoint::Decomposition])
            .law(&ujoint::Decomposition, "where the axes of the cross")
            .cases(&ujoint::Decomposition, &["straight"])
            .outputs(&["ujoint/FAXIAL1", "ujoint/FAXIAL3", "ujoint/FBEND"]),
        covered("L53", "As a vector the force is f1 e1a + f2 e2a + f3 e3a.")
            .formulas(&[&ujoint::Decomposition])
            .law(&join::Constraint, "the force on b is Jacobianᵀ")
            .method(UJoint::constraint_force)
            .outputs(&["ujoint/RF", "join/RF"]),
        covered("L55-s1", "Friction is that of four hinges together.")
            .formulas(&[&ujoint::ContactMoments, &ujoint::NormalMoments])
            .chapter("ujoint.md#friction"),
        covered(
            "L55-s2",
            "Only rotations about the local 1- and 3-directions are possible; friction is CSM1 and CSM3.",
        )
        .formulas(&[&ujoint::Friction, &coulomb::ReturnMap])
        .law(&universal::ConstraintMoment, "it does no work on turns")
        .outputs(&["ujoint/CSM1", "ujoint/CSM3"]),
        covered("L55-s3", "The subscripts 1 and 3 name those directions.").formulas(&[&ujoint::Friction]),
    ]
}

fn friction() -> Vec<Statement> {
    vec![
        covered("L57", "Φ1 = P1 − μMN1 and Φ3 = P3 − μMN3, at most 0.")
            .formulas(&[&ujoint::Friction])
            .law(&ujoint::Friction, "at the friction moments μ M_N")
            .method(UJoint::friction)
            .outputs(&["ujoint/PHI1", "ujoint/PHI3"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .erratum("lost-sign"),
        covered(
            "L60-s1",
            "P are moments of the tangential tractions, MN of the normal ones, μ is the friction coefficient.",
        )
        .formulas(&[&ujoint::Friction])
        .outputs(&["ujoint/MN1", "ujoint/MN3"]),
        covered("L60-s2", "A direction sticks if its Φ < 0, and slips if Φ = 0, with the moment μMN.")
            .formulas(&[&coulomb::ReturnMap])
            .outputs(&["ujoint/CSM1", "ujoint/CSM3", "ujoint/SLIPR1", "ujoint/SLIPR3"])
            .test("scene_friction::random_histories_agree_with_themselves")
            .test("scene_friction::golden_scenes_agree_with_themselves")
            .test("scene_ujoint::friction_of_the_drive_shaft_stays_within_its_limit_and_turns_with_the_swing"),
        covered("L62", "MN = 2|MC| + |MCint|, in either direction.")
            .formulas(&[&ujoint::NormalMoments])
            .law(&ujoint::NormalMoments, "reversing any moment")
            .cases(&ujoint::NormalMoments, &["press-fit", "no-press-fit"])
            .outputs(&["ujoint/MN1", "ujoint/MN3"])
            .erratum("two-normal-forces"),
        covered("L67", "The 2 counts the two hinges of a direction.")
            .formulas(&[&ujoint::NormalMoments])
            .chapter("ujoint.md#friction"),
    ]
}

fn contact_moments() -> Vec<Statement> {
    vec![
        covered("L69", "MC1 and MC3 are sums of contributions.")
            .formulas(&[&ujoint::ContactMoments])
            .law(&ujoint::ContactMoments, "the separate formulas")
            .outputs(&["ujoint/MC1", "ujoint/MC3"]),
        mended(
            "L71-s1",
            "The axial forces contribute αaxial Faxial Ra; αaxial is not defined.",
            "undefined-axial-factors",
        )
        .formulas(&[&ujoint::HingeAxial, &ujoint::AxialFactors])
        .law(&ujoint::AxialFactors, "the four hinges carry")
        .outputs(&["ujoint/ALPHAAXIAL", "ujoint/FHINGE1", "ujoint/FHINGE3"])
        .chapter("arm-model.md#a-force-along-an-arm")
        .erratum("lost-bars"),
        covered("L71-s2", "Ra is the effective friction arm of the axial force.")
            .item::<Cross>()
            .chapter("ujoint.md#ujoint"),
        covered("L71-s3", "If Ra is 0, the axial force is omitted.")
            .cases(&ujoint::ContactMoments, &["no-axial-arm"])
            .test("ujoint::a_parameter_of_zero_drops_its_term_and_a_small_one_does_not"),
        covered("L73", "Normal forces contribute Fn Rp, Fn being a sum.")
            .formulas(&[&ujoint::ContactMoments])
            .law(&ujoint::ContactMoments, "the separate formulas"),
        mended(
            "L75",
            "Ftotal is the root of the squares of Fbend/4, the force of twisting and that of the other axis.",
            "parallel-forces",
        )
        .formulas(&[&ujoint::HingeTransverse])
        .law(&ujoint::HingeTransverse, "exchanging the axial forces")
        .outputs(&["ujoint/FTOTAL1", "ujoint/FTOTAL3"])
        .erratum("lost-roots"),
        mended("L80-s1", "A hinge takes Fbend/4; the quotient is lost in our copy.", "lost-quotients")
            .formulas(&[&ujoint::HingeTransverse])
            .cases(&ujoint::HingeTransverse, &["bending-alone"]),
        mended("L80-s2", "It takes βaxial Faxial of the other axis; βaxial is not defined.", "undefined-axial-factors")
            .formulas(&[&ujoint::HingeAxial, &ujoint::AxialFactors])
            .law(&ujoint::HingeAxial, "two hinges along the force")
            .outputs(&["ujoint/BETAAXIAL", "ujoint/FTRANSV1", "ujoint/FTRANSV3"]),
        mended("L84", "Mtotal is the root of Mbend² + Mtwist²; Ftotalbend is 2 Mtotal over Ls.", "lost-roots")
            .formulas(&[&ujoint::HingeBending])
            .law(&ujoint::HingeBending, "the contact force, half of it")
            .cases(&ujoint::HingeBending, &["pythagoras"])
            .outputs(&["ujoint/MTOTAL", "ujoint/FTOTALBEND"])
            .erratum("lost-quotients")
            .erratum("missing-end-moment"),
        mended("L87-s1", "Mbend = Fbend La/8; the quotient is lost in our copy.", "lost-quotients")
            .formulas(&[&ujoint::HingeBending])
            .cases(&ujoint::HingeBending, &["force-alone"])
            .outputs(&["ujoint/MBEND"])
            .chapter("ujoint.md#on-a-hinge"),
        covered("L87-s2", "Ls is the overlap of pin and sleeve; if it is 0, bending is omitted.")
            .item::<Cross>()
            .cases(&ujoint::HingeBending, &["no-sleeve"])
            .cases(&ujoint::ContactMoments, &["no-sleeve"]),
        mended("L91", "MC1 in one equation.", "lost-bars")
            .formulas(&[&ujoint::ContactMoments])
            .law(&ujoint::ContactMoments, "reversing all loads")
            .law(&ujoint::ContactMoments, "the twisting moment alone")
            .method(UJoint::contact_moments)
            .outputs(&["ujoint/MC1"]),
        mended("L92", "MC3 in one equation.", "lost-bars")
            .formulas(&[&ujoint::ContactMoments])
            .law(&ujoint::ContactMoments, "exchanging the axes")
            .outputs(&["ujoint/MC3"]),
        covered("L94", "P1 = |m1| and P3 = |m3|.").formulas(&[&ujoint::Friction]).outputs(&["ujoint/P1", "ujoint/P3"]),
    ]
}

fn summary() -> Vec<Statement> {
    vec![
        covered("L99", "UJOINT is an assembled connection.").chapter("ujoint.md#ujoint"),
        covered("L100", "Constraints: JOIN and UNIVERSAL.")
            .formulas(&[&ujoint::Constraint])
            .law(&ujoint::Constraint, "its residuals and their derivatives"),
        covered("L101", "Constraint forces and moment reported: f1, f2, f3, m2.")
            .formulas(&[&join::Constraint, &universal::ConstraintMoment])
            .method(UJoint::constraint_force)
            .method(UJoint::constraint_moment)
            .outputs(&["ujoint/RF", "ujoint/RM"]),
        covered("L102", "Available components: ur1, ur3.")
            .formulas(&[&universal::Angles, &universal::RelativeMotion])
            .law(&universal::Angles, "spinning b about e1a or e3b")
            .method(UJoint::relative_motion)
            .method(UJoint::relative_motion_from)
            .outputs(&["ujoint/UR1", "ujoint/UR3", "universal/UR1", "universal/UR3"])
            .test("scene_ujoint::turns_are_followed_from_state_to_state"),
        covered("L103", "Kinetic moments reported: m1, m3.")
            .formulas(&[&universal::KineticMoment])
            .law(&universal::KineticMoment, "it works with m1")
            .method(UJoint::kinetic_moment)
            .outputs(&["ujoint/KM", "universal/KM"])
            .test("scene_friction::a_load_and_friction_make_the_kinetic_force_together"),
        covered("L104", "Orientation at a: required.")
            .method(UJoint::new)
            .test("scene_faults::a_required_triad_is_required_and_the_second_is_the_first"),
        covered("L105", "Orientation at b: optional.")
            .method(UJoint::new)
            .test("scene_faults::a_required_triad_is_required_and_the_second_is_the_first")
            .chapter("scenes.md#the-file"),
        mended("L106", "Stops bound γ between θ1min and θ1max, and between θ3min and θ3max.", "one-angle-twice")
            .formulas(&[&ujoint::Stop])
            .cases(&ujoint::Stop, &["between", "at-the-stops"])
            .method(UJoint::with_stops)
            .method(UJoint::gaps_from)
            .outputs(&["ujoint/GAP1MIN", "ujoint/GAP1MAX", "ujoint/GAP3MIN", "ujoint/GAP3MAX"])
            .test("scene_ujoint::turns_are_followed_from_state_to_state")
            .test("scene_parts::a_translator_and_a_joint_may_have_one_stop"),
        covered("L108", "Constitutive reference angles: θ1ref, θ3ref.")
            .formulas(&[&universal::RelativeMotion])
            .method(UJoint::with_reference_angles)
            .outputs(&["ujoint/UR1MAT", "ujoint/UR3MAT"]),
        covered("L109", "Friction parameters: Rp and La are required; Ra, Ls, MC1int and MC3int optional.")
            .item::<Cross>()
            .method(UJoint::with_friction)
            .test("ujoint::bad_parameters_are_named"),
        covered("L110", "Contact moments reported: MC1, MC3.")
            .formulas(&[&ujoint::ContactMoments])
            .outputs(&["ujoint/MC1", "ujoint/MC3"]),
    ]
}
