//! The parser of expressions.

use super::cursor::Parser;
use super::error::Error;
use super::name::Name;
use super::syntax::{Condition, Expr, Function, Kind, Operator, Relation};
use super::token::{Kind as Word, Token};

impl Parser<'_> {
    /// Parses sums of terms.
    pub(super) fn expression(&mut self) -> Result<Expr, Error> {
        let mut sum = self.term()?;
        loop {
            let at = self.peek().at;
            let operator = match self.peek().kind {
                Word::Sign('+') => Operator::Add,
                Word::Sign('-') => Operator::Subtract,
                _ => return Ok(sum),
            };
            self.next += 1;
            sum = binary(operator, sum, self.term()?, at);
        }
    }

    /// Parses products and quotients, from left to right. A sign applies to all of the term.
    fn term(&mut self) -> Result<Expr, Error> {
        let at = self.peek().at;
        if self.took_sign('-') {
            return Ok(Expr { kind: Kind::Negative(Box::new(self.term()?)), at });
        }
        let mut product = self.factor()?;
        let mut divided = false;
        loop {
            let at = self.peek().at;
            let operator = match self.peek().kind {
                Word::Command("cdot") => Operator::Dot,
                Word::Command("times") => Operator::Cross,
                Word::Command("otimes") => Operator::Outer,
                Word::Sign('/') => Operator::Divide,
                _ if self.begins_factor() => Operator::Times,
                _ => return Ok(product),
            };
            if divided {
                return Err(Error::new(at, "what follows a slash and its divisor is read in two ways: use a fraction"));
            }
            divided = operator == Operator::Divide;
            self.next += usize::from(operator != Operator::Times);
            let factor = self.factor()?;
            if let (Operator::Times, Kind::Number(_)) = (operator, &factor.kind) {
                return Err(Error::new(at, "a number side by side with a factor before it: write it first"));
            }
            product = binary(operator, product, factor, at);
        }
    }

    fn begins_factor(&self) -> bool {
        match self.peek().kind {
            // `(k = 1, 3)` is a range.
            Word::Sign('(') => self.tokens.get(self.next + 2).is_none_or(|token| token.kind != Word::Sign('=')),
            Word::Letter(_) | Word::Digit(_) | Word::Sign('[') | Word::BeginCases => true,
            Word::Command(name) => !matches!(name, "rvert" | "le" | "ge" | "ne" | "cdot" | "times" | "otimes"),
            _ => false,
        }
    }

    /// Parses a factor with its powers.
    fn factor(&mut self) -> Result<Expr, Error> {
        let mut factor = self.base()?;
        while self.sees('^') {
            let at = self.take().at;
            let power = self.argument()?;
            factor = Expr { kind: Kind::Power(Box::new(factor), Box::new(power)), at };
        }
        Ok(factor)
    }

    /// Parses the argument of a command: a group, or a single letter or digit.
    fn argument(&mut self) -> Result<Expr, Error> {
        let Token { kind, at } = self.peek();
        match kind {
            Word::Sign('{') => {
                self.next += 1;
                let inside = self.expression()?;
                self.expect('}')?;
                Ok(inside)
            }
            Word::Digit(digit) => {
                self.next += 1;
                Ok(Expr { kind: Kind::Number(digit.to_digit(10).map_or(f64::NAN, f64::from)), at })
            }
            Word::Letter(letter) => {
                self.next += 1;
                Ok(Expr { kind: Kind::Symbol(Name::letter(letter)), at })
            }
            _ => Err(self.expected("a group in braces, a letter or a digit")),
        }
    }

    fn base(&mut self) -> Result<Expr, Error> {
        let Token { kind, at } = self.peek();
        let kind = match kind {
            Word::Digit(_) => self.number()?,
            Word::Sign('(') => self.bracket(')')?,
            Word::Sign('[') => self.bracket(']')?,
            Word::BeginCases => self.cases()?,
            Word::Command(command) => match self.command(command, at)? {
                Some(kind) => kind,
                None => self.symbol()?,
            },
            _ => self.symbol()?,
        };
        Ok(Expr { kind, at })
    }

    /// Parses a symbol, or a declared function with arguments.
    fn symbol(&mut self) -> Result<Kind, Error> {
        let Some(name) = self.name()? else { return Err(self.expected("a number, a symbol or a bracket")) };
        if !self.sees('(') || !self.functions.iter().any(|declared| name.is_like(declared)) {
            return Ok(Kind::Symbol(name));
        }
        self.next += 1;
        Ok(Kind::Apply(name, self.list(')')?))
    }

    /// Parses expressions separated by commas, and the closing bracket.
    fn list(&mut self, close: char) -> Result<Vec<Expr>, Error> {
        let mut all = vec![self.expression()?];
        while self.took_sign(',') {
            all.push(self.expression()?);
        }
        self.expect(close)?;
        Ok(all)
    }

    fn bracket(&mut self, close: char) -> Result<Kind, Error> {
        self.next += 1;
        let mut all = self.list(close)?;
        Ok(if all.len() == 1 { all.swap_remove(0).kind } else { Kind::Tuple(all) })
    }

    /// Parses adjacent digits, and decimals.
    fn number(&mut self) -> Result<Kind, Error> {
        let whole = self.digits();
        if !self.took_sign('.') {
            return Ok(Kind::Number(whole.0));
        }
        if !matches!(self.peek().kind, Word::Digit(_)) {
            return Err(self.expected("a decimal"));
        }
        let (decimals, scale) = self.digits();
        let at = self.peek().at;
        let number = |value| Box::new(Expr { kind: Kind::Number(value), at });
        Ok(Kind::Binary(Operator::Divide, number(whole.0 * scale + decimals), number(scale)))
    }

    /// Parses what a command begins; `None` if it begins a symbol.
    fn command(&mut self, command: &str, at: usize) -> Result<Option<Kind>, Error> {
        let start = self.next;
        self.next += 1;
        let call = |function, arguments| Ok(Some(Kind::Call(function, arguments)));
        match command {
            "frac" | "tfrac" | "dfrac" => {
                if let Some(partial) = self.partial()? {
                    return Ok(Some(partial));
                }
                let (above, below) = (self.argument()?, self.argument()?);
                Ok(Some(binary(Operator::Divide, above, below, at).kind))
            }
            "sqrt" => call(Function::Sqrt, vec![self.argument()?]),
            "sin" => self.trigonometric(Function::Sin).map(Some),
            "cos" => self.trigonometric(Function::Cos).map(Some),
            "arcsin" => call(Function::ArcSin, vec![self.single_argument()?]),
            "max" => self.largest(at).map(Some),
            "operatorname" => self.operator().map(Some),
            "lvert" => {
                let inside = self.expression()?;
                if !self.took(Word::Command("rvert")) {
                    return Err(self.expected("`\\rvert`"));
                }
                Ok(Some(Kind::Size(Box::new(inside))))
            }
            "sum" => self.sum().map(Some),
            _ => {
                self.next = start;
                Ok(None)
            }
        }
    }

    /// Parses `{\partial a}{\partial x}` after the command of a fraction.
    fn partial(&mut self) -> Result<Option<Kind>, Error> {
        let start = self.next;
        if !(self.took_sign('{') && self.took(Word::Command("partial"))) {
            self.next = start;
            return Ok(None);
        }
        let of = self.factor()?;
        self.expect('}')?;
        self.expect('{')?;
        if !self.took(Word::Command("partial")) {
            return Err(self.expected("`\\partial`"));
        }
        let by = self.name()?.ok_or_else(|| self.expected("the symbol of an input"))?;
        self.expect('}')?;
        Ok(Some(Kind::Partial(Box::new(of), by)))
    }

    /// `\cos\beta`, `\cos^2\beta`
    fn trigonometric(&mut self, function: Function) -> Result<Kind, Error> {
        let at = self.peek().at;
        let power = if self.took_sign('^') { Some(self.argument()?) } else { None };
        let call = Kind::Call(function, vec![self.single_argument()?]);
        Ok(match power {
            Some(power) => Kind::Power(Box::new(Expr { kind: call, at }), Box::new(power)),
            None => call,
        })
    }

    /// Parses the argument of a function without brackets: a symbol, or an expression in brackets.
    fn single_argument(&mut self) -> Result<Expr, Error> {
        match self.peek().kind {
            Word::Digit(_) => Err(self.expected("a bracket around the argument")),
            _ => self.base(),
        }
    }

    /// `\max(a, b)`
    fn largest(&mut self, at: usize) -> Result<Kind, Error> {
        self.expect('(')?;
        let Ok([a, b]) = <[Expr; 2]>::try_from(self.list(')')?) else {
            return Err(Error::new(at, "max has 2 arguments"));
        };
        let is_first = vec![(a.clone(), Relation::GreaterOrEqual, b.clone())];
        Ok(Kind::Cases(vec![(a, is_first), (b, Vec::new())]))
    }

    /// Parses `\operatorname{…}` and its arguments.
    fn operator(&mut self) -> Result<Kind, Error> {
        let at = self.peek().at;
        let name = self.word()?;
        match name.as_str() {
            "sign" => Ok(Kind::Call(Function::Sign, vec![self.single_argument()?])),
            "round" => Ok(Kind::Call(Function::Round, vec![self.single_argument()?])),
            "atan2" => {
                self.expect('(')?;
                match self.list(')')? {
                    two if two.len() == 2 => Ok(Kind::Call(Function::Atan2, two)),
                    other => Err(Error::new(at, format!("atan2 has 2 arguments, not {}", other.len()))),
                }
            }
            _ => Err(Error::new(at, format!("the function {name} is not known: there are sign, round and atan2"))),
        }
    }

    /// `\begin{cases} value & condition \\ … \end{cases}`.
    fn cases(&mut self) -> Result<Kind, Error> {
        self.next += 1;
        let mut rows = Vec::new();
        loop {
            let value = self.expression()?;
            if !self.took(Word::Cell) {
                return Err(self.expected("`&` and a condition"));
            }
            rows.push((value, self.condition()?));
            if self.took(Word::Row) {
                continue;
            }
            if self.took(Word::EndCases) {
                return Ok(Kind::Cases(rows));
            }
            return Err(self.expected("the end of the cases"));
        }
    }

    fn condition(&mut self) -> Result<Condition, Error> {
        let mut all = Vec::new();
        if let Word::Text(words) = self.peek().kind {
            self.next += 1;
            return if words == "otherwise" { Ok(all) } else { Err(self.expected("`\\text{otherwise}`")) };
        }
        loop {
            let mut left = self.expression()?;
            let Some(mut relation) = self.relation() else { return Err(self.expected("a comparison")) };
            loop {
                let right = self.expression()?;
                all.push((left, relation, right.clone()));
                match self.relation() {
                    Some(next) => (left, relation) = (right, next),
                    None => break,
                }
            }
            if !self.took_sign(',') {
                return Ok(all);
            }
        }
    }

    pub(super) fn relation(&mut self) -> Option<Relation> {
        let relation = match self.peek().kind {
            Word::Sign('<') => Relation::Less,
            Word::Sign('>') => Relation::Greater,
            Word::Sign('=') => Relation::Equal,
            Word::Command("le") => Relation::LessOrEqual,
            Word::Command("ge") => Relation::GreaterOrEqual,
            Word::Command("ne") => Relation::Unequal,
            _ => return None,
        };
        self.next += 1;
        Some(relation)
    }

    /// Parses `\sum_{q=1}^{5}` and the product after it.
    fn sum(&mut self) -> Result<Kind, Error> {
        self.expect('_')?;
        self.expect('{')?;
        let Word::Letter(index) = self.take().kind else { return Err(self.expected("an index and its first value")) };
        self.expect('=')?;
        let from = self.integer()?;
        self.expect('}')?;
        self.expect('^')?;
        let braced = self.took_sign('{');
        let to = self.integer()?;
        if braced {
            self.expect('}')?;
        }
        Ok(Kind::Sum { index: index.into(), from, to, body: Box::new(self.term()?) })
    }
}

fn binary(operator: Operator, left: Expr, right: Expr, at: usize) -> Expr {
    Expr { kind: Kind::Binary(operator, Box::new(left), Box::new(right)), at }
}
