//! Fixes accessibility defects of mdBook's own pages for keyboard and screen reader users.

/// Replacements applied to every page.
const MENDED: [(&str, &str); 5] = [
    // A label is no button: the role permits its ARIA attributes, and makes it reachable by keyboard.
    ("<label id=\"mdbook-sidebar-toggle\"", "<label id=\"mdbook-sidebar-toggle\" role=\"button\" tabindex=\"0\""),
    // A placeholder is no accessible name, and the header of the results has another identifier.
    (
        "aria-describedby=\"searchresults-header\"",
        "aria-label=\"Search this book\" aria-describedby=\"mdbook-searchresults-header\"",
    ),
    // Scrollable code must be reachable by keyboard.
    ("<pre><code", "<pre><code tabindex=\"0\""),
    ("<pre class=\"output\"><code", "<pre class=\"output\"><code tabindex=\"0\""),
    ("</body>", "<script>\n{page.js}</script>\n</body>"),
];

/// mdBook's script for highlighting other languages, and a stub in its place: our own code is highlighted by the build.
const COLOURS: &str = "src=\"highlight.js\"></script>";
const NO_COLOURS: &str = ">window.hljs = { configure() {}, highlightBlock() {}, highlightElement() {} };</script>";

/// The script of every page.
const SCRIPT: &str = include_str!("page.js");

/// Prevents line breaks at the hyphens of command options in the text.
fn with_whole_options(page: &str) -> String {
    let mut pieces = page.split("<code>");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let is_block = out.ends_with("<pre>");
        out.push_str("<code>");
        if is_block {
            out.push_str(piece);
            continue;
        }
        let code = piece.split_once("</code>").map_or("", |(code, _)| code);
        let words = code.split(' ').map(|word| {
            if word.starts_with("--") { format!("<span class=\"option\">{word}</span>") } else { word.to_owned() }
        });
        out.push_str(&words.collect::<Vec<_>>().join(" "));
        out.push_str(&piece[code.len()..]);
    }
    out
}

/// The page, fixed.
pub(crate) fn mended(page: &str) -> String {
    let mut page = with_whole_options(page);
    for (from, to) in MENDED {
        page = page.replace(from, &to.replace("{page.js}", SCRIPT));
    }
    if !page.contains(" class=\"language-") {
        page = page.replace(COLOURS, NO_COLOURS);
    }
    // The table of contents for readers without scripts needs a title.
    if page.contains("<title>") { page } else { page.replace("<head>", "<head>\n<title>Contents</title>") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_in_the_text_are_kept_whole() {
        let options =
            "<code>golden <span class=\"option\">--check</span> a--b</code>, <pre><code>golden --check</code>";
        assert_eq!(with_whole_options("<code>golden --check a--b</code>, <pre><code>golden --check</code>"), options);
        assert_eq!(with_whole_options("a <code>b c</code> d"), "a <code>b c</code> d");
    }

    #[test]
    fn a_script_that_colours_is_loaded_where_there_is_code_to_colour() {
        let script = "<title>T</title><script src=\"highlight.js\"></script>";
        assert_eq!(mended(script), format!("<title>T</title><script {NO_COLOURS}"));
        let code = format!("{script}<code class=\"language-sh\">");
        assert_eq!(mended(&code), code);
    }

    #[test]
    fn a_page_without_a_title_gets_one() {
        assert_eq!(mended("<head><title>T</title></head>"), "<head><title>T</title></head>");
        assert_eq!(mended("<head></head>"), "<head>\n<title>Contents</title></head>");
    }

    #[test]
    fn code_is_reached_by_the_keyboard() {
        assert_eq!(mended("<pre><code class=\"a\">"), "<pre><code tabindex=\"0\" class=\"a\">");
    }
}
