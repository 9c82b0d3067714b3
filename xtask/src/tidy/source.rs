//! One file, parsed with `syn`: what it defines, imports and names, without tests.

use super::finding::Finding;
use super::import::Import;
use super::words::Words;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::BTreeSet;
use syn::{Attribute, ImplItem, Item, ItemImpl, ItemMacro, ItemMod, Meta};

/// A file.
#[derive(Debug)]
pub(super) struct Source {
    /// Its path from the root of the workspace, with forward slashes.
    pub(super) path: String,
    /// The number of its lines.
    pub(super) lines: usize,
    /// Its content.
    pub(super) scope: Scope,
    /// Its `impl Formula for …`.
    pub(super) formulas: Vec<FormulaImpl>,
    /// Whether it has an `impl Proved for …`.
    pub(super) proves: bool,
}

/// A module: a file, or `mod … { … }` within one.
#[derive(Debug, Default)]
pub(super) struct Scope {
    /// The names it defines.
    pub(super) items: BTreeSet<String>,
    /// The macros that it exports at the root of the crate.
    pub(super) exported: Vec<String>,
    /// Its imports and re-exports.
    pub(super) imports: Vec<Import>,
    /// Its modules.
    pub(super) children: Vec<Child>,
    /// The names used in its code.
    pub(super) words: Words,
}

/// A `mod`.
#[derive(Debug)]
pub(super) struct Child {
    /// Its name.
    pub(super) name: String,
    /// The features of which at least one is required.
    pub(super) features: Vec<String>,
    /// The content of its braces, unless it is a file.
    pub(super) scope: Option<Scope>,
}

/// An `impl Formula for …`.
#[derive(Debug)]
pub(super) struct FormulaImpl {
    /// The type.
    pub(super) name: String,
    /// The strings in `const SPEC`, of which one is the id.
    pub(super) spec: Vec<(String, usize)>,
    /// Its functions: name, line, and whether it has `#[inline]`.
    pub(super) functions: Vec<(String, usize, bool)>,
}

impl Source {
    /// Reads a file.
    ///
    /// # Errors
    /// The location of the syntax error, if it is not Rust.
    pub(super) fn read(path: String, text: &str) -> Result<Self, Finding> {
        let file = syn::parse_file(text).map_err(|error| {
            let line = error.span().start().line;
            Finding::new(path.clone(), line, format!("this cannot be read: {error}; let `cargo check` say more"))
        })?;
        let lines = text.lines().count();
        let mut source = Self { path, lines, scope: Scope::default(), formulas: Vec::new(), proves: false };
        source.scope = source.scope(file.items);
        Ok(source)
    }

    fn scope(&mut self, items: Vec<Item>) -> Scope {
        let mut scope = Scope::default();
        for item in items.into_iter().filter(|item| !is_test(head(item).0)) {
            match item {
                Item::Use(item) => scope.imports.extend(Import::of(&item)),
                Item::Mod(item) => scope.children.push(self.child(item)),
                Item::Macro(item) => scope.macro_item(item),
                Item::Impl(item) => self.implementation(item, &mut scope),
                item => {
                    scope.items.extend(head(&item).1.map(ToString::to_string));
                    scope.words.read(item.to_token_stream());
                }
            }
        }
        scope.imports.append(&mut scope.words.imports);
        scope
    }

    fn child(&mut self, item: ItemMod) -> Child {
        let features = item.attrs.iter().filter_map(condition).flat_map(|meta| features(&meta)).collect();
        let scope = item.content.map(|(_, items)| self.scope(items));
        Child { name: item.ident.to_string(), features, scope }
    }

    fn implementation(&mut self, mut item: ItemImpl, scope: &mut Scope) {
        item.items.retain(|item| !is_test(member_attributes(item)));
        let of = item.trait_.as_ref().and_then(|(_, path, _)| path.segments.last()).map(|last| last.ident.to_string());
        self.proves |= of.as_deref() == Some("Proved");
        if of.as_deref() == Some("Formula") {
            self.formulas.push(FormulaImpl::take(&mut item, &mut scope.words));
        }
        scope.words.read(item.into_token_stream());
    }
}

impl Scope {
    fn macro_item(&mut self, item: ItemMacro) {
        if let Some(name) = item.ident {
            let is_exported = item.attrs.iter().any(|attribute| attribute.path().is_ident("macro_export"));
            self.exported.extend(is_exported.then(|| name.to_string()));
            self.items.insert(name.to_string());
        } else {
            self.items.extend(defined_by(item.mac.tokens.clone()));
            self.words.read(item.into_token_stream());
        }
    }
}

impl FormulaImpl {
    /// Reads an `impl Formula for …`, and removes its `SPEC`, whose strings are its own.
    fn take(item: &mut ItemImpl, words: &mut Words) -> Self {
        let name = item.self_ty.to_token_stream().to_string();
        let (mut spec, mut functions) = (Words::default(), Vec::new());
        item.items.retain(|member| match member {
            ImplItem::Const(member) if member.ident == "SPEC" => {
                spec.read(member.expr.to_token_stream());
                false
            }
            ImplItem::Fn(member) => {
                let is_inlined = member.attrs.iter().any(|attribute| attribute.path().is_ident("inline"));
                let line = member.sig.ident.span().start().line;
                functions.push((member.sig.ident.to_string(), line, is_inlined));
                true
            }
            _ => true,
        });
        let strings = std::mem::take(&mut spec.strings);
        words.append(spec);
        Self { name, spec: strings, functions }
    }
}

/// The names that a macro call defines: after `struct`, `fn`, …, or at the start of a row, as in a table from which a
/// macro generates constants.
fn defined_by(tokens: TokenStream) -> Vec<String> {
    const KEYWORDS: [&str; 9] = ["pub", "struct", "enum", "union", "fn", "trait", "type", "const", "static"];
    let mut names = Vec::new();
    let mut before = String::from(";");
    for token in tokens {
        let text = token.to_string();
        let is_defined = before == ";" || KEYWORDS.contains(&before.as_str());
        if matches!(token, TokenTree::Ident(_)) && is_defined && !KEYWORDS.contains(&text.as_str()) {
            names.push(text.clone());
        }
        before = text;
    }
    names
}

/// Whether an item with these attributes exists only for tests.
fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test") || condition(attribute).is_some_and(|meta| wants_test(&meta))
    })
}

/// The condition in `#[cfg(…)]`.
fn condition(attribute: &Attribute) -> Option<Meta> {
    attribute.path().is_ident("cfg").then(|| attribute.parse_args().ok())?
}

fn wants_test(condition: &Meta) -> bool {
    match condition {
        Meta::Path(path) => path.is_ident("test") || path.is_ident("doctest"),
        Meta::List(list) if list.path.is_ident("all") => nested(list).iter().any(wants_test),
        _ => false,
    }
}

/// The features named in a condition, except within `not`.
fn features(condition: &Meta) -> Vec<String> {
    match condition {
        Meta::NameValue(pair) if pair.path.is_ident("feature") => {
            vec![pair.value.to_token_stream().to_string().trim_matches('"').to_owned()]
        }
        Meta::List(list) if !list.path.is_ident("not") => nested(list).iter().flat_map(features).collect(),
        _ => Vec::new(),
    }
}

fn nested(list: &syn::MetaList) -> Vec<Meta> {
    let parser = syn::punctuated::Punctuated::<Meta, syn::Token![,]>::parse_terminated;
    list.parse_args_with(parser).map(|metas| metas.into_iter().collect()).unwrap_or_default()
}

/// The attributes of an item, and its name.
fn head(item: &Item) -> (&[Attribute], Option<&Ident>) {
    match item {
        Item::Const(item) => (&item.attrs, Some(&item.ident)),
        Item::Enum(item) => (&item.attrs, Some(&item.ident)),
        Item::Fn(item) => (&item.attrs, Some(&item.sig.ident)),
        Item::Impl(item) => (&item.attrs, None),
        Item::Macro(item) => (&item.attrs, item.ident.as_ref()),
        Item::Mod(item) => (&item.attrs, Some(&item.ident)),
        Item::Static(item) => (&item.attrs, Some(&item.ident)),
        Item::Struct(item) => (&item.attrs, Some(&item.ident)),
        Item::Trait(item) => (&item.attrs, Some(&item.ident)),
        Item::Type(item) => (&item.attrs, Some(&item.ident)),
        Item::Union(item) => (&item.attrs, Some(&item.ident)),
        Item::Use(item) => (&item.attrs, None),
        _ => (&[], None),
    }
}

fn member_attributes(item: &ImplItem) -> &[Attribute] {
    match item {
        ImplItem::Const(item) => &item.attrs,
        ImplItem::Fn(item) => &item.attrs,
        ImplItem::Type(item) => &item.attrs,
        _ => &[],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Source {
        Source::read("a.rs".into(), text).unwrap()
    }

    fn paths(words: &Words) -> Vec<String> {
        words.paths.iter().map(|mention| mention.path.join("::")).collect()
    }

    #[test]
    fn a_macro_call_defines_what_stands_behind_keywords_and_at_the_start_of_a_row() {
        let names = |tokens: &str| defined_by(tokens.parse().unwrap());
        assert_eq!(names("/// A place. \n pub struct Place<T> { x: T = X }"), ["Place"]);
        assert_eq!(names("FIRST, \"x_1\", Length; SECOND, symbol(3), Angle;"), ["FIRST", "SECOND"]);
    }

    #[test]
    fn what_is_defined_is_known_by_its_name_and_tests_are_left_out() {
        let source = read(
            "/// Doc.\n#[cfg(test)]\nstruct Tested;\n#[test]\nfn tested() { a::b() }\n#[cfg(doctest)]\nmod examples {}\n\
             #[cfg(all(unix, any(test)))]\nconst KEPT: One = a::c;\n#[cfg(unix)]\nfn kept() { a::d() }\n\
             made! { struct Made(a::e) }\nmacro_rules! own { () => { a::f } }\n\
             /// Doc.\n#[macro_export]\nmacro_rules! shared { () => { a::g } }\n",
        );
        let Scope { items, exported, words, children, .. } = source.scope;
        assert_eq!(items.into_iter().collect::<Vec<_>>(), ["KEPT", "Made", "kept", "own", "shared"]);
        assert_eq!((exported, children.len()), (vec!["shared".to_owned()], 0));
        assert_eq!(paths(&words), ["a::c", "a::d", "a::e"]);
        assert!(!source.proves && source.formulas.is_empty());
    }

    #[test]
    fn a_module_has_the_features_that_it_needs() {
        let source = read(
            "mod a;\n#[cfg(feature = \"verify\")]\nmod b { fn c() {} }\n\
             #[cfg(all(feature = \"ours\", any(unix, feature = \"measure\"), not(feature = \"scene\")))]\nmod d;\n\
             #[cfg(not(feature = \"verify\"))]\nmod e;\n",
        );
        let child = |child: &Child| (child.name.clone(), child.features.join(" "), child.scope.is_some());
        let expected = [("a", "", false), ("b", "verify", true), ("d", "ours measure", false), ("e", "", false)]
            .map(|(name, features, is_here)| (name.to_owned(), features.to_owned(), is_here));
        assert_eq!(source.scope.children.iter().map(child).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn a_formula_is_its_specification_its_functions_and_what_else_it_names() {
        let source = read(
            "impl crate::Formula for One {\n    const SPEC: Spec = Spec::new(\"a.one\", a::of());\n    const TWO: A = a::two();\n    \
             type Inputs<T> = a::Three<T>;\n    /// Doc.\n    #[inline]\n    fn eval() { a::four() }\n    /// Doc.\n    \
             fn jacobian() {}\n    #[test]\n    fn tested() {}\n}\nimpl a::Proved for One {}\n",
        );
        let [FormulaImpl { name, spec, functions }] = source.formulas.as_slice() else { panic!("there is one") };
        assert_eq!((name.as_str(), spec.as_slice()), ("One", &[("a.one".to_owned(), 2)][..]));
        assert_eq!(functions, &[("eval".to_owned(), 7, true), ("jacobian".to_owned(), 9, false)]);
        assert!(source.proves);
        // The identifier is not typed by hand but declared here.
        assert!(source.scope.words.strings.is_empty());
        let paths = paths(&source.scope.words);
        for path in ["Spec::new", "a::of", "a::two", "a::Three", "a::four", "crate::Formula", "a::Proved"] {
            assert_eq!(paths.iter().filter(|known| *known == path).count(), 1, "{path} in {paths:?}");
        }
        let other = read("impl Other for One { const SPEC: &str = \"a.one\"; }");
        assert!(other.formulas.is_empty() && !other.proves);
        assert_eq!(other.scope.words.strings, [("a.one".to_owned(), 1)]);
    }
}
