//! C, and C++ where C compilers need not understand it.

use super::plan::{Driver, name, placed};
use jointproof::formula::Field;
use std::fmt::Write;

pub(super) fn text(driver: &Driver, is_cpp: bool) -> String {
    let [n, m] = driver.sizes();
    let head: Vec<_> = driver.head().iter().map(|line| format!(" * {line}").trim_end().to_owned()).collect();
    let headers = if is_cpp { ["<cmath>", "<cstdio>"] } else { ["<math.h>", "<stdio.h>"] };
    let exported = driver.exported_line(|stem| format!("#include \"jp_{stem}.h\"\n"));
    let mut text = format!(
        "/*\n{}\n */\n#include {}\n#include {}\n{exported}\nenum {{ inputs = {n}, outputs = {m} }};\n\n",
        head.join("\n"),
        headers[0],
        headers[1]
    );
    let _ = write!(text, "{}\n{{\n{}}}\n\n", prototype(driver), body(driver));
    text + &main(driver)
}

fn prototype(driver: &Driver) -> String {
    let taken = |field: &Field| argument(field, ["double ", "const double "]);
    let given = |field: &Field| argument(field, ["double *", "double "]);
    let (inputs, outputs) = (driver.formula.inputs(), driver.formula.outputs());
    let jacobian = driver.with_jacobian.then(|| "double jacobian[outputs][inputs]".to_owned());
    let arguments: Vec<_> = inputs.iter().map(taken).chain(outputs.iter().map(given)).chain(jacobian).collect();
    format!("/* 0, or anything else where the inputs are refused. */\nstatic int yours({})", arguments.join(", "))
}

fn argument(field: &Field, kind: [&str; 2]) -> String {
    match field.len() {
        1 => format!("{}{}", kind[0], name(field)),
        len => format!("{}{}[{len}]", kind[1], name(field)),
    }
}

fn body(driver: &Driver) -> String {
    let (inputs, outputs) = (driver.formula.inputs(), driver.formula.outputs());
    let mut names: Vec<_> = inputs.iter().chain(outputs).map(name).collect();
    if driver.is_exported {
        names.extend(driver.with_jacobian.then(|| "&jacobian[0][0]".to_owned()));
        return format!("    return {}({});\n", driver.exported(), names.join(", "));
    }
    names.extend(driver.with_jacobian.then(|| "jacobian".to_owned()));
    let unused: Vec<_> = names.iter().map(|name| format!("    (void){name};\n")).collect();
    let unused = unused.concat();
    let derivative = driver.if_jacobian(", and jacobian[i][j] to the derivative of output i with respect to input j");
    let set: Vec<_> = outputs.iter().map(name).collect();
    format!("    /* Set {}{derivative}. */\n{unused}    return 1;\n", set.join(", "))
}

fn main(driver: &Driver) -> String {
    let place = |(field, start): (&Field, usize), of: &str, one: &str| match field.len() {
        1 => format!("{one}{of}[{start}]"),
        _ => format!("{of} + {start}"),
    };
    let inputs = placed(driver.formula.inputs()).map(|field| place(field, "x", ""));
    let outputs = placed(driver.formula.outputs()).map(|field| place(field, "y", "&"));
    let jacobian = driver.with_jacobian.then(|| "jacobian".to_owned());
    let arguments: Vec<_> = inputs.chain(outputs).chain(jacobian).collect();
    let declared = driver.if_jacobian(", jacobian[outputs][inputs]");
    let printed = driver.if_jacobian(
        "        for (int i = 0; i < outputs; ++i)\n            for (int j = 0; j < inputs; ++j) printf(\" %.17g\", jacobian[i][j]);\n",
    );
    format!(
        "int main(void)\n{{\n    double x[inputs], y[outputs]{declared};\n    for (;;) {{\n\
         \x20       for (int j = 0; j < inputs; ++j)\n            if (scanf(\"%lf\", &x[j]) != 1) return 0;\n\
         \x20       if (yours({})) {{\n            puts(\"refuse\");\n            fflush(stdout);\n            continue;\n        }}\n\
         \x20       for (int i = 0; i < outputs; ++i) printf(\" %.17g\", y[i]);\n{printed}        putchar('\\n');\n\
         \x20       fflush(stdout);\n    }}\n}}\n",
        arguments.join(", ")
    )
}
