//! The layout of a displayed equation: a line for each quantity, aligned at its relation, broken between terms where it is wider than its column.
//!
//! `MathML` in browsers has no line breaks, so an equation is cut before its relations and signs into several `math`
//! elements, which wrap like words: on a desk, on a phone and on paper alike. The outermost operators break first.

/// Terms up to this width, in em, are never broken: they fit a phone.
const WHOLE: f64 = 13.0;

/// Left sides up to this width have a column of their own.
const LEFT: f64 = 12.0;

/// Factors up to this width stay with their product.
const SHORT: f64 = 4.0;

/// Relations, before which a line is aligned and may break.
const RELATIONS: &str = "=≈≠<>≤≥→⇒∝≡∈";

/// Signs between terms.
const SIGNS: &str = "+−±";

/// Signs between factors.
const PRODUCTS: &str = "⋅×⊗";

/// The pieces of HTML of an equation that was converted to `MathML`, with `latex` as its alternative text.
pub(super) fn flow(mathml: &str, alternative: &str) -> String {
    let lines: Vec<Line> = parsed(mathml).map(|math| lines(math.inner)).unwrap_or_default();
    let html: String = lines.into_iter().map(Line::html).collect();
    format!("<span class=\"math-block\" tabindex=\"0\" role=\"math\" aria-label=\"{alternative}\">{html}</span>")
}

/// An element of `MathML`.
#[derive(Clone, Debug, Default)]
struct Node {
    /// The tag with its attributes.
    tag: String,
    text: String,
    inner: Vec<Node>,
}

impl Node {
    fn new(tag: &str, inner: Vec<Node>) -> Self {
        Self { tag: tag.into(), text: String::new(), inner }
    }

    fn leaf(tag: &str, text: &str) -> Self {
        Self { tag: tag.into(), text: text.into(), inner: Vec::new() }
    }

    fn name(&self) -> &str {
        self.tag.split(' ').next().unwrap_or_default()
    }

    /// The character of an operator, or an empty text.
    fn operator(&self) -> &str {
        match (self.name(), self.text.as_str()) {
            ("mo", "&lt;") => "<",
            ("mo", "&gt;") => ">",
            ("mo", text) => text,
            _ => "",
        }
    }

    fn is_in(&self, operators: &str) -> bool {
        let text = self.operator();
        !text.is_empty() && operators.contains(text)
    }

    /// By how much the depth of brackets changes here; a closing bracket may bear an exponent.
    fn opens(&self) -> i32 {
        let mark = if self.name().starts_with("msu") { self.inner.first().unwrap_or(self) } else { self };
        match mark.operator() {
            "(" | "[" => 1,
            ")" | "]" => -1,
            "|" if mark.tag.contains("prefix") => 1,
            "|" if mark.tag.contains("postfix") => -1,
            _ => 0,
        }
    }

    /// Whether an operator that follows has an operand on its left.
    fn ends_operand(&self) -> bool {
        self.opens() < 0 || !matches!(self.name(), "mo" | "mspace") || self.is_in("′∘|")
    }

    /// A space that separates quantities.
    fn is_quad(&self) -> bool {
        let width = self.tag.strip_prefix("mspace width=\"").and_then(|rest| rest.split_once("em\""));
        width.and_then(|(em, _)| em.parse().ok()).is_some_and(|em: f64| em >= 1.0)
    }

    /// The estimated width, in em.
    fn width(&self) -> f64 {
        let widest = |nodes: &[Node]| nodes.iter().map(Node::width).fold(0.0, f64::max);
        let is_script = self.name().starts_with("msu");
        match self.name() {
            "mo" if self.is_in(RELATIONS) || self.is_in(SIGNS) || self.is_in(PRODUCTS) => 1.15,
            "mo" if self.text.chars().count() == 1 => 0.4,
            "mspace" => 0.5,
            "mi" | "mn" | "mo" | "mtext" => 0.55 * self.text.chars().count() as f64,
            "mfrac" => widest(&self.inner) + 0.2,
            "mtable" => {
                let columns = self.inner.iter().map(|row| row.inner.len()).max().unwrap_or(0);
                let column = |k: usize| {
                    let cells = self.inner.iter().filter_map(|row| row.inner.get(k));
                    cells.map(Node::width).fold(0.0, f64::max)
                };
                (0..columns).map(|k| column(k) + 0.8).sum()
            }
            _ if is_script => self.inner[..1].iter().map(Node::width).sum::<f64>() + 0.7 * widest(&self.inner[1..]),
            "munder" | "munderover" | "mover" => widest(&self.inner),
            "msqrt" => width(&self.inner) + 0.8,
            _ => width(&self.inner),
        }
    }

    fn html(&self, out: &mut String) {
        if self.inner.is_empty() && self.text.is_empty() && self.name() == "mspace" {
            out.extend(["<", &self.tag, "/>"]);
            return;
        }
        out.extend(["<", &self.tag, ">", &self.text]);
        self.inner.iter().for_each(|node| node.html(out));
        out.extend(["</", self.name(), ">"]);
    }
}

fn width(nodes: &[Node]) -> f64 {
    nodes.iter().map(Node::width).sum()
}

/// The element at the beginning of a text in the `MathML` of the converter, which is well formed and has no comments.
fn parsed(mathml: &str) -> Option<Node> {
    let mut open: Vec<Node> = Vec::new();
    let mut rest = mathml;
    while let Some((text, after)) = rest.split_once('<') {
        let (tag, after) = after.split_once('>')?;
        if let Some(node) = open.last_mut().filter(|node| node.inner.is_empty()) {
            node.text += text;
        }
        rest = after;
        let done = if tag.starts_with('/') {
            open.pop()?
        } else if let Some(tag) = tag.strip_suffix('/') {
            Node::leaf(tag, "")
        } else {
            open.push(Node::leaf(tag, ""));
            continue;
        };
        match open.last_mut() {
            Some(parent) => parent.inner.push(done),
            None => return Some(done),
        }
    }
    None
}

/// A quantity: what is left of its relation, if that is short, and the rest.
struct Line {
    left: Vec<Node>,
    right: Vec<Node>,
}

impl Line {
    /// The quantity of a row, cut before its first relation.
    fn of(mut row: Vec<Node>) -> Self {
        let at = cuts(&row, RELATIONS, 0).first().copied();
        match at.filter(|at| width(&row[..*at]) < LEFT) {
            Some(at) => {
                let right = row.split_off(at);
                Self { left: row, right }
            }
            None => Self { left: Vec::new(), right: row },
        }
    }

    fn html(self) -> String {
        let alone = if self.left.is_empty() { " alone" } else { "" };
        let left = if self.left.is_empty() {
            String::new()
        } else {
            format!("<span class=\"left\">{}</span>", math(self.left, false))
        };
        let is_cut = !left.is_empty();
        let parts: String = set(self.right, is_cut).into_iter().map(Part::html).collect();
        format!("<span class=\"line{alone}\">{left}<span class=\"right\">{parts}</span></span>")
    }
}

/// The quantities of an equation, one a line.
fn lines(row: Vec<Node>) -> Vec<Line> {
    let mut lines = Vec::new();
    for mut row in quantities(row) {
        let is_table = row.first().is_some_and(is_aligned) && row[1..].iter().all(|node| node.is_in(",.;"));
        if !is_table {
            lines.push(Line::of(row));
            continue;
        }
        // What follows a table is its punctuation.
        let mark = row.split_off(1);
        let cells = row.remove(0).inner;
        let mut rows: Vec<Vec<Node>> = cells.into_iter().flat_map(|row| pairs(row.inner)).collect();
        rows.last_mut().into_iter().for_each(|last| last.extend(mark.clone()));
        lines.extend(rows.into_iter().flat_map(quantities).map(Line::of));
    }
    lines
}

/// Whether a table has columns aligned at a relation.
fn is_aligned(table: &Node) -> bool {
    let first = table.inner.first().filter(|_| table.name() == "mtable").and_then(|row| row.inner.first());
    first.is_some_and(|cell| cell.tag.contains("text-align: right"))
}

/// The equations of a row of aligned equations: each is a left and a right cell.
fn pairs(cells: Vec<Node>) -> Vec<Vec<Node>> {
    let mut rows: Vec<Vec<Node>> = Vec::new();
    for (k, cell) in cells.into_iter().enumerate() {
        let nodes = contents(cell);
        match rows.last_mut().filter(|_| k % 2 == 1) {
            Some(row) => row.extend(nodes),
            None => rows.push(nodes),
        }
    }
    rows.retain(|row| !row.is_empty());
    rows
}

/// The quantities of a row, which are separated by a comma and a space.
fn quantities(row: Vec<Node>) -> Vec<Vec<Node>> {
    let mut rows: Vec<Vec<Node>> = vec![Vec::new()];
    let mut depth = 0;
    for node in row {
        depth += node.opens();
        let after_comma = rows.last().and_then(|row| row.last()).is_some_and(|last| last.is_in(",;"));
        if depth == 0 && node.is_quad() && after_comma {
            rows.push(Vec::new());
        } else if let Some(row) = rows.last_mut() {
            row.push(node);
        }
    }
    // What is no equation is a remark on the one before.
    let mut whole: Vec<Vec<Node>> = Vec::new();
    for row in rows.into_iter().filter(|row| !row.is_empty()) {
        let is_equation = row.first().is_some_and(is_aligned) || !cuts(&row, RELATIONS, 0).is_empty();
        match whole.last_mut().filter(|_| !is_equation) {
            Some(before) => {
                before.push(Node::leaf("mspace width=\"1em\"", ""));
                before.extend(row);
            }
            None => whole.push(row),
        }
    }
    whole
}

/// The places before these operators at a depth of brackets; a sign without an operand on its left is none.
fn cuts(row: &[Node], operators: &str, wanted: i32) -> Vec<usize> {
    let mut depth = 0;
    let mut found = Vec::new();
    for (k, node) in row.iter().enumerate() {
        if depth == wanted && k > 0 && node.is_in(operators) && row[k - 1].ends_operand() {
            found.push(k);
        }
        depth += node.opens();
    }
    found
}

/// Something that wraps as a whole, or within itself if it is wider than its column.
enum Part {
    /// The flag tells that an operand precedes it.
    Whole(Vec<Node>, bool),
    Several(Vec<Part>),
    /// Alternatives with a brace on their left.
    Cases(Vec<Vec<Part>>),
}

impl Part {
    fn html(self) -> String {
        let all = |parts: Vec<Part>| parts.into_iter().map(Part::html).collect::<String>();
        match self {
            Part::Whole(row, is_cut) => math(row, is_cut),
            Part::Several(parts) => format!("<span class=\"part\">{}</span>", all(parts)),
            Part::Cases(rows) => {
                let rows = rows.into_iter().map(|row| format!("<span class=\"part\">{}</span>", all(row)));
                format!("<span class=\"cases\">{}</span>", rows.collect::<String>())
            }
        }
    }

    /// The row at the beginning, for what is glued to it.
    fn first(&mut self) -> Option<(&mut Vec<Node>, &mut bool)> {
        match self {
            Part::Whole(row, is_cut) => Some((row, is_cut)),
            Part::Several(parts) => parts.first_mut().and_then(Part::first),
            Part::Cases(_) => None,
        }
    }

    /// The row at the end.
    fn last(&mut self) -> Option<&mut Vec<Node>> {
        match self {
            Part::Whole(row, _) => Some(row),
            Part::Several(parts) => parts.last_mut().and_then(Part::last),
            Part::Cases(_) => None,
        }
    }
}

/// A row as a `math` element; `is_cut` tells that its first operator has its operand in the one before.
fn math(mut row: Vec<Node>, is_cut: bool) -> String {
    if let Some(first) = row.first_mut().filter(|first| is_cut && first.name() == "mo" && !first.tag.contains("form="))
    {
        first.tag += " form=\"infix\"";
    }
    let mut out = "<math displaystyle=\"true\">".to_owned();
    row.iter().for_each(|node| node.html(&mut out));
    out + "</math>"
}

/// The parts of a row: cut at the relations, then at the signs, then at products, then within the widest bracket.
fn set(row: Vec<Node>, is_cut: bool) -> Vec<Part> {
    let spaces = after_spaces(&row);
    for places in [cuts(&row, RELATIONS, 0), spaces, cuts(&row, SIGNS, 0)] {
        if !places.is_empty() {
            return split(row, &places, is_cut).into_iter().map(|(row, is_cut)| one(set(row, is_cut))).collect();
        }
    }
    if width(&row) <= WHOLE {
        return vec![Part::Whole(row, is_cut)];
    }
    let mut products = cuts(&row, PRODUCTS, 0);
    products.retain(|&at| width(&row[..at]) > SHORT && width(&row[at..]) > SHORT);
    if !products.is_empty() {
        return split(row, &products, is_cut).into_iter().map(|(row, is_cut)| one(set(row, is_cut))).collect();
    }
    opened(row, is_cut)
}

/// The places after spaces between remarks, or after commas.
fn after_spaces(row: &[Node]) -> Vec<usize> {
    let mut depth = 0;
    let mut found = Vec::new();
    for (k, node) in row.iter().enumerate() {
        depth += node.opens();
        if depth == 0 && node.is_quad() && k > 0 && k + 1 < row.len() {
            found.push(k + 1);
        }
    }
    found
}

fn one(mut parts: Vec<Part>) -> Part {
    if parts.len() == 1 { parts.remove(0) } else { Part::Several(parts) }
}

fn split(mut row: Vec<Node>, places: &[usize], is_cut: bool) -> Vec<(Vec<Node>, bool)> {
    let mut rows = Vec::new();
    for &place in places.iter().rev() {
        rows.push((row.split_off(place), true));
    }
    rows.push((row, is_cut));
    rows.reverse();
    rows
}

/// A term that is too wide, broken within its widest bracket, fraction, root or case.
fn opened(row: Vec<Node>, is_cut: bool) -> Vec<Part> {
    let row = unwrapped(row);
    let Some((from, to)) = widest_bracket(&row) else { return widest_cases(row, is_cut) };
    let (mut row, mut after) = (row, Vec::new());
    after.extend(row.drain(to..));
    let inner: Vec<Node> = row.drain(from + 1..).collect();
    // The bracket stays with what precedes it, and if that is short with the beginning of what it opens.
    let mut parts = commas(inner);
    let mut ends = after.into_iter();
    let closing = ends.next();
    match parts.first_mut().and_then(Part::first).filter(|_| width(&row) <= SHORT) {
        Some((first, cut)) => {
            first.splice(0..0, row);
            *cut = is_cut;
        }
        None => parts.insert(0, Part::Whole(row, is_cut)),
    }
    match parts.last_mut().and_then(Part::last) {
        Some(last) => last.extend(closing),
        None => parts.push(Part::Whole(closing.into_iter().collect(), false)),
    }
    let rest: Vec<Node> = ends.collect();
    if rest.iter().all(|node| node.name() == "mspace" || node.is_in(",.;")) || width(&rest) <= SHORT {
        if let Some(last) = parts.last_mut().and_then(Part::last) {
            last.extend(rest);
            return parts;
        }
    }
    if !rest.is_empty() {
        parts.extend(set(rest, true));
    }
    parts
}

/// The parts of what is in a bracket, which may be a list.
fn commas(row: Vec<Node>) -> Vec<Part> {
    let mut depth = 0;
    let mut places = Vec::new();
    for (k, node) in row.iter().enumerate() {
        depth += node.opens();
        if depth == 0 && node.is_in(",") && k + 1 < row.len() {
            places.push(k + 1);
        }
    }
    if places.is_empty() {
        return set(row, false);
    }
    split(row, &places, false).into_iter().map(|(row, _)| one(set(row, false))).collect()
}

/// The row with stretched brackets, wide fractions and wide roots as plain brackets.
fn unwrapped(row: Vec<Node>) -> Vec<Node> {
    let mut out = Vec::new();
    for mut node in row {
        let is_wide = node.width() > WHOLE;
        match node.name() {
            "mrow" if is_wide && node.inner.len() > 2 && node.inner[0].text != "{" => out.extend(unwrapped(node.inner)),
            "mfrac" if is_wide && node.inner.len() == 2 && node.inner[1].width() <= WHOLE => {
                let over = std::mem::replace(&mut node.inner[0], Node::leaf("mn", "1"));
                out.push(node);
                out.extend(bracketed(over, None));
            }
            "mfrac" if is_wide && node.inner.len() == 2 => {
                let under = node.inner.pop().unwrap_or_default();
                out.extend(bracketed(node.inner.pop().unwrap_or_default(), None));
                out.push(Node::leaf("mo", "/"));
                out.extend(bracketed(under, None));
            }
            "msqrt" if is_wide => {
                let half =
                    Node::new("mfrac displaystyle=\"false\"", vec![Node::leaf("mn", "1"), Node::leaf("mn", "2")]);
                out.extend(bracketed(Node::new("mrow", node.inner), Some(half)));
            }
            "msup" if is_wide && node.inner.len() == 2 && node.inner[0].name() == "mrow" => {
                let exponent = node.inner.pop();
                let mut base = node.inner.remove(0).inner;
                let close = base.pop().unwrap_or_default();
                out.extend(base);
                out.push(Node::new("msup", [close].into_iter().chain(exponent).collect()));
            }
            _ => out.push(node),
        }
    }
    out
}

/// A sum in brackets, with an exponent if there is one.
fn bracketed(node: Node, exponent: Option<Node>) -> Vec<Node> {
    let inner = spaced(if node.tag == "mrow" { contents(node) } else { vec![node] });
    let close = Node::leaf("mo", ")");
    let close = match exponent {
        Some(exponent) => Node::new("msup", vec![close, exponent]),
        None => close,
    };
    [vec![Node::leaf("mo", "(")], inner, vec![close]].concat()
}

/// A row that was set small, with the spaces of a large one around its binary operators.
fn spaced(mut row: Vec<Node>) -> Vec<Node> {
    for k in 0..row.len() {
        let is_binary = k > 0 && row[k - 1].ends_operand();
        let node = &mut row[k];
        if node.name() == "mo" && is_binary && [RELATIONS, SIGNS, PRODUCTS].iter().any(|all| node.is_in(all)) {
            node.tag = "mo".into();
        }
        if node.name() == "mrow" {
            node.inner = spaced(std::mem::take(&mut node.inner));
        }
    }
    row
}

/// The outermost bracket with the widest contents: the places of its marks.
fn widest_bracket(row: &[Node]) -> Option<(usize, usize)> {
    let (mut depth, mut from) = (0, 0);
    let mut best: Option<(f64, usize, usize)> = None;
    for (k, node) in row.iter().enumerate() {
        let change = node.opens();
        if change > 0 && depth == 0 {
            from = k;
        }
        depth += change;
        if change < 0 && depth == 0 && k > from + 1 {
            let wide = width(&row[from + 1..k]);
            if best.is_none_or(|(known, ..)| wide > known) {
                best = Some((wide, from, k));
            }
        }
    }
    best.filter(|(wide, ..)| *wide > 2.0).map(|(_, from, to)| (from, to))
}

/// A row without brackets: its cases stand below each other as parts.
fn widest_cases(mut row: Vec<Node>, is_cut: bool) -> Vec<Part> {
    let is_cases = |node: &Node| {
        node.tag == "mrow"
            && node.inner.len() > 1
            && node.inner[0].operator() == "{"
            && node.inner[1].name() == "mtable"
    };
    let Some(at) = row.iter().position(|node| is_cases(node) && node.width() > WHOLE) else {
        return vec![Part::Whole(row, is_cut)];
    };
    let after = row.split_off(at + 1);
    let mut parts = Vec::new();
    let cases = row.pop().map(|mut node| node.inner.remove(1).inner).unwrap_or_default();
    if !row.is_empty() {
        parts.push(Part::Whole(row, is_cut));
    }
    let alternative = |row: Node| {
        let mut cells = row.inner.into_iter().map(|cell| one(set(contents(cell), false)));
        let value = cells.next();
        value
            .into_iter()
            .chain(cells.map(|condition| {
                Part::Several(vec![Part::Whole(vec![Node::leaf("mspace width=\"1em\"", "")], false), condition])
            }))
            .collect()
    };
    parts.push(Part::Cases(cases.into_iter().map(alternative).collect()));
    if !after.is_empty() {
        parts.extend(set(after, true));
    }
    parts
}

/// What is in a cell.
fn contents(cell: Node) -> Vec<Node> {
    match <[Node; 1]>::try_from(cell.inner) {
        Ok([row]) if row.tag == "mrow" => row.inner,
        Ok([one]) => vec![one],
        Err(nodes) => nodes,
    }
}

#[cfg(test)]
mod tests {
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
}
