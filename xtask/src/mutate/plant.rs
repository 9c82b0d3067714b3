//! Faults written into a source, each behind its switch.

use super::fault::{Fault, Place};
use std::ops::Range;

/// A source with faults.
pub(super) struct Planted {
    pub(super) text: String,
    /// Of each fault its number, and the bytes of its switch and of the text with the fault.
    pub(super) switches: Vec<(usize, Range<usize>, Range<usize>)>,
}

/// Writes faults into a source: each by its number, and at which of its places.
///
/// Where one stands within another it is only in what was there before: no two faults are ever on.
pub(super) fn plant(text: &str, faults: &[(usize, &Fault, usize)]) -> Planted {
    let mut places: Vec<(usize, &Place)> =
        faults.iter().filter_map(|&(number, fault, place)| Some((number, fault.places.get(place)?))).collect();
    // What encloses comes first.
    places.sort_by_key(|(number, place)| (place.range.start, std::cmp::Reverse(place.range.end), *number));
    let mut planted = Planted { text: String::new(), switches: Vec::new() };
    write(&mut planted, text, 0..text.len(), &places);
    planted
}

/// Writes a part of a source with the faults that begin in it.
fn write(planted: &mut Planted, text: &str, part: Range<usize>, mut places: &[(usize, &Place)]) {
    let mut from = part.start;
    while let Some(((number, place), rest)) = places.split_first() {
        let inside = rest.iter().take_while(|(_, inner)| inner.range.start < place.range.end).count();
        planted.text += &text[from..place.range.start];
        let start = planted.text.len();
        let [before, between, after] = place.shape.switch(*number);
        planted.text += &before;
        let fault = planted.text.len();
        planted.text += &place.text;
        let faults_end = planted.text.len();
        planted.text += &between;
        write(planted, text, place.range.clone(), &rest[..inside]);
        planted.text += &after;
        planted.switches.push((*number, start..planted.text.len(), fault..faults_end));
        from = place.range.end;
        places = &rest[inside..];
    }
    planted.text += &text[from..part.end];
}

impl Planted {
    /// The faults that an error at these bytes is due to: the innermost whose text it is in, else the innermost whose switch
    /// it is in, else all that it encloses.
    pub(super) fn blamed(&self, at: &Range<usize>) -> Vec<usize> {
        let encloses =
            |outer: &Range<usize>, inner: &Range<usize>| outer.start <= inner.start && inner.end <= outer.end;
        let of_text = self.switches.iter().filter(|(_, _, text)| encloses(text, at));
        let of_switch = self.switches.iter().filter(|(_, switch, _)| encloses(switch, at));
        let innermost =
            of_text.min_by_key(|(_, _, text)| text.len()).or_else(|| of_switch.min_by_key(|(_, s, _)| s.len()));
        match innermost {
            Some((number, ..)) => vec![*number],
            None => self.switches.iter().filter(|(_, s, _)| encloses(at, s)).map(|(number, ..)| *number).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mutate::fault::Shape;

    #[test]
    fn faults_stand_side_by_side_in_whatever_order_they_come() {
        let fault = |range: Range<usize>, text: &str, shape| Fault {
            id: "a.b".into(),
            area: "a".into(),
            file: "src/a.rs".into(),
            line: 1,
            was: String::new(),
            becomes: text.into(),
            equivalent: None,
            places: vec![Place { range, text: text.into(), shape }],
        };
        let [first, second] = [fault(0..2, "a", Shape::Bare), fault(2..4, "b", Shape::Bare)];
        let third = fault(5..6, "", Shape::Statement);
        let planted = plant("x;y;=z;", &[(6, &third, 0), (5, &second, 0), (4, &first, 0), (9, &first, 1)]);
        let expected = "if ::planted::at(4) { a } else { x; }if ::planted::at(5) { b } else { y; }=\
                        if ::planted::at(6) {  } else { z; };";
        assert_eq!(planted.text, expected);
        let numbers: Vec<_> = planted.switches.iter().map(|(number, ..)| *number).collect();
        assert_eq!(numbers, [4, 5, 6]);
        for (number, switch, text) in &planted.switches {
            assert!(planted.text[switch.clone()].starts_with(&format!("if ::planted::at({number})")));
            assert_eq!(planted.text[text.clone()], *["a", "b", ""][number - 4]);
        }
    }
}
