//! A small reader of Rust: enough to colour code without a script, and to match braces past strings and comments.

use super::html::escape;

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Spaces and newlines.
    Space,
    /// `// …` and `/* … */`.
    Comment,
    /// Strings and characters.
    Text,
    /// Numbers.
    Number,
    /// `fn`, `let`, …
    Keyword,
    /// A name that begins with a capital.
    Type,
    /// Any other name.
    Name,
    /// `'a`.
    Lifetime,
    /// A single character of anything else.
    Mark,
}

/// The reserved words.
const KEYWORDS: &[&str] = &[
    "as", "async", "await", "break", "const", "continue", "crate", "dyn", "else", "enum", "extern", "false", "fn",
    "for", "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "static",
    "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while",
];

/// The tokens of `text`, which put together give `text` again.
pub(crate) fn tokens(text: &str) -> Vec<(Kind, &str)> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (kind, length) = token(rest, first);
        let (this, after) = rest.split_at(length.clamp(first.len_utf8(), rest.len()));
        tokens.push((kind, this));
        rest = after;
    }
    tokens
}

/// Kind and length of the token at the start of `rest`.
fn token(rest: &str, first: char) -> (Kind, usize) {
    let run = |accept: fn(char) -> bool| rest.find(|c| !accept(c)).unwrap_or(rest.len());
    let word = |c: char| c.is_alphanumeric() || c == '_';
    if first.is_whitespace() {
        return (Kind::Space, run(char::is_whitespace));
    }
    if rest.starts_with("//") {
        return (Kind::Comment, rest.find('\n').unwrap_or(rest.len()));
    }
    if rest.starts_with("/*") {
        return (Kind::Comment, block_comment(rest));
    }
    if let Some(length) = string(rest) {
        return (Kind::Text, length);
    }
    if first == '\'' {
        return quote(rest);
    }
    if first.is_ascii_digit() {
        return (Kind::Number, number(rest));
    }
    if first.is_alphabetic() || first == '_' {
        let length = run(word);
        return (name(&rest[..length], first), length);
    }
    (Kind::Mark, first.len_utf8())
}

/// What a word is.
fn name(word: &str, first: char) -> Kind {
    if KEYWORDS.contains(&word) {
        Kind::Keyword
    } else if first.is_uppercase() {
        Kind::Type
    } else {
        Kind::Name
    }
}

/// Length of a number; `1..2` and `1.max(2)` end before the dot.
fn number(rest: &str) -> usize {
    let bytes = rest.as_bytes();
    let mut length = 1;
    while let Some(&byte) = bytes.get(length) {
        let exponent_sign =
            matches!(byte, b'+' | b'-') && matches!(bytes[length - 1], b'e' | b'E') && !rest.starts_with("0x");
        let point = byte == b'.'
            && bytes.get(length + 1).is_none_or(|next| !(next.is_ascii_alphabetic() || *next == b'.' || *next == b'_'));
        if !(byte.is_ascii_alphanumeric() || byte == b'_' || exponent_sign || point) {
            break;
        }
        length += 1;
    }
    length
}

/// Length of a nested block comment.
fn block_comment(rest: &str) -> usize {
    let (mut depth, mut at) = (0_usize, 0);
    while at < rest.len() {
        if rest[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if rest[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += rest[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    rest.len()
}

/// Length of a string literal of any form, if `rest` begins with one.
fn string(rest: &str) -> Option<usize> {
    let prefix = rest.find(|c: char| !"bcr".contains(c))?;
    let body = &rest[prefix..];
    if prefix > 2 {
        return None;
    }
    let hashes = body.find(|c| c != '#')?;
    if rest[..prefix].contains('r') && body[hashes..].starts_with('"') {
        let close = format!("\"{}", "#".repeat(hashes));
        let start = prefix + hashes + 1;
        return Some(rest[start..].find(&close).map_or(rest.len(), |end| start + end + close.len()));
    }
    if body.starts_with('"') && !rest[..prefix].contains('r') {
        return Some(prefix + quoted(body, '"'));
    }
    (rest.starts_with("b'")).then(|| 1 + quoted(body, '\''))
}

/// Length of a literal closed by an unescaped `end`.
fn quoted(body: &str, end: char) -> usize {
    let mut escaped = false;
    for (at, c) in body.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            c if c == end => return at + c.len_utf8(),
            _ => {}
        }
    }
    body.len()
}

/// A character literal or a lifetime.
fn quote(rest: &str) -> (Kind, usize) {
    let mut chars = rest.chars().skip(1);
    let (second, third) = (chars.next(), chars.next());
    if second == Some('\\') || third == Some('\'') {
        return (Kind::Text, quoted(rest, '\''));
    }
    let word = rest[1..].find(|c: char| !(c.is_alphanumeric() || c == '_')).map_or(rest.len(), |n| n + 1);
    (Kind::Lifetime, word)
}

/// Every line of `text` as HTML; a token over several lines is closed and opened again at each.
pub(crate) fn highlight(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (kind, token) in tokens(text) {
        for (i, part) in token.split('\n').enumerate() {
            if i > 0 {
                lines.push(String::new());
            }
            let Some(line) = lines.last_mut() else { continue };
            let html = escape(part);
            match class(kind) {
                Some(class) if !part.is_empty() => line.extend(["<i class=\"", class, "\">", &html, "</i>"]),
                _ => line.push_str(&html),
            }
        }
    }
    if lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// The class that colours a token.
fn class(kind: Kind) -> Option<&'static str> {
    match kind {
        Kind::Comment => Some("rc"),
        Kind::Text => Some("rs"),
        Kind::Number => Some("rn"),
        Kind::Keyword => Some("rk"),
        Kind::Type => Some("rt"),
        Kind::Lifetime => Some("rl"),
        Kind::Space | Kind::Name | Kind::Mark => None,
    }
}

/// Highlighted lines as a block, without the indentation they share.
pub(crate) fn block(lines: &[String]) -> String {
    let indent = |line: &String| line.len() - line.trim_start().len();
    let shared = lines.iter().filter(|line| !line.trim().is_empty()).map(indent).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(shared..).unwrap_or("")).collect();
    format!("<pre><code class=\"nohighlight\">{}</code></pre>", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str =
        "fn f<'a>(x: &'a str) -> f64 { /* {\n */ let c = '\\''; r#\"}\"\n\"# ; 1.0e-3 + x.len() as f64 - 1..2 } // }\n";

    #[test]
    fn tokens_put_together_give_the_text() {
        assert_eq!(tokens(CODE).into_iter().map(|(_, token)| token).collect::<String>(), CODE);
    }

    #[test]
    fn strings_comments_numbers_and_lifetimes_are_told_apart() {
        let of = |kind| tokens(CODE).into_iter().filter(|t| t.0 == kind).map(|t| t.1).collect::<Vec<_>>();
        assert_eq!(of(Kind::Comment), ["/* {\n */", "// }"]);
        assert_eq!(of(Kind::Text), ["'\\''", "r#\"}\"\n\"#"]);
        assert_eq!(of(Kind::Number), ["1.0e-3", "1", "2"]);
        assert_eq!(of(Kind::Lifetime), ["'a", "'a"]);
    }

    /// The tokens that are no spaces, with a letter for their kind.
    fn read(text: &str) -> String {
        let letter = |kind| match kind {
            Kind::Space => unreachable!("left out"),
            Kind::Comment => 'c',
            Kind::Text => 's',
            Kind::Number => 'n',
            Kind::Keyword => 'k',
            Kind::Type => 't',
            Kind::Name => 'w',
            Kind::Lifetime => 'l',
            Kind::Mark => 'm',
        };
        let tokens = tokens(text).into_iter().filter(|token| token.0 != Kind::Space);
        tokens.map(|(kind, text)| format!("{}:{text}", letter(kind))).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn names_keywords_and_types_are_told_apart() {
        assert_eq!(read("fn _a_1 Box2 é9 bar rust crab x"), "k:fn w:_a_1 t:Box2 w:é9 w:bar w:rust w:crab w:x");
    }

    #[test]
    fn numbers_end_where_rust_ends_them() {
        for (text, tokens) in [
            ("1_000.5f64,", "n:1_000.5f64 m:,"),
            ("1e-3+2", "n:1e-3 m:+ n:2"),
            ("1E+30-4", "n:1E+30 m:- n:4"),
            ("0xe+1", "n:0xe m:+ n:1"),
            ("1.max(2)", "n:1 m:. w:max m:( n:2 m:)"),
            ("1._x", "n:1 m:. w:_x"),
            ("1..2", "n:1 m:. m:. n:2"),
            ("1.;", "n:1. m:;"),
            ("1.", "n:1."),
            ("7 8", "n:7 n:8"),
        ] {
            assert_eq!(read(text), tokens, "{text}");
        }
    }

    #[test]
    fn texts_end_at_the_quote_that_closes_them() {
        for (text, tokens) in [
            (r#""" x"#, r#"s:"" w:x"#),
            (r#""a\\" x "b""#, r#"s:"a\\" w:x s:"b""#),
            (r#""a\"b\n" x"#, r#"s:"a\"b\n" w:x"#),
            (r#"b"a\"b" x"#, r#"s:b"a\"b" w:x"#),
            (r#"r"\" x"#, r#"s:r"\" w:x"#),
            (r#"br"\" x"#, r#"s:br"\" w:x"#),
            (r##"cr#"a"b"# x"##, r##"s:cr#"a"b"# w:x"##),
            (r###"r##"a"#b"## x"###, r###"s:r##"a"#b"## w:x"###),
            (r#"bcr"a" x"#, r#"w:bcr s:"a" w:x"#),
            (r"b'x' b'\'' y", r"s:b'x' s:b'\'' w:y"),
            (r"'a' '\n' '\\' 'é' x", r"s:'a' s:'\n' s:'\\' s:'é' w:x"),
            ("'a_b, '_ 'static>", "l:'a_b m:, l:'_ l:'static m:>"),
        ] {
            assert_eq!(read(text), tokens, "{text}");
        }
    }

    #[test]
    fn comments_end_at_their_own_end() {
        for (text, tokens) in [
            ("/* a /* b */ é */ x", "c:/* a /* b */ é */ w:x"),
            ("/**/x", "c:/**/ w:x"),
            ("/*/ a */ x", "c:/*/ a */ w:x"),
            ("// a /*\nx", "c:// a /* w:x"),
            ("a/b", "w:a m:/ w:b"),
        ] {
            assert_eq!(read(text), tokens, "{text}");
        }
    }

    #[test]
    fn each_line_is_complete_html() {
        let lines = highlight("/* a\nb */ fn\n\n");
        assert_eq!(lines, ["<i class=\"rc\">/* a</i>", "<i class=\"rc\">b */</i> <i class=\"rk\">fn</i>", ""]);
        assert_eq!(highlight("\nx"), ["", "x"]);
        assert_eq!(highlight("x\n"), ["x"]);
        assert_eq!(highlight("/*\n\n*/"), ["<i class=\"rc\">/*</i>", "", "<i class=\"rc\">*/</i>"]);
    }

    #[test]
    fn every_kind_has_its_colour() {
        let coloured = "<i class=\"rk\">let</i> a<i class=\"rl\">'b</i>:<i class=\"rt\">C</i>=<i class=\"rn\">1</i><i class=\"rs\">'&lt;'</i>";
        assert_eq!(highlight("let a'b:C=1'<'"), [coloured]);
    }

    #[test]
    fn a_block_loses_its_shared_indentation() {
        assert_eq!(
            block(&["    a".into(), String::new(), "      b".into()]),
            "<pre><code class=\"nohighlight\">a\n\n  b</code></pre>"
        );
        assert_eq!(block(&[" ".into()]), "<pre><code class=\"nohighlight\"> </code></pre>");
    }

    #[test]
    fn broken_code_is_no_trouble() {
        for broken in ["\"abc", "/* a", "'", "r#\"", "b'", "1e", "é'é", "'é"] {
            assert_eq!(tokens(broken).into_iter().map(|t| t.1).collect::<String>(), broken);
        }
    }
}
