//! A position among the tokens of an equation.

use super::error::Error;
use super::name::Name;
use super::token::{FUNCTIONS, Kind as Word, Token};
use crate::formula::Field;

/// Parses the tokens of one equation.
pub(super) struct Parser<'a> {
    pub(super) tokens: Vec<Token<'a>>,
    pub(super) next: usize,
    /// Names that are functions if a bracket follows.
    pub(super) functions: Vec<Name>,
    pub(super) known: Vocabulary,
    /// The bars that are open since the last bracket or brace.
    pub(super) bars: usize,
}

/// What somebody who writes about a formula may call its inputs and outputs, apart from their symbols.
#[derive(Clone, Debug, Default)]
pub(super) struct Vocabulary {
    /// Their names in code.
    pub(super) fields: Vec<(&'static str, Name)>,
    /// The subscripts and superscripts of their symbols, which need no braces: `F_axial1`.
    pub(super) scripts: Vec<String>,
}

impl Vocabulary {
    /// Of fields with these symbols.
    pub(super) fn of(named: &[(Name, Field)]) -> Self {
        Self {
            fields: named.iter().map(|(name, field)| (field.name, name.clone())).collect(),
            scripts: named.iter().flat_map(|(name, _)| [name.below.concat(), name.above.clone()]).collect(),
        }
    }

    /// The longest script of more than one character with which this text begins.
    pub(super) fn script(&self, text: &str) -> Option<&str> {
        let begins = |script: &&String| script.len() > 1 && text.starts_with(script.as_str());
        self.scripts.iter().filter(begins).max_by_key(|script| script.len()).map(String::as_str)
    }

    /// The symbol of a field.
    pub(super) fn field(&self, field: &str) -> Option<Name> {
        self.fields.iter().find(|(known, _)| *known == field).map(|(_, name)| name.clone())
    }
}

impl<'a> Parser<'a> {
    pub(super) fn new(tokens: Vec<Token<'a>>) -> Self {
        Self { tokens, next: 0, functions: Vec::new(), known: Vocabulary::default(), bars: 0 }
    }

    pub(super) fn peek(&self) -> Token<'a> {
        self.tokens[self.next.min(self.tokens.len() - 1)]
    }

    pub(super) fn take(&mut self) -> Token<'a> {
        let token = self.peek();
        self.next += 1;
        token
    }

    /// The letters and digits from a token on, without a space between them.
    pub(super) fn run(&self, from: usize) -> String {
        let tokens = self.tokens.get(from..).unwrap_or_default();
        let together = tokens.iter().enumerate().take_while(|(k, token)| token.at == tokens[0].at + k);
        let letter = |token: &Token<'_>| if let Word::Letter(c) | Word::Digit(c) = token.kind { Some(c) } else { None };
        together.map_while(|(_, token)| letter(token)).collect()
    }

    pub(super) fn sees(&self, sign: char) -> bool {
        self.peek().kind == Word::Sign(sign)
    }

    /// Consumes the next token if it is this one, and returns whether it was.
    pub(super) fn took(&mut self, kind: Word<'_>) -> bool {
        let is_so = self.peek().kind == kind;
        self.next += usize::from(is_so);
        is_so
    }

    pub(super) fn took_sign(&mut self, sign: char) -> bool {
        self.took(Word::Sign(sign))
    }

    pub(super) fn expect(&mut self, sign: char) -> Result<(), Error> {
        if self.took_sign(sign) { Ok(()) } else { Err(self.expected(&format!("`{sign}`"))) }
    }

    /// An error that `what` was expected here.
    pub(super) fn expected(&self, what: &str) -> Error {
        Error::new(self.peek().at, format!("{what} was expected here"))
    }

    /// Parses letters and digits in braces.
    pub(super) fn word(&mut self) -> Result<String, Error> {
        self.expect('{')?;
        let mut word = String::new();
        loop {
            match self.peek().kind {
                Word::Letter(c) | Word::Digit(c) => word.push(c),
                Word::Field(part) => word += part,
                // Without its backslash, as in `\operatorname{sign}`.
                Word::Command(part) if FUNCTIONS.contains(&part) => word += part,
                _ => break,
            }
            self.next += 1;
        }
        self.expect('}')?;
        Ok(word)
    }

    /// Parses digits as a number, and returns ten to the power of their count too.
    pub(super) fn digits(&mut self) -> (f64, f64) {
        let (mut value, mut scale) = (0.0, 1.0);
        while let Word::Digit(digit) = self.peek().kind {
            value = value * 10.0 + digit.to_digit(10).map_or(f64::NAN, f64::from);
            scale *= 10.0;
            self.next += 1;
        }
        (value, scale)
    }

    /// Parses a natural number.
    pub(super) fn integer(&mut self) -> Result<usize, Error> {
        if !matches!(self.peek().kind, Word::Digit(_)) {
            return Err(self.expected("a whole number"));
        }
        let value = self.digits().0;
        (0..100)
            .find(|&k| super::syntax::small(k) == value)
            .ok_or_else(|| self.expected("a number below 100 before this"))
    }
}
