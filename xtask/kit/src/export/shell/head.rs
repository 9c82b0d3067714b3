//! The head of a user element: what an engineer needs to use it.

use crate::export::element::names;
use crate::export::recorded::filled;
use crate::uel::{Interface, degrees, is_position, len, places};
use jointproof::catalog::AnyElement;
use jointproof::formula::Field;
use jointproof::formula::quantity::Domain;

/// The columns of the places and of the descriptions.
const COLUMNS: [usize; 2] = [11, 19];
/// The largest length of a line.
const WIDTH: usize = 100;

/// The head of an element of this type.
pub(super) fn of(element: &dyn AnyElement, number: usize) -> String {
    let interface = Interface::new(element);
    let spec = element.spec();
    let layout = &interface.layout;
    let mut head = Head(String::new());
    let held = if layout.multipliers.is_empty() { "" } else { ", with Lagrange multipliers" };
    head.text(&format!("UEL, a user element of Abaqus/Standard: {}{held}. It is of type U{number}.", spec.title));
    head.text(&format!("From {}; {}.", spec.source, spec.source.provenance));
    head.blank();
    nodes(&mut head, &interface);
    head.item("COORDS", "", "the positions of the nodes at the start");
    if interface.mcrd == 3 && interface.orientations() > 0 {
        head.item("U", "", "rotations are rotation vectors of the whole rotation, from which the triads follow; a step adds a spin in front of them, as Abaqus does");
    }
    let rhs = if layout.multipliers.is_empty() {
        "the forces of the element on its nodes".to_owned()
    } else {
        let residuals = names(layout.residuals);
        format!("the forces and moments of the element on its nodes, then the residuals {residuals}")
    };
    head.item("RHS", "", &rhs);
    head.item("AMATRX", "", "-dRHS/dU, with the spins of the nodes for their rotations; unsymmetric");
    head.item("PNEWDT", "", "0.5, and no contribution, where the element is not defined or a result is not finite: the increment is tried again with half of the time");
    properties(&mut head, &interface);
    for (k, (place, field)) in places(layout.state, 1).into_iter().enumerate() {
        head.item(if k == 0 { "SVARS" } else { "" }, &place, &meaning(field));
    }
    head.blank();
    deck(&mut head, &interface, spec.id, number);
    head.blank();
    head.text("Compile with -ffp-contract=off and without -ffast-math; with ifort and ifx, whose default reorders sums, with -fp-model precise.");
    head.text("Printed from the element that jointproof proves; free of conditions (CC0-1.0).");
    head.0
}

fn meaning(field: &Field) -> String {
    format!("{}: {}", field.name, field.quantity.meaning)
}

/// The degrees of freedom of each node.
fn nodes(head: &mut Head, interface: &Interface) {
    let layout = &interface.layout;
    let label = |field: &Field| field.name[1..].to_owned();
    let all: Vec<_> = layout.nodes.iter().filter(|field| is_position(field)).map(label).collect();
    for (k, node) in all.iter().enumerate() {
        let degrees = layout.unknowns.iter().filter(|field| label(field) == *node).map(|field| {
            let numbers = degrees(field, interface.mcrd);
            let range = match numbers[..] {
                [one] => one.to_string(),
                _ => format!("{}-{}", numbers[0], numbers[numbers.len() - 1]),
            };
            format!("{range} {}, {}", field.name, field.quantity.meaning)
        });
        let degrees: Vec<_> = degrees.collect();
        head.item(if k == 0 { "nodes" } else { "" }, &(k + 1).to_string(), &degrees.join("; "));
    }
    if !layout.multipliers.is_empty() {
        let degrees =
            places(layout.multipliers, 1).into_iter().map(|(place, field)| format!("{place} {}", meaning(field)));
        let degrees: Vec<_> = degrees.collect();
        head.item(
            "",
            &interface.nodes.to_string(),
            &format!("an internal node with the multipliers: {}", degrees.join("; ")),
        );
    }
}

fn properties(head: &mut Head, interface: &Interface) {
    let layout = &interface.layout;
    let mut first = 1;
    let mut name = "PROPS";
    for field in layout.nodes.iter().filter(|field| !is_position(field)) {
        let place = format!("{first}-{}", first + field.len() - 1);
        head.item(name, &place, &format!("{} at the start", meaning(field)));
        (name, first) = ("", first + field.len());
    }
    for (place, field) in places(layout.start, first) {
        head.item(name, &place, &meaning(field));
        name = "";
    }
    for (place, field) in places(layout.contact, first + len(layout.start)) {
        head.item(name, &place, &meaning(field));
        name = "";
    }
    if let Some(field) = layout.contact.first() {
        head.item(
            "",
            "",
            &format!("Where {} is 0 there is no friction, and what follows it has no effect.", field.name),
        );
    }
    if name == "PROPS" {
        head.item(name, "1", "not used");
    }
}

/// The cards of a deck in which the element is aligned with the axes and has no friction.
fn deck(head: &mut Head, interface: &Interface, id: &str, number: usize) {
    let Interface { layout, mcrd, nodes, .. } = interface;
    let set = id.to_uppercase();
    head.line(&format!(
        "*USER ELEMENT, TYPE=U{number}, NODES={nodes}, COORDINATES={mcrd}, PROPERTIES={}, VARIABLES={}, UNSYMM",
        interface.nprops(),
        interface.svars()
    ));
    let label = |field: &Field| field.name[1..].to_owned();
    let mut before = Vec::new();
    for (k, node) in layout.nodes.iter().filter(|field| is_position(field)).enumerate() {
        let unknowns = layout.unknowns.iter().filter(|field| label(field) == label(node));
        let active: Vec<_> = unknowns.flat_map(|field| degrees(field, *mcrd)).collect();
        if active != before {
            head.line(&listed(
                &(if k == 0 { None } else { Some(k + 1) })
                    .into_iter()
                    .chain(active.iter().copied())
                    .collect::<Vec<_>>(),
            ));
            before = active;
        }
    }
    let multipliers = len(layout.multipliers);
    if multipliers > 0 {
        head.line(&listed(&[*nodes].into_iter().chain(1..=multipliers).collect::<Vec<_>>()));
    }
    head.line(&format!("*ELEMENT, TYPE=U{number}, ELSET={set}"));
    head.line(&listed(&(0..=*nodes).map(|k| if k == 0 { 1 } else { 100 + k }).collect::<Vec<_>>()));
    head.line(&format!("*UEL PROPERTY, ELSET={set}"));
    let mut values: Vec<String> = Vec::new();
    for field in layout.nodes.iter().filter(|field| !is_position(field)) {
        let axis = field.name[1..2].parse::<usize>().unwrap_or(1);
        values.extend((1..=field.len()).map(|k| if k == axis { "1.".into() } else { "0.".into() }));
    }
    for field in layout.start {
        let value = if field.quantity.domain == Domain::Positive { "1." } else { "0." };
        values.extend(vec![value.to_owned(); field.len()]);
    }
    values.resize(interface.nprops(), "0.".into());
    for line in values.chunks(8) {
        head.line(&line.join(", "));
    }
}

fn listed(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// Comments, line by line.
struct Head(String);

impl Head {
    fn blank(&mut self) {
        self.0 += "!\n";
    }

    /// A line of a deck.
    fn line(&mut self, text: &str) {
        self.0.extend(["!     ", text, "\n"]);
    }

    fn text(&mut self, text: &str) {
        for line in filled(text.split_whitespace(), WIDTH - 2) {
            self.0.extend(["! ", &line, "\n"]);
        }
    }

    /// A name, a place and a description.
    fn item(&mut self, name: &str, place: &str, text: &str) {
        let [at, description] = COLUMNS;
        let (from, width) = if place.is_empty() { (at, 0) } else { (description, description - at) };
        let mut start = format!("{:<at$}{place:<width$}", format!("! {name}"));
        for line in filled(text.split_whitespace(), WIDTH - from) {
            self.0.extend([&start, &line, "\n"]);
            start = format!("{:<from$}", "!");
        }
    }
}
