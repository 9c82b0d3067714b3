//! The program that evaluates formulas at given points, for the comparison with Rust.

use super::super::language::File;
use super::super::program::folded;
use super::super::recorded::{Output, Recorded, Shape, Text, stem};
use jointproof::formula::Field;

/// The number of formulas and elements in one file.
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

/// The arguments of a function: inputs from one array, outputs into another.
pub(super) fn arguments(one: &Recorded, outputs: &[Output], array: &str) -> String {
    let mut from = 0;
    let mut input = |field: &Field| {
        let start = from;
        from += field.len();
        if field.len() == 1 { format!("x[{start}]") } else { format!("x + {start}") }
    };
    let mut all: Vec<_> = one.inputs().iter().map(&mut input).collect();
    let mut from = 0;
    for output in outputs {
        let by_address =
            if output.shape == Shape::Number { format!("&{array}[{from}]") } else { format!("{array} + {from}") };
        all.push(by_address);
        from += output.len();
    }
    folded(&format!("            {}", all.join(", ")), "").join("\n")
}

/// The number of all numbers.
pub(super) fn count(outputs: &[Output]) -> usize {
    outputs.iter().map(Output::len).sum()
}

fn function(one: &Recorded) -> String {
    let (n, name, functions) = (one.row(), stem(one), one.functions());
    let [value, largest] = [functions.first(), functions.last()].map(|one| one.expect("one gives the value"));
    let (m, all) = (count(&value.outputs), count(&largest.outputs));
    let head = format!("\nvoid run_{name}(void);\nvoid run_{name}(void)\n{{\n    double x[{n}]");
    let code = format!("jp_{name}_{}(\n{})", largest.name, arguments(one, &largest.outputs, "all"));
    let rest = format!(
        "    for (uint64_t left = number_of_points(); left > 0; --left) {{\n        take(x, {n});\n\
         \x20       for (int k = 0; k < {all}; ++k) all[k] = 0;\n"
    );
    let given = format!("        give(&code, 1);\n        give(all, {all});\n    }}\n}}\n");
    if functions.len() == 1 {
        return format!("{head}, all[{all}];\n{rest}        const double code = {code};\n{given}");
    }
    format!(
        "{head}, y[{m}], all[{all}];\n{rest}        double code = {code};\n\
         \x20       const int alone = jp_{name}_{}(\n{});\n\
         \x20       if (alone != (int)code) code = -1;\n\
         \x20       for (int k = 0; k < {m} && alone == 0; ++k)\n            if (y[k] != all[k] && y[k] == y[k]) code = -1;\n\
         {given}",
        value.name,
        arguments(one, &value.outputs, "y"),
    )
}
