//! Highlighted Rust code, without a script.

use super::html::escape;
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use std::ops::Range;

/// The class that colours a token, if any, and its byte range.
type Token = (Option<&'static str>, Range<usize>);

/// Every line of `text` as HTML; tokens that span several lines are closed and reopened on each.
///
/// Invalid Rust is not coloured.
pub(crate) fn highlight(text: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    match text.parse() {
        Ok(stream) => collect(stream, text, &mut tokens),
        Err(_) => tokens.push((None, 0..text.len())),
    }
    let (mut lines, mut end) = (Lines(vec![String::new()]), 0);
    for (class, range) in tokens {
        lines.between(&text[end..range.start]);
        lines.write(class, &text[range.clone()]);
        end = range.end;
    }
    lines.between(&text[end..]);
    if lines.0.last().is_some_and(String::is_empty) {
        lines.0.pop();
    }
    lines.0
}

/// The tokens in order, except doc comments, which are attributes to the compiler.
fn collect(stream: TokenStream, text: &str, tokens: &mut Vec<Token>) {
    let mut quote = None;
    for tree in stream {
        let range = tree.span().byte_range();
        if text[range.clone()].starts_with("//") || text[range.clone()].starts_with("/*") {
            continue;
        }
        match tree {
            TokenTree::Group(group) => collect_group(&group, text, tokens),
            // The quote of a lifetime, which consists of two tokens.
            TokenTree::Punct(mark) if mark.as_char() == '\'' => quote = Some(range.start),
            TokenTree::Punct(_) => tokens.push((None, range)),
            TokenTree::Literal(_) => {
                let is_number = text[range.clone()].starts_with(|c: char| c.is_ascii_digit());
                tokens.push((Some(if is_number { "rn" } else { "rs" }), range));
            }
            TokenTree::Ident(word) => tokens.push(match quote.take() {
                Some(start) => (Some("rl"), start..range.end),
                None => (class(word), range),
            }),
        }
    }
}

fn collect_group(group: &Group, text: &str, tokens: &mut Vec<Token>) {
    tokens.push((None, group.span_open().byte_range()));
    collect(group.stream(), text, tokens);
    tokens.push((None, group.span_close().byte_range()));
}

/// The class that colours a word: a type, which begins with a capital, or a keyword.
fn class(word: Ident) -> Option<&'static str> {
    if word.to_string().starts_with(char::is_uppercase) {
        return Some("rt");
    }
    let is_keyword = word != "_" && syn::parse2::<Ident>(TokenTree::from(word).into()).is_err();
    is_keyword.then_some("rk")
}

/// Lines of HTML.
struct Lines(Vec<String>);

impl Lines {
    fn write(&mut self, class: Option<&str>, text: &str) {
        for (i, part) in text.split('\n').enumerate() {
            if i > 0 {
                self.0.push(String::new());
            }
            let Some(line) = self.0.last_mut() else { continue };
            let html = escape(part);
            match class {
                Some(class) if !part.is_empty() => line.extend(["<i class=\"", class, "\">", &html, "</i>"]),
                _ => line.push_str(&html),
            }
        }
    }

    /// The text between tokens: spaces and comments.
    fn between(&mut self, text: &str) {
        for (i, line) in text.split('\n').enumerate() {
            let comment = line.trim();
            let (before, after) = line.split_once(comment).unwrap_or_default();
            self.write(None, if i > 0 { "\n" } else { "" });
            self.write(None, before);
            self.write(Some("rc"), comment);
            self.write(None, after);
        }
    }
}

/// Highlighted lines as a block, without their common indentation.
pub(crate) fn block(lines: &[String]) -> String {
    let indent = |line: &String| line.len() - line.trim_start().len();
    let shared = lines.iter().filter(|line| !line.trim().is_empty()).map(indent).min().unwrap_or(0);
    let lines: Vec<&str> = lines.iter().map(|line| line.get(shared..).unwrap_or("")).collect();
    format!("<pre><code class=\"nohighlight\">{}</code></pre>", lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_line_is_complete_html() {
        let lines = highlight("/* a\nb */ fn\n\n");
        assert_eq!(lines, ["<i class=\"rc\">/* a</i>", "<i class=\"rc\">b */</i> <i class=\"rk\">fn</i>", ""]);
        assert_eq!(highlight("\nx"), ["", "x"]);
        assert_eq!(highlight("x\n"), ["x"]);
        assert_eq!(highlight("/*\n\n*/"), ["<i class=\"rc\">/*</i>", "", "<i class=\"rc\">*/</i>"]);
        assert_eq!(highlight("\"a\n b\""), ["<i class=\"rs\">&quot;a</i>", "<i class=\"rs\"> b&quot;</i>"]);
    }

    #[test]
    fn every_kind_has_its_colour() {
        let coloured = "<i class=\"rk\">let</i> a<i class=\"rl\">'b</i>:<i class=\"rt\">C</i>=<i class=\"rn\">1</i><i class=\"rs\">'&lt;'</i>";
        assert_eq!(highlight("let a'b:C=1'<'"), [coloured]);
        assert_eq!(highlight("_ a_1 é9 'static"), ["_ a_1 é9 <i class=\"rl\">'static</i>"]);
        let range = "<i class=\"rn\">1</i>..<i class=\"rn\">2.0e-3</i>/(<i class=\"rn\">3</i>.max(x))";
        assert_eq!(highlight("1..2.0e-3/(3.max(x))"), [range]);
    }

    #[test]
    fn comments_are_told_from_code_and_keep_their_indentation() {
        let text = "//! a\n\nfn f() {\n    /// é <b>\n    /* c /* d */\n     e */ x; // {\n}\n";
        let comment = |text: &str| format!("<i class=\"rc\">{text}</i>");
        let expected = [
            comment("//! a"),
            String::new(),
            "<i class=\"rk\">fn</i> f() &#123;".into(),
            format!("    {}", comment("/// é &lt;b&gt;")),
            format!("    {}", comment("/* c /* d */")),
            format!("     {} x; {}", comment("e */"), comment("// &#123;")),
            "}".into(),
        ];
        assert_eq!(highlight(text), expected);
    }

    #[test]
    fn broken_code_has_no_colours() {
        assert_eq!(highlight("fn <\n{ (\n"), ["fn &lt;", "&#123; ("]);
    }

    #[test]
    fn a_block_loses_its_shared_indentation() {
        assert_eq!(
            block(&["    a".into(), String::new(), "      b".into()]),
            "<pre><code class=\"nohighlight\">a\n\n  b</code></pre>"
        );
        assert_eq!(block(&[" ".into()]), "<pre><code class=\"nohighlight\"> </code></pre>");
    }
}
