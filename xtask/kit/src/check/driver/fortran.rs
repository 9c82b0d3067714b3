//! Fortran 2008.

use super::plan::{Driver, name, placed};
use jointproof::formula::Field;
use std::fmt::Write;

pub(super) fn text(driver: &Driver) -> String {
    let [n, m] = driver.sizes();
    let (inputs, outputs) = (driver.formula.inputs(), driver.formula.outputs());
    let head: Vec<_> = driver.head().iter().map(|line| format!("! {line}").trim_end().to_owned()).collect();
    let exported = driver.exported_line(|stem| format!("    use jp_{stem}, only: {}\n", driver.exported()));
    let parts = |fields: &'static [Field], array: &str| -> Vec<String> {
        let part = |(field, start): (&Field, usize)| match field.len() {
            1 => format!("{array}({})", start + 1),
            len => format!("{array}({}:{})", start + 1, start + len),
        };
        placed(fields).map(part).collect()
    };
    let jacobian = |name: &str| driver.with_jacobian.then(|| name.to_owned());
    let called: Vec<_> =
        [parts(inputs, "x_all"), parts(outputs, "y_all"), jacobian("j_all").into_iter().collect()].concat();
    let printed =
        if driver.with_jacobian { ", ((j_all(row, column), column = 1, inputs), row = 1, outputs)" } else { "" };
    let declared = driver.if_jacobian(", j_all(outputs, inputs)");
    let counters = driver.if_jacobian(", row, column");
    let mut text = format!(
        "{}\nprogram answer\n    use, intrinsic :: iso_fortran_env, only: dp => real64\n{exported}    implicit none\n\
         \x20   integer, parameter :: inputs = {n}, outputs = {m}\n    real(dp) :: x_all(inputs), y_all(outputs){declared}\n\
         \x20   integer :: status{counters}\n    logical :: refused\n    do\n        read (*, *, iostat=status) x_all\n\
         \x20       if (status /= 0) exit\n        call yours({}, refused)\n        if (refused) then\n\
         \x20           write (*, '(a)') 'refuse'\n        else\n\
         \x20           write (*, '(*(es25.16e3))') y_all{printed}\n        end if\n        flush (6)\n    end do\ncontains\n",
        head.join("\n"),
        folded(&called),
    );
    let names: Vec<_> = inputs.iter().chain(outputs).map(name).chain(jacobian("jacobian")).collect();
    let _ = writeln!(text, "    subroutine yours({}, refused)", folded(&names));
    for (fields, intent) in [(inputs, "in"), (outputs, "out")] {
        text.extend(fields.iter().map(|field| {
            let shape = if field.len() == 1 { String::new() } else { format!("({})", field.len()) };
            format!("        real(dp), intent({intent}) :: {}{shape}\n", name(field))
        }));
    }
    if driver.with_jacobian {
        text += "        ! jacobian(i, j) is the derivative of output i with respect to input j.\n";
        text += "        real(dp), intent(out) :: jacobian(outputs, inputs)\n";
    }
    text += "        logical, intent(out) :: refused\n";
    text + &body(driver) + "    end subroutine yours\nend program answer\n"
}

fn body(driver: &Driver) -> String {
    let (inputs, outputs) = (driver.formula.inputs(), driver.formula.outputs());
    if driver.is_exported {
        let names = inputs.iter().chain(outputs).map(name);
        let names: Vec<_> = names.chain(driver.with_jacobian.then(|| "jacobian".to_owned())).collect();
        return format!("        refused = {}( &\n            {}) /= 0\n", driver.exported(), folded(&names));
    }
    let zero = |field: &Field| format!("        {} = 0\n", name(field));
    let zeros: String = outputs.iter().map(zero).collect();
    let jacobian = driver.if_jacobian("        jacobian = 0\n");
    format!(
        "        ! Your code; refused is for inputs that are not allowed.\n{zeros}{jacobian}        refused = .true.\n"
    )
}

/// A list, broken into as many lines as necessary.
fn folded(items: &[String]) -> String {
    let mut lines = vec![String::new()];
    for item in items {
        let last = lines.last_mut().expect("there is a first line");
        if last.len() + item.len() > 80 {
            lines.push(item.clone());
        } else {
            if !last.is_empty() {
                last.push_str(", ");
            }
            last.push_str(item);
        }
    }
    lines.join(", &\n            ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use jointproof::catalog::CATALOG;
    use judge::Wanted;

    #[test]
    fn no_line_is_longer_than_fortran_reads() {
        for formula in CATALOG {
            for (wanted, is_exported) in [(Wanted::Jacobian, true), (Wanted::Jacobian, false), (Wanted::Value, true)] {
                let driver = Driver::new(*formula, wanted, is_exported).expect("values and Jacobians have a driver");
                let text = text(&driver);
                let long = text.lines().find(|line| line.chars().count() > 132 && !line.starts_with('!'));
                assert_eq!(long, None, "{}", formula.spec().id);
            }
        }
    }
}
