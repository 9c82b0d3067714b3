//! The sliding constraint, statement by statement: one paragraph that has lost its symbols. `s` numbers its
//! statements, `e` its equations.

use crate::statements::document::Document;
use crate::statements::statement::{Statement, covered, mended, outside};
use jointproof::connector::slider::{self, Pivots, Slider, Slider2d, documented};
use jointproof::formula;

pub(super) fn document() -> Document {
    Document {
        source: formula::Document::SLIDER,
        anchor: "slider",
        about: "The theory of a multi-point constraint that keeps a node on the straight line through two others: the condition, \
                its elimination, its derivative, and the case of two dimensions. Our copy is one paragraph without \
                headings, in which **all symbols and equations are missing**; only the words between them remain, and [the \
                chapter](slider.md) derives the equations from them.",
        found: "The text calls its subject *the sliding constraint*, an MPC. It names the products Abaqus/Standard and \
                Abaqus/Explicit, and gives no title.",
        sections: &[],
        text: Some((2168, "5484cd2e520cbf705f2c4031f072ede5105a0ad0da3dd3ccc27eff09bc47562d")),
        statements: [line(), constraint(), derivative(), plane()].into_iter().flatten().collect(),
    }
}

fn line() -> Vec<Statement> {
    vec![
        outside("s1", "It has a variety of uses.", "a general remark"),
        covered("s2", "With other constraints it joins a mesh of shells to a mesh of solids.")
            .chapter("slider.md#slider")
            .chapter("scene-interface.md#example-from-shell-to-solid"),
        covered("s3", "Straight lines through the thickness of a shell stay straight.")
            .law(&slider::Eliminate, "m is on the line")
            .chapter("slider.md#slider"),
        covered("s4", "On solids it is a kinematic approximation of compatibility with the shell.")
            .chapter("slider.md#slider"),
        covered("s5", "Two points define the line; node m must lie on it.")
            .formulas(&[&slider::Constraint])
            .method(Slider::new)
            .method(Slider::constraint)
            .law(&slider::Constraint, "it vanishes on the line"),
        covered("e1", "The direction n of the line, and its length l.")
            .formulas(&[&slider::Line])
            .law(&slider::Line, "l n leads from node 1")
            .law(&slider::Line, "n has length 1")
            .method(Slider::line)
            .outputs(&["slider@3d/N", "slider@3d/L"]),
        covered("e2", "A unit normal t1 from a global base vector, or from another one if that fails.")
            .formulas(&[&slider::Basis])
            .law(&slider::Basis, "t1 is a unit vector")
            .cases(&slider::Basis, &["i", "minus-i"])
            .method(Slider::basis)
            .chapter("slider.md#two-directions-across-it"),
        covered("e3", "An orthogonal normal t2.").formulas(&[&slider::Basis]).law(&slider::Basis, "t1, t2 and n"),
        covered("s6", "Together they are an orthonormal base.")
            .formulas(&[&slider::Basis])
            .law(&slider::Basis, "t1, t2 and n"),
    ]
}

fn constraint() -> Vec<Statement> {
    vec![
        covered("e4", "The line from node 1 to node m is perpendicular to t1 and to t2.")
            .formulas(&[&slider::Constraint])
            .law(&slider::Constraint, "g1² + g2²")
            .outputs(&["slider@3d/G1", "slider@3d/G2"]),
        mended("e5", "i is the axis of t1's largest projection; the comparisons are lost.", "ties-of-the-pivot-rule")
            .item::<Pivots>()
            .cases(&slider::Eliminate, &["second-tie"])
            .test("slider_pivots::the_pivots_are_those_of_t1_and_t2"),
        mended("e6", "j is chosen in the same way; the comparisons are lost.", "ties-of-the-pivot-rule")
            .item::<Pivots>()
            .cases(&slider::Eliminate, &["extremal"])
            .test("slider_pivots::the_pivots_are_those_of_t1_and_t2"),
        covered("e7", "The conditions in components of node m.").chapter("slider.md#eliminating-two-coordinates"),
        covered("e8", "Two coordinates of m are eliminated; the numbering avoids a division by 0.")
            .formulas(&[&slider::Eliminate])
            .law(&slider::Eliminate, "the documented route")
            .method(documented::eliminate::<f64>)
            .method(Slider::eliminate)
            .outputs(&["slider@3d/AXES", "slider@3d/XMI", "slider@3d/XMJ"])
            .test("slider_pivots::the_kept_axis_is_never_nearly_across_the_line"),
    ]
}

fn derivative() -> Vec<Statement> {
    vec![
        covered("e9", "The derivatives of the conditions.")
            .formulas(&[&slider::Constraint])
            .method(Slider::constraint_jacobian)
            .chapter("slider.md#variations"),
        covered("e10", "They contain dt1 and dt2.")
            .formulas(&[&slider::BasisVariation])
            .law(&slider::BasisVariation, "it is the derivative of the directions"),
        mended("e11", "They reduce to a shorter form.", "on-the-line-only")
            .formulas(&[&slider::IncrementalConstraint])
            .law(&slider::IncrementalConstraint, "on the line it is the variation")
            .test("slider::off_the_line_the_documented_increments_are_others"),
        covered("e12", "dn follows from the definition of n.")
            .formulas(&[&slider::DirectionVariation])
            .law(&slider::DirectionVariation, "it is the derivative of the line")
            .cases(&slider::DirectionVariation, &["along-x"]),
        covered("e13", "So do the products with dn.")
            .law(&slider::BasisVariation, "the directions remain normal to the line")
            .chapter("slider.md#variations"),
        covered("e14", "The incremental conditions.")
            .formulas(&[&slider::IncrementalConstraint])
            .cases(&slider::IncrementalConstraint, &["half-way", "translation"])
            .outputs(&["slider@3d/R1", "slider@3d/R2"]),
        covered("e15", "With ξ, written out in the same ordering.")
            .formulas(&[&slider::IncrementalConstraint])
            .law(&slider::IncrementalConstraint, "a translation of all three")
            .chapter("slider.md#variations"),
        covered("e16", "Solved for the two eliminated increments.")
            .formulas(&[&slider::Increment])
            .law(&slider::Increment, "on the line, the documented route")
            .law(&slider::Increment, "the increments satisfy")
            .method(documented::increment::<f64>)
            .method(Slider::coefficients)
            .outputs(&["slider@3d/DXMI", "slider@3d/DXMJ"]),
    ]
}

fn plane() -> Vec<Statement> {
    vec![
        covered("s7", "In two dimensions the line is in the x–y or the r–z plane.")
            .outputs(&["slider@2d/G", "slider@axisymmetric/G"])
            .formulas(&[&slider::Constraint2d])
            .method(Slider2d::new),
        mended("s8", "There the second condition is satisfied automatically.", "condition-that-holds-by-itself")
            .law(&slider::Constraint2d, "in the plane z = 0 of space")
            .chapter("slider.md#in-the-plane"),
        covered("e17", "The condition that remains.")
            .formulas(&[&slider::Constraint2d])
            .cases(&slider::Constraint2d, &["left", "right"])
            .method(Slider2d::constraint)
            .outputs(&["slider@2d/G"]),
        covered("e18", "Its derivative.")
            .formulas(&[&slider::IncrementalConstraint2d, &slider::Increment2d, &slider::Eliminate2d])
            .law(&slider::IncrementalConstraint2d, "on the line it is the variation")
            .law(&slider::IncrementalConstraint2d, "the increments that the elimination gives")
            .cases(&slider::IncrementalConstraint2d, &["half-way", "lagging"])
            .method(Slider2d::incremental_constraint)
            .method(Slider2d::coefficients)
            .outputs(&["slider@2d/R", "slider@2d/XMI", "slider@2d/DXMI", "slider@axisymmetric/R"])
            .test("scene_parts::the_residual_in_the_plane_is_that_of_space"),
    ]
}
