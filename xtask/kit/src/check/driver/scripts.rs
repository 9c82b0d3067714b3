//! Python and Julia.

use super::plan::{Driver, name, placed};
use jointproof::formula::Field;

pub(super) fn python(driver: &Driver) -> String {
    let names: Vec<_> = driver.formula.inputs().iter().map(name).collect();
    let parts = placed(driver.formula.inputs()).map(|(field, start)| match field.len() {
        1 => format!("x[{start}]"),
        len => format!("x[{start} : {}]", start + len),
    });
    let imported =
        if driver.is_exported { format!("import jp_{} as exported\n\n", driver.stem()) } else { String::new() };
    let body = if driver.is_exported {
        let names = names.join(", ");
        let numbers = if driver.with_jacobian {
            format!("    value, jacobian = exported.jacobian({names})\n    return value.tolist(), jacobian.tolist()\n")
        } else {
            format!("    return exported.value({names}).tolist(), []\n")
        };
        format!("    if exported.refused({names}):\n        raise ValueError(\"refused\")\n{numbers}")
    } else {
        "    raise ValueError(\"your code is still missing\")\n".to_owned()
    };
    let jacobian =
        if driver.with_jacobian { ", and the rows of the Jacobian, one an output" } else { ", and nothing more" };
    format!(
        "\"\"\"{}\"\"\"\n\nimport sys\n\n{imported}\ndef yours({}):\n\
         \x20   \"\"\"A list of the outputs{jacobian}; ValueError where the inputs are refused.\"\"\"\n{body}\n\n\
         for line in sys.stdin:\n    x = [float(number) for number in line.split()]\n    try:\n\
         \x20       outputs, rows = yours({})\n\
         \x20       print(*map(repr, outputs), *(repr(entry) for row in rows for entry in row), flush=True)\n\
         \x20   except ValueError:\n        print(\"refuse\", flush=True)\n",
        driver.head().join("\n").trim_end(),
        names.join(", "),
        parts.collect::<Vec<_>>().join(", "),
    )
}

pub(super) fn julia(driver: &Driver) -> String {
    let names: Vec<_> = driver.formula.inputs().iter().map(name).collect();
    let part = |(field, start): (&Field, usize)| match field.len() {
        1 => format!("x[{}]", start + 1),
        len => format!("x[{}:{}]", start + 1, start + len),
    };
    let parts: Vec<_> = placed(driver.formula.inputs()).map(part).collect();
    let head: Vec<_> = driver.head().iter().map(|line| format!("# {line}").trim_end().to_owned()).collect();
    let jacobian = if driver.with_jacobian {
        ", and the Jacobian, a matrix with a row an output"
    } else {
        ", and an empty matrix"
    };
    format!(
        "{}\n\n# The outputs in a vector{jacobian}; nothing where the inputs are refused.\nfunction yours({})\n\
         \x20   return nothing # your code is still missing\nend\n\n\
         for line in eachline(stdin)\n    x = parse.(Float64, split(line))\n    found = yours({})\n\
         \x20   if found === nothing\n        println(\"refuse\")\n    else\n        outputs, jacobian = found\n\
         \x20       # Julia keeps columns together: the transpose gives row after row.\n\
         \x20       println(join([outputs; vec(permutedims(jacobian))], ' '))\n    end\n    flush(stdout)\nend\n",
        head.join("\n"),
        names.join(", "),
        parts.join(", "),
    )
}
