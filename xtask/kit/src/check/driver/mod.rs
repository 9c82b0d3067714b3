//! Programs that answer `check`, complete except for the call of the user's own code.

pub(super) mod abi;
mod c;
mod fortran;
mod plan;
mod scripts;
#[cfg(test)]
mod tests;

pub(super) use plan::Driver;

/// A language that a driver is printed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Lang {
    C,
    Cpp,
    Fortran,
    Python,
    Julia,
}

/// The program; `None` if the formula is not exported to this language.
pub(super) fn text(driver: &Driver, lang: Lang) -> Option<String> {
    match lang {
        Lang::C => Some(c::text(driver, false)),
        Lang::Cpp => Some(c::text(driver, true)),
        Lang::Fortran => Some(fortran::text(driver)),
        Lang::Python => Some(scripts::python(driver)),
        Lang::Julia => (!driver.is_exported).then(|| scripts::julia(driver)),
    }
}
