//! The names used in the code of a scope, read from its tokens, so that the arguments of macro calls are read like other code.

use super::import::Import;
use proc_macro2::{Delimiter, Ident, Literal, TokenStream, TokenTree};
use std::collections::BTreeMap;

/// A path of two or more segments, as `crate::connector::slot::Friction` or `hard::triad`.
#[derive(Debug, Clone)]
pub(super) struct Mention {
    /// Its segments up to the first `<`.
    pub(super) path: Vec<String>,
    /// Its line.
    pub(super) line: usize,
}

/// The names used.
#[derive(Debug, Default)]
pub(super) struct Words {
    /// Every path.
    pub(super) paths: Vec<Mention>,
    /// Every single name that may come from elsewhere, with the first line that has it: names that begin with a
    /// capital or are called. Fields, methods and variables are never from elsewhere.
    pub(super) names: BTreeMap<String, usize>,
    /// Imports within functions.
    pub(super) imports: Vec<Import>,
    /// Every string, with its line.
    pub(super) strings: Vec<(String, usize)>,
}

impl Words {
    /// Adds the names in these tokens, except in attributes and documentation.
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

    /// Adds the names of another scope.
    pub(super) fn append(&mut self, other: Self) {
        let Self { paths, names, imports, strings } = other;
        self.paths.extend(paths);
        for (name, line) in names {
            self.names.entry(name).or_insert(line);
        }
        self.imports.extend(imports);
        self.strings.extend(strings);
    }

    /// Adds a `use` within a function; returns the number of its tokens.
    fn import(&mut self, tokens: &[TokenTree]) -> usize {
        let length = tokens.iter().position(|token| is_mark(Some(token), ';')).map_or(1, |end| end + 1);
        let Ok(item) = syn::parse2(tokens[..length].iter().cloned().collect()) else { return 1 };
        self.imports.extend(Import::of(&item));
        length
    }

    /// Adds the path that begins with `word` at `at`; returns the number of its tokens.
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

/// The length of an attribute; 1 for a `#` that starts none.
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

/// The token after `::`.
fn after_colons(tokens: &[TokenTree]) -> Option<&TokenTree> {
    (is_mark(tokens.first(), ':') && is_mark(tokens.get(1), ':')).then(|| tokens.get(2))?
}

fn ends_in_colons(tokens: &[TokenTree]) -> bool {
    matches!(tokens, [.., first, second] if is_mark(Some(first), ':') && is_mark(Some(second), ':'))
}

/// Whether the `::` at the end starts a path rather than continuing one, as in `Vec::<T>::new` and `<T as Trait>::new`.
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

#[cfg(test)]
mod tests {
    use super::*;

    fn words(code: &str) -> Words {
        let mut words = Words::default();
        words.read(code.parse().unwrap());
        words
    }

    /// Paths, names, imports and strings, each with its line, separated by bars.
    fn shown(words: &Words) -> String {
        let paths = words.paths.iter().map(|mention| format!("{} {}", mention.path.join("::"), mention.line));
        let names = words.names.iter().map(|(name, line)| format!("{name} {line}"));
        let imports = words.imports.iter().map(|import| format!("{} {}", import.shown(), import.line));
        let strings = words.strings.iter().map(|(text, line)| format!("{text} {line}"));
        let joined = |all: Vec<String>| all.join(", ");
        [joined(paths.collect()), joined(names.collect()), joined(imports.collect()), joined(strings.collect())]
            .join(" | ")
    }

    #[track_caller]
    fn says(code: &str, expected: &str) {
        assert_eq!(shown(&words(code)), expected, "{code}");
    }

    #[test]
    fn what_begins_with_a_capital_or_is_called_is_a_name() {
        says("One", " | One 1 |  | ");
        says("let one = two\n+ Two - three;\nOne", " | One 3, Two 2 |  | ");
        says(
            "one(two) + three.four(five) + Six { seven: eight } + nine {} + ten[Eleven]",
            " | Eleven 1, Six 1, one 1 |  | ",
        );
        says("note!(x); told![x]; one != (two)", " | note 1, told 1 |  | ");
        says("one::<Two>(three)", " | Two 1, one 1 |  | ");
        says("let one: dyn Two = if three { four } else { five }", " | Two 1 |  | ");
        // The first of two lines.
        says("One\nOne", " | One 1 |  | ");
    }

    #[test]
    fn a_path_is_all_its_segments_and_begins_where_no_other_goes_on() {
        says("crate::one::Two", "crate::one::Two 1 |  |  | ");
        says("\none::two(three)", "one::two 2 |  |  | ");
        says("x = ::one::Two", "one::Two 1 |  |  | ");
        says("f(::one::Two)", "one::Two 1 | f 1 |  | ");
        // A path after a `>` or a group continues the previous one.
        says("One::<Two>::new(three)", " | One 1, Two 1 |  | ");
        says("[One]::of::two(three)", " | One 1 |  | ");
        says("<One as two::Three>::FOUR", "two::Three 1 | One 1 |  | ");
        says("one.two::<Three>().Four", " | Three 1 |  | ");
    }

    #[test]
    fn attributes_and_lifetimes_are_passed_over_and_what_is_put_in_is_not() {
        says("#[one(Two)] Three", " | Three 1 |  | ");
        says("#![one(Two)] Three", " | Three 1 |  | ");
        says("#One #(Two) #{Three}", " | One 1, Three 1, Two 1 |  | ");
        says("&'One Two", " | Two 1 |  | ");
    }

    #[test]
    fn imports_within_functions_are_taken_apart() {
        says("use one::{two, Three as Four}; Five", " | Five 1 | use one::two 1, use one::Three as Four 1 | ");
        says("f(); use crate::one;", " | f 1 | use crate::one 1 | ");
        // A malformed `use` is read like other tokens.
        says("use", " |  |  | ");
        says("use One", " | One 1 |  | ");
    }

    #[test]
    fn strings_are_kept_and_other_literals_are_not() {
        says("\"one\" 2 'T' b\"three\"\nr\"four\" Five", " | Five 2 |  | one 1, four 2");
    }

    #[test]
    fn what_is_read_elsewhere_is_added() {
        let mut all = words("One; one::two; \"three\"");
        all.append(words("\nOne; Four; five::six; use seven::Eight; \"nine\""));
        assert_eq!(shown(&all), "one::two 1, five::six 2 | Four 2, One 1 | use seven::Eight 2 | three 1, nine 2");
    }
}
