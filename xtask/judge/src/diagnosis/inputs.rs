//! Misinterpreted inputs: in degrees, in single precision, exchanged, or with the opposite sign.

use jointproof::formula::Field;
use jointproof::formula::quantity::{Domain, Unit};
use std::f64::consts::PI;

/// All mistakes in the inputs that are searched for.
/// Words, where every component comes from with its factor, and whether it is rounded to single precision.
pub(super) type Other = (String, Vec<(usize, f64)>, bool);

pub(super) fn others(inputs: &[Field]) -> Vec<Other> {
    let count = inputs.iter().map(Field::len).sum();
    let same: Vec<_> = (0..count).map(|k| (k, 1.0)).collect();
    let mut starts = Vec::new();
    let mut start = 0;
    for field in inputs {
        starts.push((field, start));
        start += field.len();
    }
    let mut others = Vec::new();
    let mut add = |what: String, from: Vec<(usize, f64)>| others.push((what, from, false));
    for &(field, start) in &starts {
        let components = start..start + field.len();
        let times = |factor: f64| {
            let scaled = |&(k, one): &(usize, f64)| (k, if components.contains(&k) { factor } else { one });
            same.iter().map(scaled).collect()
        };
        let name = field.name;
        if field.quantity.unit == Unit::ONE && field.len() == 1 && field.quantity.domain != Domain::NonNegative {
            add(format!("{name} is taken for degrees"), times(PI / 180.0));
            add(format!("{name} is converted to degrees"), times(180.0 / PI));
        }
        add(format!("the sign of the input {name} is reversed"), times(-1.0));
        add(format!("the input {name} is taken twice"), times(2.0));
        add(format!("half of the input {name} is taken"), times(0.5));
        for a in components.clone() {
            for b in components.start..a {
                let mut from = same.clone();
                from.swap(a, b);
                add(format!("exchanged: the inputs {name}[{}] and {name}[{}]", b - start, a - start), from);
            }
        }
        for &(before, first) in starts.iter().take_while(|(before, _)| before.name != name) {
            if before.len() == field.len() {
                let mut from = same.clone();
                (0..field.len()).for_each(|k| from.swap(first + k, start + k));
                add(format!("exchanged: the inputs {} and {name}", before.name), from);
            }
        }
    }
    let mut of_nodes = same.clone();
    for &(field, start) in &starts {
        let other = field.name.strip_suffix('a').map(|name| format!("{name}b"));
        if let Some((_, second)) = starts.iter().find(|(field, _)| Some(field.name) == other.as_deref()) {
            (0..field.len()).for_each(|k| of_nodes.swap(start + k, second + k));
        }
    }
    others.push(("exchanged: the nodes a and b".into(), of_nodes, false));
    others.push(("inputs are rounded to single precision".into(), same, true));
    others
}

#[cfg(test)]
mod tests {
    use super::others;
    use jointproof::catalog::find;

    #[test]
    fn single_numbers_without_a_unit_may_be_angles() {
        let degrees = |id| {
            let others = others(find(id).unwrap().inputs()).into_iter().map(|(what, ..)| what);
            others.filter(|what| what.contains("degrees")).collect::<Vec<_>>()
        };
        assert_eq!(degrees("coulomb.yield"), [""; 0]);
        assert_eq!(degrees("slot.constraint"), [""; 0]);
        assert_eq!(degrees("universal.constraint"), ["c0 is taken for degrees", "c0 is converted to degrees"]);
    }
}
