//! Queries typed by readers, and the page that must come first: `book/queries.txt`.

use std::fmt;
use std::fs;
use std::path::Path;

use anyhow::{Result, bail, ensure};

use crate::book::browser::{Browser, DESK};
use crate::project::Project;

const LIST: &str = "book/queries.txt";

/// The required number of correct answers, out of 50.
const ENOUGH: (usize, usize) = (47, 50);

/// The answers of the search.
#[derive(Default)]
pub(super) struct Answers {
    asked: usize,
    right: usize,
    wrong: Vec<String>,
}

impl Answers {
    pub(super) fn are_enough(&self) -> bool {
        self.asked > 0 && self.right * ENOUGH.1 >= self.asked * ENOUGH.0
    }
}

impl fmt::Display for Answers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "search: {} of {} queries give the right entry first", self.right, self.asked)?;
        self.wrong.iter().try_for_each(|wrong| write!(f, "\n    {wrong}"))
    }
}

/// Types every query into the book's search, using `script`; `None` if the project has no list.
pub(super) fn ask(project: &Project, out: &Path, browser: &mut Browser, script: &str) -> Result<Option<Answers>> {
    let Ok(list) = fs::read_to_string(project.root().join(LIST)) else { return Ok(None) };
    let queries = parsed(&list)?;
    browser.screen(DESK)?;
    browser.open(&out.join("index.html"))?;
    browser.evaluate(script)?;
    let texts: Vec<_> = queries.iter().map(|(query, _)| query).collect();
    let found = browser.evaluate(&format!("found({})", serde_json::to_string(&texts)?))?;
    let found: Vec<Vec<String>> = serde_json::from_value(found)?;
    let mut answers = Answers::default();
    for ((query, wanted), found) in queries.iter().zip(&found) {
        answers.asked += 1;
        let first = found.first().map_or("nothing", String::as_str);
        if wanted.contains(&first) {
            answers.right += 1;
        } else {
            answers.wrong.push(format!(
                "{query}: wanted is {}, found {}",
                wanted.join(" or "),
                if found.is_empty() { first.into() } else { found.join(", ") }
            ));
        }
    }
    Ok(Some(answers))
}

/// Each line is `query => page`, or several pages separated by `or`.
fn parsed(list: &str) -> Result<Vec<(&str, Vec<&str>)>> {
    let mut queries = Vec::new();
    for (at, line) in list.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#')) {
        let Some((query, wanted)) = line.split_once(" => ") else {
            bail!("{LIST}:{}: wanted is `query => page`", at + 1)
        };
        queries.push((query.trim(), wanted.split(" or ").map(str::trim).collect()));
    }
    ensure!(!queries.is_empty(), "no query in the list");
    Ok(queries)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forty_seven_of_fifty_answers_are_enough() {
        let enough = |asked, right| Answers { asked, right, wrong: Vec::new() }.are_enough();
        assert!(enough(50, 47) && enough(1, 1) && enough(20, 20) && enough(20, 19));
        assert!(!enough(50, 46) && !enough(20, 18) && !enough(1, 0) && !enough(0, 0));
    }

    #[test]
    fn queries_stand_a_line_each_beside_remarks() {
        let list = "# What readers type.\n\na b => c.html#d\n μ  => e.html or f.html\n";
        let expected = [("a b", vec!["c.html#d"]), ("μ", vec!["e.html", "f.html"])];
        assert_eq!(parsed(list).unwrap(), expected);
        let error = |list: &str| parsed(list).unwrap_err().to_string();
        assert_eq!(error("# none\n\n"), "no query in the list");
        assert_eq!(error("a => b\n\nc -> d\n"), "book/queries.txt:3: wanted is `query => page`");
    }
}
