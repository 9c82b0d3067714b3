//! The history of a scene in tables, which it names.

use super::keys;
use crate::scene::json::{Mark, Read, Reader};
use crate::scene::model::Scene;
use crate::scene::table::Table;
use crate::scene::tables::Tables;
use std::path::Path;

/// The tables that the frames name, each with the position at which they do.
pub(super) struct NamedTables {
    tables: Tables,
    marks: Vec<Mark>,
}

impl NamedTables {
    /// Reads the names of tables, if the frames are an object with such names instead of nodes, loads or pressures.
    pub(super) fn read(reader: &mut Reader, folder: Option<&Path>) -> Read<Option<Self>> {
        let place = reader.place();
        let mut is_named = false;
        if reader.begins_with(b'{') {
            reader.object("frames", |reader, key, _| {
                is_named |= keys::TABLES.contains(&key) && reader.begins_with(b'"');
                reader.skip()
            })?;
            reader.go(place);
        }
        if !is_named {
            return Ok(None);
        }
        let mut found = Self { tables: Tables::default(), marks: Vec::new() };
        reader.record(&keys::TABLES, |reader, key| {
            let at = reader.place();
            let Some(name) = reader.string("the path of a .csv file")? else { return Ok(()) };
            let Some(folder) = folder else {
                reader.fault(
                    at,
                    "a table in a text that is in no folder",
                    "a scene without tables, or read from a file",
                );
                return Ok(());
            };
            let Tables { nodes, loads, pressures } = &mut found.tables;
            *[nodes, loads, pressures][key] = Some(Table::file_called(&folder.join(&*name), &name));
            found.marks.push(reader.mark(at));
            Ok(())
        })?;
        Ok(Some(found))
    }

    /// Gives the history to a scene, or reports what is wrong with it.
    pub(super) fn give(self, reader: &mut Reader, scene: Scene) -> Option<Scene> {
        let names: Vec<_> = {
            let Tables { nodes, loads, pressures } = &self.tables;
            [nodes, loads, pressures].into_iter().flatten().map(|table| table.name().to_owned()).collect()
        };
        let given = scene.with_tables(self.tables);
        given
            .map_err(|fault| {
                let named = names.iter().position(|name| *name == fault.table).unwrap_or_default();
                if let Some(mark) = self.marks.into_iter().nth(named) {
                    reader.fault_at(mark, fault.found(), fault.allowed);
                }
            })
            .ok()
    }
}
