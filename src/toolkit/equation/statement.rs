//! Statements: definitions, ranges, remarks.

use super::cursor::{Parser, Vocabulary};
use super::error::Error;
use super::name::Name;
use super::syntax::{ArgMin, Body, Expr, Kind, Statement};
use super::token::{Kind as Word, Token, plain, tokens};

/// The definitions of an equation, with families expanded.
pub(super) fn statements(latex: &str, functions: Vec<Name>) -> Result<Vec<Statement>, Error> {
    all(Parser { functions, ..Parser::new(tokens(latex)?) }, Parser::statement)
}

/// The statements of prose: sides that are equal or ordered, with families expanded.
pub(super) fn chains(latex: &str, functions: Vec<Name>) -> Result<Vec<Statement>, Error> {
    all(Parser { functions, ..Parser::new(tokens(latex)?) }, Parser::chain)
}

/// The definitions of an equation that somebody has written about a formula, in LaTeX or as plain text.
pub(super) fn written(latex: &str, functions: Vec<Name>, known: &Vocabulary) -> Result<Vec<Statement>, Error> {
    all(informed(latex, functions, known)?, Parser::statement)
}

/// The relations that somebody has written about a formula.
pub(super) fn relations(latex: &str, functions: Vec<Name>, known: &Vocabulary) -> Result<Vec<Statement>, Error> {
    all(informed(latex, functions, known)?, Parser::chain)
}

fn informed<'l>(latex: &'l str, functions: Vec<Name>, known: &Vocabulary) -> Result<Parser<'l>, Error> {
    let fields: Vec<_> = known.fields.iter().map(|(field, _)| *field).collect();
    Ok(Parser { functions, known: known.clone(), ..Parser::new(plain(latex, &fields)?) })
}

fn all<'l>(
    mut parser: Parser<'l>,
    one: impl Fn(&mut Parser<'l>) -> Result<Statement, Error>,
) -> Result<Vec<Statement>, Error> {
    parser.declare();
    let mut all = Vec::new();
    loop {
        while parser.took(Word::Gap) || parser.took_sign(',') {}
        let Token { kind, at } = parser.peek();
        match kind {
            Word::End => return Ok(all.into_iter().flat_map(apart).collect()),
            Word::Text(words) => {
                parser.next += 1;
                check_remark(words, at)?;
            }
            _ => match parser.range()? {
                Some(range) => all = range.applied_to(all)?,
                None => all.push(one(&mut parser)?),
            },
        }
        if !matches!(parser.peek().kind, Word::Gap | Word::End | Word::Sign(',' | '(') | Word::Text(_)) {
            return Err(parser.expected("an operator, a comma or `\\quad`"));
        }
    }
}

/// Symbols separated by commas, each perhaps a function of parameters: `\mathbf{X}(g),\ \mathbf{t}`.
pub(super) fn symbols(latex: &str) -> Result<Vec<(Name, Vec<Name>)>, Error> {
    let mut parser = Parser::new(plain(latex, &[])?);
    let mut all = Vec::new();
    loop {
        let Some(name) = parser.name()? else { return Err(parser.expected("a symbol")) };
        let parameters = if parser.sees('(') { parser.names()? } else { Vec::new() };
        all.push((name, parameters));
        match parser.take().kind {
            Word::End => return Ok(all),
            Word::Sign(',') => {}
            _ => return Err(parser.expected("a comma before this")),
        }
    }
}

/// Checks that a remark consists of words only: anything mathematical would go unchecked.
fn check_remark(words: &str, at: usize) -> Result<(), Error> {
    match words.chars().find(|c| !(c.is_alphabetic() || c.is_whitespace() || ".,;:".contains(*c))) {
        None => Ok(()),
        Some(c) => Err(Error::new(at, format!("a remark holds words only, not `{c}`: mathematics is executed"))),
    }
}

/// The values of an index.
struct Range {
    index: String,
    values: Vec<usize>,
    at: usize,
}

impl Range {
    /// Expands statements that have the index.
    fn applied_to(&self, statements: Vec<Statement>) -> Result<Vec<Statement>, Error> {
        if !statements.iter().any(|statement| statement.has_index(&self.index)) {
            return Err(Error::new(self.at, format!("no statement before this has the index {}", self.index)));
        }
        let family = |statement: Statement| {
            if !statement.has_index(&self.index) {
                return vec![statement];
            }
            self.values.iter().map(|&value| statement.with_index(&self.index, value)).collect()
        };
        Ok(statements.into_iter().flat_map(family).collect())
    }
}

impl Parser<'_> {
    /// Finds the functions that the equation declares, `r(g) = …`, before the rest is parsed.
    fn declare(&mut self) {
        for start in 0..self.tokens.len() {
            let begins = start == 0 || matches!(self.tokens[start - 1].kind, Word::Gap | Word::Sign(','));
            self.next = start;
            if begins
                && let Ok(Some(name)) = self.name()
                && self.sees('(')
                && self.names().is_ok()
                && self.sees('=')
            {
                self.functions.push(name);
            }
        }
        self.next = 0;
    }

    /// Parses `i = 1, 2, 3`, with or without brackets.
    fn range(&mut self) -> Result<Option<Range>, Error> {
        let (start, at) = (self.next, self.peek().at);
        let bracket = self.took_sign('(');
        let Word::Letter(index) = self.take().kind else {
            self.next = start;
            return Ok(None);
        };
        let mut values = Vec::new();
        if self.took_sign('=') && matches!(self.peek().kind, Word::Digit(_)) {
            values.push(self.integer()?);
            while self.sees(',') && matches!(self.tokens.get(self.next + 1).map(|t| t.kind), Some(Word::Digit(_))) {
                self.next += 1;
                values.push(self.integer()?);
            }
        }
        if values.len() < 2 || (bracket && !self.took_sign(')')) {
            self.next = start;
            return Ok(None);
        }
        Ok(Some(Range { index: index.into(), values, at }))
    }

    /// `(g, h)`
    fn names(&mut self) -> Result<Vec<Name>, Error> {
        self.expect('(')?;
        let mut all = Vec::new();
        loop {
            all.push(self.name()?.ok_or_else(|| self.expected("a symbol"))?);
            if !self.took_sign(',') {
                self.expect(')')?;
                return Ok(all);
            }
        }
    }

    fn statement(&mut self) -> Result<Statement, Error> {
        let at = self.peek().at;
        let (names, parameters) = if self.sees('(') {
            (self.names()?, Vec::new())
        } else {
            let name = self.name()?.ok_or_else(|| self.expected("a symbol that is defined"))?;
            (vec![name], if self.sees('(') { self.names()? } else { Vec::new() })
        };
        self.expect('=')?;
        let body = match self.peek().kind {
            Word::Command("operatorname") if self.took_arg_min() => self.arg_min(&names)?,
            _ => {
                let mut sides = vec![self.expression()?];
                while self.took_sign('=') {
                    sides.push(self.expression()?);
                }
                Body::Equal(sides)
            }
        };
        Ok(Statement { names, parameters, body, at })
    }

    /// `a = b \le c`, of expressions.
    fn chain(&mut self) -> Result<Statement, Error> {
        let at = self.peek().at;
        let first = self.expression()?;
        let mut rest = Vec::new();
        while let Some(relation) = self.relation() {
            rest.push((relation, self.expression()?));
        }
        Ok(Statement { names: Vec::new(), parameters: Vec::new(), body: Body::Chain(first, rest), at })
    }

    /// `\operatorname*{arg\,min}`
    fn took_arg_min(&mut self) -> bool {
        let start = self.next;
        self.next += 1;
        let is_so = self.took_sign('*') && self.word().is_ok_and(|word| word == "argmin");
        if !is_so {
            self.next = start;
        }
        is_so
    }

    /// `_{-1 \le g \le 1} objective`
    fn arg_min(&mut self, names: &[Name]) -> Result<Body, Error> {
        self.expect('_')?;
        self.expect('{')?;
        let low = self.expression()?;
        let at = self.peek().at;
        let first = self.relation();
        let name = self.name()?;
        let second = self.relation();
        let high = self.expression()?;
        self.expect('}')?;
        let at_most = Some(super::syntax::Relation::LessOrEqual);
        if (first, second) != (at_most, at_most) || name.as_ref() != names.first() || names.len() != 1 {
            return Err(Error::new(
                at,
                "the defined symbol between its bounds was expected here, as in `0 \\le t \\le 1`",
            ));
        }
        let objective = self.expression()?;
        Ok(Body::ArgMin(Box::new(ArgMin { low, high, objective })))
    }
}

/// Splits the definition of a tuple of names into one definition each.
pub(super) fn apart(statement: Statement) -> Vec<Statement> {
    let ([_, _, ..], Body::Equal(sides)) = (&statement.names[..], &statement.body) else {
        return vec![statement];
    };
    let definition = |(k, name): (usize, &Name)| Statement {
        names: vec![name.clone()],
        body: Body::Equal(sides.iter().map(|side| item(side, k)).collect()),
        ..statement.clone()
    };
    statement.names.iter().enumerate().map(definition).collect()
}

fn item(tuple: &Expr, k: usize) -> Expr {
    let kind = match &tuple.kind {
        Kind::Tuple(items) if k < items.len() => items[k].kind.clone(),
        _ => Kind::Item(Box::new(tuple.clone()), k),
    };
    Expr { kind, at: tuple.at }
}
