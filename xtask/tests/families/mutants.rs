//! Wrong routines, made by rule: each statement is left out, given the other sign, doubled, or answered from the last call;
//! each variable in it is ignored; each condition always holds, or never.

use super::{Family, Member};

pub(super) fn mutants(family: &Family) -> Vec<Member> {
    let lines: Vec<_> = family.body().lines().collect();
    let mut members = Vec::new();
    for (k, line) in lines.iter().enumerate() {
        for (rule, changed) in changes(family, line) {
            let place = format!("{}: {}", k + 1, line.trim());
            if family.same.iter().any(|(same, text)| *same == rule && line.trim() == *text) {
                continue;
            }
            let changed: Vec<_> =
                lines.iter().enumerate().map(|(at, line)| if at == k { changed.as_str() } else { *line }).collect();
            let body = changed.join("\n") + "\n";
            let declared = if rule == LAST { "    real(dp), save :: last = 1\n    real(dp) :: now\n" } else { "" };
            members.push(Member::new(format!("{rule}, line {place}"), declared, &body));
        }
    }
    members
}

const LAST: &str = "of the last call";

/// Every change of a line, with its rule.
fn changes(family: &Family, line: &str) -> Vec<(String, String)> {
    let indent = &line[..line.len() - line.trim_start().len()];
    let mut changes = Vec::new();
    let mut add = |rule: &str, text: String| changes.push((rule.to_owned(), format!("{indent}{text}")));
    if let Some(condition) = line.trim().strip_prefix("if (").and_then(|rest| rest.strip_suffix(") then")) {
        add("always", "if (.true.) then".into());
        add("never", "if (.false.) then".into());
        for (name, text) in without(family, condition) {
            add(&format!("{name} ignored"), format!("if ({text}) then"));
        }
        return changes;
    }
    let Some((left, right)) = line.trim().split_once(" = ") else { return changes };
    add("left out", "continue".into());
    let is_number = !right.starts_with(['[', 'j', 'm']) && !left.starts_with("jdof") && left != "k" && left != "lm";
    if is_number && right != "0" {
        add("the other sign", format!("{left} = -({right})"));
        add("doubled", format!("{left} = 2 * ({right})"));
    }
    let is_constant = right.parse::<f64>().is_ok();
    if !is_constant
        && !left.contains(':')
        && !right.contains([':', '['])
        && !ARRAYS.contains(&left)
        && !left.starts_with("code")
    {
        add(LAST, format!("now = {right}; {left} = {}; last = now", if left == "k" { "nint(last)" } else { "last" }));
    }
    for (name, text) in without(family, right) {
        add(&format!("{name} ignored"), format!("{left} = {text}"));
    }
    changes
}

/// Local variables that are arrays.
const ARRAYS: &[&str] = &["axes", "x1", "xn", "xm", "d", "row", "f", "g"];

/// An expression without one of its variables, for each occurrence.
fn without(family: &Family, expression: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    if ["jp_slider", "[", "maxloc", "transpose"].iter().any(|whole| expression.contains(whole)) {
        return found;
    }
    for (name, instead) in family.ignored {
        for (at, _) in expression.match_indices(name) {
            let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
            let after = &expression[at + name.len()..];
            if expression[..at].ends_with(is_name) || after.starts_with(is_name) {
                continue;
            }
            let index = if after.starts_with('(') { after.find(')').map_or(0, |end| end + 1) } else { 0 };
            let text = format!("{}{instead}{}", &expression[..at], &after[index..]);
            found.push((format!("{name}{}", &after[..index]), text));
        }
    }
    found
}
