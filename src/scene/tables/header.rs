//! The columns of a table, found by their names.

use super::fault::TableFault;
use super::lines::Lines;
use crate::scene::table::Subject;

/// What a column has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Value {
    /// A component of the displacement, from 0.
    Move(usize),
    /// A component of the rotation vector, from 0.
    Turn(usize),
    /// A load of elements, by its name in their kinds.
    Load(&'static str),
    Pressure,
}

/// Names of columns without case, spaces, hyphens and underscores: those of the books, and of postprocessors.
const TIMES: &[&str] = &["time", "totaltime", "t"];
const NODES: &[&str] = &["node", "nodelabel", "nodeid", "nodenumber", "nodename"];
const ELEMENTS: &[&str] = &["element", "elementlabel", "elementid", "elementnumber", "elementname"];
const INSTANCES: &[&str] = &["instance", "instancename", "partinstance", "partinstancename"];
const MOTIONS: [(&[&str], Value); 6] = [
    (&["u1", "ux", "uu1"], Value::Move(0)),
    (&["u2", "uy", "uu2"], Value::Move(1)),
    (&["u3", "uz", "uu3"], Value::Move(2)),
    (&["ur1", "urx", "urur1"], Value::Turn(0)),
    (&["ur2", "ury", "urur2"], Value::Turn(1)),
    (&["ur3", "urz", "urur3"], Value::Turn(2)),
];
const LOADS: [(&[&str], Value); 6] = [
    (&["f1"], Value::Load("f1")),
    (&["f2"], Value::Load("f2")),
    (&["f3"], Value::Load("f3")),
    (&["m1"], Value::Load("m1")),
    (&["m2"], Value::Load("m2")),
    (&["m3"], Value::Load("m3")),
];
const PRESSURES: [(&[&str], Value); 1] = [(&["pressure", "p", "cpress"], Value::Pressure)];

impl Subject {
    /// The names of the column with the names of nodes or elements.
    fn names(self) -> &'static [&'static str] {
        if self == Self::Loads { ELEMENTS } else { NODES }
    }

    /// The columns of numbers.
    fn values(self) -> &'static [(&'static [&'static str], Value)] {
        match self {
            Self::Motions => &MOTIONS,
            Self::Loads => &LOADS,
            Self::Pressures => &PRESSURES,
        }
    }
}

/// Where the columns of a table are, from 0.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) names: Vec<String>,
    pub(super) time: usize,
    pub(super) name: usize,
    pub(super) instance: Option<usize>,
    pub(super) values: Vec<(usize, Value)>,
    /// The names of the columns that are not used.
    pub(super) ignored: Vec<String>,
}

impl Header {
    /// Finds the columns in the first row of a table of this name.
    pub(super) fn read(table: &str, row: &Lines<'_>, subject: Subject) -> Result<Self, TableFault> {
        let names: Vec<_> = row.cells().map(|name| String::from_utf8_lossy(name).into_owned()).collect();
        let plain: Vec<String> = names.iter().map(|name| plain(name)).collect();
        let fault = |column: Option<usize>, found: String, allowed: String| {
            let column = column.map_or((1, String::new()), |column| (column + 1, names[column].clone()));
            TableFault { table: table.into(), line: row.number, column, found, allowed }
        };
        let place = |known: &[&str]| -> Result<Option<usize>, TableFault> {
            let mut places = (0..plain.len()).filter(|&place| known.contains(&&*plain[place]));
            let first = places.next();
            match places.next() {
                Some(second) => Err(fault(Some(second), "this column for the second time".into(), "each once".into())),
                None => Ok(first),
            }
        };
        let required = |known: &[&str]| -> Result<usize, TableFault> {
            place(known)?.ok_or_else(|| {
                let found = format!("no column {:?} among {}", known[0], names.join(", "));
                fault(
                    None,
                    found,
                    format!("a first row with the names of the columns, here one of {}", known.join(", ")),
                )
            })
        };
        let (time, name, instance) = (required(TIMES)?, required(subject.names())?, place(INSTANCES)?);
        let mut values = Vec::new();
        for &(known, value) in subject.values() {
            values.extend(place(known)?.map(|place| (place, value)));
        }
        if values.is_empty() {
            let known: Vec<_> = subject.values().iter().map(|(known, _)| known[0]).collect();
            let found = format!("no column of numbers that is known among {}", names.join(", "));
            return Err(fault(None, found, format!("some of {}", known.join(", "))));
        }
        let is_used = |place: &usize| {
            [time, name].contains(place) || instance == Some(*place) || values.iter().any(|(value, _)| value == place)
        };
        let ignored = (0..names.len()).filter(|place| !is_used(place)).map(|place| names[place].clone()).collect();
        Ok(Self { names, time, name, instance, values, ignored })
    }
}

/// A name without case, spaces, hyphens and underscores.
fn plain(name: &str) -> String {
    name.chars().filter(|c| !matches!(c, ' ' | '-' | '_')).flat_map(char::to_lowercase).collect()
}
