//! What mdBook's own pages lack for readers who use a keyboard or have a page read to them.

/// What is put in the place of what, in every page.
const MENDED: [(&str, &str); 5] = [
    // A label is no button: with the role, what it says of itself is allowed, and the keyboard reaches it.
    ("<label id=\"mdbook-sidebar-toggle\"", "<label id=\"mdbook-sidebar-toggle\" role=\"button\" tabindex=\"0\""),
    // A placeholder is no name, and the header of the results has another identifier.
    (
        "aria-describedby=\"searchresults-header\"",
        "aria-label=\"Search this book\" aria-describedby=\"mdbook-searchresults-header\"",
    ),
    // Code that scrolls is reached by the keyboard.
    ("<pre><code", "<pre><code tabindex=\"0\""),
    ("<pre class=\"output\"><code", "<pre class=\"output\"><code tabindex=\"0\""),
    ("</body>", "<script>\n{page.js}</script>\n</body>"),
];

/// What colours code of other languages, and what stands in for it where there is none: our own is coloured by the build.
const COLOURS: &str = "src=\"highlight.js\"></script>";
const NO_COLOURS: &str = ">window.hljs = { configure() {}, highlightBlock() {}, highlightElement() {} };</script>";

/// What every page does.
const SCRIPT: &str = include_str!("page.js");

/// Options of commands within the text are kept whole: a line would break at their hyphens.
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

/// The page, mended.
pub(crate) fn mended(page: &str) -> String {
    let mut page = with_whole_options(page);
    for (from, to) in MENDED {
        page = page.replace(from, &to.replace("{page.js}", SCRIPT));
    }
    if !page.contains(" class=\"language-") {
        page = page.replace(COLOURS, NO_COLOURS);
    }
    // The table of contents for readers without scripts.
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
