//! The parser of symbols.

use super::cursor::Parser;
use super::error::Error;
use super::name::Name;
use super::token::Kind as Word;

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

impl Parser<'_> {
    /// Parses the longest symbol that begins here, with subscript, primes and a superscript that is not a power.
    pub(super) fn name(&mut self) -> Result<Option<Name>, Error> {
        let start = self.next;
        let change = self.change()?;
        let Some(mut name) = self.stem()? else {
            self.next = start;
            return Ok(None);
        };
        name.change = change;
        loop {
            if name.below.is_empty() && self.took_sign('_') {
                name.below = self.subscript()?;
            } else if self.took_sign('\'') {
                name.primes += 1;
            } else if name.above.is_empty() && self.sees('^') && self.is_word_above() {
                self.next += 1;
                name.above = self.superscript()?;
            } else {
                return Ok(Some(name));
            }
        }
    }

    /// Parses `\delta`, `\mathrm{d}` or `\Delta` before a symbol.
    fn change(&mut self) -> Result<&'static str, Error> {
        if self.is_variation() {
            self.next += 1;
            return Ok(match self.change()? {
                "d" => "δd",
                "Δ" => "δΔ",
                _ => "δ",
            });
        }
        if self.took(Word::Command("Delta")) {
            return Ok("Δ");
        }
        if !self.took(Word::Command("mathrm")) {
            return Ok("");
        }
        if self.word()? == "d" { Ok("d") } else { Err(self.expected("only the d of a differential is upright:")) }
    }

    /// Whether a `\delta` here is a variation rather than a letter, since a symbol follows.
    fn is_variation(&self) -> bool {
        let next = self.tokens.get(self.next + 1).map(|token| token.kind);
        let begins = match next {
            Some(Word::Letter(_)) => true,
            Some(Word::Command(word)) => {
                LETTERS.contains(&word) || ["mathbf", "boldsymbol", "mathit", "mathrm", "Delta"].contains(&word)
            }
            _ => false,
        };
        self.peek().kind == Word::Command("delta") && begins
    }

    /// Parses the letter itself.
    fn stem(&mut self) -> Result<Option<Name>, Error> {
        let token = self.peek();
        let (base, bold) = match token.kind {
            Word::Letter(letter) => {
                self.next += 1;
                (letter.to_string(), false)
            }
            Word::Command(letter) if LETTERS.contains(&letter) => {
                self.next += 1;
                (letter.to_string(), false)
            }
            Word::Command(font @ ("mathbf" | "mathit")) => {
                self.next += 1;
                (self.word()?, font == "mathbf")
            }
            Word::Command("boldsymbol") => {
                self.next += 1;
                (self.greek()?, true)
            }
            _ => return Ok(None),
        };
        Ok(Some(Name { bold, base, ..Name::default() }))
    }

    /// Parses a Greek letter in braces.
    fn greek(&mut self) -> Result<String, Error> {
        self.expect('{')?;
        let token = self.take();
        let Word::Command(letter) = token.kind else {
            return Err(Error::new(token.at, "a Greek letter was expected here; others are bold by `\\mathbf`"));
        };
        self.expect('}')?;
        Ok(letter.into())
    }

    /// Parses one letter, or a group of letters, digits, commas and upright words.
    fn subscript(&mut self) -> Result<Vec<String>, Error> {
        if !self.took_sign('{') {
            return Ok(vec![self.piece()?]);
        }
        let mut pieces = Vec::new();
        while !self.took_sign('}') {
            pieces.push(if self.took_sign(',') { ",".into() } else { self.piece()? });
        }
        Ok(pieces)
    }

    fn piece(&mut self) -> Result<String, Error> {
        let token = self.take();
        match token.kind {
            Word::Letter(c) | Word::Digit(c) => Ok(c.to_string()),
            Word::Command("mathrm") => self.word(),
            Word::Command(word @ ("min" | "max" | "times" | "perp")) => Ok(word.into()),
            Word::Command(letter) if LETTERS.contains(&letter) => Ok(letter.into()),
            _ => Err(Error::new(token.at, "a letter, a digit or an upright word was expected in this subscript")),
        }
    }

    /// Whether the superscript here is a word or a lone minus rather than a power.
    fn is_word_above(&self) -> bool {
        let after = |k: usize| self.tokens.get(self.next + k).map(|token| token.kind);
        let is_word = |kind| matches!(kind, Some(Word::Command("mathrm" | "min" | "max")));
        let lone_minus = after(1) == Some(Word::Sign('-'));
        is_word(after(1)) || lone_minus || after(1) == Some(Word::Sign('{')) && is_word(after(2))
    }

    fn superscript(&mut self) -> Result<String, Error> {
        if self.took_sign('-') {
            return Ok("-".into());
        }
        let braced = self.took_sign('{');
        let word = self.piece()?;
        if braced {
            self.expect('}')?;
        }
        Ok(word)
    }
}
