//! `export --shell`: a user routine for a finite-element program in one file, with the exported functions that it calls.
//!
//! FRIC, MPC and `umpc_user` are written by hand around formulas. An element is `uel.f90` or `vuel.f90` around its recorded functions: from
//! its fields follow the layout of its properties, its state and its multipliers, and the calls.

mod fixed;
mod head;

use super::fortran::driver::passed;
use super::fortran::{RUNTIME, module_of};
use super::program::folded;
use super::recorded::{Output, Recorded, Shape, Subject, record};
use crate::files;
use crate::outcome::Usage;
use crate::project::Project;
use crate::template::filled;
use crate::uel::{Interface, is_position, is_rotation, len};
use anyhow::Context;
use jointproof::catalog::{AnyForm, Form};
use jointproof::formula::Field;
use jointproof::toolkit::verify::Layout;
use std::ops::Range;
use std::path::Path;

/// A routine to take away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Shell {
    /// A user element of Abaqus/Standard, for each --element: with multipliers, and friction if it has any
    Uel,
    /// A user element of Abaqus/Explicit, for each --element: with penalties instead of multipliers, and friction if it has any
    Vuel,
    /// A friction model of Abaqus: Coulomb's, in one direction or two
    Fric,
    /// A multi-point constraint of Abaqus: SLIDER
    Mpc,
    /// A user MPC of CalculiX: SLIDER
    UmpcUser,
}

impl Shell {
    /// The name that a program calls it by.
    pub(super) fn routine(self) -> &'static str {
        match self {
            Self::Uel => "UEL",
            Self::Vuel => "VUEL",
            Self::Fric => "FRIC",
            Self::Mpc => "MPC",
            Self::UmpcUser => "umpc_user",
        }
    }

    pub(super) fn is_element(self) -> bool {
        matches!(self, Self::Uel | Self::Vuel)
    }
}

/// Compilers take the rest of the file as free form, whatever its name.
const FREE_FORM: &str = "!DEC$ FREEFORM\n";

/// A routine: the first formula or element that it calls, its name, its head, its own text, and the modules that it uses.
struct Routine {
    of: &'static str,
    name: String,
    head: String,
    text: String,
    modules: Vec<String>,
}

/// Writes a routine in one file, in free form, or in fixed form.
///
/// # Errors
/// If an element is missing or has no recorded operations, or the file cannot be written.
pub(super) fn write(
    project: &Project,
    shell: Shell,
    elements: &[&'static dyn AnyForm],
    is_fixed: bool,
    folder: &Path,
) -> anyhow::Result<String> {
    let File { name, text, .. } = file(project, shell, elements, is_fixed)?;
    let path = folder.join(name);
    files::write(&path, &text)?;
    Ok(format!("{} lines in {}\n", text.lines().count(), path.display()))
}

/// A file with a routine.
pub(super) struct File {
    /// The first formula or element that it calls.
    pub(super) of: &'static str,
    pub(super) name: String,
    pub(super) text: String,
}

/// A routine in one file.
///
/// # Errors
/// If an element is missing or has no recorded operations.
pub(super) fn file(
    project: &Project,
    shell: Shell,
    elements: &[&'static dyn AnyForm],
    is_fixed: bool,
) -> anyhow::Result<File> {
    let Routine { of, name, head, text, modules } = match shell {
        Shell::Uel | Shell::Vuel => user_elements(project, shell, elements)?,
        Shell::Fric => by_hand(project, "fric", include_str!("shell/fric.f90"))?,
        Shell::Mpc => by_hand(project, "mpc", include_str!("shell/mpc.f90"))?,
        Shell::UmpcUser => by_hand(project, "umpc_user", include_str!("shell/umpc_user.f90"))?,
    };
    // No module of another file has the same name.
    let runtime = format!("jp_runtime_{name}");
    let modules = [vec![RUNTIME.to_owned()], modules].concat();
    let code = [modules.join("\n"), "\n".into(), text].concat().replace("jp_runtime", &runtime);
    let (extension, text) = if is_fixed {
        ("f", fixed::form(&[head, "\n".into(), code].concat()))
    } else {
        ("f90", [FREE_FORM.into(), head, "\n".into(), code].concat())
    };
    Ok(File { of, name: format!("{name}.{extension}"), text })
}

/// A routine around formulas.
fn by_hand(project: &Project, name: &str, text: &str) -> anyhow::Result<Routine> {
    let calls = |subject: &Subject| {
        ["value", "jacobian"].iter().any(|what| text.contains(&format!("jp_{}_{what}(", subject.stem())))
    };
    let formulas: Vec<_> = project.catalog().iter().map(|&formula| Subject::Formula(formula)).filter(calls).collect();
    let (recorded, _) = record(&formulas, Some(project));
    let of = recorded.first().with_context(|| format!("none of the formulas that {name} calls is in the catalog"))?;
    let of = of.subject.spec().id;
    let uses: Vec<_> = recorded.iter().map(|one| format!("    use jp_{}\n", one.subject.stem())).collect();
    let (head, body) = text.split_once("\nsubroutine ").context("a routine is a routine")?;
    let body = filled(body, &[("axes", include_str!("shell/axes.f90"))]).replace("{uses}", &uses.concat());
    Ok(Routine {
        of,
        name: name.to_owned(),
        head: format!("{head}\n"),
        text: format!("subroutine {body}"),
        modules: recorded.iter().map(module_of).collect(),
    })
}

/// Elements in one file, by the numbers of their types.
fn user_elements(project: &Project, shell: Shell, elements: &[&'static dyn AnyForm]) -> anyhow::Result<Routine> {
    let routine = shell.routine().to_lowercase();
    if elements.is_empty() {
        let ids: Vec<_> = project.elements().iter().map(|element| element.spec().id).collect();
        return Err(Usage(format!("--shell {routine}: an element, by --element {}", ids.join("|"))).into());
    }
    let (template, arguments, stop) = if shell == Shell::Vuel {
        let arguments = "lflags(3), rhs(kblock, :), amass(kblock, :, :), dtimestable(kblock), svars(kblock, :), \
                         energy(kblock, 3), props, transpose(coords(kblock, :, :)), mcrd, u(kblock, :), is_well";
        (include_str!("shell/vuel_call.f90"), arguments, "call xplb_exit")
    } else {
        let arguments = "rhs, amatrx, svars, ndofel, props, coords, mcrd, u, lflags, mlvarx, pnewdt";
        (include_str!("shell/uel_call.f90"), arguments, "call xit")
    };
    let names: Vec<_> = elements.iter().map(|element| element.name()).collect();
    let (mut head, mut all) = (String::new(), Vec::new());
    for (&element, number) in elements.iter().zip(1..) {
        let (recorded, refused) = record(&Subject::forms(element), Some(project));
        if let Some((subject, why)) = refused.first() {
            return Err(Usage(format!("--element {}: it cannot be exported, since {why}", subject.spec().id)).into());
        }
        head += &head::of(element, number, shell == Shell::Vuel);
        all.extend(recorded.iter().map(module_of));
        all.push(module(shell, element, &recorded));
    }
    let uses: Vec<_> = names.iter().map(|name| format!("use jp_{routine}_{name}, only: {routine}_{name}")).collect();
    let call = |name: &String| format!("call {routine}_{name}({arguments})");
    let calls = if let [name] = &names[..] {
        call(name)
    } else {
        let cases: Vec<_> =
            names.iter().zip(1..).map(|(name, number)| format!("case ({number})\n    {}\n", call(name))).collect();
        format!("select case (jtype)\n{}case default\n    {stop}\nend select", cases.concat())
    };
    let text = filled(template, &[("uses", &uses.join("\n")), ("calls", &calls)]);
    Ok(Routine {
        of: elements[0].spec().id,
        name: format!("{routine}_{}", names.join("_")),
        head,
        text: tidied(&text),
        modules: all,
    })
}

/// The module with the routine of an element.
fn module(shell: Shell, element: &dyn AnyForm, forms: &[Recorded]) -> String {
    let interface = Interface::new(element);
    let layout = &interface.layout;
    let [motions, held, states] = [layout.unknowns, layout.multipliers, layout.state].map(len);
    let first = interface.orientations() + 1;
    let stick = first + len(layout.start);
    let places = Places::new(&interface);
    let smooth =
        [places.arguments, passed(layout.multipliers, "u", motions + 1), passed(layout.start, "props", first)].concat();
    let rubbing = [&smooth[..], &passed(layout.contact, "props", stick), &passed(layout.state, "svars", 1)].concat();
    let id = &element.name();
    let [plain, with_friction] = [forms.first(), forms.get(1)];
    let call = |form: Option<&Recorded>, arguments: &[String]| {
        form.map_or_else(String::new, |form| {
            let outputs = outputs(form);
            let names = outputs.iter().map(|output| output.name.to_owned());
            let all: Vec<_> = arguments.iter().cloned().chain(names).collect();
            format!("code = jp_{}_step({})", form.subject.stem(), all.join(", "))
        })
    };
    let (smooth, rubbing) = (call(plain, &smooth), call(with_friction, &rubbing));
    let declared = outputs(with_friction.or(plain).expect("an element was recorded"));
    let mut declarations = vec![declared_as(&declared)];
    declarations.extend(places.declarations);
    let call = if with_friction.is_some() {
        declarations.push("logical :: rubs".into());
        format!("rubs = .not. abs(props({stick})) <= 0\nif (rubs) then\n    {rubbing}\nelse\n    {smooth}\nend if")
    } else {
        smooth
    };
    // What friction alone gives is 0 without it.
    let before = if with_friction.is_some() { "after = 0\n" } else { "" };
    let mut conditions = Vec::new();
    if held > 0 {
        conditions.push("rhs(motions + 1:all_motions, 1) = residuals".to_owned());
    }
    if with_friction.is_some() {
        conditions.push(format!("if (rubs) svars(:{states}) = after"));
    }
    let matrices = if held > 0 {
        "amatrx(:motions, motions + 1:) = -by_multipliers\namatrx(motions + 1:, :motions) = -rows"
    } else {
        ""
    };
    let finite = |output: &Output| format!("is_well = is_well .and. all(abs({}) <= huge(0.0_dp))", output.name);
    let finite: Vec<_> = declared.iter().map(finite).collect();
    let functions = match (interface.orientations(), interface.mcrd) {
        (0, _) => "",
        (_, 3) => include_str!("shell/turned_space.f90"),
        _ => include_str!("shell/turned_plane.f90"),
    };
    let use_rubbing = if with_friction.is_some() { format!("use jp_element_{id}_rubbing") } else { String::new() };
    let functions = [include_str!("shell/keeps_order.f90"), functions].concat();
    let (template, masses, energy) = if shell == Shell::Vuel {
        (include_str!("shell/vuel.f90"), masses(&interface), energy(&interface))
    } else {
        (include_str!("shell/uel.f90"), String::new(), String::new())
    };
    let text = filled(
        template,
        &[
            ("use_rubbing", &use_rubbing),
            ("declarations", &declarations.join("\n")),
            ("nodes", &places.statements.join("\n")),
            ("call", &format!("{before}{call}")),
            ("finite", &finite.join("\n")),
            ("conditions", &conditions.join("\n")),
            ("matrices", matrices),
            ("functions", &functions),
            ("masses", &masses),
            ("energy", &energy),
            ("motions", &motions.to_string()),
            ("ndofel", &interface.ndofel().to_string()),
            ("id", id),
        ],
    );
    tidied(&text)
}

/// The mass of each degree of freedom, from the properties after all others.
fn masses(interface: &Interface) -> String {
    let one = |(range, field): (Range<usize>, &Field)| {
        let property = interface.nprops() + 1 + usize::from(is_rotation(field));
        format!("mass({}:{}) = props({property})\n", range.start + 1, range.end)
    };
    let unknowns = interface.layout.unknowns;
    Field::ranges(unknowns).zip(unknowns).map(one).collect()
}

/// The energy of the penalties: half of each times the square of its residual.
fn energy(interface: &Interface) -> String {
    let Layout { start, residuals, .. } = interface.layout;
    let of = |(property, kappa): (Range<usize>, &Field)| {
        let held = Field::ranges(residuals).zip(residuals).filter(|(_, residual)| Form::penalty(residual) == *kappa);
        let places: Vec<_> = held.flat_map(|(range, _)| range).map(|k| (k + 1).to_string()).collect();
        let kappa = interface.orientations() + property.start + 1;
        (!places.is_empty()).then(|| format!("props({kappa}) * sum(residuals([{}])**2) / 2", places.join(", ")))
    };
    let sum: Vec<_> = Field::ranges(start).zip(start).filter_map(of).collect();
    if sum.is_empty() { String::new() } else { format!("energy = {}", sum.join(" + ")) }
}

/// A filled template without lines of blanks, and with long lines folded.
fn tidied(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.trim().is_empty() || line.is_empty());
    lines.flat_map(|line| folded(line, " &")).map(|line| line + "\n").collect()
}

fn outputs(form: &Recorded) -> Vec<Output> {
    form.largest_function().outputs
}

fn declared_as(outputs: &[Output]) -> String {
    let one = |output: &Output| match output.shape {
        Shape::Matrix(rows, columns) => format!("{}({rows}, {columns})", output.name),
        _ => format!("{}({})", output.name, output.len()),
    };
    format!("real(dp) :: {}", outputs.iter().map(one).collect::<Vec<_>>().join(", "))
}

/// The nodes of an element, from U, COORDS and PROPS.
#[derive(Default)]
struct Places {
    declarations: Vec<String>,
    statements: Vec<String>,
    /// One for each input of the nodes.
    arguments: Vec<String>,
}

impl Places {
    fn new(interface: &Interface) -> Self {
        let Interface { layout, mcrd, triads, positions, .. } = interface;
        let mut places = Self::default();
        let (mut at, mut position, mut turned, mut property) = (1, 0, 0, 1);
        let node_of = |from: usize| {
            let mut place = 0;
            let field = layout.nodes.iter().find(|field| {
                place += field.len();
                place > from
            });
            field.map_or("", |field| field.name)
        };
        for unknown in layout.unknowns {
            let place = format!("u({at}:{})", at + unknown.len() - 1);
            if !is_rotation(unknown) {
                let name = node_of(positions[position]);
                position += 1;
                places.declarations.push(format!("{name}({mcrd})"));
                places.statements.push(format!("{name} = coords(:{mcrd}, {position}) + {place}"));
            } else if let Some(triad) = triads.get(turned) {
                let name = format!("e{}", &node_of(triad[0])[2..]);
                turned += 1;
                let properties = format!("props({property}:{})", property + triad.len() * mcrd - 1);
                property += triad.len() * mcrd;
                if *mcrd == 3 {
                    places.declarations.push(format!("{name}(3, 3)"));
                    places.statements.push(format!("{name} = turned({place}, {properties})"));
                } else {
                    places.declarations.push(format!("{name}({mcrd})"));
                    places.statements.push(format!("{name} = turned(u({at}), {properties})"));
                }
            }
            at += unknown.len();
        }
        let argument = |field: &Field| match (is_position(field), mcrd) {
            (true, _) => field.name.to_owned(),
            (false, 3) => format!("e{}(:, {})", &field.name[2..], &field.name[1..2]),
            (false, _) => format!("e{}", &field.name[2..]),
        };
        places.arguments = layout.nodes.iter().map(argument).collect();
        places.declarations = vec![format!("real(dp) :: {}", places.declarations.join(", "))];
        places
    }
}
