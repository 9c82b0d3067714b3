//! Equations as they are set, and all equations of the catalog.

use super::node::{parsed, width};
use super::*;
use jointproof::catalog::CATALOG;
use jointproof::toolkit::equation::{Signature, View};
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

fn mathml(latex: &str) -> String {
    let converter = LatexToMathML::new(MathCoreConfig::default()).unwrap();
    converter.convert_with_local_state(latex, MathDisplay::Block).unwrap().mathml
}

/// Lines, with a bar before the relation and slashes between the pieces.
fn set_as(latex: &str) -> Vec<String> {
    let html = flow(&mathml(latex), "");
    let lines = html.split("<span class=\"line").skip(1);
    let line = |line: &str| {
        let marked = line.replace("</math></span><span class=\"right\">", "|").replace("</math>", "/");
        let plain = marked.split('<').map(|part| part.rsplit_once('>').map_or(part, |(_, text)| text));
        plain.collect::<String>().trim_start_matches("\" alone\"").trim_end_matches('/').to_owned()
    };
    lines.map(line).collect()
}

#[test]
fn a_quantity_has_a_line_and_a_remark_stays_with_it() {
    assert_eq!(set_as(r"a = b,\quad c = d\quad (i = 1, 2),\quad e"), ["a|=b,", "c|=d/(i=1,2),/e"]);
    assert_eq!(set_as(r"\begin{aligned} a &= b, & c &= d, \\ e &= f \end{aligned}"), ["a|=b,", "c|=d,", "e|=f"]);
    assert_eq!(set_as(r"a"), ["a"]);
}

#[test]
fn lines_break_before_relations_and_signs_but_not_after_an_operator_or_in_short_brackets() {
    assert_eq!(set_as("a = -b + c(d - e) = f"), ["a|=−b/+c(d−e)/=f"]);
    assert_eq!(set_as("a = b^{-1} - (c)^2 + -d"), ["a|=b−1/−(c)2/+−d"]);
}

#[test]
fn what_is_too_wide_is_opened_at_its_widest_bracket_fraction_root_and_case() {
    let sum = "xxxxxxxxxx + yyyyyyyyyy + zzzzzzzzzz";
    let opened = "(xxxxxxxxxx/+yyyyyyyyyy/+zzzzzzzzzz)";
    assert_eq!(set_as(&format!("a = b({sum})c")), [format!("a|=b{opened}c")]);
    assert_eq!(set_as(&format!(r"a = \left({sum}\right)^2")), [format!("a|={opened}2")]);
    assert_eq!(set_as(&format!(r"a = \frac{{{sum}}}{{c}}")), [format!("a|=1c{opened}")]);
    assert_eq!(set_as(&format!(r"a = \sqrt{{{sum}}}")), [format!("a|={opened}12")]);
    let cases = format!(r"a = \begin{{cases}} {sum} & b > 0 \\ 0 & \text{{otherwise}} \end{{cases}}");
    let html = flow(&mathml(&cases), "");
    assert_eq!(html.matches("<span class=\"cases\">").count(), 1, "{html}");
    assert!(set_as(&cases)[0].contains("xxxxxxxxxx/+yyyyyyyyyy/+zzzzzzzzzz/"), "{html}");
}

/// Everything that entries show: no letter is lost, and no piece is wider than a column.
#[test]
fn all_equations_of_the_catalog_fit() {
    let letters = |html: &str| {
        let mut all: Vec<String> =
            html.split("<mi").skip(1).filter_map(|rest| rest.split(['>', '<']).nth(1).map(String::from)).collect();
        all.sort();
        all
    };
    let mut widest = (0.0, String::new());
    for formula in CATALOG {
        let signature = Signature { spec: formula.spec(), inputs: formula.inputs(), outputs: formula.outputs() };
        let views = View::of(&signature).unwrap().map(|view| [view.variation, view.closed].concat());
        let all = [vec![formula.spec().latex.to_owned()], views.unwrap_or_default()].concat();
        for latex in all {
            let whole = mathml(&latex);
            let html = flow(&whole, "");
            assert_eq!(letters(&html), letters(&whole), "{latex}");
            for piece in html.split("<math displaystyle").skip(1) {
                let piece = format!("<math displaystyle{}", piece.split_once("</math>").unwrap().0) + "</math>";
                let width = width(&parsed(&piece).unwrap().inner);
                if width > widest.0 {
                    widest = (width, latex.clone());
                }
            }
        }
    }
    assert!(widest.0 > WHOLE / 2.0 && widest.0 < 28.0, "{widest:?}");
}
