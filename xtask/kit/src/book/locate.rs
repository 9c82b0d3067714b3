//! Finds in the sources what an entry points at: the functions of an `impl Formula for …`, and the tests that name an id.

use super::content::{CodeSpan, SourceFile, TestRef};
use super::rust::{Kind, tokens};

/// A token with the line it begins on, from 1.
struct Token<'a> {
    /// Its kind.
    kind: Kind,
    /// Its characters.
    text: &'a str,
    /// Its line.
    line: usize,
}

/// The tokens that mean something, with their lines.
fn significant(text: &str) -> Vec<Token<'_>> {
    let mut line = 1;
    let mut out = Vec::new();
    for (kind, text) in tokens(text) {
        if !matches!(kind, Kind::Space | Kind::Comment) {
            out.push(Token { kind, text, line });
        }
        line += text.matches('\n').count();
    }
    out
}

/// The sources, read once for many questions.
pub(crate) struct Index<'a> {
    /// Each file with its tokens.
    files: Vec<(&'a SourceFile, Vec<Token<'a>>)>,
}

impl<'a> Index<'a> {
    /// Reads the sources.
    pub(crate) fn new(sources: &'a [SourceFile]) -> Self {
        Self { files: sources.iter().map(|source| (source, significant(&source.text))).collect() }
    }

    /// Where the functions called `names` stand in `impl Formula for type_name` in `file`, with their doc comments and
    /// attributes.
    ///
    /// A name that is not there is left out; the caller decides whether that is a fault.
    pub(crate) fn functions(&self, file: &str, type_name: &str, names: &[&str]) -> Vec<CodeSpan> {
        for (source, tokens) in self.files.iter().filter(|(source, _)| source.path == file) {
            if let Some(body) = formula_impl(tokens, type_name) {
                return names.iter().filter_map(|name| function(source, body, name)).collect();
            }
        }
        Vec::new()
    }

    /// Every test function that names the id of a formula, as a string, or its type in a file of its family (another
    /// family may have a type of the same name).
    pub(crate) fn tests_naming(&self, id: &str, type_name: &str) -> Vec<TestRef> {
        let literal = format!("\"{id}\"");
        let family = id.split('.').next().unwrap_or(id);
        self.tests(|source| {
            let of_family = source.path.contains(family);
            let literal = &literal;
            move |token| token.text == literal || (of_family && token.kind == Kind::Type && token.text == type_name)
        })
    }

    /// Every test function that runs over the whole catalog.
    pub(crate) fn tests_over_catalog(&self) -> Vec<TestRef> {
        self.tests(|source| {
            let of_tests = source.path.starts_with("tests/");
            move |token| of_tests && ["CATALOG", "for_every_formula"].contains(&token.text)
        })
    }

    /// Every test function with a token that counts; `counting` says for a file which do.
    fn tests<C: Fn(&Token<'_>) -> bool>(&self, counting: impl Fn(&SourceFile) -> C) -> Vec<TestRef> {
        let mut found: Vec<TestRef> = Vec::new();
        for (source, tokens) in &self.files {
            let counts = counting(source);
            for (at, _) in tokens.iter().enumerate().filter(|(_, token)| counts(token)) {
                found.extend(enclosing_test(source, tokens, at).filter(|test| !found.contains(test)));
            }
        }
        found
    }
}

/// The tokens between the braces of `impl … Formula for type_name`.
fn formula_impl<'t, 'a>(tokens: &'t [Token<'a>], type_name: &str) -> Option<&'t [Token<'a>]> {
    for (start, _) in tokens.iter().enumerate().filter(|(_, token)| token.text == "impl") {
        let open = start + tokens[start..].iter().position(|token| token.text == "{")?;
        let head: Vec<&str> = tokens[start..open].iter().map(|token| token.text).collect();
        let split = head.iter().position(|text| *text == "for");
        if split.is_some_and(|at| head[..at].contains(&"Formula") && head[at..].contains(&type_name)) {
            return Some(&tokens[open + 1..closing(tokens, open)?]);
        }
    }
    None
}

/// The index of the brace that closes the one at `open`.
fn closing(tokens: &[Token<'_>], open: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in tokens.iter().enumerate().skip(open) {
        match token.text {
            "{" => depth += 1,
            "}" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// The lines of one function in the body of an `impl`.
fn function(source: &SourceFile, body: &[Token<'_>], name: &str) -> Option<CodeSpan> {
    let at = body.windows(2).position(|pair| pair[0].text == "fn" && pair[1].text == name)?;
    let open = at + body[at..].iter().position(|token| token.text == "{")?;
    let last = body[closing(body, open)?].line;
    let lines: Vec<&str> = source.text.lines().collect();
    let belongs = |line: &&&str| line.trim_start().starts_with("///") || line.trim_start().starts_with("#[");
    let above = lines[..body[at].line - 1].iter().rev().take_while(belongs).count();
    let first = body[at].line - above;
    Some(CodeSpan { name: name.to_owned(), file: source.path.clone(), first, last })
}

/// The test function around the token `at`.
fn enclosing_test(source: &SourceFile, tokens: &[Token<'_>], at: usize) -> Option<TestRef> {
    let start = tokens[..at].windows(2).rposition(|pair| pair[0].text == "fn" && pair[1].kind == Kind::Name)?;
    let open = start + tokens[start..].iter().position(|token| token.text == "{")?;
    let attributes =
        tokens[..start].iter().rev().map(|token| token.text).take_while(|text| !["{", "}", ";"].contains(text));
    let is_test = attributes.into_iter().any(|text| text == "test");
    let name = tokens[start + 1].text.to_owned();
    let test = TestRef { name, file: source.path.clone(), line: tokens[start].line };
    (is_test && open < at && at < closing(tokens, open)?).then_some(test)
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
        // The formula's own functions, in whatever order types are.
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
