//! The program that evaluates formulas at given points, for the comparison with Rust.

use super::super::language::File;
use super::super::program::folded;
use super::super::recorded::{Recorded, Text, stem};
use jointproof::formula::Field;

/// The number of formulas in one file.
const FORMULAS: usize = 12;

/// Reads points.bin, writes found.bin.
pub(super) fn files(recorded: &[Recorded]) -> Vec<File> {
    let mut files = vec![("driver.h".to_owned(), HEADER.to_owned()), ("driver.c".to_owned(), main(recorded))];
    let groups = recorded.chunks(FORMULAS).enumerate();
    files.extend(groups.map(|(k, group)| {
        let functions: Vec<_> = group.iter().map(function).collect();
        (format!("driver_{}.c", k + 1), format!("#include \"driver.h\"\n{}", functions.concat()))
    }));
    files
}

const HEADER: &str = "/* What evaluates formulas at the points of points.bin, and writes found.bin. */
#ifndef DRIVER_H
#define DRIVER_H

#include \"jointproof.h\"
#include <stddef.h>
#include <stdint.h>

void take(double *x, size_t n);
void give(const double *x, size_t n);
uint64_t number_of_points(void);

#endif
";

fn main(recorded: &[Recorded]) -> String {
    let mut text = Text::from(
        "/* Evaluates every formula at the points of points.bin, and writes found.bin. */\n\
         #include \"driver.h\"\n#include <stdio.h>\n#include <stdlib.h>\n\n\
         static FILE *points, *found;\n\n\
         void take(double *x, size_t n)\n{\n    if (fread(x, sizeof *x, n, points) != n) exit(2);\n}\n\n\
         void give(const double *x, size_t n)\n{\n    if (fwrite(x, sizeof *x, n, found) != n) exit(2);\n}\n\n\
         uint64_t number_of_points(void)\n{\n    uint64_t n;\n    if (fread(&n, sizeof n, 1, points) != 1) exit(2);\n    return n;\n}\n\n",
    );
    for one in recorded {
        text.push(format!("void run_{}(void);\n", stem(one)));
    }
    text.push(
        "\nint main(void)\n{\n    points = fopen(\"points.bin\", \"rb\");\n    found = fopen(\"found.bin\", \"wb\");\n    if (!points || !found) return 2;\n",
    );
    for one in recorded {
        text.push(format!("    run_{}();\n", stem(one)));
    }
    text.push("    return fclose(found) != 0;\n}\n");
    text.finished()
}

/// The arguments of a formula's functions: inputs from one array, outputs into another.
pub(super) fn arguments(one: &Recorded, outputs: &str) -> String {
    let passed = |fields: &[Field], array: &str, by_address: &str| {
        let mut from = 0;
        let arguments = fields.iter().map(|field| {
            let start = from;
            from += field.len();
            if field.len() == 1 { format!("{by_address}{array}[{start}]") } else { format!("{array} + {start}") }
        });
        arguments.collect::<Vec<_>>()
    };
    let all = [passed(one.formula.inputs(), "x", ""), passed(one.formula.outputs(), outputs, "&")].concat();
    folded(&format!("            {}", all.join(", ")), "").join("\n")
}

/// The counts of inputs, outputs and Jacobian entries.
pub(super) fn counts(one: &Recorded) -> [usize; 3] {
    let count = |fields: &[Field]| fields.iter().map(Field::len).sum::<usize>();
    [count(one.formula.inputs()), count(one.formula.outputs()), one.graph.jacobian.len()]
}

fn function(one: &Recorded) -> String {
    let ([n, m, entries], name) = (counts(one), stem(one));
    if entries == 0 {
        return format!(
            "\nvoid run_{name}(void);\nvoid run_{name}(void)\n{{\n    double x[{n}], y[{m}];\n\
             \x20   for (uint64_t left = number_of_points(); left > 0; --left) {{\n        take(x, {n});\n\
             \x20       for (int k = 0; k < {m}; ++k) y[k] = 0;\n\
             \x20       const double code = jp_{name}_value(\n{});\n\
             \x20       give(&code, 1);\n        give(y, {m});\n    }}\n}}\n",
            arguments(one, "y"),
        );
    }
    format!(
        "\nvoid run_{name}(void);\nvoid run_{name}(void)\n{{\n    double x[{n}], y[{m}], both[{m} + {entries}];\n\
         \x20   for (uint64_t left = number_of_points(); left > 0; --left) {{\n        take(x, {n});\n\
         \x20       for (int k = 0; k < {m} + {entries}; ++k) both[k] = 0;\n\
         \x20       double code = jp_{name}_jacobian(\n{},\n            both + {m});\n\
         \x20       const int alone = jp_{name}_value(\n{});\n\
         \x20       if (alone != (int)code) code = -1;\n\
         \x20       for (int k = 0; k < {m} && alone == 0; ++k)\n            if (y[k] != both[k] && y[k] == y[k]) code = -1;\n\
         \x20       give(&code, 1);\n        give(both, {m} + {entries});\n    }}\n}}\n",
        arguments(one, "both"),
        arguments(one, "y"),
    )
}
