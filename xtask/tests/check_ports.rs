//! `cargo xtask check` of ports: correct ones pass, and mistakes planted in them are diagnosed.

use crate::common::Bench;
use crate::port::Plant::{After, Before, Driver, Nothing, Within};
use crate::port::{Lang, Plant, check, port};

/// A class of mistakes, where it is planted, and its diagnosis.
struct Planted {
    class: &'static str,
    lang: Lang,
    id: &'static str,
    plant: Plant,
    says: &'static str,
}

const fn planted(class: &'static str, lang: Lang, id: &'static str, plant: Plant, says: &'static str) -> Planted {
    Planted { class, lang, id, plant, says }
}

use Lang::{C, Fortran, Python};

/// Every class is planted at least once, in three languages, over a dozen formulas.
const PLANTED: &[Planted] = &[
    planted("sign", C, "slot.friction", After("jacobian[1][1] = -jacobian[1][1];"), "wrong sign: ∂fn/∂f2"),
    planted(
        "sign",
        Python,
        "slot.contact_force",
        After("rows[0] = [-x for x in rows[0]]"),
        "wrong sign: the whole Jacobian",
    ),
    planted(
        "sign of all",
        Fortran,
        "universal.kinetic_moment",
        After("j_all = -j_all"),
        "wrong sign: the whole Jacobian",
    ),
    planted(
        "sign of an output",
        Python,
        "slot.friction",
        After("outputs[2] *= -1; rows[2] = [-x for x in rows[2]]"),
        "wrong sign: phi, and the derivatives of phi",
    ),
    planted(
        "transposed",
        C,
        "ujoint.twist_factors",
        After("double t = jacobian[0][1]; jacobian[0][1] = jacobian[1][0]; jacobian[1][0] = t;"),
        "the Jacobian is transposed",
    ),
    planted(
        "transposed",
        Python,
        "slot.relative_position",
        After("rows = [list(row) for row in zip(*rows)]"),
        "the Jacobian is written column by column",
    ),
    planted(
        "row-major",
        Fortran,
        "slot.friction",
        Driver("((j_all(row, column), column = 1, inputs), row = 1, outputs)", "j_all"),
        "the Jacobian is written column by column",
    ),
    planted(
        "row-major",
        Fortran,
        "join.geometric_stiffness",
        After("y_all(10:18) = reshape(transpose(reshape(y_all(10:18), [3, 3])), [9])"),
        "transposed: the matrix",
    ),
    planted(
        "spin",
        Fortran,
        "join.geometric_stiffness",
        After("y_all(10:18) = (y_all(10:18) + y_all([10, 13, 16, 11, 14, 17, 12, 15, 18])) / 2"),
        "by rotation vectors, not by spins: the symmetric part of k_ta_ta",
    ),
    planted("factor 2", Python, "translator.friction", After("rows[1][1] *= 2"), "a factor of 2 too much in ∂fn/∂f2"),
    planted(
        "factor ½",
        C,
        "slider.line",
        After("for (int j = 0; j < inputs; ++j) jacobian[3][j] *= 0.5;"),
        "a factor of ½ too much in the derivatives of l",
    ),
    planted(
        "degrees",
        Fortran,
        "universal.angles",
        After("y_all = y_all * 57.295779513082320877_dp; j_all = j_all * 57.295779513082320877_dp"),
        "degrees for radians (a factor of 180/π) in alpha, gamma, and the whole Jacobian",
    ),
    planted(
        "degrees",
        Python,
        "universal.relative_motion",
        Before("x[0] *= 0.017453292519943295"),
        "alpha is taken for degrees",
    ),
    planted(
        "index swapped",
        C,
        "slot.friction",
        After(
            "for (int i = 0; i < outputs; ++i) { double t = jacobian[i][1]; jacobian[i][1] = jacobian[i][2]; jacobian[i][2] = t; }",
        ),
        "exchanged: the derivatives with respect to f2 and f3",
    ),
    planted(
        "index swapped",
        Fortran,
        "slider.line",
        Before("x_all(1:2) = x_all([2, 1])"),
        "exchanged: the inputs x1[0] and x1[1]",
    ),
    planted(
        "index swapped",
        Python,
        "slot.friction",
        After("rows[1][2] = rows[1][1]"),
        "an index is wrong: ∂fn/∂f3 holds ∂fn/∂f2",
    ),
    planted(
        "index swapped",
        C,
        "slot.friction",
        Within("jp_norm2(f2, f3)", "jp_norm2(f2, fc_int)"),
        "fc_int for f3 in length(f2, f3)",
    ),
    planted(
        "term left out",
        C,
        "slot.friction",
        Within("t9 - t12;", "t9;"),
        "value: the term mu |length(f2, f3) + fc_int| is left out",
    ),
    planted(
        "term left out",
        Fortran,
        "translator.friction",
        After("j_all(3, 9) = 0"),
        "left out (always 0): ∂phi/∂fc_int",
    ),
    planted(
        "sign of a term",
        Python,
        "slot.friction",
        Within("t6 + fc_int", "t6 - fc_int"),
        "the sign of the input fc_int is reversed",
    ),
    planted("sign of a term", C, "translator.friction", Within("t25 - t77", "t25 + t77"), "value: the sign of mu"),
    planted(
        "single precision",
        C,
        "slider.line",
        After("for (int i = 0; i < outputs; ++i) y[i] = (float)y[i];"),
        "results are rounded to single precision",
    ),
    planted(
        "single precision",
        Fortran,
        "translator.contact_force",
        Before("x_all = real(real(x_all), dp)"),
        "inputs are rounded to single precision",
    ),
    planted(
        "single precision",
        Python,
        "slot.contact_force",
        After("outputs[0] *= 1.0000000298023224"),
        "a constant of single precision",
    ),
    planted(
        "stale state",
        C,
        "slot.friction",
        After(
            "static double kept[outputs][inputs]; for (int i = 0; i < outputs; ++i) for (int j = 0; j < inputs; ++j) { double t = kept[i][j]; kept[i][j] = jacobian[i][j]; jacobian[i][j] = t; }",
        ),
        "∂p/∂f1, ∂fn/∂f2, ∂fn/∂f3, ∂fn/∂fc_int, 5 more is that of the point asked before",
    ),
    planted(
        "stick for slip",
        C,
        "coulomb.return_map",
        After("jacobian[0][0] = 1; jacobian[0][1] = 0; jacobian[0][2] = 0;"),
        "stick tangent in slip",
    ),
    planted(
        "stick for slip",
        Fortran,
        "coulomb.return_map",
        After("j_all(1, :) = [1.0_dp, 0.0_dp, 0.0_dp]"),
        "stick tangent in slip",
    ),
    planted(
        "NaN at a kink",
        C,
        "slot.contact_force",
        After("jacobian[0][0] = x[0] / y[0]; jacobian[0][1] = x[1] / y[0];"),
        "NaN on the kink",
    ),
    planted(
        "missing chain rule",
        Python,
        "slot.friction",
        After("rows[2][1] = 0.0; rows[2][2] = 0.0"),
        "left out (always 0): ∂phi/∂f2, ∂phi/∂f3",
    ),
];

#[test]
fn planted_mistakes_are_named() {
    let mut others = Vec::new();
    for Planted { class, lang, id, plant, says } in PLANTED.iter().filter(|planted| planted.lang.is_here()) {
        let bench = Bench::new();
        let program = port(&bench, *lang, id, *plant);
        let said = check(&bench, id, &program, &["--samples", "200"], 1);
        let diagnoses: Vec<_> = said.lines().filter_map(|line| line.trim().strip_prefix("diagnosis: ")).collect();
        if !said.contains(&format!("diagnosis: {says}")) {
            others.push(format!("{class} in {lang:?}, {id}: {diagnoses:?}, expected {says:?}"));
        }
    }
    assert!(others.is_empty(), "{}", others.join("\n"));
}

#[test]
fn two_mistakes_are_named_together() {
    let class = |planted: &&Planted| planted.class == "spin";
    let Planted { lang, id, plant: After(code), says, .. } = PLANTED.iter().find(class).unwrap() else { panic!() };
    if lang.is_here() {
        let more = format!("{code}\n        y_all(1:9) = 2*y_all(1:9)");
        let bench = Bench::new();
        let program = port(&bench, *lang, id, After(more.leak()));
        let said = check(&bench, id, &program, &["--samples", "50"], 1);
        assert!(said.contains(says) && said.contains("a factor of 2 too much in k_ua_ta"), "{said}");
    }
}

#[test]
fn drivers_with_what_is_exported_pass_in_every_language() {
    for lang in Lang::ALL.into_iter().filter(|lang| lang.is_here()) {
        for id in ["slot.friction", "ujoint.friction", "coulomb.return_map"] {
            let bench = Bench::new();
            let program = port(&bench, lang, id, Nothing);
            let said = check(&bench, id, &program, &["--samples", "100"], 0);
            assert!(said.starts_with(&format!("ok  {id}")), "{said}");
        }
    }
}
