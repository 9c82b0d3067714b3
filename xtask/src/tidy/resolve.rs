//! Finds the file that defines what a path names.

use super::import::{Import, Known};
use super::tree::{FileId, Module, ModuleId, Tree};
use std::collections::BTreeSet;

impl Tree {
    /// The files that define what `path`, written in the module `from`, names.
    ///
    /// Re-exports are followed. A path to a module has no definition, since only what is used from the module counts;
    /// neither has a path out of the workspace. A name may denote several items, such as a function and a module.
    pub(super) fn definitions(&self, from: ModuleId, path: &[String]) -> BTreeSet<FileId> {
        let targets = self.path(from, path, &mut Vec::new());
        targets
            .into_iter()
            .filter_map(|target| if let Target::Item(file) = target { Some(file) } else { None })
            .collect()
    }

    fn path(&self, from: ModuleId, path: &[String], trail: &mut Trail) -> Vec<Target> {
        let Some((first, rest)) = path.split_first() else { return Vec::new() };
        let mut here = match (self.step(from, first), first.as_str()) {
            (Some(module), _) => vec![Target::Module(module)],
            (None, "crate") => vec![Target::Module(self.modules[from].root)],
            (None, name) => self.first(from, name, trail),
        };
        for segment in rest {
            // If further segments follow, it is a module, unless there is only a type with this name.
            if here.iter().any(|target| matches!(target, Target::Module(_))) {
                here.retain(|target| matches!(target, Target::Module(_)));
            }
            let inside = |target| match target {
                Target::Item(file) => vec![Target::Item(file)],
                Target::Module(module) => match self.step(module, segment) {
                    Some(module) => vec![Target::Module(module)],
                    None => self.name(module, segment, trail),
                },
            };
            here = here.into_iter().flat_map(inside).collect();
        }
        here
    }

    /// `self` or `super`.
    fn step(&self, from: ModuleId, segment: &str) -> Option<ModuleId> {
        match segment {
            "self" => Some(from),
            "super" => self.modules[from].parent,
            _ => None,
        }
    }

    /// The first segment of a path: something in this module, or a library.
    fn first(&self, from: ModuleId, name: &str, trail: &mut Trail) -> Vec<Target> {
        let found = self.name(from, name, trail);
        let library = || self.libraries.get(name).map(|&root| Target::Module(root)).into_iter().collect();
        if found.is_empty() { library() } else { found }
    }

    /// What `name` denotes in a module: its definitions, its imports, or else what its globs provide.
    fn name(&self, module: ModuleId, name: &str, trail: &mut Trail) -> Vec<Target> {
        let Module { file, children, items, macros, imports, .. } = &self.modules[module];
        let mut found: Vec<Target> = children.get(name).map(|&child| Target::Module(child)).into_iter().collect();
        found.extend(items.contains(name).then_some(Target::Item(*file)));
        found.extend(macros.get(name).map(|&file| Target::Item(file)));
        let is_named = |import: &Import| matches!(&import.known, Known::As(known) if known == name);
        for (at, import) in imports.iter().enumerate().filter(|(_, import)| is_named(import)) {
            found.extend(trail_through(trail, (module, at), |trail| self.path(module, &import.path, trail)));
        }
        if !found.is_empty() {
            return found;
        }
        for (at, import) in imports.iter().enumerate().filter(|(_, import)| import.known == Known::Glob) {
            found.extend(trail_through(trail, (module, at), |trail| {
                let from = self.path(module, &import.path, trail).into_iter();
                let modules = from.filter_map(|target| if let Target::Module(id) = target { Some(id) } else { None });
                modules.flat_map(|id| self.name(id, name, trail)).collect()
            }));
        }
        found
    }
}

/// What a name denotes.
#[derive(Debug, Clone, Copy)]
enum Target {
    Module(ModuleId),
    /// An item defined by this file.
    Item(FileId),
}

/// The imports being followed; none is followed recursively.
type Trail = Vec<(ModuleId, usize)>;

fn trail_through(
    trail: &mut Trail,
    import: (ModuleId, usize),
    follow: impl FnOnce(&mut Trail) -> Vec<Target>,
) -> Vec<Target> {
    if trail.contains(&import) {
        return Vec::new();
    }
    trail.push(import);
    let found = follow(trail);
    trail.pop();
    found
}
