//! The parser of expressions.

use super::call::power_of;
use super::cursor::Parser;
use super::error::Error;
use super::name::Name;
use super::syntax::{Condition, Expr, Kind, Operator, Relation, binary};
use super::token::{FUNCTIONS, Kind as Word, Token};

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
        // A leading plus has no meaning.
        self.took_sign('+');
        let mut product = self.factor()?;
        let mut divided = false;
        loop {
            let at = self.peek().at;
            let (operator, is_written) = match self.peek().kind {
                Word::Command("cdot") => (Operator::Dot, true),
                Word::Command("times") => (Operator::Cross, true),
                Word::Command("otimes") => (Operator::Outer, true),
                Word::Sign('*') => (Operator::Times, true),
                Word::Sign('/') => (Operator::Divide, true),
                _ if self.begins_factor() => (Operator::Times, false),
                _ => return Ok(product),
            };
            // With an asterisk it is code, which is read from left to right.
            if divided && self.peek().kind != Word::Sign('*') {
                return Err(Error::new(at, "what follows a slash and its divisor is read in two ways: use a fraction"));
            }
            divided = operator == Operator::Divide;
            self.next += usize::from(is_written);
            let factor = self.factor()?;
            if let (false, Kind::Number(_)) = (is_written, &factor.kind) {
                return Err(Error::new(at, "a number side by side with a factor before it: write it first"));
            }
            product = binary(operator, product, factor, at);
        }
    }

    fn begins_factor(&self) -> bool {
        match self.peek().kind {
            // `(k = 1, 3)` is a range.
            Word::Sign('(') => self.tokens.get(self.next + 2).is_none_or(|token| token.kind != Word::Sign('=')),
            Word::Letter(_)
            | Word::Digit(_)
            | Word::Field(_)
            | Word::Sign('[')
            | Word::BeginCases
            | Word::BeginMatrix => true,
            // Between bars another one closes them.
            Word::Sign('|') => self.bars == 0,
            Word::Command(name) => !matches!(name, "rvert" | "le" | "ge" | "ne" | "cdot" | "times" | "otimes" | "**"),
            _ => false,
        }
    }

    /// Parses a factor with its powers.
    fn factor(&mut self) -> Result<Expr, Error> {
        let mut factor = self.base()?;
        loop {
            let at = self.peek().at;
            let power = match self.peek().kind {
                Word::Sign('^') => {
                    self.next += 1;
                    if self.sees('(') { self.base()? } else { self.argument()? }
                }
                Word::Command("**") => {
                    self.next += 1;
                    let negative = self.took_sign('-');
                    let power = self.base()?;
                    if negative { Expr { kind: Kind::Negative(Box::new(power)), at } } else { power }
                }
                _ => return Ok(factor),
            };
            factor = power_of(factor, power, at);
        }
    }

    /// Parses the argument of a command: a group, a single letter or digit, or what another command begins.
    pub(super) fn argument(&mut self) -> Result<Expr, Error> {
        let Token { kind, at } = self.peek();
        match kind {
            Word::Sign('{') => {
                self.next += 1;
                self.closed(|parser| {
                    let inside = parser.expression()?;
                    parser.expect('}')?;
                    Ok(inside)
                })
            }
            Word::Digit(digit) => {
                self.next += 1;
                Ok(Expr { kind: Kind::Number(digit.to_digit(10).map_or(f64::NAN, f64::from)), at })
            }
            Word::Letter(letter) => {
                self.next += 1;
                Ok(Expr { kind: Kind::Symbol(Name::letter(letter)), at })
            }
            Word::Command(_) | Word::Field(_) => self.base(),
            _ => Err(self.expected("a group in braces, a letter or a digit")),
        }
    }

    /// Parses what is in brackets, where bars open and close by themselves.
    fn closed<T>(&mut self, inside: impl FnOnce(&mut Self) -> Result<T, Error>) -> Result<T, Error> {
        let bars = std::mem::take(&mut self.bars);
        let found = inside(self);
        self.bars = bars;
        found
    }

    pub(super) fn base(&mut self) -> Result<Expr, Error> {
        let Token { kind, at } = self.peek();
        let kind = match kind {
            Word::Digit(_) | Word::Sign('.') => self.number()?,
            Word::Sign('(') => self.bracket(')')?,
            Word::Sign('[') => self.bracket(']')?,
            Word::Sign('|') | Word::Command("lvert") => self.size()?,
            Word::BeginCases => self.closed(Self::cases)?,
            Word::BeginMatrix => self.closed(Self::column)?,
            Word::Text(name) if FUNCTIONS.contains(&name) => {
                self.next += 1;
                self.function(name, at)?
            }
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
        let token = self.peek();
        let Some(name) = self.name()? else { return Err(self.nothing(token)) };
        if !self.sees('(') || !self.functions.iter().any(|declared| name.is_like(declared)) {
            return Ok(Kind::Symbol(name));
        }
        self.next += 1;
        Ok(Kind::Apply(name, self.list(')')?))
    }

    /// The error that no number, symbol or bracket begins here, with what to write instead.
    fn nothing(&self, token: Token<'_>) -> Error {
        let Word::Command(command) = token.kind else {
            return self.expected("a number, a symbol or a bracket");
        };
        let cure = match command {
            "pm" | "mp" => "two equations are two calls",
            "langle" => r"a bracket that is 0 for negative numbers is `\max(0, x)`",
            "top" | "intercal" => r"products of vectors are `\cdot`, `\times` and `\otimes`",
            "circ" | "degree" => "angles are in radians",
            "ln" | "log" | "sinh" | "cosh" | "tanh" => "no formula here has this function",
            "int" | "oint" | "lim" => "only closed expressions can be evaluated",
            _ => {
                r"there are `\frac`, `\sqrt`, `\sin`, `\arctan`, `\max`, `\operatorname{atan2}`, `\cdot`, `\times` and Greek letters"
            }
        };
        Error::new(token.at, format!(r"`\{command}` is not read here: {cure}"))
    }

    /// Parses expressions separated by commas, and the closing bracket.
    pub(super) fn list(&mut self, close: char) -> Result<Vec<Expr>, Error> {
        self.closed(|parser| {
            let mut all = vec![parser.expression()?];
            while parser.took_sign(',') {
                all.push(parser.expression()?);
            }
            parser.expect(close)?;
            Ok(all)
        })
    }

    fn bracket(&mut self, close: char) -> Result<Kind, Error> {
        self.next += 1;
        let mut all = self.list(close)?;
        Ok(if all.len() == 1 { all.swap_remove(0).kind } else { Kind::Tuple(all) })
    }

    /// `\lvert x\rvert`, `|x|`
    fn size(&mut self) -> Result<Kind, Error> {
        let is_directed = self.take().kind == Word::Command("lvert");
        let bars = self.bars;
        self.bars = if is_directed { 0 } else { bars + 1 };
        let inside = self.expression();
        self.bars = bars;
        let inside = inside?;
        if !self.took(Word::Command("rvert")) && !self.took_sign('|') {
            return Err(self.expected("the bar that closes this size, `\\rvert` or `|`,"));
        }
        Ok(Kind::Size(Box::new(inside)))
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
        match command {
            "frac" | "tfrac" | "dfrac" | "cfrac" => {
                if let Some(partial) = self.partial()? {
                    return Ok(Some(partial));
                }
                let (above, below) = (self.argument()?, self.argument()?);
                return Ok(Some(binary(Operator::Divide, above, below, at).kind));
            }
            "sum" => return self.sum().map(Some),
            "operatorname" | "mathrm" | "mathit" | "mathsf" => {
                let name = self.word().unwrap_or_default();
                if FUNCTIONS.contains(&name.as_str()) {
                    return self.function(&name, at).map(Some);
                }
                if command == "operatorname" && self.sees('(') {
                    let known = FUNCTIONS.join(", ");
                    return Err(Error::new(at, format!("the function {name} is not known: there are {known}")));
                }
            }
            name if FUNCTIONS.contains(&name) => return self.function(name, at).map(Some),
            _ => {}
        }
        self.next = start;
        Ok(None)
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

    /// The vector whose components are the cells of a matrix with one row or one column.
    fn column(&mut self) -> Result<Kind, Error> {
        let at = self.take().at;
        let (mut all, mut separators) = (vec![self.expression()?], Vec::new());
        loop {
            let token = self.take();
            match token.kind {
                Word::EndMatrix if separators.iter().all(|other| *other == separators[0]) => {
                    return Ok(Kind::Tuple(all));
                }
                Word::EndMatrix => {
                    let cure = r"a matrix of several rows and columns is written by `\otimes` and `\mathbf{I}`";
                    return Err(Error::new(at, cure));
                }
                separator @ (Word::Cell | Word::Row) => {
                    if self.took(Word::EndMatrix) {
                        self.next -= 1;
                        continue;
                    }
                    separators.push(separator);
                    all.push(self.expression()?);
                }
                _ => return Err(Error::new(token.at, "the end of the matrix was expected here")),
            }
        }
    }

    /// `\begin{cases} value & condition \\ … \end{cases}`.
    fn cases(&mut self) -> Result<Kind, Error> {
        self.next += 1;
        let mut rows = Vec::new();
        loop {
            let value = self.expression()?;
            self.took_sign(',');
            if !self.took(Word::Cell) {
                return Err(self.expected("`&` and a condition"));
            }
            rows.push((value, self.condition()?));
            if self.took(Word::Row) && self.peek().kind != Word::EndCases {
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
            match words.trim().trim_end_matches(['.', ',']) {
                "otherwise" | "else" => return Ok(all),
                "if" | "for" | "when" | "where" => {}
                _ => return Err(self.expected("a comparison or `\\text{otherwise}` instead of the words before this,")),
            }
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
            let is_and = matches!(self.peek().kind, Word::Text(words) if words.trim() == "and");
            self.next += usize::from(is_and);
            if !is_and && !self.took_sign(',') || matches!(self.peek().kind, Word::Row | Word::EndCases) {
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
