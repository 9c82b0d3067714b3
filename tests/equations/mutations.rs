//! Equations with one token changed: sign, index, exponent, constant, function, relation, order of operands, symbol.

/// An equation with one token changed.
pub struct Mutant {
    pub latex: String,
    /// The change, at a byte.
    pub what: String,
}

/// Tokens and what stands in their place.
const REPLACED: &[(&str, &str)] = &[
    (r"\sin", r"\cos"),
    (r"\cos", r"\sin"),
    (r"\arcsin", r"\sin"),
    (r"\operatorname{sign}", r"\sin"),
    (r"\sqrt{", r"\tfrac1{"),
    (r"\cdot", r"\times"),
    (r"\times", r"\cdot"),
    (r"\le", r"\ge"),
    (r"\ge", r"\le"),
    (r"\ne", "="),
    (r"\pi", "e"),
    ("<", ">"),
    (">", "<"),
    ("/", ""),
];

/// All single-token mutants.
pub fn mutants(latex: &str) -> Vec<Mutant> {
    let mut all = Vec::new();
    let mut put = |at: usize, old: &str, new: &str| {
        let mutated = [&latex[..at], new, &latex[at + old.len()..]].concat();
        all.push(Mutant { latex: mutated, what: format!("{old} → {new} at {at}") });
    };
    for (old, new) in REPLACED {
        for (at, _) in latex.match_indices(old) {
            let ends = latex[at + old.len()..].chars().next();
            if !(old.starts_with('\\') && ends.is_some_and(|c| c.is_ascii_alphabetic())) {
                put(at, old, new);
            }
        }
    }
    for (at, sign) in latex.match_indices(['+', '-']) {
        let before = latex[..at].trim_end().chars().next_back();
        let alone = before.is_none_or(|c| "=({[&,".contains(c));
        let other = if sign == "-" { "+" } else { "-" };
        put(at, sign, if alone { "" } else { other });
    }
    for (at, digit) in latex.match_indices(|c: char| c.is_ascii_digit()) {
        let other = match digit {
            "9" => "8".to_string(),
            digit => (digit.parse::<u8>().unwrap_or(0) + 1).to_string(),
        };
        put(at, digit, &other);
    }
    let names = names(latex);
    for (k, (at, name)) in names.iter().enumerate() {
        // Of its own kind where there is another: a number for a number, a vector for a vector.
        let others: Vec<_> =
            names[k..].iter().chain(&names[..k]).map(|(_, other)| other).filter(|o| *o != name).collect();
        let alike = others.iter().find(|other| other.contains("mathbf") == name.contains("mathbf"));
        if let Some(other) = alike.or(others.first()) {
            put(*at, name, other);
        }
    }
    for (at, (first, second)) in pairs(latex) {
        let (open, between) = if latex[at..].starts_with('{') { ("{", "}{") } else { ("(", ", ") };
        let close = if open == "{" { "}" } else { ")" };
        let old = latex[at..].get(..2 + first.len() + second.len() + between_length(&latex[at..], first)).unwrap_or("");
        put(at, old, &[open, second, between, first, close].concat());
    }
    all
}

/// The bytes between the first operand and the second.
fn between_length(pair: &str, first: &str) -> usize {
    let rest = &pair[1 + first.len()..];
    rest.len() - rest.trim_start_matches(['}', '{', ',', '\\', ' ']).len()
}

/// Symbols with their subscripts and superscripts.
fn names(latex: &str) -> Vec<(usize, String)> {
    const STEMS: &[&str] = &[r"\mathbf{", r"\mathit{"];
    const GREEK: &[&str] =
        &[r"\alpha", r"\beta", r"\gamma", r"\lambda", r"\varphi", r"\mu", r"\eta", r"\xi", r"\Phi", r"\theta", r"\ell"];
    let mut all = Vec::new();
    let mut at = 0;
    while let Some(first) = latex[at..].chars().next() {
        let rest = &latex[at..];
        let stem = STEMS.iter().find(|stem| rest.starts_with(**stem));
        let greek = GREEK.iter().find(|greek| rest.starts_with(**greek));
        let length = match (stem, greek) {
            (Some(_), _) => rest.find('}').map_or(rest.len(), |end| end + 1),
            (_, Some(greek)) => greek.len(),
            _ if first.is_ascii_alphabetic() => 1,
            _ => {
                // A command, or a text, which is no symbol.
                let command =
                    rest.strip_prefix('\\').map_or(0, |r| 1 + r.bytes().take_while(u8::is_ascii_alphabetic).count());
                let group = [r"\mathrm{", r"\text{", r"\begin{", r"\end{", r"\operatorname{", r"\operatorname*{"];
                let group = group.iter().any(|g| rest.starts_with(g));
                at += match rest.find('}') {
                    Some(end) if group => end + 1,
                    _ => command.max(first.len_utf8()),
                };
                continue;
            }
        };
        let end = at + length + scripts(&latex[at + length..]);
        all.push((at, latex[at..end].to_string()));
        at = end;
    }
    all
}

/// The length of the subscript, primes and upright superscript here.
fn scripts(mut rest: &str) -> usize {
    let start = rest.len();
    loop {
        let is_script = rest.starts_with('_')
            || rest.starts_with(r"^{\mathrm")
            || rest.starts_with(r"^{\min")
            || rest.starts_with(r"^{\max");
        if rest.starts_with('\'') {
            rest = &rest[1..];
        } else if is_script {
            rest = &rest[1 + group(&rest[1..])..];
        } else {
            return start - rest.len();
        }
    }
}

/// The length of a group in braces, or of one character.
fn group(rest: &str) -> usize {
    let mut depth = 0;
    for (at, c) in rest.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return at + c.len_utf8();
        }
    }
    rest.len()
}

/// Operands of fractions and of atan2: where they begin, and both.
fn pairs(latex: &str) -> Vec<(usize, (&str, &str))> {
    let mut all = Vec::new();
    for command in [r"\frac{", r"\dfrac{", r"\tfrac{"] {
        for (at, _) in latex.match_indices(command) {
            let start = at + command.len() - 1;
            let first = group(&latex[start..]);
            let second = group(&latex[start + first..]);
            all.push((
                start,
                (&latex[start + 1..start + first - 1], &latex[start + first + 1..start + first + second - 1]),
            ));
        }
    }
    for (at, command) in latex.match_indices(r"\operatorname{atan2}") {
        let start = at + command.len();
        let inside = latex[start..].strip_prefix('(').and_then(|rest| rest.split_once(')'));
        if let Some((first, second)) = inside.and_then(|(inside, _)| inside.split_once(r",\ ")) {
            all.push((start, (first, second)));
        }
    }
    all
}
