//! The command line.

use crate::outcome::{Outcome, Usage};
use crate::project::Project;
use crate::{audit, book, check, console, equation, export, formulas, golden, new, prove, report, verify};
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser, Subcommand};
use jointproof::formula::Field;
use std::process::ExitCode;

/// The exit code of bad usage, which is also clap's.
const BAD_USAGE: u8 = 2;

/// Golden files, audits, reports and the book, all from the one definition of each formula.
///
/// Results go to standard output, everything else to standard error. The exit code is 0 if all is well, 1 if something
/// is off (it says what, where and by how much), 2 for bad usage.
#[derive(Parser)]
#[command(version, max_term_width = 100)]
struct Arguments {
    /// The folder of the project, instead of the one where the command is called or above
    #[arg(long, global = true, value_name = "FOLDER", value_hint = clap::ValueHint::DirPath)]
    project: Option<std::path::PathBuf>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Verify(verify::Arguments),
    Golden(golden::Arguments),
    Prove(prove::Arguments),
    Audit(audit::Arguments),
    Check(check::Arguments),
    Equation(equation::Arguments),
    Export(export::Arguments),
    Report(report::Arguments),
    Book(book::Arguments),
    New(new::Arguments),
    Formulas(formulas::Arguments),
    Complete(Complete),
}

/// Write the completions for a shell, which reads them at its start
#[derive(clap::Args)]
#[command(after_help = "Examples:
  {command} complete bash > ~/.local/share/bash-completion/completions/jointproof
  {command} complete fish > ~/.config/fish/completions/jointproof.fish")]
struct Complete {
    /// The shell
    shell: clap_complete::Shell,
}

fn complete(project: &Project, arguments: &Complete) -> Outcome {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut command_line(project), project.name(), &mut text);
    console::print(&String::from_utf8_lossy(&text))?;
    Ok(ExitCode::SUCCESS)
}

/// Runs the command that the arguments of the program name.
pub fn main(project: Project) -> ExitCode {
    let matches = command_line(&project).get_matches();
    let found = project.found(matches.get_one("project")).map_err(anyhow::Error::from);
    found.and_then(|project| run(&project, &matches)).unwrap_or_else(|error| {
        console::error(&format!("{error:#}"));
        if error.is::<Usage>() { ExitCode::from(BAD_USAGE) } else { ExitCode::FAILURE }
    })
}

fn run(project: &Project, matches: &ArgMatches) -> Outcome {
    if let Some((name, matches)) = matches.subcommand()
        && let Some((_, run)) = project.extension.commands.iter().find(|(command, _)| command.get_name() == name)
    {
        return run(project, matches);
    }
    match Arguments::from_arg_matches(matches)?.command {
        Command::Verify(arguments) => verify::run(project, &arguments),
        Command::Golden(arguments) => golden::run(project, &arguments),
        Command::Prove(arguments) => prove::run(project, &arguments),
        Command::Audit(arguments) => audit::run(project, &arguments),
        Command::Check(arguments) => check::run(project, &arguments),
        Command::Equation(arguments) => equation::run(project, &arguments),
        Command::Export(arguments) => export::run(project, &arguments),
        Command::Report(arguments) => report::run(project, &arguments),
        Command::Book(arguments) => book::run(project, &arguments),
        Command::New(arguments) => new::run(project, &arguments),
        Command::Formulas(arguments) => formulas::run(project, &arguments),
        Command::Complete(arguments) => complete(project, &arguments),
    }
}

/// All commands, with examples as they would be typed in this project.
fn command_line(project: &Project) -> clap::Command {
    let own = project.extension.commands.iter().map(|(command, _)| command.clone());
    let all = Arguments::command().name(project.command()).bin_name(project.command()).subcommands(own);
    let ids = Ids(project.ids().collect());
    let named = [("filter", None), ("formula", None), ("id", None), ("against", Some("equation"))];
    all.mut_subcommands(|command| {
        let help = command.get_after_help().map(|help| examples(project, &help.to_string()));
        let name = command.get_name().to_owned();
        let command = command.mut_args(|argument| {
            let is_id = |(id, of): &(&str, Option<&str>)| argument.get_id() == *id && of.is_none_or(|of| of == name);
            if named.iter().any(is_id) {
                argument.value_parser(ids.clone()).hide_possible_values(true)
            } else {
                argument
            }
        });
        match help {
            Some(help) => command.after_help(help),
            None => command,
        }
    })
}

/// Identifiers, which a shell completes; any text is accepted, since it may be a pattern.
#[derive(Clone)]
struct Ids(Vec<&'static str>);

impl clap::builder::TypedValueParser for Ids {
    type Value = String;
    fn parse_ref(
        &self,
        command: &clap::Command,
        argument: Option<&clap::Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<String, clap::Error> {
        clap::builder::StringValueParser::new().parse_ref(command, argument, value)
    }
    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = clap::builder::PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|id| clap::builder::PossibleValue::new(*id))))
    }
}

/// Replaces `{command}`, `{family}`, `{formula}` and `{point}` in examples by the project's command and its shortest
/// formula.
fn examples(project: &Project, text: &str) -> String {
    let components = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    let shortest = project.catalog().iter().min_by_key(|formula| components(formula.inputs()));
    let id = shortest.map_or("family.name", |formula| formula.spec().id);
    let family = id.split('.').next().unwrap_or(id);
    let one = |components: usize| if components == 1 { "1".to_owned() } else { format!("{:?}", vec![1; components]) };
    let inputs = shortest.map_or(&[][..], |formula| formula.inputs());
    let point: Vec<_> = inputs.iter().map(|field| format!("\"{}\": {}", field.name, one(field.len()))).collect();
    let text = text
        .replace("{command}", project.command())
        .replace("{family}", family)
        .replace("{formula}", id)
        .replace("{point}", &format!("{{{}}}", point.join(", ")));
    aligned(&text)
}

/// Aligns the text after two spaces into one column.
fn aligned(text: &str) -> String {
    let split = |line: &str| {
        let (example, what) = line.trim_start().split_once("  ").unwrap_or((line.trim_start(), ""));
        (example.to_owned(), what.trim().to_owned())
    };
    let rows: Vec<_> = text.lines().map(split).collect();
    let width = rows.iter().filter(|row| !row.1.is_empty()).map(|row| row.0.chars().count()).max().unwrap_or_default();
    let line = |(k, (example, what)): (usize, &(String, String))| {
        let indent = if k == 0 { "" } else { "  " };
        format!("{indent}{example:width$}   {what}").trim_end().to_owned()
    };
    rows.iter().enumerate().map(line).collect::<Vec<_>>().join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::connector::slot::ContactForce;
    use jointproof::contact::slide_line::ClosestLinear;

    #[test]
    fn what_examples_do_stands_in_a_column_and_the_first_is_not_indented() {
        let text = "Examples:\n  a  the first\n  longer --one 1    the second\n  a command alone that is much longer than these";
        let expected = "Examples:\n  a                the first\n  longer --one 1   the second\n  \
                        a command alone that is much longer than these";
        assert_eq!(aligned(text), expected);
        assert_eq!(aligned("a  b\nc d"), "a   b\n  c d");
        assert_eq!(aligned("a b\nc"), "a b\n  c");
    }

    #[test]
    fn examples_have_a_point_of_the_shortest_formula() {
        let shown =
            |project: &Project| examples(project, "{command} audit --point '{point}'  of {formula}, a {family}");
        let project = |catalog| Project::new("named", env!("CARGO_MANIFEST_DIR"), catalog).called("joints", "joints");
        assert_eq!(
            shown(&project(&[&ClosestLinear, &ContactForce])),
            "joints audit --point '{\"f2\": 1, \"f3\": 1}'   of slot.contact_force, a slot"
        );
        assert_eq!(
            shown(&project(&[&ClosestLinear])),
            "joints audit --point '{\"xs\": [1, 1], \"x1\": [1, 1], \"x2\": [1, 1]}'   of slide_line.closest_linear, a slide_line"
        );
    }
}
