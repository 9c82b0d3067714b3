//! What came of all faults, as a table.

use super::fault::{Judged, Verdict};
use std::collections::BTreeMap;
use std::fmt::Write;

/// The part of the faults of every area that tests must notice, those aside that nothing can.
const WANTED: f64 = 0.95;

/// How many of some faults came to which end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Score {
    pub(super) killed: usize,
    /// Of the killed, those that ran too long, took too much memory or ended without a word.
    pub(super) stopped: usize,
    pub(super) survived: usize,
    pub(super) equivalent: usize,
}

impl Score {
    pub(super) fn of<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> Self {
        let mut score = Self::default();
        for judged in judged {
            match judged.verdict {
                Verdict::Killed(_) => score.killed += 1,
                Verdict::Stopped(_) => (score.killed, score.stopped) = (score.killed + 1, score.stopped + 1),
                Verdict::Survived(_) => score.survived += 1,
                Verdict::Equivalent(_) => score.equivalent += 1,
            }
        }
        score
    }

    /// The part that was killed of what can be; all of nothing.
    pub(super) fn rate(&self) -> f64 {
        let (killed, survived) = (count(self.killed), count(self.survived));
        if killed + survived == 0.0 { 1.0 } else { killed / (killed + survived) }
    }

    pub(super) fn is_enough(&self) -> bool {
        self.rate() >= WANTED
    }
}

fn count(number: usize) -> f64 {
    f64::from(u32::try_from(number).unwrap_or(u32::MAX))
}

/// The score of each group, in the order of the groups' names.
pub(super) fn by<'a>(judged: &'a [Judged], group: impl Fn(&'a Judged) -> Option<&'a str>) -> BTreeMap<&'a str, Score> {
    let mut groups: BTreeMap<&str, Vec<&Judged>> = BTreeMap::new();
    for one in judged {
        if let Some(group) = group(one) {
            groups.entry(group).or_default().push(one);
        }
    }
    groups.into_iter().map(|(name, judged)| (name, Score::of(judged))).collect()
}

/// The program whose test failed.
pub(super) fn checker(judged: &Judged) -> Option<&str> {
    match &judged.verdict {
        Verdict::Killed(test) | Verdict::Stopped(test) => test.split_once(": ").map(|(program, _)| program),
        Verdict::Survived(_) | Verdict::Equivalent(_) => None,
    }
}

/// What is printed at the end: survivors, then a line an area.
pub(super) fn text(judged: &[Judged]) -> String {
    let mut text = String::new();
    for one in judged {
        if let Verdict::Survived(tests) = one.verdict {
            let reach = match tests {
                0 => "no test comes there".into(),
                1 => "1 test comes there".into(),
                tests => format!("{tests} tests come there"),
            };
            let _ = writeln!(text, "survived: {}\n    {}; {reach}", one.id, one.change());
        }
    }
    let _ = writeln!(text, "{:>8} {:>8} {:>8} {:>10} {:>6}", "killed", "stopped", "survived", "equivalent", "rate");
    let areas = by(judged, |one| Some(&one.area));
    let all = ("all", Score::of(judged));
    for (name, score) in areas.into_iter().chain([all]) {
        let Score { killed, stopped, survived, equivalent } = score;
        let rate = 100.0 * score.rate();
        let off = if score.is_enough() { "" } else { "  too few" };
        let _ = writeln!(text, "{killed:>8} {stopped:>8} {survived:>8} {equivalent:>10} {rate:>5.1}% {name}{off}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(area: &str, was: &str, verdict: Verdict) -> Judged {
        let [id, area, was] = [format!("{area}.{was}"), area.to_owned(), was.to_owned()];
        Judged { id, area, file: "src/a.rs".into(), line: 3, was, becomes: String::new(), hash: 1, verdict }
    }

    #[test]
    fn a_rate_is_the_part_that_was_noticed_and_enough_from_95_percent_on() {
        let score = |killed, survived| Score { killed, survived, stopped: 1, equivalent: 9 };
        let rates = [(0, 0), (0, 1), (1, 0), (1, 1), (3, 1), (19, 1), (18, 1)].map(|(k, s)| score(k, s));
        assert_eq!(rates.map(|score| score.rate()), [1.0, 0.0, 1.0, 0.5, 0.75, 0.95, 18.0 / 19.0]);
        assert_eq!(rates.map(|score| score.is_enough()), [true, false, true, false, false, true, false]);
    }

    #[test]
    fn what_is_printed_is_every_survivor_and_a_line_an_area() {
        let killed = || Verdict::Killed("tiny: tests::sum".into());
        let stopped = || Verdict::Stopped("tiny: tests::sum".into());
        let all = [
            judged("sums", "a", killed()),
            judged("sums", "b", killed()),
            judged("sums", "c", stopped()),
            judged("roots", "d", Verdict::Survived(0)),
            judged("roots", "e", Verdict::Survived(1)),
            judged("roots", "f", Verdict::Survived(2)),
            judged("roots", "g", Verdict::Equivalent("nobody asks".into())),
            judged("roots", "h", killed()),
        ];
        let expected = "\
survived: roots.d
    src/a.rs:3: `d` → nothing; no test comes there
survived: roots.e
    src/a.rs:3: `e` → nothing; 1 test comes there
survived: roots.f
    src/a.rs:3: `f` → nothing; 2 tests come there
  killed  stopped survived equivalent   rate
       1        0        3          1  25.0% roots  too few
       3        1        0          0 100.0% sums
       4        1        3          1  57.1% all  too few
";
        assert_eq!(text(&all), expected);
        assert_eq!(all.iter().filter_map(checker).collect::<Vec<_>>(), ["tiny"; 4]);
    }
}
