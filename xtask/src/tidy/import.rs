//! One `use`, split into imports: `use a::{b as c, d::*};` is two imports.

use syn::{ItemUse, UseTree, Visibility};

/// The name of an import.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Known {
    /// Its own, or the one after `as`.
    As(String),
    /// `as _`: a trait imported for its methods.
    Nameless,
    /// `*`.
    Glob,
}

/// One imported path.
#[derive(Debug, Clone)]
pub(super) struct Import {
    /// Its segments, without the `*`.
    pub(super) path: Vec<String>,
    /// The name it gets.
    pub(super) known: Known,
    /// Whether other modules may import it from here, so that it is a re-export.
    pub(super) is_public: bool,
    /// Its line.
    pub(super) line: usize,
}

impl Import {
    /// The imports of one `use`.
    pub(super) fn of(item: &ItemUse) -> Vec<Self> {
        let is_public = !matches!(item.vis, Visibility::Inherited);
        let mut imports = Vec::new();
        flatten(&item.tree, &mut Vec::new(), is_public, &mut imports);
        imports
    }

    /// The import written as a single `use`.
    pub(super) fn shown(&self) -> String {
        let path = self.path.join("::");
        match &self.known {
            Known::Glob => format!("use {path}::*"),
            Known::Nameless => format!("use {path} as _"),
            Known::As(name) if self.path.last() == Some(name) => format!("use {path}"),
            Known::As(name) => format!("use {path} as {name}"),
        }
    }
}

fn flatten(tree: &UseTree, path: &mut Vec<String>, is_public: bool, imports: &mut Vec<Import>) {
    let mut leaf = |path: &[String], last: Option<&syn::Ident>, known: Known, line: usize| {
        let last = last.map(ToString::to_string).filter(|last| last != "self" || path.is_empty());
        let path = path.iter().cloned().chain(last).collect();
        imports.push(Import { path, known, is_public, line });
    };
    match tree {
        UseTree::Path(inner) => {
            path.push(inner.ident.to_string());
            flatten(&inner.tree, path, is_public, imports);
            path.pop();
        }
        UseTree::Group(group) => group.items.iter().for_each(|tree| flatten(tree, path, is_public, imports)),
        UseTree::Name(name) => {
            let own = Some(&name.ident).filter(|ident| *ident != "self").map(ToString::to_string);
            let known = own.or_else(|| path.last().cloned()).map_or(Known::Nameless, Known::As);
            leaf(path, Some(&name.ident), known, name.ident.span().start().line);
        }
        UseTree::Rename(rename) => {
            let known = if rename.rename == "_" { Known::Nameless } else { Known::As(rename.rename.to_string()) };
            leaf(path, Some(&rename.ident), known, rename.ident.span().start().line);
        }
        UseTree::Glob(glob) => leaf(path, None, Known::Glob, glob.star_token.spans[0].start().line),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_use_is_taken_apart_and_each_part_shown_as_one_would_write_it_alone() {
        let of = |text: &str| Import::of(&syn::parse_str(text).unwrap());
        let shown = |text: &str| of(text).iter().map(Import::shown).collect::<Vec<_>>();
        assert_eq!(shown("use a;"), ["use a"]);
        assert_eq!(
            shown("use a::{b::{C, D as E}, f, g::*, H as _};"),
            ["use a::b::C", "use a::b::D as E", "use a::f", "use a::g::*", "use a::H as _"]
        );
        // The module itself is imported under its own name.
        assert_eq!(
            shown("use crate::y::{self, self as z, Y};"),
            ["use crate::y", "use crate::y as z", "use crate::y::Y"]
        );
        assert_eq!(of("use crate::y::{self};")[0].known, Known::As("y".into()));
        assert_eq!((&of("use self as z;")[0].path, of("use a::a;").len()), (&vec!["self".to_owned()], 1));
        let lines = |text: &str| of(text).iter().map(|import| (import.line, import.is_public)).collect::<Vec<_>>();
        assert_eq!(lines("use a::{\nB,\nC as D,\ne::*,\n};"), [(2, false), (3, false), (4, false)]);
        assert_eq!(lines("\npub(crate) use a::B;"), [(2, true)]);
    }
}
