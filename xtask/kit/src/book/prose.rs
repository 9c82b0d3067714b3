//! Mathematics in chapters: claims about a formula, mathematics for presentation only, and numbers with their origins.

use super::fault::Fault;
use super::markdown::{Found, Piece, scan};
use super::numeral::{self, Numeral};
use jointproof::catalog::AnyFormula;
use jointproof::toolkit::equation::{Setting, Signature};

/// The mark before a display that says how it is checked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// `{{#equation slot.friction; if f_1 > 0}}`: it is executed.
    Executed(String),
    /// `{{#presentation why}}`: it is not executed, for this reason.
    Presentation(String),
}

/// A display in a chapter.
#[derive(Clone, Debug)]
pub(crate) struct Display {
    pub(crate) latex: String,
    pub(crate) line: usize,
    pub(crate) mark: Option<Mark>,
}

/// The mark for a directive, if it is one.
pub(crate) fn mark(piece: &Piece) -> Option<Mark> {
    let Piece::Directive { name, argument } = piece else { return None };
    match name.as_str() {
        "equation" => Some(Mark::Executed(argument.clone())),
        "presentation" => Some(Mark::Presentation(argument.clone())),
        _ => None,
    }
}

/// A chapter in the form in which it is checked.
pub(crate) struct Chapter {
    pub(crate) numerals: Vec<Numeral>,
    pub(crate) displays: Vec<Display>,
    pub(crate) faults: Vec<Fault>,
}

/// Reads a chapter; unmarked displays and numbers are faults.
pub(crate) fn read(file: &str, text: &str) -> Chapter {
    let (shown, numerals) = numeral::shown(text);
    let fault = |line, message: &str| Fault { file: file.into(), line, message: message.into() };
    let mut faults = Vec::new();
    let mut displays = Vec::new();
    let mut before: Option<(Mark, usize)> = None;
    for Found { piece, line, .. } in scan(&shown).0 {
        let pending = before.take();
        if let Piece::DisplayMath(latex) = piece {
            let mark = pending.map(|(mark, _)| mark);
            if mark.is_none() {
                faults.push(fault(line, "this equation is neither executed nor marked: put `{{#equation ID}}` or `{{#presentation why}}` before it"));
            }
            displays.push(Display { latex, line, mark });
            continue;
        }
        if let Some((_, line)) = pending {
            faults.push(fault(line, "no equation follows this"));
        }
        before = mark(&piece).map(|mark| (mark, line));
    }
    faults.extend(before.map(|(_, line)| fault(line, "no equation follows this")));
    let bare = numeral::bare(text).into_iter();
    faults.extend(bare.map(|(line, numeral)| {
        fault(
            line,
            &format!(
                "{numeral} does not say where it is from: `{{{{{numeral} = expression}}}}`, `… in test`, `given …`"
            ),
        )
    }));
    let unshown = numeral::unshown(text).into_iter();
    faults.extend(unshown.map(|(line, claim)| {
        fault(
            line,
            &format!("no test shows this claim (`{claim}`); name one that quotes it: `{{{{\"words\" in test}}}}`"),
        )
    }));
    Chapter { numerals, displays, faults }
}

/// The formula that a display is about, and the setting in which it is read.
pub(crate) type About = (Option<&'static dyn AnyFormula>, Setting);

/// Formulas by their identifiers.
pub(crate) struct Formulas<'c>(pub(crate) &'c [&'static dyn AnyFormula]);

impl Formulas<'_> {
    pub(crate) fn find(&self, id: &str) -> Result<&'static dyn AnyFormula, String> {
        let found = self.0.iter().copied().find(|formula| formula.spec().id == id);
        found.ok_or_else(|| format!("no formula `{id}` in the catalog"))
    }

    /// Parses an argument: `ID; let …; if …; put …; free …; from ID …; triads`, in any order. `above` continues the
    /// setting of the previous display.
    pub(crate) fn setting(&self, argument: &str, above: Option<&(About, String)>) -> Result<About, String> {
        let (mut of, mut setting) = (None, Setting::default());
        let mut definitions = Vec::new();
        for part in argument.split(';').map(str::trim).filter(|part| !part.is_empty()) {
            let (word, rest) = part.split_once(char::is_whitespace).unwrap_or((part, ""));
            match word {
                "above" => {
                    let (before, latex) = above.ok_or("nothing is executed above")?;
                    (of, setting) = before.clone();
                    setting.above.push(latex.clone());
                }
                "triads" => setting.triads = true,
                "let" => definitions.push(rest),
                "if" => setting.condition = rest.into(),
                "put" => setting.put = rest.into(),
                "free" => setting.free = rest.into(),
                "from" => {
                    let (id, symbols) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
                    setting.from.push((symbols.into(), self.find(id)?.spec()));
                }
                id if rest.is_empty() => {
                    let formula = self.find(id)?;
                    let (spec, inputs, outputs) = (formula.spec(), formula.inputs(), formula.outputs());
                    setting.of = Some(Signature { spec, inputs, outputs });
                    of = Some(formula);
                }
                _ => {
                    return Err(format!("`{word}` is none of let, if, put, free, from, triads, above, and no formula"));
                }
            }
        }
        let own = definitions.join(r"\quad ");
        setting.definitions = format!(r"{}\quad {own}", setting.definitions);
        Ok((of, setting))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;

    fn faults(text: &str) -> Vec<String> {
        read("a.md", text).faults.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn every_display_has_a_mark_and_every_mark_a_display() {
        let good = "{{#equation slot.stop}}\n\n$$\na = b\n$$\n\n`c`\n\n{{#presentation as it is}}\n\n$$\nd\n$$\n";
        let Chapter { displays, faults: none, .. } = read("a.md", good);
        assert_eq!(none, []);
        let displays: Vec<_> = displays.into_iter().map(|Display { latex, line, mark }| (latex, line, mark)).collect();
        let [executed, shown] = [Mark::Executed("slot.stop".into()), Mark::Presentation("as it is".into())];
        assert_eq!(displays, [("\na = b\n".into(), 3, Some(executed)), ("\nd\n".into(), 11, Some(shown))]);
        let unmarked = faults("# A\n\n$$\na = b\n$$\n");
        assert!(unmarked.len() == 1 && unmarked[0].starts_with("a.md:3: this equation is neither"), "{unmarked:?}");
        for rest in ["", "`b`\n"] {
            let text = format!("a\n\n{{{{#presentation why}}}}\n\n{rest}");
            assert_eq!(faults(&text), ["a.md:3: no equation follows this"]);
        }
    }

    #[test]
    fn what_is_said_of_a_display_is_read_part_by_part() {
        let formulas = Formulas(CATALOG);
        let said =
            "slot.stop; let a = 1; ; if f_1 > 0; put x = 2; free y; from slot.friction P, F_C; let b = 2; triads";
        let (of, setting) = formulas.setting(said, None).unwrap();
        assert_eq!(of.unwrap().spec().id, "slot.stop");
        assert_eq!(setting.of.as_ref().unwrap().spec.id, "slot.stop");
        assert_eq!([&setting.condition, &setting.put, &setting.free], ["f_1 > 0", "x = 2", "y"]);
        assert!(setting.definitions.ends_with(r"a = 1\quad b = 2"), "{}", setting.definitions);
        let from: Vec<_> = setting.from.iter().map(|(symbols, spec)| (symbols.as_str(), spec.id)).collect();
        assert_eq!((setting.triads, from), (true, vec![("P, F_C", "slot.friction")]));
        assert!(setting.above.is_empty());
        let before = ((of, setting), "c = a".to_owned());
        let (of, setting) = formulas.setting("above; let c = 3", Some(&before)).unwrap();
        assert_eq!(
            (of.unwrap().spec().id, setting.triads, setting.above),
            ("slot.stop", true, vec!["c = a".to_owned()])
        );
        assert!(setting.definitions.contains("b = 2") && setting.definitions.ends_with("c = 3"));
        assert!(!formulas.setting("slot.stop", None).unwrap().1.triads);
    }

    #[test]
    fn what_cannot_be_read_of_a_display_is_said() {
        let said = |argument: &str| Formulas(CATALOG).setting(argument, None).err().unwrap_or_default();
        assert_eq!(said("slot.nothing"), "no formula `slot.nothing` in the catalog");
        assert_eq!(said("above"), "nothing is executed above");
        assert!(said("where a = 1").starts_with("`where` is none of let, if, put,"));
    }
}
