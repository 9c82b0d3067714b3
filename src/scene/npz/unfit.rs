//! What is wrong with arrays.

/// What is wrong with a file or an array of it, and what may be there.
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

/// A shape as Python writes it.
pub(super) fn tuple(shape: &[usize]) -> String {
    let sizes: Vec<_> = shape.iter().map(usize::to_string).collect();
    if let [one] = &sizes[..] { format!("({one},)") } else { format!("({})", sizes.join(", ")) }
}
