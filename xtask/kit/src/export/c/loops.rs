//! The program that times formulas.

use super::driver::{arguments, count};
use crate::export::language::File;
use crate::export::recorded::{Recorded, Text, stem};

/// The number of formulas in one file.
const FORMULAS: usize = 20;

/// Reads points from `<name>.f64`, and prints nanoseconds per evaluation of value and Jacobian.
pub(in crate::export) fn files(recorded: &[&Recorded]) -> Vec<File> {
    let groups = recorded.chunks(FORMULAS).enumerate();
    let mut files: Vec<_> = groups
        .map(|(k, group)| {
            let loops: Vec<_> = group.iter().map(|one| one_loop(one)).collect();
            (
                format!("speed_{}.c", k + 1),
                format!("#include \"jointproof.h\"\n#include <stddef.h>\n{}", loops.concat()),
            )
        })
        .collect();
    files.push(("speed.c".into(), main(recorded)));
    files
}

fn one_loop(one: &Recorded) -> String {
    let (n, name, function) = (one.row(), stem(one), one.largest_function());
    let all = count(&function.outputs);
    format!(
        "\nvoid loop_{name}(const double *x, size_t points);\nvoid loop_{name}(const double *x, size_t points)\n{{\n\
         \x20   double all[{all}];\n    for (size_t k = 0; k < points; ++k, x += {n}) {{\n\
         \x20       jp_{name}_{}(\n{});\n\
         \x20       __asm__ volatile(\"\" : : \"g\"(all) : \"memory\");\n    }}\n}}\n",
        function.name,
        arguments(one, &function.outputs, "all"),
    )
}

fn main(recorded: &[&Recorded]) -> String {
    let mut text = Text::from(HEAD);
    for one in recorded {
        text.push(format!("void loop_{}(const double *x, size_t points);\n", stem(one)));
    }
    text.push("\nint main(void)\n{\n");
    for one in recorded {
        text.push(format!("    take(\"{0}\", {1}, loop_{0});\n", stem(one), one.row()));
    }
    text.push("    return 0;\n}\n");
    text.finished()
}

const HEAD: &str = r#"/* Takes the time of value and Jacobian at the points of <name>.f64; the median of 15 rounds. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define ROUNDS 15

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void take(const char *name, size_t inputs, void (*loop)(const double *, size_t))
{
    static double x[1 << 22];
    char path[128];
    snprintf(path, sizeof path, "%s.f64", name);
    FILE *file = fopen(path, "rb");
    if (!file) exit(2);
    const size_t points = fread(x, sizeof *x * inputs, (1 << 22) / inputs, file);
    double times[ROUNDS];
    fclose(file);
    for (int round = 0; round < ROUNDS; ++round) {
        size_t passes = 0;
        const double start = now();
        double end;
        do {
            loop(x, points);
            ++passes;
            end = now();
        } while (end - start < 2e6);
        times[round] = (end - start) / (double)(passes * points);
    }
    qsort(times, ROUNDS, sizeof *times, by_size);
    printf("%s %.3f\n", name, times[ROUNDS / 2]);
}

"#;

#[cfg(test)]
mod tests {
    use super::files;
    use crate::export::recorded::formulas;

    #[test]
    fn every_formula_has_a_loop_that_is_called() {
        let ids = ["slot.contact_force", "coulomb.yield"];
        let files = files(&formulas(&ids).iter().collect::<Vec<_>>());
        let file = |wanted: &str| files.iter().find(|(name, _)| name == wanted).map_or("", |(_, text)| text);
        for name in ids.map(|id| id.replace('.', "_")) {
            assert!(file("speed_1.c").contains(&format!("        jp_{name}_jacobian(")), "{name}");
        }
        let takes = "    take(\"slot_contact_force\", 2, loop_slot_contact_force);\n    take(\"coulomb_yield\", 3, loop_coulomb_yield);\n";
        assert!(file("speed.c").ends_with(&format!("\nint main(void)\n{{\n{takes}    return 0;\n}}\n")));
    }
}
