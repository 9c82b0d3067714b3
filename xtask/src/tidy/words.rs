//! What the code of a scope names, read from its tokens: so the insides of macro calls are read as everything else.

use super::import::Import;
use proc_macro2::{Delimiter, Ident, Literal, TokenStream, TokenTree};
use std::collections::BTreeMap;

/// A path of two or more segments, as `crate::slot::Friction` or `hard::triad`.
#[derive(Debug, Clone)]
pub(super) struct Mention {
    /// Its segments up to the first `<`.
    pub(super) path: Vec<String>,
    /// Its line.
    pub(super) line: usize,
}

/// What is named.
#[derive(Debug, Default)]
pub(super) struct Words {
    /// Every path.
    pub(super) paths: Vec<Mention>,
    /// Every single name that can come from elsewhere, with the first line that has it: what begins with a capital, or
    /// is called. A field, a method or a variable cannot.
    pub(super) names: BTreeMap<String, usize>,
    /// Imports within functions.
    pub(super) imports: Vec<Import>,
    /// Every string, with its line.
    pub(super) strings: Vec<(String, usize)>,
}

impl Words {
    /// Adds what these tokens name. Attributes and documentation are passed over.
    pub(super) fn read(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at += match token {
                TokenTree::Punct(mark) if mark.as_char() == '#' => attribute(&tokens[at..]),
                TokenTree::Punct(mark) if mark.as_char() == '\'' => 2,
                TokenTree::Punct(_) => 1,
                TokenTree::Group(group) => {
                    self.read(group.stream());
                    1
                }
                TokenTree::Literal(literal) => {
                    self.strings.extend(string(literal));
                    1
                }
                TokenTree::Ident(word) if word == "use" => self.import(&tokens[at..]),
                TokenTree::Ident(word) => self.path(word, &tokens, at),
            };
        }
    }

    /// Adds what was read elsewhere.
    pub(super) fn append(&mut self, other: Self) {
        let Self { paths, names, imports, strings } = other;
        self.paths.extend(paths);
        for (name, line) in names {
            self.names.entry(name).or_insert(line);
        }
        self.imports.extend(imports);
        self.strings.extend(strings);
    }

    /// A `use` within a function; the number of its tokens.
    fn import(&mut self, tokens: &[TokenTree]) -> usize {
        let length = tokens.iter().position(|token| is_mark(Some(token), ';')).map_or(1, |end| end + 1);
        let Ok(item) = syn::parse2(tokens[..length].iter().cloned().collect()) else { return 1 };
        self.imports.extend(Import::of(&item));
        length
    }

    /// The path that begins with `word` at `at`; the number of its tokens.
    fn path(&mut self, word: &Ident, tokens: &[TokenTree], at: usize) -> usize {
        let line = word.span().start().line;
        let mut path = vec![word.to_string()];
        let mut length = 1;
        while let Some(TokenTree::Ident(next)) = after_colons(&tokens[at + length..]) {
            path.push(next.to_string());
            length += 3;
        }
        let (before, next) = (&tokens[..at], tokens.get(at + length));
        let continues = is_mark(before.last(), '.') || (ends_in_colons(before) && !is_global(before));
        if continues {
            return length;
        }
        if path.len() > 1 {
            self.paths.push(Mention { path, line });
        } else if path[0].starts_with(char::is_uppercase) || is_call(next, tokens.get(at + length + 1)) {
            self.names.entry(path.remove(0)).or_insert(line);
        }
        length
    }
}

/// The length of an attribute; 1 for a `#` that begins none.
fn attribute(tokens: &[TokenTree]) -> usize {
    let inner = usize::from(is_mark(tokens.get(1), '!'));
    match tokens.get(1 + inner) {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => 2 + inner,
        _ => 1,
    }
}

fn string(literal: &Literal) -> Option<(String, usize)> {
    match syn::Lit::new(literal.clone()) {
        syn::Lit::Str(text) => Some((text.value(), literal.span().start().line)),
        _ => None,
    }
}

fn is_mark(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

/// The token behind `::`.
fn after_colons(tokens: &[TokenTree]) -> Option<&TokenTree> {
    (is_mark(tokens.first(), ':') && is_mark(tokens.get(1), ':')).then(|| tokens.get(2))?
}

fn ends_in_colons(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [.., first, second] if is_mark(Some(first), ':') && is_mark(Some(second), ':'))
}

/// Whether the `::` at the end begins a path rather than going on with one, as in `Vec::<T>::new` and `<T as Trait>::new`.
fn is_global(tokens: &[TokenTree]) -> bool {
    let before = tokens.len().checked_sub(3).and_then(|at| tokens.get(at));
    !(is_mark(before, '>') || matches!(before, Some(TokenTree::Ident(_) | TokenTree::Group(_))))
}

/// `f(…)`, `f!(…)` or `f::<T>(…)`.
fn is_call(next: Option<&TokenTree>, second: Option<&TokenTree>) -> bool {
    match next {
        Some(TokenTree::Group(group)) => group.delimiter() == Delimiter::Parenthesis,
        Some(TokenTree::Punct(mark)) if mark.as_char() == '!' => matches!(second, Some(TokenTree::Group(_))),
        Some(TokenTree::Punct(mark)) => mark.as_char() == ':' && is_mark(second, ':'),
        _ => false,
    }
}
