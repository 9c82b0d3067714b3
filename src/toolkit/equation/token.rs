//! LaTeX as tokens, without purely typographic commands.

use super::error::Error;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind<'a> {
    /// `\name`, without its backslash.
    Command(&'a str),
    /// A letter of the alphabet.
    Letter(char),
    /// A digit: `\tfrac12` is one half, so digits are combined only where a number is parsed.
    Digit(char),
    /// Any other character.
    Sign(char),
    /// The content of `\text{…}`.
    Text(&'a str),
    /// The name of an input or output in code: `fc_int`.
    Field(&'a str),
    /// `\begin{cases}`, `\end{cases}`, and `\\` and `&` between its cells.
    BeginCases,
    EndCases,
    /// `\begin{pmatrix}` and the like, with the same separators.
    BeginMatrix,
    EndMatrix,
    Row,
    Cell,
    /// `\quad`, `\Rightarrow` or the end of a line, between statements.
    Gap,
    End,
}

/// A token, and the byte offset at which it begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token<'a> {
    pub(super) kind: Kind<'a>,
    pub(super) at: usize,
}

/// Sizes of brackets, which have no meaning.
const SIZES: &[&str] = &[
    "left", "right", "middle", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "bigm", "Bigl", "Bigr", "Bigm", "biggl",
    "biggr", "Biggl", "Biggr",
];

/// Spaces and styles, which have no meaning either.
const TYPOGRAPHY: &[&str] = &[
    ",",
    ";",
    ":",
    "!",
    " ",
    ">",
    "/",
    "(",
    ")",
    "[",
    "]",
    "displaystyle",
    "textstyle",
    "limits",
    "nolimits",
    "nonumber",
    "notag",
    "thinspace",
    "medspace",
    "thickspace",
    "enspace",
];

/// Commands that are only other spellings.
const SPELLINGS: &[(&str, Kind<'_>)] = &[
    ("|", Kind::Sign('|')),
    ("vert", Kind::Sign('|')),
    ("Vert", Kind::Sign('|')),
    ("lVert", Kind::Command("lvert")),
    ("rVert", Kind::Command("rvert")),
    ("{", Kind::Sign('(')),
    ("}", Kind::Sign(')')),
    ("lbrace", Kind::Sign('(')),
    ("rbrace", Kind::Sign(')')),
    ("lbrack", Kind::Sign('[')),
    ("rbrack", Kind::Sign(']')),
    ("leq", Kind::Command("le")),
    ("leqslant", Kind::Command("le")),
    ("geq", Kind::Command("ge")),
    ("geqslant", Kind::Command("ge")),
    ("neq", Kind::Command("ne")),
    ("lt", Kind::Sign('<')),
    ("gt", Kind::Sign('>')),
    ("coloneqq", Kind::Sign('=')),
    ("equiv", Kind::Sign('=')),
    ("triangleq", Kind::Sign('=')),
    ("ast", Kind::Sign('*')),
    ("land", Kind::Sign(',')),
    ("wedge", Kind::Sign(',')),
    ("prime", Kind::Sign('\'')),
    ("implies", Kind::Gap),
    ("Rightarrow", Kind::Gap),
    ("quad", Kind::Gap),
    ("qquad", Kind::Gap),
];

/// Characters beyond ASCII that are spellings of commands and signs.
const CHARACTERS: &[(&str, Kind<'_>)] = &[
    ("·⋅∙•", Kind::Command("cdot")),
    ("×", Kind::Command("times")),
    ("⊗", Kind::Command("otimes")),
    ("−–", Kind::Sign('-')),
    ("∗", Kind::Sign('*')),
    ("∕÷", Kind::Sign('/')),
    ("√", Kind::Command("sqrt")),
    ("∑", Kind::Command("sum")),
    ("∂", Kind::Command("partial")),
    ("≤⩽", Kind::Command("le")),
    ("≥⩾", Kind::Command("ge")),
    ("≠", Kind::Command("ne")),
    ("≔≡", Kind::Sign('=')),
    ("∣‖∥", Kind::Sign('|')),
    ("′’", Kind::Sign('\'')),
    ("∧", Kind::Sign(',')),
    ("Δ∆", Kind::Command("Delta")),
    ("µ", Kind::Command("mu")),
    ("ϕ", Kind::Command("phi")),
    ("φ", Kind::Command("varphi")),
    ("ϵ", Kind::Command("epsilon")),
    ("ε", Kind::Command("varepsilon")),
    ("ℓ", Kind::Command("ell")),
    ("α", Kind::Command("alpha")),
    ("β", Kind::Command("beta")),
    ("γ", Kind::Command("gamma")),
    ("δ", Kind::Command("delta")),
    ("ζ", Kind::Command("zeta")),
    ("η", Kind::Command("eta")),
    ("θϑ", Kind::Command("theta")),
    ("κ", Kind::Command("kappa")),
    ("λ", Kind::Command("lambda")),
    ("μ", Kind::Command("mu")),
    ("ν", Kind::Command("nu")),
    ("ξ", Kind::Command("xi")),
    ("π", Kind::Command("pi")),
    ("ρ", Kind::Command("rho")),
    ("σ", Kind::Command("sigma")),
    ("τ", Kind::Command("tau")),
    ("χ", Kind::Command("chi")),
    ("ψ", Kind::Command("psi")),
    ("ω", Kind::Command("omega")),
    ("Γ", Kind::Command("Gamma")),
    ("Θ", Kind::Command("Theta")),
    ("Λ", Kind::Command("Lambda")),
    ("Ξ", Kind::Command("Xi")),
    ("Σ", Kind::Command("Sigma")),
    ("Φ", Kind::Command("Phi")),
    ("Ψ", Kind::Command("Psi")),
    ("Ω", Kind::Command("Omega")),
];

/// Small characters above and below the line, and what they are on it.
const ABOVE: &str = "⁰0¹1²2³3⁴4⁵5⁶6⁷7⁸8⁹9⁻-ⁿn";
const BELOW: &str = "₀0₁1₂2₃3₄4₅5₆6₇7₈8₉9ₐaₑeₕhᵢiⱼjₖkₗlₘmₙnₒoₚpᵣrₛsₜtᵤuᵥvₓx";

/// Greek letters and other commands that are letters.
pub(super) const LETTERS: &[&str] = &[
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "pi",
    "rho",
    "sigma",
    "tau",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Theta",
    "Lambda",
    "Xi",
    "Sigma",
    "Phi",
    "Psi",
    "Omega",
    "ell",
];

/// Functions that may be written without a backslash.
pub(super) const FUNCTIONS: &[&str] = &[
    "sqrt", "sin", "cos", "tan", "cot", "asin", "acos", "atan", "arcsin", "arccos", "arctan", "atan2", "arctan2",
    "sign", "sgn", "round", "abs", "norm", "hypot", "exp", "min", "max", "dot", "cross",
];

/// The tokens of an equation; the last one is [`Kind::End`].
pub(super) fn tokens(latex: &str) -> Result<Vec<Token<'_>>, Error> {
    Reader::read(latex, None)
}

/// The tokens of an equation in which Greek letters, functions and these fields may be written without a backslash.
pub(super) fn plain<'a>(latex: &'a str, fields: &[&str]) -> Result<Vec<Token<'a>>, Error> {
    Reader::read(latex, Some(fields))
}

struct Reader<'a, 'f> {
    latex: &'a str,
    at: usize,
    all: Vec<Token<'a>>,
    /// For each enclosing environment, whether its cells and lines have a meaning, as those of `cases` have.
    tables: Vec<bool>,
    fields: Option<&'f [&'f str]>,
}

impl<'a> Reader<'a, '_> {
    fn read(latex: &'a str, fields: Option<&[&str]>) -> Result<Vec<Token<'a>>, Error> {
        let mut reader = Reader { latex, at: 0, all: Vec::new(), tables: Vec::new(), fields };
        while reader.at < latex.len() {
            reader.next()?;
        }
        // What ends a sentence.
        while matches!(reader.all.last(), Some(Token { kind: Kind::Sign('.' | ',') | Kind::Gap, .. })) {
            reader.all.pop();
        }
        reader.put(Kind::End, latex.len());
        Ok(reader.all)
    }

    fn put(&mut self, kind: Kind<'a>, at: usize) {
        // A line that begins with one of these continues the previous one.
        let goes_on = matches!(kind, Kind::Sign('+' | '=')) || kind == Kind::Sign('-') && self.fields.is_some();
        while goes_on && self.all.last().is_some_and(|last| last.kind == Kind::Gap) {
            self.all.pop();
        }
        self.all.push(Token { kind, at });
    }

    fn rest(&self) -> &'a str {
        &self.latex[self.at..]
    }

    fn is_in_table(&self) -> bool {
        self.tables.last() == Some(&true)
    }

    /// Skips a piece if it comes next.
    fn took(&mut self, piece: &str) -> bool {
        let is_so = self.rest().starts_with(piece);
        self.at += if is_so { piece.len() } else { 0 };
        is_so
    }

    fn next(&mut self) -> Result<(), Error> {
        let at = self.at;
        let Some(first) = self.rest().chars().next() else { return Ok(()) };
        if self.word(at) {
            return Ok(());
        }
        self.at += first.len_utf8();
        let kind = match first {
            '\\' => return self.command(at),
            '&' => {
                if self.is_in_table() {
                    self.put(Kind::Cell, at);
                }
                return Ok(());
            }
            '%' => {
                self.at += self.rest().find('\n').unwrap_or(self.rest().len());
                return Ok(());
            }
            '$' | '~' => return Ok(()),
            _ if first.is_whitespace() => return Ok(()),
            _ if first.is_ascii_alphabetic() => Kind::Letter(first),
            _ if first.is_ascii_digit() => Kind::Digit(first),
            '*' if self.took("*") => Kind::Command("**"),
            '<' if self.took("=") => Kind::Command("le"),
            '>' if self.took("=") => Kind::Command("ge"),
            '!' if self.took("=") => Kind::Command("ne"),
            ':' if self.took("=") => Kind::Sign('='),
            '=' => {
                self.took("=");
                Kind::Sign('=')
            }
            ';' => Kind::Gap,
            '+' | '-' | ',' | '.' | '(' | ')' | '[' | ']' | '/' | '<' | '>' | '\'' | '^' | '_' | '{' | '}' | '*'
            | '|' => Kind::Sign(first),
            _ => {
                if let Some((_, kind)) = CHARACTERS.iter().find(|(all, _)| all.contains(first)) {
                    *kind
                } else {
                    return self.script(first, at);
                }
            }
        };
        self.put(kind, at);
        Ok(())
    }

    /// A run of small characters, as a superscript or a subscript in braces.
    fn script(&mut self, first: char, at: usize) -> Result<(), Error> {
        let on_line = |script: &str, c: char| {
            let place = script.chars().position(|small| small == c).filter(|place| place % 2 == 0)?;
            script.chars().nth(place + 1)
        };
        let (sign, script) = match [ABOVE, BELOW].map(|script| on_line(script, first).is_some()) {
            [true, _] => ('^', ABOVE),
            [_, true] => ('_', BELOW),
            _ => return Err(Error::new(at, format!("`{first}` is no mathematics that is read here"))),
        };
        self.at = at;
        self.put(Kind::Sign(sign), at);
        self.put(Kind::Sign('{'), at);
        while let Some(c) = self.rest().chars().next()
            && let Some(large) = on_line(script, c)
        {
            let kind = match large {
                '-' => Kind::Sign('-'),
                _ if large.is_ascii_digit() => Kind::Digit(large),
                _ => Kind::Letter(large),
            };
            self.put(kind, self.at);
            self.at += c.len_utf8();
        }
        self.put(Kind::Sign('}'), at);
        Ok(())
    }

    /// Reads a field, a Greek letter or a function that is written without a backslash, if one begins here.
    fn word(&mut self, at: usize) -> bool {
        let Some(fields) = self.fields else { return false };
        let run = |is_part: fn(char) -> bool| self.rest().find(|c| !is_part(c)).unwrap_or(self.rest().len());
        let (letters, digits, whole) = (
            run(|c| c.is_ascii_alphabetic()),
            run(|c| c.is_ascii_alphanumeric()),
            run(|c| c.is_ascii_alphanumeric() || c == '_'),
        );
        let cut = |length: usize| &self.rest()[..length];
        let is_inside = self.latex[..at].ends_with(|c: char| c.is_ascii_alphabetic());
        let (length, kind) = if letters == 0 || whole == 1 || is_inside {
            return false;
        } else if fields.contains(&cut(whole)) {
            (whole, Kind::Field(cut(whole)))
        } else if FUNCTIONS.contains(&cut(digits)) {
            (digits, Kind::Command(cut(digits)))
        } else if LETTERS.contains(&cut(letters)) || FUNCTIONS.contains(&cut(letters)) || cut(letters) == "Delta" {
            (letters, Kind::Command(cut(letters)))
        } else {
            return false;
        };
        self.put(kind, at);
        self.at += length;
        true
    }

    /// The token after a backslash.
    fn command(&mut self, at: usize) -> Result<(), Error> {
        let letters = self.rest().bytes().take_while(u8::is_ascii_alphabetic).count();
        let length = match self.rest().chars().next() {
            Some(single) if letters == 0 => single.len_utf8(),
            _ => letters,
        };
        let name = &self.rest()[..length];
        self.at += length;
        if TYPOGRAPHY.contains(&name) {
            return Ok(());
        }
        if SIZES.contains(&name) {
            self.bracket(name, at);
            return Ok(());
        }
        let kind = match name {
            "\\" => {
                if self.took("[") {
                    self.at += self.rest().find(']').map_or(0, |end| end + 1);
                }
                if self.is_in_table() { Kind::Row } else { Kind::Gap }
            }
            "text" | "textrm" | "textnormal" | "mbox" => Kind::Text(self.group(at)?),
            "label" | "tag" | "hspace" | "vspace" => {
                self.group(at)?;
                return Ok(());
            }
            "begin" | "end" => return self.environment(name == "begin", at),
            _ => SPELLINGS.iter().find(|(other, _)| *other == name).map_or(Kind::Command(name), |(_, kind)| *kind),
        };
        self.put(kind, at);
        Ok(())
    }

    /// A bracket after the command of its size; a bar opens or closes as that command says.
    fn bracket(&mut self, size: &str, at: usize) {
        let before = self.at;
        self.at += self.rest().len() - self.rest().trim_start().len();
        if self.took(".") {
            return;
        }
        let brace = self.at;
        if self.took(r"\{") && self.rest().trim_start().starts_with(r"\begin{array}") {
            return;
        }
        self.at = brace;
        let bar = [r"\|", r"\vert", r"\Vert", r"\lvert", r"\rvert", r"\lVert", r"\rVert", "|"];
        let is_bar = bar.iter().any(|bar| self.took(bar));
        let side = match size {
            "left" => Kind::Command("lvert"),
            "right" => Kind::Command("rvert"),
            _ if size.ends_with('l') => Kind::Command("lvert"),
            _ if size.ends_with('r') => Kind::Command("rvert"),
            _ => Kind::Sign('|'),
        };
        if is_bar {
            self.put(side, at);
        } else {
            self.at = before;
        }
    }

    fn environment(&mut self, is_begun: bool, at: usize) -> Result<(), Error> {
        let environment = self.group(at)?;
        let name = environment.trim_end_matches('*');
        let [begin, end] = match name {
            "cases" | "dcases" => [Kind::BeginCases, Kind::EndCases],
            "array" => {
                if is_begun && self.rest().starts_with('{') {
                    self.group(at)?;
                }
                [Kind::BeginCases, Kind::EndCases]
            }
            "matrix" | "pmatrix" | "bmatrix" | "Bmatrix" | "smallmatrix" => [Kind::BeginMatrix, Kind::EndMatrix],
            "aligned" | "align" | "split" | "gather" | "gathered" | "multline" | "eqnarray" | "equation"
            | "displaymath" | "math" | "subequations" => [Kind::Gap; 2],
            _ => {
                let known = "`cases`, `aligned`, `align`, `split`, `gather`, `equation` or `pmatrix`";
                return Err(Error::new(at, format!("the environment {environment} is not read: it is {known}")));
            }
        };
        let is_table = begin != Kind::Gap;
        if is_begun {
            self.tables.push(is_table);
        } else if self.tables.pop() != Some(is_table) {
            return Err(Error::new(at, format!("no environment {environment} was begun")));
        }
        self.put(if is_begun { begin } else { end }, at);
        Ok(())
    }

    /// The text between the following braces.
    fn group(&mut self, at: usize) -> Result<&'a str, Error> {
        let inside = self.rest().strip_prefix('{').and_then(|rest| rest.split_once('}'));
        let (content, _) = inside.ok_or_else(|| Error::new(at, "a group in braces must follow"))?;
        self.at += content.len() + 2;
        Ok(content)
    }
}
