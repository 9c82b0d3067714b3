//! A position among the tokens of an equation.

use super::error::Error;
use super::name::Name;
use super::token::{Kind as Word, Token};

/// Parses the tokens of one equation.
pub(super) struct Parser<'a> {
    pub(super) tokens: Vec<Token<'a>>,
    pub(super) next: usize,
    /// Names that are functions if a bracket follows.
    pub(super) functions: Vec<Name>,
}

impl<'a> Parser<'a> {
    pub(super) fn peek(&self) -> Token<'a> {
        self.tokens[self.next.min(self.tokens.len() - 1)]
    }

    pub(super) fn take(&mut self) -> Token<'a> {
        let token = self.peek();
        self.next += 1;
        token
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
        while let Word::Letter(c) | Word::Digit(c) = self.peek().kind {
            word.push(c);
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
