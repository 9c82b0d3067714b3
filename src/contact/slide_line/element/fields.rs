//! What ISL21A and ISL22A compute from as elements.

use crate::contact::interaction::{ExponentialContact, LinearContact, PressureExponential, PressureLinear};
use crate::fields;
use crate::formula::quantity::{CLEARANCE, Domain, MU, PRESSURE_AT_TOUCH, Quantity, STIFFNESS, Shape, Unit};
use crate::formula::{Component, Field, Fields, Formula};
use crate::number::scalar::Scalar;
use nalgebra::{Vector2, Vector3};
use std::fmt::Debug;

/// Position, translation and force of nodes, each in the plane (r, z).
macro_rules! quantities {
    ($($x:ident $u:ident $f:ident: $index:literal, $which:literal;)*) => {$(
        #[doc = concat!("Position of ", $which, ".")]
        pub const $x: Quantity = Quantity::new(
            concat!(r"\mathbf{x}_{", $index, "}"), Shape::Vec2, Unit::L, Domain::Meridian,
            concat!("position of ", $which, ", in the plane (r, z)"),
        );
        #[doc = concat!("Translation of ", $which, ".")]
        pub const $u: Quantity = Quantity::new(
            concat!(r"\mathbf{u}_{", $index, "}"), Shape::Vec2, Unit::L, Domain::Real,
            concat!("translation of ", $which, ", in the plane (r, z)"),
        );
        #[doc = concat!("Force on ", $which, ".")]
        pub const $f: Quantity = Quantity::new(
            concat!(r"\mathbf{f}_{", $index, "}"), Shape::Vec2, Unit::F, Domain::Real,
            concat!("force of the contact on ", $which, ", in the plane (r, z), around the whole circumference"),
        );
    )*};
}

quantities! {
    XS1 US1 FS1: "s1", "the first slave node";
    XS2 US2 FS2: "s2", "the second slave node";
    XS3 US3 FS3: "s3", "the third slave node";
    X11 U11 F11: "11", "the first node of the segment under the first slave node";
    X12 U12 F12: "12", "the second node of the segment under the first slave node";
    X13 U13 F13: "13", "the third node of the segment under the first slave node";
    X21 U21 F21: "21", "the first node of the segment under the second slave node";
    X22 U22 F22: "22", "the second node of the segment under the second slave node";
    X23 U23 F23: "23", "the third node of the segment under the second slave node";
    X31 U31 F31: "31", "the first node of the segment under the third slave node";
    X32 U32 F32: "32", "the second node of the segment under the third slave node";
    X33 U33 F33: "33", "the third node of the segment under the third slave node";
}

/// The nodes of an element: its slave nodes, then those of the segment under each of them.
macro_rules! nodes {
    ($(#[$doc:meta])* $name:ident, $number:literal:
        $($x:ident $position:ident, $u:ident $translation:ident, $f:ident $force:ident;)*
    ) => {
        fields! { $(#[$doc])* pub struct $name<T> { $($x: Vector2<T> = $position),* } }

        impl<T: Component> $name<T> {
            pub(super) const UNKNOWNS: &'static [Field] = &[$(Field::new(stringify!($u), &$translation)),*];
            pub(super) const FORCES: &'static [Field] = &[$(Field::new(stringify!($f), &$force)),*];

            /// Combines the slave nodes with the nodes of the segment under each of them.
            pub fn new(slaves: [Vector2<T>; $number], segments: [[Vector2<T>; $number]; $number]) -> Self {
                let mut points = slaves.iter().chain(segments.as_flattened());
                let mut next = || *points.next().expect("there is a point for every node");
                Self { $($x: next()),* }
            }
        }
    };
}

nodes! {
    /// The positions of the nodes of ISL21A, and of the straight segments under them.
    Isl21aNodes, 2:
    xs1 XS1, us1 US1, fs1 FS1;
    xs2 XS2, us2 US2, fs2 FS2;
    x11 X11, u11 U11, f11 F11;
    x12 X12, u12 U12, f12 F12;
    x21 X21, u21 U21, f21 F21;
    x22 X22, u22 U22, f22 F22;
}
nodes! {
    /// The positions of the nodes of ISL22A, and of the parabolic segments under them; the second is the midside node.
    Isl22aNodes, 3:
    xs1 XS1, us1 US1, fs1 FS1;
    xs2 XS2, us2 US2, fs2 FS2;
    xs3 XS3, us3 US3, fs3 FS3;
    x11 X11, u11 U11, f11 F11;
    x12 X12, u12 U12, f12 F12;
    x13 X13, u13 U13, f13 F13;
    x21 X21, u21 U21, f21 F21;
    x22 X22, u22 U22, f22 F22;
    x23 X23, u23 U23, f23 F23;
    x31 X31, u31 U31, f31 F31;
    x32 X32, u32 U32, f32 F32;
    x33 X33, u33 U33, f33 F33;
}

const PRESSURE: Unit = Unit::new(-2, 1, 0);

const fn places(shape: Shape) -> Quantity {
    Quantity::new("g", shape, Unit::ONE, Domain::Real, "position of each slave node along its segment, from -1 to 1")
}
const fn shears(shape: Shape) -> Quantity {
    let meaning = "shear stress at each slave node, positive where it resists positive slip";
    Quantity::new("S_{12}", shape, PRESSURE, Domain::Real, meaning)
}

/// Position of both slave nodes along their segments.
pub const G_OF_TWO: Quantity = places(Shape::Vec2);
/// Position of the three slave nodes along their segments.
pub const G_OF_THREE: Quantity = places(Shape::Vec3);
/// Shear stress at both slave nodes.
pub const S12_OF_TWO: Quantity = shears(Shape::Vec2);
/// Shear stress at the three slave nodes.
pub const S12_OF_THREE: Quantity = shears(Shape::Vec3);
/// Stiffness in stick, as a stress.
pub const K_STICK_SHEAR: Quantity = Quantity::scalar(
    r"k_{\mathrm{stick}}",
    PRESSURE.per(Unit::L),
    Domain::Positive,
    "stiffness in stick, shear stress per displacement",
);

fields! {
    /// What both slave nodes of ISL21A remember from one increment to the next.
    pub struct Isl21aState<T> { g: Vector2<T> = G_OF_TWO, s12: Vector2<T> = S12_OF_TWO }
}
fields! {
    /// What the three slave nodes of ISL22A remember from one increment to the next.
    pub struct Isl22aState<T> { g: Vector3<T> = G_OF_THREE, s12: Vector3<T> = S12_OF_THREE }
}
fields! {
    /// The friction of an element on a slide line.
    pub struct IslContact<T> { k_stick: T = K_STICK_SHEAR, mu: T = MU }
}
fields! {
    /// The parameter of the linear pressure law.
    pub struct LinearLaw<T> { k: T = STIFFNESS }
}
fields! {
    /// The parameters of the exponential pressure law.
    pub struct ExponentialLaw<T> { c0: T = CLEARANCE, p0: T = PRESSURE_AT_TOUCH }
}

/// A pressure law of a slide line: [`PressureLinear`] or [`PressureExponential`].
pub trait PressureLaw: Formula + Debug + PartialEq {
    /// Its parameters.
    type Parameters<T: Component>: Fields<T>;
    /// The identifiers and titles of ISL21A and ISL22A with this law.
    const NAMES: [[&'static str; 2]; 2];
    /// The pressure at an overclosure, and its derivative with respect to the overclosure.
    fn pressure<D: Scalar>(h: D, parameters: &Self::Parameters<D>) -> [D; 2];
}

impl PressureLaw for PressureLinear {
    type Parameters<T: Component> = LinearLaw<T>;
    const NAMES: [[&'static str; 2]; 2] = [
        ["isl21a_linear", "ISL21A as an element, with the linear pressure law"],
        ["isl22a_linear", "ISL22A as an element, with the linear pressure law"],
    ];
    fn pressure<D: Scalar>(h: D, &LinearLaw { k }: &LinearLaw<D>) -> [D; 2] {
        let (found, by) = Self::linearized(&LinearContact { h, k });
        [found.p, by.p.h]
    }
}

impl PressureLaw for PressureExponential {
    type Parameters<T: Component> = ExponentialLaw<T>;
    const NAMES: [[&'static str; 2]; 2] = [
        ["isl21a_exponential", "ISL21A as an element, with the exponential pressure law"],
        ["isl22a_exponential", "ISL22A as an element, with the exponential pressure law"],
    ];
    fn pressure<D: Scalar>(h: D, &ExponentialLaw { c0, p0 }: &ExponentialLaw<D>) -> [D; 2] {
        let (found, by) = Self::linearized(&ExponentialContact { h, c0, p0 });
        [found.p, by.p.h]
    }
}
