//! The layout of a displayed equation: a line for each quantity, aligned at its relation, broken between terms where it is wider than its column.
//!
//! `MathML` in browsers has no line breaks, so an equation is cut before its relations and signs into several `math`
//! elements, which wrap like words: on a desk, on a phone and on paper alike. The outermost operators break first.

mod node;
#[cfg(test)]
mod tests;

use node::{Node, PRODUCTS, RELATIONS, SIGNS, parsed, width};

/// Terms up to this width, in em, are never broken: they fit a phone.
const WHOLE: f64 = 13.0;

/// Left sides up to this width have a column of their own.
const LEFT: f64 = 12.0;

/// Factors up to this width stay with their product.
const SHORT: f64 = 4.0;

/// The pieces of HTML of an equation that was converted to `MathML`, with `latex` as its alternative text.
pub(super) fn flow(mathml: &str, alternative: &str) -> String {
    let lines: Vec<Line> = parsed(mathml).map(|math| lines(math.inner)).unwrap_or_default();
    let html: String = lines.into_iter().map(Line::html).collect();
    format!("<span class=\"math-block\" tabindex=\"0\" role=\"math\" aria-label=\"{alternative}\">{html}</span>")
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
    for node in &row {
        node.html(&mut out);
    }
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
    let is_short = width(&rest) <= SHORT || rest.iter().all(|node| node.name() == "mspace" || node.is_in(",.;"));
    if let Some(last) = parts.last_mut().and_then(Part::last).filter(|_| is_short) {
        last.extend(rest);
        return parts;
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
