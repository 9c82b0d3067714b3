use super::*;
use clap::ValueEnum;
use expect_test::expect_file;
use jointproof::catalog::find;
use judge::Wanted;

/// Drivers in every language, kept in `tests/printed/check_drivers.txt`: for vectors, for a name that is reserved in a
/// language, and for more names than fit on a line.
#[test]
fn what_a_driver_is_in_every_language() {
    let of = |id: &str, lang: Lang, wanted: Wanted, is_exported: bool| {
        let driver = Driver::new(find(id).unwrap(), wanted, is_exported).unwrap();
        let text = text(&driver, lang).unwrap_or_else(|| "none\n".into());
        format!("{lang:?}, {}, exported: {is_exported}\n{text}\n", wanted.name())
    };
    let all = |wanted, is_exported| {
        let langs = Lang::value_variants().iter();
        langs.map(|lang| of("slider.nodal_forces_2d", *lang, wanted, is_exported)).collect::<String>()
    };
    let texts = [
        all(Wanted::Jacobian, false),
        all(Wanted::Value, true),
        of("slider.nodal_forces_2d", Lang::C, Wanted::Jacobian, true),
        of("slider.nodal_forces_2d", Lang::Fortran, Wanted::Jacobian, true),
        of("slider.nodal_forces_2d", Lang::Python, Wanted::Jacobian, true),
        of("slider.nodal_forces_2d", Lang::Julia, Wanted::Value, false),
        of("translator.friction", Lang::Fortran, Wanted::Jacobian, false),
    ];
    expect_file!["../../../tests/printed/check_drivers.txt"].assert_eq(&texts.concat());
}

#[test]
fn products_have_no_driver() {
    assert!(Driver::new(find("slider.line").unwrap(), Wanted::Products, false).is_none());
}
