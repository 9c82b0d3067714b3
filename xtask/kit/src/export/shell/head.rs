//! The head of a user element: what an engineer needs to use it.

use crate::export::element::names;
use crate::export::recorded::filled;
use crate::uel::{Interface, degrees, is_position, len, places};
use jointproof::catalog::{AnyForm, Form};
use jointproof::formula::Field;
use jointproof::formula::quantity::Domain;
use jointproof::toolkit::verify::Layout;

/// The columns of the places and of the descriptions.
const COLUMNS: [usize; 2] = [11, 19];
/// The largest length of a line.
const WIDTH: usize = 100;

/// The head of an element of this type.
pub(super) fn of(element: &dyn AnyForm, number: usize, is_explicit: bool) -> String {
    let interface = Interface::new(element);
    let spec = element.spec();
    let layout = &interface.layout;
    let mut head = Head(String::new());
    let held = if layout.multipliers.is_empty() { "" } else { ", with Lagrange multipliers" };
    let (letter, program) = if is_explicit { ("V", "Explicit") } else { ("", "Standard") };
    let kind = format!("{letter}U{number}");
    head.text(&format!("{letter}UEL, a user element of Abaqus/{program}: {}{held}. It is of type {kind}.", spec.title));
    element.form().remarks().into_iter().for_each(|remark| head.text(remark));
    head.text(&format!("From {}; {}.", spec.source, spec.source.provenance));
    head.blank();
    nodes(&mut head, &interface);
    head.item("COORDS", "", "the positions of the nodes at the start");
    if interface.mcrd == 3 && interface.orientations() > 0 {
        head.item("U", "", if is_explicit {
            "rotations are taken as rotation vectors of the whole rotation, from which the triads follow"
        } else {
            "rotations are rotation vectors of the whole rotation, from which the triads follow; a step adds a spin in front of them, as Abaqus does"
        });
    }
    if is_explicit {
        explicit(&mut head, element);
    } else {
        standard(&mut head, layout);
    }
    properties(&mut head, &interface, is_explicit);
    for (k, (place, field)) in places(layout.state, 1).into_iter().enumerate() {
        head.item(if k == 0 { "SVARS" } else { "" }, &place, &meaning(field));
    }
    head.blank();
    deck(&mut head, &interface, &element.name(), (&kind, is_explicit));
    head.blank();
    if is_explicit {
        head.text("Abaqus/Explicit in double precision (double=explicit).");
    }
    head.text("Compile with -ffp-contract=off and without -ffast-math; with ifort and ifx, whose default reorders sums, with -fp-model precise.");
    head.text("Printed from the element that jointproof proves; free of conditions (CC0-1.0).");
    head.0
}

/// The results of a UEL.
fn standard(head: &mut Head, layout: &Layout) {
    let rhs = if layout.multipliers.is_empty() {
        "the forces of the element on its nodes".to_owned()
    } else {
        let residuals = names(layout.residuals);
        format!("the forces and moments of the element on its nodes, then the residuals {residuals}")
    };
    head.item("RHS", "", &rhs);
    head.item("AMATRX", "", "-dRHS/dU, with the spins of the nodes for their rotations; unsymmetric");
    head.item("PNEWDT", "", "0.5, and no contribution, where the element is not defined or a result is not finite: the increment is tried again with half of the time");
}

/// The results of a VUEL.
fn explicit(head: &mut Head, element: &dyn AnyForm) {
    head.item("RHS", "", "what Abaqus/Explicit calls the internal force, which it subtracts from the loads: minus the forces and moments of the element on its nodes");
    head.item("AMASS", "", "diagonal, at each node the mass and the rotary inertia of PROPS, which the element adds to the model; they may be small, but not 0");
    head.item("", "", "DTIMESTABLE is 2 / omega, at most the time of the step; omega**2 is the Frobenius norm of the derivative of the forces between unit masses, and no frequency of the element alone is higher. DMASSSCALEFACTOR is not used");
    let energy = if element.form().has_penalties { "3, internal: that of the penalties" } else { "not computed" };
    head.item("ENERGY", "", &format!("{energy}, without the work of friction"));
    head.text("The analysis ends (XPLB_EXIT) where the element is not defined, a mass is not positive or a result is not finite.");
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

fn properties(head: &mut Head, interface: &Interface, is_explicit: bool) {
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
            &format!(
                "Where {} is 0 there is no friction, and the other properties of friction have no effect.",
                field.name
            ),
        );
    }
    if name == "PROPS" {
        head.item(name, "1", "not used");
    }
    if is_explicit {
        let masses = ["mass of the element at each of its nodes", "rotary inertia of the element at each of its nodes"];
        for (k, what) in masses.into_iter().take(interface.masses()).enumerate() {
            head.item("", &(interface.nprops() + k + 1).to_string(), what);
        }
    }
}

/// The cards of a deck in which the element is aligned with the axes and has no friction.
fn deck(head: &mut Head, interface: &Interface, id: &str, (kind, is_explicit): (&str, bool)) {
    let Interface { layout, mcrd, nodes, .. } = interface;
    let set = id.to_uppercase();
    let (masses, unsymmetric) = if is_explicit { (interface.masses(), "") } else { (0, ", UNSYMM") };
    head.line(&format!(
        "*USER ELEMENT, TYPE={kind}, NODES={nodes}, COORDINATES={mcrd}, PROPERTIES={}, VARIABLES={}{unsymmetric}",
        interface.nprops() + masses,
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
    head.line(&format!("*ELEMENT, TYPE={kind}, ELSET={set}"));
    head.line(&listed(&(0..=*nodes).map(|k| if k == 0 { 1 } else { 100 + k }).collect::<Vec<_>>()));
    head.line(&format!("*UEL PROPERTY, ELSET={set}"));
    let mut values: Vec<String> = Vec::new();
    for field in layout.nodes.iter().filter(|field| !is_position(field)) {
        let axis = field.name[1..2].parse::<usize>().unwrap_or(1);
        values.extend((1..=field.len()).map(|k| if k == axis { "1.".into() } else { "0.".into() }));
    }
    for field in layout.start {
        let is_penalty = layout.residuals.iter().any(|residual| Form::penalty(residual) == *field);
        let value = if is_penalty || field.quantity.domain == Domain::Positive { "1." } else { "0." };
        values.extend(vec![value.to_owned(); field.len()]);
    }
    values.resize(interface.nprops(), "0.".into());
    values.extend(vec!["1.".to_owned(); masses]);
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
