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
    /// `\begin{cases}`, `\end{cases}`, and `\\` and `&` between its cells.
    BeginCases,
    EndCases,
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

/// Spaces and sizes of brackets, which have no meaning.
const TYPOGRAPHY: &[&str] = &[
    ",", ";", ":", "!", " ", "left", "right", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "biggl",
    "biggr", "Biggl", "Biggr",
];

/// The tokens of an equation; the last one is [`Kind::End`].
pub(super) fn tokens(latex: &str) -> Result<Vec<Token<'_>>, Error> {
    let mut reader = Reader { latex, at: 0, aligned: Vec::new() };
    let mut all: Vec<Token<'_>> = Vec::new();
    loop {
        let token = reader.next()?;
        // A line that begins with a plus continues the previous one.
        let goes_on = token.is_some_and(|token| token.kind == Kind::Sign('+'));
        while goes_on && all.last().is_some_and(|last| last.kind == Kind::Gap) {
            all.pop();
        }
        all.extend(token);
        if let Some(Token { kind: Kind::End, .. }) = token {
            return Ok(all);
        }
    }
}

struct Reader<'a> {
    latex: &'a str,
    at: usize,
    /// For each enclosing environment, whether it is `aligned`, whose cells and lines merely arrange statements.
    aligned: Vec<bool>,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.latex[self.at..]
    }

    fn is_aligned(&self) -> bool {
        self.aligned.last() == Some(&true)
    }

    /// The next token; `None` if there is only typography.
    fn next(&mut self) -> Result<Option<Token<'a>>, Error> {
        let at = self.at;
        let Some(first) = self.rest().chars().next() else {
            return Ok(Some(Token { kind: Kind::End, at }));
        };
        self.at += first.len_utf8();
        let kind = match first {
            '\\' => return Ok(self.command(at)?.map(|kind| Token { kind, at })),
            '&' => (!self.is_aligned()).then_some(Kind::Cell),
            _ if first.is_whitespace() => None,
            _ if first.is_ascii_alphabetic() => Some(Kind::Letter(first)),
            _ if first.is_ascii_digit() => Some(Kind::Digit(first)),
            '+' | '-' | '=' | ',' | '.' | '(' | ')' | '[' | ']' | '/' | '<' | '>' | '\'' | '^' | '_' | '{' | '}'
            | '*' => Some(Kind::Sign(first)),
            _ => return Err(Error::new(at, format!("`{first}` is no mathematics that is read here"))),
        };
        Ok(kind.map(|kind| Token { kind, at }))
    }

    /// The token after a backslash.
    fn command(&mut self, at: usize) -> Result<Option<Kind<'a>>, Error> {
        let letters = self.rest().bytes().take_while(u8::is_ascii_alphabetic).count();
        let length = match self.rest().chars().next() {
            Some(single) if letters == 0 => single.len_utf8(),
            _ => letters,
        };
        let name = &self.rest()[..length];
        self.at += length;
        Ok(Some(match name {
            _ if TYPOGRAPHY.contains(&name) => return Ok(None),
            "\\" if self.is_aligned() => Kind::Gap,
            "\\" => Kind::Row,
            "quad" | "qquad" | "Rightarrow" => Kind::Gap,
            "text" => Kind::Text(self.group(at)?),
            "begin" | "end" => {
                let environment = self.group(at)?;
                let aligned = environment == "aligned";
                if name == "begin" {
                    self.aligned.push(aligned);
                } else if self.aligned.pop() != Some(aligned) {
                    return Err(Error::new(at, format!("no environment {environment} was begun")));
                }
                match (environment, name) {
                    ("aligned", _) => Kind::Gap,
                    ("cases", "begin") => Kind::BeginCases,
                    ("cases", _) => Kind::EndCases,
                    _ => return Err(Error::new(at, "an environment is `cases` or `aligned`")),
                }
            }
            _ => Kind::Command(name),
        }))
    }

    /// The text between the following braces.
    fn group(&mut self, at: usize) -> Result<&'a str, Error> {
        let inside = self.rest().strip_prefix('{').and_then(|rest| rest.split_once('}'));
        let (content, _) = inside.ok_or_else(|| Error::new(at, "a group in braces must follow"))?;
        self.at += content.len() + 2;
        Ok(content)
    }
}
