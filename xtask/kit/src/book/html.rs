//! Small helpers for writing HTML.

use std::fmt::Write as _;

/// Escapes text for an HTML element or attribute, and hides `{{` from mdBook's own directives.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '{' => out.push_str("&#123;"),
            '\n' => out.push_str("&#10;"),
            c => out.push(c),
        }
    }
    out
}

/// Escapes text so that neither Markdown nor HTML interprets anything in it.
pub(crate) fn escape_markdown(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if c.is_ascii_punctuation() {
            let _ = write!(out, "&#{};", u32::from(c));
        } else {
            out.push(if c == '\n' { ' ' } else { c });
        }
    }
    out
}

/// The characters of an HTML fragment without its tags, entities decoded.
pub(crate) fn text_of(html: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for c in html.chars() {
        match c {
            '<' => inside = true,
            '>' => inside = false,
            c if !inside => text.push(c),
            _ => {}
        }
    }
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
}

/// The HTML of several items, one after the other.
pub(crate) fn each<T>(items: impl IntoIterator<Item = T>, html: impl FnMut(T) -> String) -> String {
    items.into_iter().map(html).collect()
}

/// A table that scrolls inside its box on narrow screens.
pub(crate) fn table(class: &str, head: &[&str], rows: &str) -> String {
    let head = each(head, |name| format!("<th>{name}</th>"));
    format!(
        "<div class=\"table-wrapper\" tabindex=\"0\"><table class=\"{class}\"><thead><tr>{head}</tr></thead>\
         <tbody>{rows}</tbody></table></div>"
    )
}

/// A row; a cell whose text can be long is `wide`, a number is a `figure`.
pub(crate) fn row(cells: &[(&str, String)]) -> String {
    let cell = |(class, html): &(&str, String)| format!("<td class=\"{class}\">{html}</td>");
    format!("<tr>{}</tr>", each(cells, cell))
}

/// A number for readers: `0.93`, `12`, or `3.1 × 10⁻⁷¹` with a real superscript.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if (0.01..10_000.0).contains(&size) {
        let digits = if size < 10.0 && value.fract() != 0.0 { 2 } else { 0 };
        return format!("{value:.digits$}").replace('-', "−");
    }
    let text = format!("{value:.1e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{}\u{a0}×\u{a0}10<sup>{}</sup>", mantissa.replace('-', "−"), exponent.replace('-', "−"))
}

/// The relative path from the page `from` to the page `to`, both given from the root of the book.
pub(crate) fn relative(from: &str, to: &str) -> String {
    format!("{}{to}", "../".repeat(from.matches('/').count()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_what_would_be_read_as_markup() {
        assert_eq!(escape("a<b & \"{{#x"), "a&lt;b &amp; &quot;&#123;&#123;#x");
        assert_eq!(escape("a>\nb"), "a&gt;&#10;b");
        assert_eq!(escape_markdown("a*b|c"), "a&#42;b&#124;c");
        assert_eq!(escape_markdown("a\nb"), "a b");
    }

    #[test]
    fn text_of_mathml_is_its_characters() {
        assert_eq!(text_of("<msub><mi>F</mi><mi>C</mi></msub><mo>&lt;</mo>"), "FC<");
    }

    #[test]
    fn numbers_read_well_at_every_size() {
        assert_eq!(number(0.934), "0.93");
        assert_eq!(number(-12.4), "−12");
        assert_eq!(number(3.14e-71), "3.1\u{a0}×\u{a0}10<sup>−71</sup>");
        assert_eq!((number(0.0), number(4.0)), ("0".into(), "4".into()));
        let shown = [0.01, 9.5, 10.6, -0.5, 10_000.0, f64::INFINITY, f64::NAN].map(number);
        assert_eq!(shown, ["0.01", "9.50", "11", "−0.50", "1.0\u{a0}×\u{a0}10<sup>4</sup>", "inf", "NaN"]);
    }

    #[test]
    fn relative_paths_climb_out_of_folders() {
        assert_eq!(relative("slot.html", "golden/a.json"), "golden/a.json");
        assert_eq!(relative("joints/slot.html", "golden/a.json"), "../golden/a.json");
    }
}
