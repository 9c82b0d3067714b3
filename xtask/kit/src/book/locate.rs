//! Finds the targets of an entry in the sources: the functions of an `impl Formula for …`, and the tests that name an id.

use super::content::{CodeSpan, SourceFile, TestRef};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::HashSet;
use syn::spanned::Spanned;
use syn::{ImplItem, Item, ItemImpl, Type};

/// The sources, parsed once for many queries.
pub(crate) struct Index<'a> {
    sources: &'a [SourceFile],
    tests: Vec<Test<'a>>,
}

/// A test function.
struct Test<'a> {
    place: TestRef,
    source: &'a SourceFile,
    /// The names and literals in its body.
    words: HashSet<String>,
}

impl<'a> Index<'a> {
    /// Parses the sources; one that is not valid Rust has no tests.
    pub(crate) fn new(sources: &'a [SourceFile]) -> Self {
        let mut tests = Vec::new();
        for source in sources {
            if let Ok(stream) = source.text.parse() {
                collect_tests(stream, source, &mut tests);
            }
        }
        Self { sources, tests }
    }

    /// The location of the functions called `names` in `impl Formula for type_name` in `file`, with their doc comments
    /// and attributes.
    ///
    /// A missing name is omitted; the caller decides whether that is a fault.
    pub(crate) fn functions(&self, file: &str, type_name: &str, names: &[&str]) -> Vec<CodeSpan> {
        let source = self.sources.iter().find(|source| source.path == file);
        let parsed = source.and_then(|source| syn::parse_file(&source.text).ok());
        let Some(formula) = parsed.as_ref().and_then(|parsed| formula_impl(&parsed.items, type_name)) else {
            return Vec::new();
        };
        let function = |name: &&str| {
            formula.items.iter().find_map(|item| match item {
                ImplItem::Fn(function) if function.sig.ident == name => {
                    let [first, last] = [function.span().start().line, function.span().end().line];
                    Some(CodeSpan { name: (*name).to_owned(), file: file.to_owned(), first, last })
                }
                _ => None,
            })
        };
        names.iter().filter_map(function).collect()
    }

    /// Every test function that names the id of a formula as a string, or its type in a file of its family, since
    /// another family may have a type of the same name.
    pub(crate) fn tests_naming(&self, id: &str, type_name: &str) -> Vec<TestRef> {
        let literal = format!("\"{id}\"");
        let family = id.split('.').next().unwrap_or(id);
        self.tests(|test| {
            test.words.contains(&literal) || test.source.path.contains(family) && test.words.contains(type_name)
        })
    }

    /// Every test function that runs over the whole catalog.
    pub(crate) fn tests_over_catalog(&self) -> Vec<TestRef> {
        self.tests(|test| {
            let names = ["CATALOG", "for_every_formula"];
            test.source.path.starts_with("tests/") && names.iter().any(|name| test.words.contains(*name))
        })
    }

    fn tests(&self, counts: impl Fn(&Test<'a>) -> bool) -> Vec<TestRef> {
        self.tests.iter().filter(|test| counts(test)).map(|test| test.place.clone()).collect()
    }
}

/// `impl … Formula for type_name`, also within modules.
fn formula_impl<'s>(items: &'s [Item], type_name: &str) -> Option<&'s ItemImpl> {
    items.iter().find_map(|item| match item {
        Item::Impl(item) if is_formula_of(item, type_name) => Some(item),
        Item::Mod(module) => formula_impl(&module.content.as_ref()?.1, type_name),
        _ => None,
    })
}

fn is_formula_of(item: &ItemImpl, type_name: &str) -> bool {
    let last = |path: &syn::Path, name: &str| path.segments.last().is_some_and(|segment| segment.ident == name);
    let is_formula = item.trait_.as_ref().is_some_and(|(_, path, _)| last(path, "Formula"));
    is_formula && matches!(&*item.self_ty, Type::Path(of) if last(&of.path, type_name))
}

/// The test functions, also within macros.
fn collect_tests<'a>(stream: TokenStream, source: &'a SourceFile, tests: &mut Vec<Test<'a>>) {
    let trees: Vec<_> = stream.into_iter().collect();
    for (at, tree) in trees.iter().enumerate() {
        match tree {
            TokenTree::Ident(word) if word == "fn" && is_test(&trees[..at]) => {
                if let Some(TokenTree::Ident(name)) = trees.get(at + 1)
                    && let Some(body) = trees[at..].iter().find_map(braces)
                {
                    let (mut words, line) = (HashSet::new(), word.span().start().line);
                    collect_words(body.stream(), &mut words);
                    tests.push(Test {
                        place: TestRef { name: name.to_string(), file: source.path.clone(), line },
                        source,
                        words,
                    });
                }
            }
            TokenTree::Group(group) => collect_tests(group.stream(), source, tests),
            _ => {}
        }
    }
}

/// Whether an attribute at the end of these tokens marks a test.
fn is_test(before: &[TokenTree]) -> bool {
    let ends =
        |tree: &TokenTree| braces(tree).is_some() || matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ';');
    let names_test = |tree: &TokenTree| {
        let TokenTree::Group(group) = tree else { return false };
        group.stream().into_iter().any(|tree| matches!(tree, TokenTree::Ident(word) if word == "test"))
    };
    before.iter().rev().take_while(|tree| !ends(tree)).any(names_test)
}

fn braces(tree: &TokenTree) -> Option<&Group> {
    match tree {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

fn collect_words(stream: TokenStream, words: &mut HashSet<String>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => collect_words(group.stream(), words),
            TokenTree::Punct(_) => {}
            TokenTree::Ident(_) | TokenTree::Literal(_) => {
                words.insert(tree.to_string());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sources() -> Vec<SourceFile> {
        let room = "struct A;\nimpl Formula for A {\n    const ID: &str = \"}\";\n    /// Doc.\n    #[inline]\n    \
                    fn eval() {\n        { 1 }\n    }\n    fn jacobian() {}\n}\n#[cfg(test)]\nmod t {\n    #[test]\n    \
                    fn guards() { check(\"a.b\") }\n}\n";
        let test = "use x::A;\n#[test]\nfn all() { let _ = \"a.b\"; go::<A>(); }\nfn help() { \"a.b\"; }\n";
        let file = |path: &str, text: &str| SourceFile { path: path.to_owned(), text: text.to_owned() };
        // Another family may have a type of this name.
        let other = "#[test]\nfn other() { go::<A>(); }\n";
        vec![file("src/a.rs", room), file("tests/golden.rs", test), file("tests/other.rs", other)]
    }

    #[test]
    fn functions_are_found_with_their_docs() {
        let sources = sources();
        let index = Index::new(&sources);
        let spans = index.functions("src/a.rs", "A", &["eval", "jacobian", "nothing"]);
        let lines: Vec<_> = spans.iter().map(|s| (s.name.as_str(), s.first, s.last)).collect();
        assert_eq!(lines, [("eval", 4, 8), ("jacobian", 9, 9)]);
        assert_eq!(index.functions("src/a.rs", "B", &["eval"]), []);
    }

    #[test]
    fn code_that_is_cut_off_has_no_functions() {
        let file = |text: &str| SourceFile { path: "src/a.rs".to_owned(), text: text.to_owned() };
        let lines = |text: &str| {
            let sources = [file(text)];
            let spans = Index::new(&sources).functions("src/a.rs", "A", &["eval"]);
            spans.iter().map(|span| (span.first, span.last)).collect::<Vec<_>>()
        };
        assert_eq!(lines("impl Formula for A { fn eval() {} }"), [(1, 1)]);
        assert_eq!(lines("impl Formula for A {\n fn eval() {\n"), []);
        // The formula's own functions, in any order of types.
        let others = "impl Formula for B {\n fn eval() {}\n}\nimpl A {\n fn eval() {}\n}\n";
        assert_eq!(
            lines(&format!(
                "{others}impl<T> x::Formula for A {{\n// eval\n\nfn other() {{}}\n#[inline]\nfn eval() {{\n}}\n}}\n"
            )),
            [(11, 13)]
        );
    }

    #[test]
    fn tests_of_the_catalog_are_those_in_tests_that_name_it() {
        let source = |path: &str| SourceFile {
            path: path.to_owned(),
            text:
                "#[test]\nfn one() {}\n#[test]\nfn all() {\n  CATALOG;\n}\n#[test]\nfn each() { for_every_formula() }\n"
                    .to_owned(),
        };
        let sources = [source("src/a.rs"), source("tests/b.rs")];
        let tests = Index::new(&sources).tests_over_catalog();
        let names: Vec<_> = tests.iter().map(|t| (t.name.as_str(), t.file.as_str(), t.line)).collect();
        assert_eq!(names, [("all", "tests/b.rs", 4), ("each", "tests/b.rs", 8)]);
    }

    #[test]
    fn tests_are_found_once_each() {
        let sources = sources();
        let tests = Index::new(&sources).tests_naming("a.b", "A");
        let names: Vec<_> = tests.iter().map(|t| (t.name.as_str(), t.file.as_str(), t.line)).collect();
        assert_eq!(names, [("guards", "src/a.rs", 14), ("all", "tests/golden.rs", 3)]);
    }
}
