//! Numbers stored as arrays in a file next to the scene.

use crate::scene::json::{Mark, Read, Reader, Stop};
use crate::scene::npz::{Archive, Array, Unfit};
use std::path::Path;
use std::sync::Arc;

/// The file of arrays that a scene names, if it names one.
#[derive(Default)]
pub(super) struct Columns {
    archive: Option<Arc<Archive>>,
}

/// The name of an array, and the position at which the scene refers to it.
pub(super) struct Reference {
    pub(super) name: String,
    pub(super) mark: Mark,
}

impl Columns {
    /// Reads the name of the file; `folder` is the folder of the scene, if it is in one. Without the file, nothing that could
    /// refer to it is read.
    pub(super) fn read(reader: &mut Reader, folder: Option<&Path>) -> Read<Self> {
        let place = reader.place();
        let Some(name) = reader.string("the path of a .npz file")? else { return Err(Stop) };
        let Some(folder) = folder else {
            reader.fault(
                place,
                "columns in a text that is in no folder",
                "a scene without columns, or read from a file",
            );
            return Err(Stop);
        };
        match Archive::open(&folder.join(&*name), &name) {
            Ok(archive) => Ok(Self { archive: Some(Arc::new(archive)) }),
            Err(Unfit { found, allowed }) => {
                reader.fault(place, found, allowed);
                Err(Stop)
            }
        }
    }

    /// The file of arrays.
    pub(super) fn file(&self) -> Option<&Arc<Archive>> {
        self.archive.as_ref()
    }

    /// The name of an array, if it is next in the text. Without a file of arrays, a string is not a name.
    pub(super) fn refer(&self, reader: &mut Reader) -> Read<Option<Reference>> {
        let place = reader.place();
        if self.archive.is_none() || !reader.begins_with(b'"') {
            return Ok(None);
        }
        let mark = reader.mark(place);
        Ok(reader.string("the name of an array")?.map(|name| Reference { name: name.into(), mark }))
    }

    /// Reads a value from an array that the scene refers to, or records the fault.
    pub(super) fn load<T>(
        &self,
        reader: &mut Reader,
        Reference { name, mark }: Reference,
        load: impl FnOnce(Array) -> Result<T, Unfit>,
    ) -> Option<T> {
        let loaded = self.archive.as_ref()?.array(&name).and_then(load);
        loaded.map_err(|Unfit { found, allowed }| reader.fault_at(mark, found, allowed)).ok()
    }
}
