//! Listing pages for Rust files: line anchors that work from `file://`, excluded from the search index and the print page.

use std::fmt::Write as _;

use super::content::SourceFile;
use super::html::escape;
use super::rust::highlight;

/// The page that lists a file, from the root of the book.
pub fn listing_page(path: &str) -> String {
    format!("source/{path}.html")
}

/// The whole listing page, in the theme chosen in the book.
pub(crate) fn listing(source: &SourceFile, book_title: &str) -> String {
    let path = escape(&source.path);
    let root = "../".repeat(listing_page(&source.path).matches('/').count());
    let title = escape(book_title);
    let mut lines = String::new();
    for (index, line) in highlight(&source.text).iter().enumerate() {
        let n = index + 1;
        let _ = writeln!(
            lines,
            "<span id=\"L{n}\" class=\"line\"><a href=\"#L{n}\" data-n=\"{n}\" aria-label=\"line {n}\"></a>{line}</span>"
        );
    }
    format!(
        r#"<!DOCTYPE html>
<html lang="en" class="light">
<head>
<meta charset="UTF-8">
<title>{path} - {title}</title>
<meta name="robots" content="noindex">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="{root}favicon.svg">
<link rel="stylesheet" href="{root}css/variables.css">
<link rel="stylesheet" href="{root}css/general.css">
<link rel="stylesheet" href="{root}fonts/fonts.css">
<link rel="stylesheet" href="{root}theme/book.css">
<link rel="stylesheet" href="{root}theme/code.css">
<script>
(() => {{
  let theme = null;
  try {{ theme = localStorage.getItem("mdbook-theme"); }} catch {{ }}
  theme = theme && theme.replace(/"/g, "");
  if (!theme || theme === "default_theme") theme = matchMedia("(prefers-color-scheme: dark)").matches ? "navy" : "light";
  document.documentElement.className = theme + " js";
}})();
</script>
</head>
<body class="listing">
<header><a href="{root}index.html">{title}</a> <code>{path}</code></header>
<pre tabindex="0">{lines}</pre>
</body>
</html>
"#
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_has_an_anchor_and_markup_is_escaped() {
        let source = SourceFile { path: "src/a.rs".into(), text: "fn f() {\n    a < b\n}\n".into() };
        let page = listing(&source, "Book");
        assert_eq!(listing_page(&source.path), "source/src/a.rs.html");
        assert_eq!(page.matches("class=\"line\"").count(), 3);
        let second = "<span id=\"L2\" class=\"line\"><a href=\"#L2\" data-n=\"2\" aria-label=\"line 2\"></a>    a &lt; b</span>\n";
        assert!(page.contains(second) && page.contains("id=\"L1\"") && page.contains("id=\"L3\""), "{page}");
        assert!(page.contains("href=\"../../css/variables.css\""));
    }
}
