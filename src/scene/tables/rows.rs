//! A table being read, state by state.

use super::fault::TableFault;
use super::header::{Header, Value};
use super::lines::Lines;
use crate::formula::quantity::Domain;
use crate::scene::kind::Dimension;
use crate::scene::model::{Frame, Members, Named, Scene, Unsorted, moves_with};
use crate::scene::table::{Subject, Table};
use std::collections::HashMap;
use std::fmt;

/// A table being read.
pub(in crate::scene) struct Rows<'s> {
    scene: &'s Scene,
    table: &'s Table,
    subject: Subject,
    pub(super) header: Header,
    lines: Lines<'s>,
    /// Whether the row is the first of the next state.
    waits: bool,
    /// The times of the last state and of the row, and the text of the latter.
    last: Option<f64>,
    time: f64,
    time_text: Vec<u8>,
    /// The state that last named each node or element, from 1; 0 if none did.
    named: Vec<u32>,
    states: u32,
    /// The line with which the last state began.
    begun: u64,
    /// The place of the next name, since names mostly come in order; and memory for a name.
    next: usize,
    name: String,
    /// By their names in upper case, once one is sought: nodes or elements; `None` if several have the name.
    in_upper_case: Option<HashMap<String, Option<Members>>>,
    /// The number of rows about what is not in the scene, and the first of them.
    pub(super) strange: Option<(usize, String, u64)>,
}

impl fmt::Debug for Rows<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Rows").field("table", &self.table).field("states", &self.states).finish_non_exhaustive()
    }
}

impl<'s> Rows<'s> {
    /// Opens a table and reads its first row.
    pub(in crate::scene) fn open(scene: &'s Scene, table: &'s Table, subject: Subject) -> Result<Self, TableFault> {
        let lines = Lines::open(table)?;
        if lines.len() == 0 {
            return Err(TableFault {
                table: table.name().into(),
                line: 1,
                column: (1, String::new()),
                found: "no row".into(),
                allowed: "a first row with the names of the columns".into(),
            });
        }
        let header = Header::read(table.name(), &lines, subject)?;
        let things = if subject == Subject::Loads { scene.elements.len() } else { scene.nodes.len() };
        Ok(Self {
            scene,
            table,
            subject,
            header,
            lines,
            waits: false,
            last: None,
            time: f64::NAN,
            time_text: Vec::new(),
            named: vec![0; things],
            states: 0,
            begun: 0,
            next: 0,
            name: String::new(),
            in_upper_case: None,
            strange: None,
        })
    }

    /// The name of the table in messages.
    pub(in crate::scene) fn name(&self) -> &str {
        self.table.name()
    }

    /// The checksum of the table, once all of it is read.
    pub(in crate::scene) fn sum(&self) -> u32 {
        self.lines.sum()
    }

    /// Whether any row was about something in the scene.
    pub(super) fn has_any(&self) -> bool {
        self.named.iter().any(|&state| state > 0)
    }

    /// The number of bytes that persist from state to state.
    pub(in crate::scene) fn bytes(&self) -> usize {
        size_of_val(&*self.named) + Lines::BYTES
    }

    /// A fault in a column of the current row.
    fn fault(&self, column: usize, found: impl Into<String>, allowed: impl Into<String>) -> TableFault {
        self.fault_at(self.lines.number, column, found, allowed)
    }

    /// A fault in a column of a line.
    pub(super) fn fault_at(
        &self,
        line: u64,
        column: usize,
        found: impl Into<String>,
        allowed: impl Into<String>,
    ) -> TableFault {
        let column = (column + 1, self.header.names[column].clone());
        TableFault { table: self.table.name().into(), line, column, found: found.into(), allowed: allowed.into() }
    }

    /// The line with which the last state began; the end of the table if there are no more.
    pub(super) fn line(&self) -> u64 {
        self.begun
    }

    /// The next state, if there is one. It ends where the time changes, or where the first name of the state comes again: two
    /// states may have one time.
    pub(in crate::scene) fn advance(&mut self) -> Result<Option<Frame>, TableFault> {
        self.states += 1;
        let mut state = State::default();
        let mut first = None;
        let mut is_begun = false;
        loop {
            if !std::mem::take(&mut self.waits) && !self.read()? {
                break;
            }
            if is_begun && self.last != Some(self.time) {
                self.waits = true;
                break;
            }
            if !is_begun {
                self.begin()?;
                is_begun = true;
            }
            let Some(members) = self.members() else { continue };
            if first == Some(members) {
                self.waits = true;
                break;
            }
            first.get_or_insert(members);
            self.take(members, &mut state)?;
        }
        Ok(is_begun.then(|| state.frame(self.last.unwrap_or_default())))
    }

    /// Reads the next row and its time; `false` at the end.
    fn read(&mut self) -> Result<bool, TableFault> {
        if !self.lines.advance()? {
            return Ok(false);
        }
        let (found, expected) = (self.lines.len(), self.header.names.len());
        if found != expected {
            let (table, line) = (self.table.name().into(), self.lines.number);
            let column = (found.min(expected) + 1, String::new());
            let (found, allowed) = (format!("{found} cells"), format!("{expected}, as in the first row"));
            return Err(TableFault { table, line, column, found, allowed });
        }
        if self.lines.cell(self.header.time) != self.time_text {
            self.time = self.number(self.header.time, Domain::Real)?;
            self.time_text.clear();
            self.time_text.extend_from_slice(self.lines.cell(self.header.time));
        }
        Ok(true)
    }

    /// Begins a state at the time of the row.
    fn begin(&mut self) -> Result<(), TableFault> {
        if let Some(last) = self.last.filter(|last| self.time < *last) {
            let allowed = format!(
                "a time of at least {last:?}: the rows of a state together, and states in order of time; sort by time"
            );
            return Err(self.fault(self.header.time, format!("{:?} after {last:?}", self.time), allowed));
        }
        (self.last, self.begun) = (Some(self.time), self.lines.number);
        Ok(())
    }

    /// The nodes or elements that the row names; those that the scene does not have are counted.
    fn members(&mut self) -> Option<Members> {
        let name = |place: usize| std::str::from_utf8(self.lines.cell(place)).unwrap_or("\u{fffd}");
        let label = name(self.header.name);
        let instance = self.header.instance.map(name).filter(|instance| !instance.is_empty());
        let mut found = None;
        if let Some(instance) = instance {
            self.name.clear();
            self.name.extend([instance, ".", label]);
            found = self.scene.look_up(self.subject, &mut self.next, &self.name);
        }
        let found = found.or_else(|| self.scene.look_up(self.subject, &mut self.next, label));
        // Some postprocessors write names in upper case.
        let found = found.or_else(|| {
            let written = if instance.is_some() { &*self.name } else { label };
            let in_upper_case = self.in_upper_case.get_or_insert_with(|| self.scene.in_upper_case(self.subject));
            *in_upper_case.get(&written.to_uppercase())?
        });
        if found.is_none() {
            let line = self.lines.number;
            self.strange.get_or_insert_with(|| (0, label.into(), line)).0 += 1;
        }
        found
    }

    /// Adds the row to a state.
    fn take(&mut self, members: Members, state: &mut State) -> Result<(), TableFault> {
        let mut is_twice = false;
        for number in members.numbers() {
            is_twice |= std::mem::replace(&mut self.named[number as usize], self.states) == self.states;
        }
        let Header { name, .. } = self.header;
        if is_twice {
            let found = format!("{:?} for the second time in the state at time {:?}", self.text(name), self.time);
            return Err(self.fault(name, found, "each once in a state, or the whole state again"));
        }
        let first = members.number(0);
        if let Some(with) = (self.subject == Subject::Motions).then(|| self.scene.nodes[first].with).flatten() {
            let [found, allowed] = moves_with(self.scene.nodes.name(first), self.scene.nodes.name(with));
            return Err(self.fault(name, found, allowed));
        }
        let dimension = self.scene.dimension();
        let (mut motion, mut turn) = ([0.0; 3], [0.0; 3]);
        let [mut moves, mut turns] = [false; 2];
        for index in 0..self.header.values.len() {
            let (column, value) = self.header.values[index];
            match value {
                Value::Move(component) if component < dimension.coordinates() => {
                    motion[component] = self.number(column, Domain::Real)?;
                    moves = true;
                }
                Value::Turn(component) if turns_about(dimension, component) => {
                    turn[component] = self.number(column, Domain::Real)?;
                    turns = true;
                }
                Value::Load(load) => {
                    let kind = self.scene.elements[members.number(0)].kind;
                    match kind.loads().position(|name| name == load) {
                        Some(place) => state.load(place, members, self.number(column, kind.domain(load))?),
                        None => self.nothing(column, format_args!("no {load}, which {} does not have", kind.name))?,
                    }
                }
                Value::Pressure => state.pressures.push_all(members, self.number(column, Domain::NonNegative)?),
                Value::Move(_) | Value::Turn(_) => {
                    self.nothing(column, format_args!("0, since the scene is {}", dimension.name()))?;
                }
            }
        }
        if moves {
            state.moves.push_all(members, motion);
        }
        if turns {
            state.turns.push_all(members, turn);
        }
        Ok(())
    }

    /// A number of a domain.
    fn number(&self, column: usize, domain: Domain) -> Result<f64, TableFault> {
        let text = std::str::from_utf8(self.lines.cell(column)).ok();
        let number = text.and_then(|text| text.parse::<f64>().ok());
        number.filter(|number| number.is_finite() && domain.allows(*number)).ok_or_else(|| {
            let text = self.text(column);
            let found = if text.is_empty() { "an empty cell".into() } else { format!("{text:?}") };
            self.fault(column, found, domain.allowed())
        })
    }

    /// Checks that a number that the scene cannot have is 0.
    fn nothing(&self, column: usize, allowed: fmt::Arguments<'_>) -> Result<(), TableFault> {
        let number = self.number(column, Domain::Real)?;
        if number == 0.0 { Ok(()) } else { Err(self.fault(column, format!("{number:?}"), allowed.to_string())) }
    }

    fn text(&self, column: usize) -> String {
        String::from_utf8_lossy(self.lines.cell(column)).into_owned()
    }
}

/// Whether nodes can turn about an axis, counted from 0.
fn turns_about(dimension: Dimension, axis: usize) -> bool {
    match dimension {
        Dimension::Space => true,
        Dimension::Plane => axis == 2,
        Dimension::Axisymmetric => false,
    }
}

impl Scene {
    /// The nodes or elements of this name, which are first looked for at `next`.
    fn look_up(&self, subject: Subject, next: &mut usize, name: &str) -> Option<Members> {
        fn among<T>(known: &Named<T>, next: &mut usize, name: &str) -> Option<Members> {
            known.members_near(next, name).or_else(|| known.members(name))
        }
        if subject == Subject::Loads { among(&self.elements, next, name) } else { among(&self.nodes, next, name) }
    }

    /// Nodes or elements by their names in upper case.
    fn in_upper_case(&self, subject: Subject) -> HashMap<String, Option<Members>> {
        fn all<T>(known: &Named<T>) -> HashMap<String, Option<Members>> {
            let mut all = HashMap::new();
            for (name, members, _) in known.iter() {
                all.entry(name.to_uppercase()).and_modify(|of| *of = None).or_insert(Some(members));
            }
            all
        }
        if subject == Subject::Loads { all(&self.elements) } else { all(&self.nodes) }
    }
}

/// The changes of a state, in the order of the rows.
#[derive(Default)]
struct State {
    moves: Unsorted<[f64; 3]>,
    turns: Unsorted<[f64; 3]>,
    loads: Vec<Unsorted<f64>>,
    pressures: Unsorted<f64>,
}

impl State {
    fn load(&mut self, place: usize, members: Members, value: f64) {
        if self.loads.len() <= place {
            self.loads.resize_with(place + 1, Unsorted::default);
        }
        self.loads[place].push_all(members, value);
    }

    fn frame(self, time: f64) -> Frame {
        let Self { moves, turns, loads, pressures } = self;
        let loads = loads.into_iter().map(Unsorted::sorted).collect();
        Frame { time, moves: moves.sorted(), turns: turns.sorted(), loads, pressures: pressures.sorted() }
    }
}
