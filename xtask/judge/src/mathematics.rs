//! Mathematics as text: `\tfrac12\,\lvert f_1\rvert` as `1/2 |f₁|`.

use std::iter::Peekable;
use std::str::Chars;

/// LaTeX as text. What is unknown stays as it is.
pub fn as_text(latex: &str) -> String {
    let text = converted(&mut latex.chars().peekable(), None);
    let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
    lines.collect::<Vec<_>>().join("\n").replace("( ", "(").replace(" )", ")").replace(" ,", ",")
}

/// What stands before this end; everything without one.
fn converted(latex: &mut Peekable<Chars<'_>>, end: Option<&str>) -> String {
    let mut text = String::new();
    while let Some(next) = latex.next() {
        match next {
            '}' if end == Some("}") => return text,
            '{' => text += &converted(latex, Some("}")),
            '\\' => {
                let name = command(latex);
                if name == "end" {
                    let closed = argument(latex);
                    if end == Some(&closed) {
                        return text;
                    }
                } else {
                    text += &meaning(&name, latex);
                }
            }
            '^' => text += &raised(&argument(latex)),
            '_' => text += &lowered(&argument(latex)),
            '&' if end == Some("aligned") => {}
            '&' => text += ", ",
            '=' | '<' | '>' => text.extend([' ', next, ' ']),
            '-' => text.push('−'),
            _ => text.push(next),
        }
    }
    text
}

/// The name of a command: letters, or one other character.
fn command(latex: &mut Peekable<Chars<'_>>) -> String {
    let mut name = String::new();
    while let Some(letter) = latex.next_if(char::is_ascii_alphabetic) {
        name.push(letter);
    }
    if name.is_empty() {
        return latex.next().map(String::from).unwrap_or_default();
    }
    // What opens something stands close to it.
    if matches!(name.as_str(), "lvert" | "lVert" | "left" | "bigl" | "Bigl" | "partial" | "delta" | "Delta") {
        while latex.next_if_eq(&' ').is_some() {}
    }
    name
}

/// The argument of a command or script: a group, a command or a character.
fn argument(latex: &mut Peekable<Chars<'_>>) -> String {
    while latex.next_if_eq(&' ').is_some() {}
    match latex.next() {
        Some('{') => converted(latex, Some("}")),
        Some('\\') => {
            let name = command(latex);
            meaning(&name, latex)
        }
        Some(one) => one.into(),
        None => String::new(),
    }
}

fn meaning(name: &str, latex: &mut Peekable<Chars<'_>>) -> String {
    if let Some((_, sign)) = SIGNS.iter().find(|(known, _)| *known == name) {
        return (*sign).into();
    }
    match name {
        "frac" | "dfrac" | "tfrac" => {
            let [above, below] = [argument(latex), argument(latex)];
            format!("{}/{} ", held(&above), held(&below))
        }
        "sqrt" => format!("√{}", held(&argument(latex))),
        "mathbf" | "mathrm" | "mathit" | "boldsymbol" | "operatorname" | "text" => argument(latex),
        "left" | "right" | "bigl" | "bigr" | "Bigl" | "Bigr" => {
            latex.next_if_eq(&'.');
            String::new()
        }
        "begin" => {
            let kind = argument(latex);
            let inner = converted(latex, Some(&kind));
            let rows: Vec<_> = inner.lines().map(str::trim).filter(|row| !row.is_empty()).collect();
            match kind.as_str() {
                "cases" => format!("{{ {} }}", rows.join("; ")),
                "aligned" => rows.join("\n"),
                _ => format!("[{}]", rows.join("; ")),
            }
        }
        _ => format!("\\{name}"),
    }
}

/// In parentheses if it is more than a name or a number.
fn held(text: &str) -> String {
    let text = text.trim();
    let is_one = text.chars().all(|c| {
        c.is_alphanumeric() || "_√".contains(c) || SCRIPTS.iter().any(|(_, low, high)| c == *low || c == *high)
    });
    let is_enclosed = text.starts_with('|') && text.ends_with('|') && text.matches('|').count() == 2;
    if is_one || is_enclosed { text.into() } else { format!("({text})") }
}

fn raised(text: &str) -> String {
    script(text, |(_, _, high)| *high).unwrap_or_else(|| format!("^{}", held(text)))
}

fn lowered(text: &str) -> String {
    script(text, |(_, low, _)| *low).unwrap_or_else(|| format!("_{}", held(text)))
}

/// The text in small characters, if there are such.
fn script(text: &str, small: fn(&(char, char, char)) -> char) -> Option<String> {
    let one = |c| SCRIPTS.iter().find(|(plain, ..)| *plain == c).map(small).filter(|small| *small != ' ');
    text.chars().map(one).collect()
}

/// A character, low and high.
const SCRIPTS: [(char, char, char); 14] = [
    ('0', '₀', '⁰'),
    ('1', '₁', '¹'),
    ('2', '₂', '²'),
    ('3', '₃', '³'),
    ('4', '₄', '⁴'),
    ('5', '₅', '⁵'),
    ('6', '₆', '⁶'),
    ('7', '₇', '⁷'),
    ('8', '₈', '⁸'),
    ('9', '₉', '⁹'),
    ('+', '₊', '⁺'),
    ('−', '₋', '⁻'),
    ('-', '₋', '⁻'),
    ('T', ' ', 'ᵀ'),
];

/// Commands that stand for text.
#[rustfmt::skip]
const SIGNS: &[(&str, &str)] = &[
    ("alpha", "α"), ("beta", "β"), ("gamma", "γ"), ("delta", "δ"), ("Delta", "Δ"), ("epsilon", "ε"), ("varepsilon", "ε"),
    ("zeta", "ζ"), ("eta", "η"), ("theta", "θ"), ("Theta", "Θ"), ("kappa", "κ"), ("lambda", "λ"), ("Lambda", "Λ"), ("mu", "μ"),
    ("nu", "ν"), ("xi", "ξ"), ("Xi", "Ξ"), ("pi", "π"), ("rho", "ρ"), ("sigma", "σ"), ("Sigma", "Σ"), ("tau", "τ"), ("phi", "φ"),
    ("varphi", "φ"), ("Phi", "Φ"), ("chi", "χ"), ("psi", "ψ"), ("Psi", "Ψ"), ("omega", "ω"), ("Omega", "Ω"), ("Gamma", "Γ"),
    ("ell", "ℓ"), ("partial", "∂"), ("sum", "Σ"), ("times", " × "), ("cdot", "·"), ("otimes", "⊗"), ("pm", "±"), ("perp", "⊥"),
    ("le", " ≤ "), ("leq", " ≤ "), ("ge", " ≥ "), ("geq", " ≥ "), ("ne", " ≠ "), ("neq", " ≠ "), ("approx", " ≈ "), ("in", " ∈ "),
    ("to", " → "), ("infty", "∞"), ("top", "ᵀ"), ("circ", "°"), ("S", "§"), ("ldots", "…"), ("dots", "…"), ("cdots", "…"),
    ("lvert", "|"), ("rvert", "|"), ("lVert", "‖"), ("rVert", "‖"), ("vert", "|"), ("{", "{"), ("}", "}"), ("%", "%"),
    ("sin", "sin "), ("cos", "cos "), ("tan", "tan "), ("arcsin", "arcsin "), ("arctan", "arctan "), ("exp", "exp "), ("log", "log "),
    ("ln", "ln "), ("min", "min "), ("max", "max "), ("quad", "  "), ("qquad", "  "), (",", " "), (";", " "), (":", " "), (" ", " "),
    ("!", ""), ("\\", "\n"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;

    #[test]
    fn fractions_roots_scripts_and_cases_are_readable() {
        for (latex, text) in [
            (r"P = \lvert f_1\rvert,\quad \Phi = P - \mu F_N", "P = |f₁|, Φ = P − μ F_N"),
            (r"F_N = \left\lvert\sqrt{f_2^2+f_3^2} + F_C^{\mathrm{int}}\right\rvert", "F_N = |√(f₂²+f₃²) + F_C^int|"),
            (r"\tfrac12\,a + \frac{a+b}{\sqrt{c}}", "1/2 a + (a+b)/√c"),
            (r"\mathbf{x}_a^{T} \unknown", r"x_aᵀ \unknown"),
            (
                r"x = \begin{cases} 0 & x < 1 \\ x^{-1} & \text{otherwise} \end{cases}",
                "x = { 0, x < 1; x⁻¹, otherwise }",
            ),
            (r"\begin{aligned} a &= 1 \\ b &= \sin\alpha \end{aligned}", "a = 1\nb = sin α"),
        ] {
            assert_eq!(as_text(latex), text);
        }
    }

    #[test]
    fn no_equation_of_the_catalog_keeps_a_command() {
        for formula in CATALOG {
            let kinks = formula.kinks().into_iter().map(|kink| kink.condition);
            for latex in kinks.chain([formula.spec().latex.to_owned()]) {
                let text = as_text(&latex);
                assert!(!text.contains('\\'), "{}: {latex}\n{text}", formula.spec().id);
            }
        }
    }
}
