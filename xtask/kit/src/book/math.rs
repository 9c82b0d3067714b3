//! LaTeX to `MathML` at build time, so that the book needs neither network nor scripts to show mathematics.

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use super::flow;
use super::html::escape;

/// Why a formula could not be converted: the reason, and the position in the formula.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("cannot set the formula `{latex}`: {reason} (at character {at})")]
pub(crate) struct MathError {
    /// The formula as written.
    pub(crate) latex: String,
    /// The message of the converter.
    pub(crate) reason: String,
    /// Character offset in the formula, from 1.
    pub(crate) at: usize,
}

/// The LaTeX converter of one build.
pub(crate) struct Math {
    /// The LaTeX parser, without macros: a formula must read the same in golden files and in the book.
    converter: LatexToMathML,
}

impl Math {
    /// A converter without macros.
    pub(crate) fn new() -> Self {
        let converter = LatexToMathML::new(MathCoreConfig::default());
        Self { converter: converter.unwrap_or_else(|_| unreachable!("no macros, so none can be wrong")) }
    }

    /// A formula within a line.
    ///
    /// # Errors
    /// If the LaTeX is wrong or uses a command the converter does not know.
    pub(crate) fn inline(&self, latex: &str) -> Result<String, MathError> {
        self.convert(latex, MathDisplay::Inline)
    }

    /// A formula on its own line, broken where its column is narrower, in a box that scrolls where it cannot be broken.
    ///
    /// # Errors
    /// As for [`Math::inline`].
    pub(crate) fn block(&self, latex: &str) -> Result<String, MathError> {
        let mathml = self.convert(latex, MathDisplay::Block)?;
        Ok(flow::flow(&mathml, &escape(latex.trim())))
    }

    /// The `MathML`, with the LaTeX as its alternative text.
    fn convert(&self, latex: &str, display: MathDisplay) -> Result<String, MathError> {
        let latex = latex.trim();
        let result = self.converter.convert_with_local_state(latex, display).map_err(|error| MathError {
            latex: latex.to_owned(),
            reason: error.error_message(),
            at: latex.get(..error.0.start).map_or(0, |before| before.chars().count()) + 1,
        })?;
        let alternative = escape(latex);
        Ok(level(&result.mathml).replace("<math", &format!("<math alttext=\"{alternative}\"")))
    }
}

/// Letters with descenders, whose subscripts would be set lower than those of other letters.
const BELOW: &str = "fgjpqyQβγζημξρφχψς";

/// Sets the subscript of such a letter at the height of all others, by declaring that the letter has no depth.
fn level(mathml: &str) -> String {
    let mut out = mathml.to_owned();
    for script in ["<msub>", "<msubsup>"] {
        for letter in BELOW.chars() {
            let from = format!("{script}<mi>{letter}</mi>");
            out = out.replace(&from, &format!("{script}<mpadded depth=\"0\"><mi>{letter}</mi></mpadded>"));
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All commands used in formulas must be supported.
    const USED: &[&str] = &[
        r"F_C = \sqrt{f_2^2 + f_3^2}",
        r"\mathbf{e}_{1a}\cdot(\mathbf{x}_b-\mathbf{x}_a)",
        r"\begin{cases} f & \text{if } \lvert f\rvert < \mu F_N \\ \mu F_N \operatorname{sign}(f) & \text{otherwise} \end{cases}",
        r"\begin{aligned} x &= 1 \\ y &= 2 \end{aligned}",
        r"-\operatorname{atan2}\!\left(\tfrac12, \frac{\partial\Phi}{\partial f}\right)",
        r"\begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}\hat{\mathbf{n}}\bar f^{\mathsf T}",
    ];

    #[test]
    fn everything_the_formulary_uses_is_set() {
        let math = Math::new();
        for latex in USED {
            let mathml = math.block(latex).unwrap_or_else(|e| panic!("{e}"));
            assert!(mathml.contains("<math ") && !mathml.contains('\n'), "{mathml}");
        }
    }

    #[test]
    fn a_wrong_formula_names_itself_and_the_place() {
        let error = Math::new().inline(r"a + \nonsense b").unwrap_err();
        assert_eq!(error.at, 5);
        let text = error.to_string();
        assert!(text.contains(r"a + \nonsense b") && text.contains("Unknown command"), "{text}");
    }

    #[test]
    fn indices_stand_at_one_height() {
        let math = Math::new();
        assert!(
            math.inline("y_0").unwrap().contains("<msub><mpadded depth=\"0\"><mi>y</mi></mpadded><mn>0</mn></msub>")
        );
        assert!(math.inline("z_0").unwrap().contains("<msub><mi>z</mi><mn>0</mn></msub>"));
    }

    #[test]
    fn less_than_is_escaped() {
        let mathml = Math::new().inline("a < b").unwrap();
        assert!(mathml.contains("<mo>&lt;</mo>") && mathml.contains("alttext=\"a &lt; b\""), "{mathml}");
    }
}
