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

/// The page, mended.
pub(crate) fn mended(page: &str) -> String {
    let mut page = page.to_owned();
    for (from, to) in MENDED {
        page = page.replace(from, &to.replace("{page.js}", SCRIPT));
    }
    if !page.contains(" class=\"language-") {
        page = page.replacen(COLOURS, NO_COLOURS, 1);
    }
    // The table of contents for readers without scripts.
    if page.contains("<title>") { page } else { page.replacen("<head>", "<head>\n<title>Contents</title>", 1) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn code_is_reached_by_the_keyboard() {
        assert_eq!(mended("<pre><code class=\"a\">"), "<pre><code tabindex=\"0\" class=\"a\">");
    }
}
