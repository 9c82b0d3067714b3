//! Symbols, independent of the arrangement of their LaTeX.

use std::fmt;

/// A symbol with all its decorations: `\mathrm{d}\mathbf{t}_1`, `F_C^{\mathrm{int}}`, `\mathbf{X}'`.
#[derive(Clone, Debug, Default)]
pub(super) struct Name {
    /// `d`, `Δ` or `δ` for a change, else empty; `δd` and `δΔ` are variations of changes.
    pub(super) change: &'static str,
    /// Whether it is bold, as vectors are.
    pub(super) bold: bool,
    /// The letter, or the letters of an `\mathit`.
    pub(super) base: String,
    /// The pieces of the subscript: `\mathrm{axial}k` has two.
    pub(super) below: Vec<String>,
    /// A superscript that is a word or a sign rather than a power.
    pub(super) above: String,
    pub(super) primes: usize,
}

impl Name {
    /// A plain letter.
    pub(super) fn letter(base: impl Into<String>) -> Self {
        Self { base: base.into(), ..Self::default() }
    }

    /// Whether this is a plain letter.
    pub(super) fn is_letter(&self, letter: &str) -> bool {
        self.base == letter && !self.bold && self.below.is_empty() && self.above.is_empty() && self.change.is_empty()
    }

    /// Other ways to write this symbol: a vector in plain type, φ and ϵ in their other shapes.
    pub(super) fn otherwise(&self) -> Vec<Self> {
        let shapes = [("phi", "varphi"), ("epsilon", "varepsilon")];
        let shape = shapes.into_iter().find_map(|(a, b)| {
            let other = if self.base == a { b } else { a };
            (self.base == a || self.base == b).then(|| Self { base: other.into(), ..self.clone() })
        });
        let bold = (!self.bold).then(|| Self { bold: true, ..self.clone() });
        bold.into_iter().chain(shape).collect()
    }

    /// The symbol of which this is the variation or the differential.
    pub(super) fn unchanged(&self) -> Option<Self> {
        let change = match self.change {
            "δ" | "d" => "",
            "δd" => "d",
            "δΔ" => "Δ",
            _ => return None,
        };
        Some(Self { change, ..self.clone() })
    }

    /// Whether this is a variation, δ.
    pub(super) fn is_variation(&self) -> bool {
        self.change.starts_with('δ')
    }

    /// The variation of this symbol.
    pub(super) fn varied(&self) -> Self {
        let change = match self.change {
            "d" => "δd",
            "Δ" => "δΔ",
            _ => "δ",
        };
        Self { change, ..self.clone() }
    }

    /// The subscript in one piece.
    fn subscript(&self) -> String {
        self.below.concat()
    }

    /// The vector of which this symbol would be a component, and the index: `x_{m,k}` of **x**_m.
    pub(super) fn component(&self) -> Option<(Self, &str)> {
        let (last, rest) = self.below.split_last()?;
        let rest = match rest.split_last() {
            Some((comma, rest)) if comma == "," => rest,
            _ => rest,
        };
        (!self.bold).then(|| (Self { bold: true, below: rest.to_vec(), ..self.clone() }, last.as_str()))
    }

    /// The k-th component, counted from 1.
    pub(super) fn at(&self, k: usize) -> Self {
        let mut below = self.below.clone();
        below.push(k.to_string());
        Self { bold: false, below, ..self.clone() }
    }

    /// Whether the index is a piece of the subscript.
    pub(super) fn has_index(&self, index: &str) -> bool {
        self.below.iter().any(|piece| piece == index)
    }

    /// The symbol with an index replaced by a number.
    pub(super) fn with_index(&self, index: &str, value: usize) -> Self {
        let put = |piece: &String| if piece == index { value.to_string() } else { piece.clone() };
        Self { below: self.below.iter().map(put).collect(), ..self.clone() }
    }

    /// Whether this is a declared function, apart from the index in a family of functions.
    pub(super) fn is_like(&self, declared: &Self) -> bool {
        let head = |name: &Self| (name.change, name.bold, name.base.clone(), name.above.clone(), name.primes);
        head(self) == head(declared) && self.below.len() == declared.below.len()
    }
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        (self.change, self.bold, self.primes) == (other.change, other.bold, other.primes)
            && self.base == other.base
            && self.above == other.above
            && self.subscript() == other.subscript()
    }
}

/// As plain text: `dt_1`, `F_C^int`.
impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.change, self.base, "'".repeat(self.primes))?;
        if !self.below.is_empty() {
            write!(f, "_{}", self.subscript())?;
        }
        if !self.above.is_empty() {
            write!(f, "^{}", self.above)?;
        }
        f.write_str(if self.bold { " (a vector)" } else { "" })
    }
}
