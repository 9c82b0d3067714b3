//! Slide lines and the elements on them, statement by statement.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, mended, outside};
use jointproof::contact::isl::{Contact, ElementSet, Interaction, IslElement, TorquePrint};
use jointproof::contact::slide_line::{self, Interpolation, Nodes, PlacedLine, SlideLine};
use jointproof::contact::{coulomb, interaction};
use jointproof::formula;

pub(super) fn document() -> Document {
    Document {
        source: formula::Document::SLIDE_LINE,
        anchor: "slide-line",
        about: "A run of pages of a manual: the end of its Section 40.4.1, *Slide line contact elements*, from the local basis on, \
                and Section 40.4.2, *Axisymmetric slide line element library*. The part before the local basis is missing \
                in our copy. The defaults of EXTENSION ZONE (0.1) and SMOOTH (0) are those of the public keyword page of \\*SLIDE LINE, \
                which this section refers to.",
        found: "Look for Sections 40.4.1 and 40.4.2, Figures 40.4.1–3 to 40.4.1–5. The pages name the product Abaqus/Standard.",
        sections: &[
            "Defining the local basis system",
            "The master-slave concept for slide lines and slide line elements",
            "Defining the slide line (master surface)",
            "Defining a linear slide line",
            "Defining a parabolic slide line",
            "Generating the slide line nodes",
            "Smoothing the slide line",
            "Defining slide line elements (slave surface)",
            "Associating the slide line elements with a slide line",
            "Defining the slide line element’s section properties",
            "Defining nondefault mechanical surface interactions with slide line elements",
            "Obtaining the “maximum torque” that can be transmitted across axisymmetric slide lines",
            "40.4.2 AXISYMMETRIC SLIDE LINE ELEMENT LIBRARY",
            "Overview",
            "Element types",
            "Nodal coordinates required",
            "Element property definition",
            "Element-based loading",
            "Element output",
            "Node ordering and integration point numbering",
        ],
        text: Some((9555, "937453e8b0f6469deb347e891b3df7eb420cec308cb14f4574a9806dc42f7d08")),
        statements: [basis(), line(), elements(), interactions(), torque(), library()].into_iter().flatten().collect(),
    }
}

fn basis() -> Vec<Statement> {
    vec![
        covered("L2-s1", "The sequence of the nodes defines the tangent t.")
            .formulas(&[&slide_line::LocalBasis])
            .law(&slide_line::LocalBasis, "reversing the sequence")
            .chapter("slide-line.md#tangent-and-normal"),
        covered("L2-s2", "Normal and tangent span the contact plane.").chapter("slide-line.md#tangent-and-normal"),
        covered("L2-s3", "The normal is n = s × t, with s = (0, 0, 1) normal to the contact plane.")
            .formulas(&[&slide_line::LocalBasis])
            .law(&slide_line::LocalBasis, "t and n are orthonormal")
            .cases(&slide_line::LocalBasis, &["along-r", "along-z"]),
        covered("L3-s1", "The nodes i, j, k, … are given in order.")
            .item::<SlideLine>()
            .chapter("slide-line-elements.md#the-line"),
        covered("L3-s2", "The nodes I, J, K, … are those of the elements on the line.").item::<ElementSet>(),
        covered("L3-s3", "Giving s, the normal of the contact plane, defines the line's normal.")
            .outputs(&["isl21a/N", "isl22a/N"])
            .chapter("slide-line.md#tangent-and-normal"),
        covered("L5-15", "A figure of line, elements and basis.").chapter("slide-line.md#smoothed-corners"),
        covered("L16-s1", "t is the first local tangent t1.")
            .outputs(&["isl21a/T1", "isl22a/T1"])
            .chapter("slide-line.md#tangent-and-normal"),
        covered("L16-s2", "The second local tangent t2 is opposite to s.").chapter("slide-line.md#tangent-and-normal"),
        covered("L18-s1", "A strict master–slave concept enforces the contact.")
            .chapter("slide-line-elements.md#master-and-slave"),
        covered("L18-s2", "The elements are the slave, the line is the master.")
            .item::<Contact>()
            .chapter("slide-line-elements.md#master-and-slave"),
        covered("L18-s3", "Nodes of the slave must not penetrate the master.")
            .formulas(&[&slide_line::ClosestLinear, &slide_line::ClosestParabolic])
            .outputs(&["isl21a/E11", "isl22a/E11"])
            .test("slide_line::a_point_on_the_wrong_side_penetrates")
            .chapter("slide-line-elements.md#what-is-the-sources-and-what-is-ours"),
        covered(
            "L19",
            "The master should be the stiffer body, or the one with the coarser mesh; else the choice is free.",
        )
        .chapter("slide-line-elements.md#master-and-slave"),
    ]
}

fn line() -> Vec<Statement> {
    vec![
        covered("L22-s1", "The nodes of a line are listed or generated.")
            .item::<SlideLine>()
            .test("slide_line::generated_nodes_are_the_listed_ones"),
        covered("L22-s2", "Their sequence must make a continuous line.")
            .item::<SlideLine>()
            .method(SlideLine::extended)
            .test("slide_line::an_open_line_is_extended_by_a_part_of_its_end_segments")
            .test("slide_line::bad_lines_are_named"),
        covered("L22-s3", "It defines the tangent.").formulas(&[&slide_line::LocalBasis]),
        covered("L22-s4", "Segments are linear or parabolic, depending on the order of the elements.")
            .item::<Interpolation>()
            .formulas(&[&slide_line::LinearPoint, &slide_line::ParabolicPoint])
            .chapter("slide-line.md#segments"),
        covered("L22-s5", "Smoothing may improve convergence.").chapter("slide-line.md#smoothed-corners"),
        covered("L24", "First-order elements have a line of linear segments.")
            .formulas(&[&slide_line::LinearPoint])
            .cases(&slide_line::LinearPoint, &["first-node", "last-node"])
            .item::<Interpolation>(),
        covered("L25", "Keyword: SLIDE LINE, TYPE=LINEAR.").chapter("scenes.md#slide-lines"),
        outside("L26-30", "A figure of a linear line.", "repeats the text"),
        covered("L32-s1", "Second-order elements have a line of second-order segments.")
            .formulas(&[&slide_line::ParabolicPoint])
            .cases(&slide_line::ParabolicPoint, &["first-node", "midside-node", "last-node"]),
        covered("L32-s2", "Its number of nodes should be odd.")
            .item::<SlideLine>()
            .test("slide_line::bad_lines_are_named")
            .chapter("slide-line-elements.md#the-line"),
        covered("L33", "Keyword: SLIDE LINE, TYPE=PARABOLIC.").chapter("scenes.md#slide-lines"),
        covered("L40", "Nodes can be generated from a first, a last and an increment.")
            .item::<SlideLine>()
            .test("slide_line::generated_nodes_are_the_listed_ones")
            .test("scene_parts::generated_nodes_are_the_listed_ones")
            .chapter("scenes.md#slide-lines"),
        covered("L41", "Keyword: SLIDE LINE, GENERATE.").item::<SlideLine>().chapter("scenes.md#slide-lines"),
        covered("L43-s1", "Smoothing makes the tangent vary smoothly between segments.")
            .formulas(&[
                &slide_line::SmoothedLinearPoint,
                &slide_line::SmoothedParabolicPoint,
                &slide_line::ClosestSmoothedLinear,
                &slide_line::ClosestSmoothedParabolic,
            ])
            .law(&slide_line::SmoothedLinearPoint, "it leaves the segments")
            .method(SlideLine::smoothed)
            .chapter("slide-line.md#smoothed-corners"),
        outside("L43-s2", "Details are in Section 38.1.1.", "that section is not among the documents"),
    ]
}

fn elements() -> Vec<Statement> {
    vec![
        outside(
            "L45-s1",
            "Many models can use surfaces instead, see Chapter 36.",
            "that chapter is not among the documents",
        ),
        covered(
            "L45-s2",
            "These elements are for special uses, as surfaces of substructures, or CAXA and SAXA elements.",
        )
        .chapter("slide-line-elements.md#which-elements"),
        covered("L46-s1", "The elements define the slave surface.")
            .item::<ElementSet>()
            .chapter("slide-line-elements.md#master-and-slave"),
        mended(
            "L46-s2",
            "A node's area follows from the current length and a constant “width”, which depends on the underlying elements.",
            "width-of-an-element",
        )
        .formulas(&[&slide_line::ContactAreaLinear, &slide_line::ContactAreaParabolic])
        .law(&slide_line::ContactAreaLinear, "the areas add up")
        .method(IslElement::areas::<f64>)
        .outputs(&["isl21a/AREA", "isl22a/AREA"])
        .test("scene_parts::areas_and_bases_are_those_of_element_and_line")
        .chapter("slide-line.md#contact-area"),
        covered("L48", "A line is associated with a set of elements.")
            .item::<Contact>()
            .chapter("scenes.md#slide-lines"),
        covered("L51", "A set of elements has section properties.").chapter("slide-line-elements.md#which-elements"),
        covered("L52", "Axisymmetric ones have no section data.").chapter("slide-line-elements.md#which-elements"),
        covered("L53", "Keyword: INTERFACE.").chapter("slide-line-elements.md#which-elements"),
    ]
}

fn interactions() -> Vec<Statement> {
    vec![
        covered("L55", "By default contact is hard and without friction.")
            .item::<Interaction>()
            .test("isl::hard_contact_presses_only_when_closed")
            .chapter("interaction.md#interaction-laws"),
        covered("L56", "Friction is available.")
            .formulas(&[&coulomb::ReturnMap])
            .method(Interaction::with_friction)
            .outputs(&["isl21a/S12"])
            .test("isl::friction_sticks_slips_and_returns"),
        covered("L57-s1", "So is modified hard contact.").chapter("interaction.md#modified-hard-contact"),
        covered("L57-s2", "So is softened contact.")
            .formulas(&[&interaction::PressureLinear, &interaction::PressureExponential])
            .method(Interaction::linear)
            .method(Interaction::exponential)
            .chapter("interaction.md#what-is-the-sources-and-what-is-ours"),
        covered("L57-s3", "So is viscous damping.")
            .formulas(&[&interaction::Damping])
            .method(Interaction::with_damping),
    ]
}

fn torque() -> Vec<Statement> {
    vec![
        covered(
            "L59-s1",
            "With axisymmetric elements, CAX and CGAX, the largest torque across a line can be calculated.",
        )
        .formulas(&[&slide_line::TorqueLinear, &slide_line::TorqueParabolic])
        .method(Contact::torque::<f64>)
        .outputs(&["isl21a/T", "isl22a/T"])
        .chapter("threaded-connector.md#torque-of-a-threaded-connector"),
        covered("L59-s2", "It is of interest for threaded connectors.")
            .chapter("threaded-connector.md#torque-of-a-threaded-connector"),
        covered("L61", "T = ∬ r² p ds dθ.")
            .formulas(&[&slide_line::TorqueLinear, &slide_line::TorqueParabolic])
            .law(&slide_line::TorqueLinear, "cutting the element in two")
            .cases(&slide_line::TorqueLinear, &["cylinder", "disc"])
            .test("isl::the_torque_is_that_of_the_pressures"),
        covered("L63", "p is the pressure, r the radius, s the current length; friction is taken as unity.")
            .formulas(&[&slide_line::TorqueLinear])
            .chapter("slide-line.md#torque"),
        covered("L64-s1", "The torque can be printed.")
            .item::<TorquePrint>()
            .test("isl::the_table_prints_as_often_as_asked"),
        covered("L64-s2", "It is given for every slide line.")
            .method(TorquePrint::rows)
            .outputs(&["isl21a/T"])
            .chapter("scenes.md#slide-lines"),
        covered("L64-s3", "A frequency limits how often.")
            .method(TorquePrint::every)
            .method(TorquePrint::is_due)
            .test("scene_parts::the_torque_is_a_result_as_often_as_asked")
            .chapter("scenes.md#slide-lines"),
        covered("L64-s4", "The frequency is 1 if not given.")
            .item::<TorquePrint>()
            .test("scene_parts::the_torque_is_a_result_as_often_as_asked"),
        outside("L65", "For surfaces, CTRQ is similar.", "contact of surfaces is not among the documents"),
        covered("L66", "Keyword: TORQUE PRINT, FREQUENCY=n.").item::<TorquePrint>(),
        outside("L67-74", "References and overview of the element library.", "refers to other sections"),
    ]
}

fn library() -> Vec<Statement> {
    vec![
        covered("L76", "ISL21A has two nodes, for first-order axisymmetric elements.")
            .method(IslElement::isl21a)
            .outputs(&["isl21a/E11"])
            .chapter("scenes.md#slide-lines"),
        covered("L77", "ISL22A has three nodes, for second-order axisymmetric elements.")
            .method(IslElement::isl22a)
            .outputs(&["isl22a/E11"]),
        covered("L79", "Degrees of freedom 1 and 2 at the nodes.").item::<Nodes>().chapter("scenes.md#slide-lines"),
        covered("L81", "Two additional variables at each node, for the contact stresses.")
            .chapter("slide-line-elements.md#what-is-the-sources-and-what-is-ours"),
        covered("L83", "The coordinates are r and z.").item::<Nodes>().test("slide_line::bad_nodes_are_named"),
        covered("L85", "The property definition: SLIDE LINE and INTERFACE.")
            .chapter("slide-line-elements.md#which-elements"),
        outside("L87", "There is no element loading.", "nothing to implement"),
        covered("L90", "S11: the pressure between node and line.")
            .formulas(&[&interaction::PressureLinear, &interaction::PressureExponential, &interaction::Damping])
            .method(Interaction::pressure::<f64>)
            .outputs(&["isl21a/S11", "isl22a/S11"]),
        covered("L91", "S12: the shear stress between node and line.")
            .formulas(&[&coulomb::ReturnMap])
            .method(Interaction::shear::<f64>)
            .outputs(&["isl21a/S12", "isl22a/S12"]),
        covered("L93", "E11: the separation between node and line.")
            .formulas(&[
                &slide_line::ClosestLinear,
                &slide_line::ClosestParabolic,
                &slide_line::ClosestSmoothedLinear,
                &slide_line::ClosestSmoothedParabolic,
            ])
            .law(&slide_line::ClosestParabolic, "xs − X is perpendicular")
            .method(PlacedLine::<f64>::closest)
            .outputs(&["isl21a/E11", "isl22a/E11"]),
        covered("L94", "E12: the accumulated tangential displacement between node and line.")
            .formulas(&[&slide_line::SlipIncrementLinear, &slide_line::SlipIncrementParabolic])
            .law(&slide_line::SlipIncrementLinear, "a common displacement")
            .test("isl::the_slip_around_a_sharp_corner_does_not_depend_on_the_increments")
            .outputs(&["isl21a/E12", "isl22a/E12"])
            .chapter("slide-line-elements.md#slip"),
        covered("L95-124", "Figures: the order of the nodes; integration points are at the nodes.")
            .method(IslElement::areas::<f64>)
            .test("isl::areas_add_up_at_shared_nodes")
            .chapter("slide-line.md#contact-area"),
        outside("L125-127", "The next section, rigid surfaces.", "not among the documents"),
    ]
}
