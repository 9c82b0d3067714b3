//! Bounds of rounding errors that are proved, for all inputs and without a box: each by a certificate that is checked by adding up.
//!
//! On one way through its branches a result y is computed by a list of operations. Each number t among them, and each of its uses, has a
//! *part*: t times the derivative of y with respect to it there. An operation with a relative error of at most ρu, u = 2⁻⁵³, changes y by
//! at most ρu times the magnitude of the part of its result, to first order. This is its load. Rules that hold for any function move
//! loads from part to part: by P(ab) = P(a) the part of a product is that of each factor, and by P(a + b) = P(a) + P(b) no part of three
//! is larger than the other two together. A bound C is proved if every load ends on parts of inputs and on y itself, on none of them more
//! than C: then the error is at most C u (Σ |∂y/∂xᵢ · xᵢ| + |y|).
//!
//! A normwise bound compares the error with the largest size of several results y_j, by whole vectors: |y_j| + Σ |∂y_j/∂x| |x|. There loads
//! end on y_j, or on products of ∂y_j/∂x_i and another component x_k of the same vector, which together are at most |∂y_j/∂x| |x| if their
//! amounts add up to at most 1 for each i and for each k. The largest sum of amounts for each y_j, added up over j, is the bound.
//!
//! A [`Certificate`] says how often each rule is used. Finding one is a linear programme, which is [solved](prove) elsewhere; checking
//! one needs only sums of fractions. Parts that are the same up to a factor, whatever the inputs are, count as one: this is tested modulo
//! a prime, at points where numbers look random.
//!
//! A proof is about the recorded graph. It knows nothing of under- and overflow, believes what is said of library functions, and takes
//! comparisons of rounded numbers for those of exact ones: nearer to a kink than a rounding, a result may be that of the other side.

mod certificate;
mod exact;
mod field;
mod file;
mod parts;
mod points;
mod possible;
mod sign;
mod summary;
mod way;

pub use certificate::{Certificate, Programme, check, prove};
pub use field::Rational;
pub use file::{Head, Line, Proof};
pub use parts::{Part, Rule};
pub use possible::MOST_WAYS;
pub use summary::{Summary, accuracy};
pub use way::Answers;
