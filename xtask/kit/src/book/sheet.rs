//! Element sheets: all that the author of a user element needs, from the fields of an element, the equations of its formulas, and
//! one of its cases in numbers.

use std::fmt::Write as _;

use jointproof::catalog::AnyElement;
use jointproof::formula::Field;

use super::content::{Content, Entry, Sheet};
use super::worked::{listed as listed_numbers, matrix, numbers};
use crate::project::Project;
use crate::uel::{Interface, degrees, is_position, is_rotation, len, places};

/// The names of the lists of formulas in the directive, in the order of the sheet.
const LISTS: [&str; 6] = ["residuals", "rows", "forces", "stiffness", "friction", "rotations"];

const ORDER: &str = "Components are global. Forces, rows and matrices are in this order.";
const VELOCITY: &str = "The acceleration equations are $\\mathbf{G}\\,\\ddot{\\mathbf{q}} = -\\boldsymbol{\\gamma}$ with \
    $\\gamma_k = \\dot{\\mathbf{q}}^T\\mathbf{K}_k\\,\\dot{\\mathbf{q}}$, where $\\mathbf{K}_k$ is the stiffness without friction for $\\lambda_k = 1$ and no other multiplier. \
    For rotations, $\\dot{\\mathbf{q}}$ contains the angular velocities.";
const INTERNAL: &str = "A program that assembles internal forces, as [CalculiX](references.md#calculix) does with its user elements, takes $-\\mathbf{f}$ and $-\\mathbf{K}$.";
const ROWS: &str = "A row is the derivative of a residual with respect to the degrees of freedom. The entries of nodes that do not occur are zero.";
const FORCES: &str = "The forces and moments act on the nodes. They are $\\mathbf{G}^T\\boldsymbol{\\lambda}$, with the rows in $\\mathbf{G}$";
const STIFFNESS: &str = "The stiffness is the derivative of the forces and moments with respect to the degrees of freedom. \
    $\\mathbf{K}_{p,q}$ has a row for each component of the action on $p$ and a column for each component of the motion $q$.";
const HELD_FIXED: &str = "The multipliers are held constant.";
const TANGENT: &str = "A friction force $R$ works against a motion $s$ of the connector: it adds $-R\\,\\partial s/\\partial\\mathbf{q}$ to the \
    forces on the nodes, the moment on the first node included. To the stiffness it adds two parts, and one to the derivative with respect to the multipliers:\n\n\
    {{#presentation every golden case and every audited point holds it}}\n\n$$\n\
    \\mathbf{K} \\mathrel{+}= -R\\,\\frac{\\partial^2 s}{\\partial\\mathbf{q}^2} - \\frac{\\partial s}{\\partial\\mathbf{q}}\\otimes\\frac{\\partial R}{\\partial\\mathbf{q}},\\qquad\
    \\frac{\\partial\\mathbf{f}}{\\partial\\boldsymbol{\\lambda}} \\mathrel{+}= -\\frac{\\partial s}{\\partial\\mathbf{q}}\\otimes\\frac{\\partial R}{\\partial\\boldsymbol{\\lambda}}\n$$\n\n\
    In stick $\\partial R/\\partial\\mathbf{q} = k_{\\mathrm{stick}}\\,\\partial s/\\partial\\mathbf{q}$ and $\\partial R/\\partial\\boldsymbol{\\lambda} = \\mathbf{0}$; in slip \
    $R$ follows the limit, and both are $\\mu$ times the derivative of the normal force, with the sign of $R$. The first part remains in stick: the friction force rotates with its node.";
const ROTATIONS: &str = "The rotations above are spins, $\\delta\\mathbf{e} = \\delta\\boldsymbol{\\theta}\\times\\mathbf{e}$. With rotation vectors \
    $\\boldsymbol{\\psi}$ as unknowns, $\\delta\\boldsymbol{\\theta} = \\mathbf{T}\\,\\delta\\boldsymbol{\\psi}$: multiply the columns of the spin in the rows by $\\mathbf{T}$ from the right, \
    replace the moment $\\mathbf{m}$ by $\\mathbf{T}^T\\mathbf{m}$, and the block $\\mathbf{K}$ of two spins by $\\mathbf{T}^T\\mathbf{K}\\,\\mathbf{T}$, with $\\partial(\\mathbf{T}^T\\mathbf{m})/\\partial\\boldsymbol{\\psi}$ added to that of a node's own spin. \
    [`export --unknowns rotation-vectors`](export.md#forms) writes the element in these unknowns.";
const HELD: &str = "| | here | `UEL` of Abaqus |\n|---|---|---|\n\
    | forces on the nodes | $\\mathbf{f}$ | `RHS(1:n)` $= \\mathbf{f}$ |\n\
    | residuals | $\\mathbf{g}$ | `RHS(n+1:)` $= \\mathbf{g}$ |\n\
    | stiffness | $\\mathbf{K} = \\partial\\mathbf{f}/\\partial\\mathbf{q}$ | `AMATRX(1:n,1:n)` $= -\\mathbf{K}$ |\n\
    | derivative with respect to multipliers | $\\partial\\mathbf{f}/\\partial\\boldsymbol{\\lambda}$, without friction $\\mathbf{G}^T$ | `AMATRX(1:n,n+1:)` $= -\\partial\\mathbf{f}/\\partial\\boldsymbol{\\lambda}$ |\n\
    | rows | $\\mathbf{G} = \\partial\\mathbf{g}/\\partial\\mathbf{q}$ | `AMATRX(n+1:,1:n)` $= -\\mathbf{G}$ |\n";
const FREE: &str = "| | here | `UEL` of Abaqus |\n|---|---|---|\n\
    | forces on the nodes | $\\mathbf{f}$ | `RHS` $= \\mathbf{f}$ |\n\
    | stiffness | $\\mathbf{K} = \\partial\\mathbf{f}/\\partial\\mathbf{q}$ | `AMATRX` $= -\\mathbf{K}$ |\n";

/// The sheet of an element; `None` if no case of it can be computed.
pub(crate) fn of(project: &Project, element: &dyn AnyElement) -> Option<Sheet> {
    let (interface, id, command) = (Interface::new(element), element.spec().id, project.command());
    let layout = &interface.layout;
    Some(Sheet {
        id: id.into(),
        degrees: table_of_degrees(&interface),
        is_held: !layout.multipliers.is_empty(),
        rotates: interface.mcrd == 3 && layout.unknowns.iter().any(is_rotation),
        parameters: parameters(&interface),
        friction: match layout.contact {
            [] => String::new(),
            contact => {
                let from = interface.orientations() + len(layout.start) + 1;
                table_of_places("`PROPS`", contact, from) + "\n" + &table_of_places("`SVARS`", layout.state, 1)
            }
        },
        state: state(element)?,
        check: format!(
            "```console\n{command} check --element {id} --abi uel --out around\n\
             gfortran -std=legacy -I around around/uel_driver.f90 uel_{id}.f90 -o mine\n\
             {command} check --element {id} -- ./mine\n```\n"
        ),
    })
}

/// A dash at which no line breaks.
const TO: &str = "\u{2060}–\u{2060}";

/// `4–6`, or `4`.
fn range(from: usize, count: usize) -> String {
    if count == 1 { from.to_string() } else { format!("{from}{TO}{}", from + count - 1) }
}

fn described(field: &Field) -> String {
    format!("${}$, {}", field.quantity.latex, field.quantity.meaning)
}

/// The degrees of freedom with what acts on them, then the multipliers with their residuals.
fn table_of_degrees(interface: &Interface) -> String {
    let Interface { layout, mcrd, nodes, .. } = interface;
    let mut text = "| | unknown | force or residual | in a `UEL` |\n|---|---|---|---|\n".to_owned();
    let mut at = 1;
    let mut row = |[one, other]: [&Field; 2], place: String| {
        let numbers = range(at, one.len());
        at += one.len();
        let _ = writeln!(text, "| {numbers} | {} | {} | {place} |", described(one), described(other));
    };
    let mut labels: Vec<&str> = Vec::new();
    for (unknown, force) in layout.unknowns.iter().zip(layout.forces) {
        let label = &unknown.name[1..];
        if !labels.contains(&label) {
            labels.push(label);
        }
        let node = labels.iter().position(|known| *known == label).map_or(0, |k| k + 1);
        let own = degrees(unknown, *mcrd);
        row([unknown, force], format!("node {node}, {}", range(own[0], own.len())));
    }
    let mut before = 1;
    // A residual may be a vector whose components have multipliers of their own.
    let residual_of = |from: usize| {
        let mut end = 0;
        layout.residuals.iter().find(|residual| {
            end += residual.len();
            end >= from
        })
    };
    for multiplier in layout.multipliers {
        if let Some(residual) = residual_of(before) {
            row([multiplier, residual], format!("node {nodes}, {}", range(before, multiplier.len())));
        }
        before += multiplier.len();
    }
    text
}

/// What the element is given besides its nodes; behind the orientations of these at the start.
fn parameters(interface: &Interface) -> String {
    let (layout, orientations) = (&interface.layout, interface.orientations());
    let table = table_of_places("`PROPS`", layout.start, orientations + 1);
    if orientations == 0 {
        return table;
    }
    let names: Vec<_> = layout.nodes.iter().filter(|field| !is_position(field)).map(|field| field.name).collect();
    let head = format!("`PROPS(1:{orientations})` are the orientations at the start: `{}`.", names.join("`, `"));
    format!("{head}\n\n{table}")
}

/// Fields with their places in an array of a user element.
fn table_of_places(array: &str, fields: &'static [Field], from: usize) -> String {
    if fields.is_empty() {
        return String::new();
    }
    let rows = places(fields, from)
        .into_iter()
        .map(|(place, field)| format!("| {} | `{}` | {} |\n", place.replace('-', TO), field.name, described(field)));
    format!("| {array} | name | meaning |\n|---|---|---|\n{}", rows.collect::<String>())
}

/// The index of a degree of freedom in the symbol of a block: `ua`, `\theta a`.
fn index(field: &Field) -> String {
    if is_rotation(field) { format!(r"\theta {}", &field.name[1..]) } else { field.name.into() }
}

/// The numbers of a matrix with so many columns, in a rectangle.
fn part(numbers: &[f64], columns: usize, rows: [usize; 2], from: [usize; 2]) -> Vec<Vec<f64>> {
    let [first, left] = from;
    (0..rows[0]).map(|row| numbers[(first + row) * columns + left..][..rows[1]].to_vec()).collect()
}

/// The blocks that are not zero, with their symbols.
fn blocks(
    numbers: &[f64],
    rows: &[(String, usize)],
    columns: &[(String, usize)],
    symbol: impl Fn(&str, &str) -> String,
) -> String {
    let width = columns.iter().map(|(_, len)| len).sum();
    let (mut shown, mut first) = (Vec::new(), 0);
    for (row, height) in rows {
        let mut left = 0;
        for (column, len) in columns {
            let block = part(numbers, width, [*height, *len], [first, left]);
            left += len;
            if block.concat().iter().any(|x| *x != 0.0) {
                shown.push(format!("${}{}$", symbol(row, column), matrix(&block)));
            }
        }
        first += height;
    }
    // They wrap, and scroll where one is wider than a phone.
    format!("\n\n<div class=\"table-wrapper\" tabindex=\"0\">\n\n{}\n\n</div>", shown.join(" \u{2003} "))
}

/// The results of a case: residuals, rows, forces, stiffness, forces by multipliers, and the state after.
struct Results<'r> {
    residuals: &'r [f64],
    rows: &'r [f64],
    forces: &'r [f64],
    stiffness: &'r [f64],
    by_multipliers: &'r [f64],
    after: &'r [f64],
}

impl<'r> Results<'r> {
    fn new(element: &dyn AnyElement, all: &'r [f64]) -> Self {
        let layout = element.layout();
        let [n, m, held] = [layout.unknowns, layout.residuals, layout.multipliers].map(len);
        let mut rest = all;
        let mut next = |count: usize| {
            let (part, behind) = rest.split_at(count);
            rest = behind;
            part
        };
        let [residuals, rows, forces, stiffness, by_multipliers] = [m, m * n, n, n * n, n * held].map(&mut next);
        Self { residuals, rows, forces, stiffness, by_multipliers, after: rest }
    }
}

/// The beginning of the cases whose numbers have few digits, where an element has them.
const SHORT: &str = "turned";

/// The largest size of a number that is easily read.
const LARGE: f64 = 1e4;

/// A smaller number is 0 but for rounding.
const ROUNDING: f64 = 1e-12;

/// One of the cases with short numbers; of these, or else of all, the one with the fewest zeros and the shortest numbers.
fn state(element: &dyn AnyElement) -> Option<String> {
    let layout = element.layout();
    let rubs = !layout.contact.is_empty();
    let motions: Vec<_> = layout.unknowns.iter().map(|field| (index(field), field.len())).collect();
    let k = |p: &str, q: &str| format!(r"\mathbf{{K}}_{{{p},{q}}} = ");
    let valid = element.cases(rubs, 0).into_iter().filter_map(|case| {
        let mut results = element.value(&case.inputs, rubs).ok()?;
        results.iter_mut().filter(|x| x.abs() < ROUNDING).for_each(|x| *x = 0.0);
        let stiffness = blocks(Results::new(element, &results).stiffness, &motions, &motions, k);
        let zeros = results.iter().filter(|x| **x == 0.0).count();
        let is_large = results.iter().any(|x| x.abs() > LARGE);
        Some((
            (!case.id.starts_with(SHORT), is_large, zeros, stiffness.len()),
            case.id,
            case.inputs,
            results,
            stiffness,
        ))
    });
    let (_, id, inputs, results, stiffness) = valid.min_by_key(|(rank, ..)| *rank)?;
    let found = Results::new(element, &results);
    let prefix = if rubs { "rubbing-" } else { "" };
    let mut text = format!(
        "This is the case `{prefix}{id}` of the [golden file](golden/elements/{}.json), which has all digits. Inputs: {}. \
         Blocks that are not shown are zero.\n\n",
        element.spec().id,
        numbers(element.inputs(rubs), &inputs).join("; ")
    );
    let mut line = |what: &str, shown: &str| {
        let _ = writeln!(text, "**{what}.** {shown}\n");
    };
    let listed = |fields: &'static [Field], values: &[f64]| numbers(fields, values).join("; ");
    line(
        if layout.multipliers.is_empty() { "Result" } else { "Residuals" },
        &listed(layout.residuals, found.residuals),
    );
    let all = [(String::new(), len(layout.residuals))];
    let rows = blocks(found.rows, &all, &motions, |_, q| format!(r"\mathbf{{G}}_{{,{q}}} = "));
    line(if layout.multipliers.is_empty() { "Derivative" } else { "Rows" }, &rows);
    line("Forces and moments on the nodes", &listed(layout.forces, found.forces));
    line("Stiffness", &stiffness);
    if !layout.multipliers.is_empty() {
        if rubs {
            let forces: Vec<_> = layout.forces.iter().map(|field| (field.quantity.latex.into(), field.len())).collect();
            let held = [(String::new(), len(layout.multipliers))];
            let by = |force: &str, _: &str| format!(r"\frac{{\partial {force}}}{{\partial\boldsymbol{{\lambda}}}} = ");
            line(
                "Derivative of the forces with respect to the multipliers",
                &blocks(found.by_multipliers, &forces, &held, by),
            );
        }
        let velocities = velocities(len(layout.unknowns));
        let term = velocity_term(element, &inputs, &velocities, rubs)?;
        let mut at = 0;
        let given = layout.unknowns.iter().map(|field| {
            at += field.len();
            format!(r"$\dot{{{}}} =$ {}", field.quantity.latex, listed_numbers(&velocities[at - field.len()..at]))
        });
        let given = given.collect::<Vec<_>>().join(", ");
        line("Velocity term", &format!("With {given} it is {}.", listed_numbers(&term)));
    }
    if rubs {
        line("State after the step", &listed(layout.state, found.after));
    }
    Some(text)
}

/// Velocities with which no block of a velocity term vanishes.
fn velocities(count: usize) -> Vec<f64> {
    [0.0, 0.0, 1.0, -1.0, 2.0, 0.0, 1.0, 2.0, 0.0, 0.0, 1.0, 1.0].into_iter().cycle().take(count).collect()
}

/// q̇ᵀ K q̇ with the stiffness of each residual alone, as [`Parameters::velocity_term`](jointproof::element::Parameters) has it.
fn velocity_term(element: &dyn AnyElement, inputs: &[f64], velocities: &[f64], rubs: bool) -> Option<Vec<f64>> {
    let layout = element.layout();
    let smooth = &inputs[..if rubs { inputs.len() - len(layout.contact) - len(layout.state) } else { inputs.len() }];
    let (from, held, n) = (len(layout.nodes), len(layout.multipliers), velocities.len());
    let term = |k: usize| {
        let mut alone = smooth.to_vec();
        alone[from..from + held].iter_mut().enumerate().for_each(|(j, x)| *x = f64::from(u8::from(j == k)));
        let results = element.value(&alone, false).ok()?;
        let stiffness = Results::new(element, &results).stiffness;
        let row = |row: usize| (0..n).map(|column| stiffness[row * n + column] * velocities[column]).sum::<f64>();
        Some((0..n).map(|k| velocities[k] * row(k)).sum())
    };
    (0..held).map(term).collect()
}

/// Which half of a sheet: up to friction, or from the signs on. Between them a page says what is the connector's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Half {
    Equations,
    Numbers,
}

impl Half {
    /// The half that a directive is replaced by.
    pub(crate) fn of(directive: &str) -> Option<Self> {
        match directive {
            "element" => Some(Self::Equations),
            "element-in-numbers" => Some(Self::Numbers),
            _ => None,
        }
    }
}

/// The Markdown in place of `{{#element ID; rows JOIN.ROWS, …; …}}`, with lists of formulas.
///
/// # Errors
/// What is wrong with the directive.
pub(crate) fn markdown(content: &Content, half: Half, argument: &str) -> Result<String, String> {
    let (id, lists) = argument.split_once(';').unwrap_or((argument, ""));
    let known = || content.sheets.iter().map(|sheet| sheet.id.as_str()).collect::<Vec<_>>().join(", ");
    let sheet = content.sheets.iter().find(|sheet| sheet.id == id.trim());
    let sheet = sheet.ok_or_else(|| format!("no element `{}`; there are: {}", id.trim(), known()))?;
    let mut equations: [String; LISTS.len()] = Default::default();
    for list in lists.split(';').map(str::trim).filter(|list| !list.is_empty()) {
        let (name, ids) = list.split_once(' ').unwrap_or((list, ""));
        let k = LISTS.iter().position(|known| *known == name);
        let k = k.ok_or_else(|| format!("`{name}` is none of {}", LISTS.join(", ")))?;
        for id in ids.split(',').map(str::trim) {
            let entry = content.entries.iter().find(|entry| entry.id == id);
            equations[k] += &equation(entry.ok_or_else(|| format!("no formula `{id}` in the catalog"))?);
        }
    }
    Ok(match half {
        Half::Equations => sheet.equations(&equations),
        Half::Numbers => sheet.numbers(&equations),
    })
}

/// The equation of a formula, and where its symbols are from.
fn equation(Entry { id, latex, given, .. }: &Entry) -> String {
    let given = if given.is_empty() { String::new() } else { format!("{given}.\n\n") };
    format!("{{{{#equation {id}}}}}\n\n$$\n{latex}\n$$\n\n{given}")
}

/// A section with the parts that are not empty.
fn section(title: &str, parts: &[&str]) -> String {
    let parts: Vec<_> = parts.iter().map(|part| part.trim_end()).filter(|part| !part.is_empty()).collect();
    format!("## {title}\n\n{}\n\n", parts.join("\n\n"))
}

impl Sheet {
    fn equations(&self, [residuals, rows, forces, stiffness, friction, _]: &[String; LISTS.len()]) -> String {
        let rubs = !self.friction.is_empty();
        let forces_are = format!("{FORCES}{}.", if rubs { ", and of [friction](#friction)" } else { "" });
        let held = |text| if self.is_held { text } else { "" };
        let mut sections = vec![
            section("Degrees of freedom", &[ORDER, &self.degrees, &self.parameters]),
            section(if self.is_held { "Residuals" } else { "Contact" }, &[residuals]),
        ];
        if self.is_held {
            sections.push(section("Rows", &[ROWS, rows]));
        }
        sections.push(section("Nodal forces", &[held(&forces_are), forces]));
        sections.push(section("Stiffness", &[STIFFNESS, held(HELD_FIXED), stiffness]));
        if rubs {
            sections.push(section("Friction", &[&self.friction, friction, held(TANGENT)]));
        }
        sections.concat()
    }

    fn numbers(&self, [.., rotations]: &[String; LISTS.len()]) -> String {
        let mut sections = vec![section("Signs", &[if self.is_held { HELD } else { FREE }, INTERNAL])];
        if self.is_held {
            sections.push(section("Velocity term", &[VELOCITY]));
        }
        if self.rotates {
            sections.push(section("Rotation vectors", &[ROTATIONS, rotations]));
        }
        sections.push(section("One state in numbers", &[&self.state]));
        let files = format!("{{{{#downloads {}}}}}", self.id);
        sections.push(section("Files", &[&files, &self.check]));
        sections.concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::{CATALOG, ELEMENTS};

    #[test]
    fn blocks_of_zeros_are_left_out() {
        let fields = |names: [(&str, usize); 2]| names.map(|(name, len)| (name.to_owned(), len));
        let (rows, columns) = (fields([("a", 1), ("b", 1)]), fields([("p", 2), ("q", 1)]));
        let shown = blocks(&[0.0, 0.0, 3.0, 1.0, 0.0, 0.0], &rows, &columns, |p, q| format!("{p}{q}"));
        let one = r"$aq\begin{pmatrix} 3 \end{pmatrix}$";
        let other = r"$bp\begin{pmatrix} 1 & 0 \end{pmatrix}$";
        assert!(shown.contains(&format!("\n\n{one} \u{2003} {other}\n\n")), "{shown}");
    }

    /// SLOT's multipliers are those of its two residuals, and UJOINT's first residual is a vector with three.
    #[test]
    fn every_element_has_a_sheet_with_a_line_for_each_multiplier() {
        let project = Project::new("sheets", env!("CARGO_MANIFEST_DIR"), CATALOG);
        for element in ELEMENTS {
            let layout = element.layout();
            let sheet = of(&project, *element).unwrap();
            let lines = sheet.degrees.lines().count() - 2;
            assert_eq!(lines, layout.unknowns.len() + layout.multipliers.len(), "{}", sheet.id);
            assert!(sheet.state.contains("**Stiffness.** \n\n<div"), "{}", sheet.state);
            assert_eq!(sheet.state.contains("**Velocity term.**"), sheet.is_held);
        }
    }
}
