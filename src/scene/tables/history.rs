//! A history in tables, checked.

use super::Tables;
use super::fault::TableFault;
use super::rows::Rows;
use crate::scene::model::{Frame, History, HistoryTables, Quantity, Scene};
use crate::scene::table::{Subject, Table};
use std::collections::BTreeMap;

impl Scene {
    /// The same scene with a history from tables, which are read and checked. They are read again, state by state, by every
    /// run, so they must not change meanwhile; that is noticed.
    ///
    /// # Errors
    /// The first fault of the tables, with its line and column; tables whose times differ; no table.
    pub fn with_tables(self, tables: Tables) -> Result<Self, TableFault> {
        let history = HistoryTables::read(&self, tables)?;
        Ok(Self { history: History::Tables(history), ..self })
    }

    /// What was ignored in reading, in words: columns of tables that are not known.
    pub fn notes(&self) -> &[String] {
        match &self.history {
            History::Tables(tables) => &tables.notes,
            _ => &[],
        }
    }
}

impl HistoryTables {
    fn read(scene: &Scene, Tables { nodes, loads, pressures }: Tables) -> Result<Self, TableFault> {
        let given = [(nodes, Subject::Motions), (loads, Subject::Loads), (pressures, Subject::Pressures)];
        let given: Vec<_> = given.into_iter().filter_map(|(table, subject)| Some((table?, subject))).collect();
        let mut history = Self {
            tables: Vec::new(),
            times: Vec::new(),
            changed: Frame::default(),
            notes: Vec::new(),
            warnings: Vec::new(),
        };
        let mut changed = Changed::default();
        for (table, subject) in given {
            let sum = history.check(scene, &table, subject, &mut changed)?;
            history.tables.push((table, subject, sum));
        }
        for (quantity, is_changed) in changed.0.into_values() {
            let numbers = (0..).zip(is_changed).filter(|(_, is_changed)| *is_changed).map(|(number, _)| number);
            *history.changed.of_mut(quantity) = numbers.collect();
        }
        Ok(history)
    }

    /// Reads a whole table. Its times are those of the tables before it.
    fn check(
        &mut self,
        scene: &Scene,
        table: &Table,
        subject: Subject,
        changed: &mut Changed,
    ) -> Result<u32, TableFault> {
        let mut rows = Rows::open(scene, table, subject)?;
        let first = self.tables.first().map(|(first, ..)| first.name().to_owned());
        let mut states = 0;
        while let Some(frame) = rows.advance()? {
            if let Some(first) = &first {
                if self.times.get(states) != Some(&frame.time) {
                    let expected = self.times.get(states).map_or("no further state".into(), |time| format!("{time:?}"));
                    let (line, time) = (rows.line(), rows.header.time);
                    let found = format!("the time {:?} of state {states}", frame.time);
                    return Err(rows.fault_at(line, time, found, format!("{expected}, as in {first}")));
                }
            } else {
                self.times.push(frame.time);
            }
            changed.add(scene, &frame);
            states += 1;
        }
        let strange = rows.strange.take();
        if states < self.times.len() {
            let allowed = format!("{}, as in {}", self.times.len(), first.unwrap_or_default());
            let (line, time) = (rows.line(), rows.header.time);
            return Err(rows.fault_at(line, time, format!("the last of {states} states"), allowed));
        }
        let what = if subject == Subject::Loads { "element" } else { "node" };
        if !rows.has_any() {
            let (found, line) = strange.map_or(("no row".into(), 1), |(_, name, line)| {
                (format!("{name:?}, and no {what} of the scene"), line)
            });
            return Err(rows.fault_at(line, rows.header.name, found, format!("rows about each {what} that changes")));
        }
        if let Some((count, name, line)) = strange {
            self.warnings.push(format!(
                "{}: {count} rows name no {what} of the scene, the first in line {line} {name:?}; they are ignored",
                table.name()
            ));
        }
        if !rows.header.ignored.is_empty() {
            self.notes.push(format!("{}: the columns {} are not used", table.name(), rows.header.ignored.join(", ")));
        }
        Ok(rows.sum())
    }
}

/// Whether each node or element is changed by some state, for every quantity.
#[derive(Default)]
struct Changed(BTreeMap<usize, (Quantity, Vec<bool>)>);

impl Changed {
    fn add(&mut self, scene: &Scene, frame: &Frame) {
        for (quantity, of) in frame.changed() {
            let things = if matches!(quantity, Quantity::Loads(_)) { scene.elements.len() } else { scene.nodes.len() };
            let (_, is_changed) = self.0.entry(quantity.place()).or_insert_with(|| (quantity, vec![false; things]));
            for &number in of {
                is_changed[number as usize] = true;
            }
        }
    }
}
