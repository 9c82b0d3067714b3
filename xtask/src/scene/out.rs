//! Files of results, whose names determine their format.

use super::show::Format;
use std::path::PathBuf;
use std::str::FromStr;

/// A file for results.
#[derive(Clone, Debug)]
pub(crate) struct Target {
    pub(crate) path: PathBuf,
    pub(crate) form: Form,
}

/// The format of results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// As arrays readable by NumPy.
    Arrays,
    /// In a printed format.
    Printed(Format),
    /// As a page, which a description has.
    Page,
}

/// The possible file extensions.
const FORMS: [(&str, Form); 5] = [
    ("npz", Form::Arrays),
    ("json", Form::Printed(Format::Json)),
    ("csv", Form::Printed(Format::Csv)),
    ("txt", Form::Printed(Format::Text)),
    ("html", Form::Page),
];

impl FromStr for Target {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let path = PathBuf::from(text);
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        let known = FORMS.iter().find(|(known, _)| extension.as_deref() == Some(known));
        let &(_, form) = known.ok_or_else(|| {
            let allowed = FORMS.map(|(known, _)| format!(".{known}")).join(", ");
            format!("allowed is a name that ends in one of {allowed}")
        })?;
        Ok(Self { path, form })
    }
}
