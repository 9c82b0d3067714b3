//! The elements of `MathML`: their text, their width and their role in an equation.

/// Relations, before which a line is aligned and may break.
pub(super) const RELATIONS: &str = "=≈≠<>≤≥→⇒∝≡∈";

/// Signs between terms.
pub(super) const SIGNS: &str = "+−±";

/// Signs between factors.
pub(super) const PRODUCTS: &str = "⋅×⊗";

/// An element of `MathML`.
#[derive(Clone, Debug, Default)]
pub(super) struct Node {
    /// The tag with its attributes.
    pub(super) tag: String,
    pub(super) text: String,
    pub(super) inner: Vec<Node>,
}

impl Node {
    pub(super) fn new(tag: &str, inner: Vec<Node>) -> Self {
        Self { tag: tag.into(), text: String::new(), inner }
    }

    pub(super) fn leaf(tag: &str, text: &str) -> Self {
        Self { tag: tag.into(), text: text.into(), inner: Vec::new() }
    }

    pub(super) fn name(&self) -> &str {
        self.tag.split(' ').next().unwrap_or_default()
    }

    /// The character of an operator, or an empty text.
    pub(super) fn operator(&self) -> &str {
        match (self.name(), self.text.as_str()) {
            ("mo", "&lt;") => "<",
            ("mo", "&gt;") => ">",
            ("mo", text) => text,
            _ => "",
        }
    }

    pub(super) fn is_in(&self, operators: &str) -> bool {
        let text = self.operator();
        !text.is_empty() && operators.contains(text)
    }

    /// By how much the depth of brackets changes here; a closing bracket may bear an exponent.
    pub(super) fn opens(&self) -> i32 {
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
    pub(super) fn ends_operand(&self) -> bool {
        self.opens() < 0 || !matches!(self.name(), "mo" | "mspace") || self.is_in("′∘|")
    }

    /// A space that separates quantities.
    pub(super) fn is_quad(&self) -> bool {
        let width = self.tag.strip_prefix("mspace width=\"").and_then(|rest| rest.split_once("em\""));
        width.and_then(|(em, _)| em.parse().ok()).is_some_and(|em: f64| em >= 1.0)
    }

    /// The estimated width, in em.
    pub(super) fn width(&self) -> f64 {
        let widest = |nodes: &[Node]| nodes.iter().map(Node::width).fold(0.0, f64::max);
        let is_script = self.name().starts_with("msu");
        match self.name() {
            "mo" if self.is_in(RELATIONS) || self.is_in(SIGNS) || self.is_in(PRODUCTS) => 1.15,
            "mo" if self.text.chars().count() == 1 => 0.4,
            "mspace" => 0.5,
            "mi" | "mn" | "mo" | "mtext" => self.text.chars().map(|_| 0.55).sum(),
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

    pub(super) fn html(&self, out: &mut String) {
        if self.inner.is_empty() && self.text.is_empty() && self.name() == "mspace" {
            out.extend(["<", &self.tag, "/>"]);
            return;
        }
        out.extend(["<", &self.tag, ">", &self.text]);
        for node in &self.inner {
            node.html(out);
        }
        out.extend(["</", self.name(), ">"]);
    }
}

pub(super) fn width(nodes: &[Node]) -> f64 {
    nodes.iter().map(Node::width).sum()
}

/// The element at the beginning of a text in the `MathML` of the converter, which is well formed and has no comments.
pub(super) fn parsed(mathml: &str) -> Option<Node> {
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
