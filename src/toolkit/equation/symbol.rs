//! The parser of symbols.

use super::cursor::Parser;
use super::error::Error;
use super::name::Name;
use super::token::{FUNCTIONS, Kind as Word, LETTERS};

/// Fonts in which vectors are written, and those without a meaning.
const BOLD: &[&str] = &["mathbf", "boldsymbol", "bm", "pmb", "vec", "mathbfit", "symbf", "symbfit", "overrightarrow"];
const UPRIGHT: &[&str] = &["mathit", "mathrm", "mathnormal", "mathsf", "textit", "operatorname", "underline"];
/// Marks over a letter, which belong to the symbol.
const ACCENTS: &[&str] = &["hat", "widehat", "bar", "overline", "tilde", "widetilde", "dot", "ddot", "check", "breve"];

impl Parser<'_> {
    /// Parses the longest symbol that begins here, with subscript, primes and a superscript that is not a power.
    pub(super) fn name(&mut self) -> Result<Option<Name>, Error> {
        let start = self.next;
        let change = self.change()?;
        let Some(mut name) = self.stem()? else {
            self.next = start;
            return Ok(None);
        };
        if name.change.is_empty() {
            name.change = change;
        }
        loop {
            if name.below.is_empty() && self.took_sign('_') {
                name.below = self.subscript()?;
            } else if self.took_sign('\'') || self.sees('^') && self.took_prime() {
                name.primes += 1;
            } else if name.above.is_empty() && self.sees('^') && self.is_word_above() {
                self.next += 1;
                name.above = self.superscript()?;
            } else {
                return Ok(Some(name));
            }
        }
    }

    /// `^{\prime}`
    fn took_prime(&mut self) -> bool {
        let start = self.next;
        self.next += 1;
        let braced = self.took_sign('{');
        let is_so = self.took_sign('\'') && (!braced || self.took_sign('}'));
        if !is_so {
            self.next = start;
        }
        is_so
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
        let start = self.next;
        if self.took(Word::Command("mathrm"))
            && self.took_sign('{')
            && self.took(Word::Letter('d'))
            && self.took_sign('}')
        {
            return Ok("d");
        }
        self.next = start;
        Ok("")
    }

    /// Whether a `\delta` here is a variation rather than a letter, since a symbol follows.
    fn is_variation(&self) -> bool {
        let next = self.tokens.get(self.next + 1).map(|token| token.kind);
        let begins = match next {
            Some(Word::Letter(_) | Word::Field(_)) => true,
            Some(Word::Command(word)) => {
                [LETTERS, BOLD, &["mathit", "mathrm", "Delta"]].iter().any(|all| all.contains(&word))
            }
            _ => false,
        };
        self.peek().kind == Word::Command("delta") && begins
    }

    /// Parses the letter itself.
    fn stem(&mut self) -> Result<Option<Name>, Error> {
        let token = self.peek();
        self.next += 1;
        match token.kind {
            Word::Letter(letter) => Ok(Some(Name::letter(letter))),
            Word::Command(letter) if LETTERS.contains(&letter) => Ok(Some(Name::letter(letter))),
            Word::Field(field) => Ok(self.known.field(field)),
            Word::Command(font) if BOLD.contains(&font) => Ok(Some(Name { bold: true, ..self.group()? })),
            Word::Command(font) if UPRIGHT.contains(&font) => self.group().map(Some),
            Word::Command(accent) if ACCENTS.contains(&accent) => {
                let name = self.group()?;
                Ok(Some(Name { base: format!("{accent} {}", name.base), ..name }))
            }
            Word::Text(word) if word.chars().all(|c| c.is_ascii_alphanumeric()) => Ok(Some(Name::letter(word))),
            _ => {
                self.next -= 1;
                Ok(None)
            }
        }
    }

    /// Parses what a font applies to: a letter, several letters in braces, or a symbol in braces.
    fn group(&mut self) -> Result<Name, Error> {
        let none = "a letter was expected here";
        if !self.sees('{') {
            let at = self.peek().at;
            return self.stem()?.ok_or_else(|| Error::new(at, none));
        }
        let start = self.next;
        if let Ok(word) = self.word()
            && !word.is_empty()
        {
            return Ok(Name::letter(word));
        }
        self.next = start + 1;
        let name = self.name()?.ok_or_else(|| Error::new(self.peek().at, none))?;
        self.expect('}')?;
        Ok(name)
    }

    /// Parses one letter, or a group of letters, digits, commas and upright words.
    fn subscript(&mut self) -> Result<Vec<String>, Error> {
        if let Some(script) = self.known.script(&self.run(self.next)).map(str::to_owned) {
            self.next += script.len();
            return Ok(vec![script]);
        }
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
            Word::Text(word) if word.trim().chars().all(char::is_alphanumeric) => Ok(word.trim().into()),
            Word::Command("mathrm" | "mathit" | "mathsf" | "mathnormal" | "operatorname" | "textit") => {
                if self.sees('{') { self.word() } else { self.piece() }
            }
            Word::Field(word) | Word::Command(word @ ("min" | "max" | "times" | "perp")) => Ok(word.into()),
            Word::Command(letter) if LETTERS.contains(&letter) || FUNCTIONS.contains(&letter) => Ok(letter.into()),
            _ => Err(Error::new(token.at, "a letter, a digit or an upright word was expected in this subscript")),
        }
    }

    /// Whether the superscript here is a word or a lone minus rather than a power.
    fn is_word_above(&self) -> bool {
        let after = |k: usize| self.tokens.get(self.next + k).map(|token| token.kind);
        let is_word = |kind| {
            let fonts = ["mathrm", "mathit", "mathsf", "mathnormal", "operatorname", "textit", "min", "max"];
            matches!(kind, Some(Word::Text(_))) || matches!(kind, Some(Word::Command(word)) if fonts.contains(&word))
        };
        let lone_minus = after(1) == Some(Word::Sign('-')) && !matches!(after(2), Some(Word::Digit(_)));
        let braced = usize::from(after(1) == Some(Word::Sign('{')));
        // The superscript of a symbol that there is: `F_C^{int}`.
        let is_known = self.known.script(&self.run(self.next + 1 + braced)).is_some();
        is_word(after(1 + braced)) || lone_minus || is_known
    }

    fn superscript(&mut self) -> Result<String, Error> {
        if self.took_sign('-') {
            return Ok("-".into());
        }
        let braced = self.took_sign('{');
        let script = self.known.script(&self.run(self.next)).map(str::to_owned);
        let word = match script {
            Some(script) => {
                self.next += script.len();
                script
            }
            None => self.piece()?,
        };
        if braced {
            self.expect('}')?;
        }
        Ok(word)
    }
}
