//! Errors of arrays.

/// A fault of a file or of an array in it, and what is allowed.
#[derive(Debug)]
pub(in crate::scene) struct Unfit {
    pub(in crate::scene) found: String,
    pub(in crate::scene) allowed: String,
}

impl Unfit {
    pub(in crate::scene) fn new(found: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self { found: found.into(), allowed: allowed.into() }
    }
}

/// A shape in Python notation.
pub(super) fn tuple(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(usize::to_string).collect();
    if let [one] = &sizes[..] { format!("({one},)") } else { format!("({})", sizes.join(", ")) }
}
