//! Fixed form: statements in columns 7 to 72.

/// The columns for the text of a line.
const WIDTH: usize = 66;

/// A program in fixed form, from one in free form without texts in quotes longer than a line.
pub(super) fn form(free: &str) -> String {
    let mut fixed = String::new();
    let mut statement = String::new();
    for line in free.lines() {
        if line.is_empty() || line.trim_start().starts_with('!') {
            fixed += line.trim_start();
            fixed.push('\n');
            continue;
        }
        let (part, goes_on) = match line.strip_suffix('&') {
            Some(part) => (part.trim_end(), true),
            None => (line, false),
        };
        if statement.is_empty() {
            statement.push_str(part);
        } else {
            statement.extend([" ", part.trim_start()]);
        }
        if !goes_on {
            fixed += &lines(&std::mem::take(&mut statement));
        }
    }
    fixed
}

/// A statement, broken after blanks.
fn lines(statement: &str) -> String {
    let text = statement.trim_start();
    let indent = " ".repeat(((statement.len() - text.len()) / 2).min(16));
    let mut lines = String::new();
    let (mut start, mut rest) = (format!("      {indent}"), text);
    loop {
        let room = WIDTH - indent.len();
        if rest.len() <= room {
            return lines + &start + rest + "\n";
        }
        // Blanks have no meaning in fixed form: a word is broken only where it is longer than a line.
        let at = rest[..=room].rfind(' ').filter(|&at| at > 0).unwrap_or(room);
        lines.extend([&start, rest[..at].trim_end(), "\n"]);
        (start, rest) = (format!("     &{indent}"), rest[at..].trim_start());
    }
}

#[cfg(test)]
mod tests {
    use super::form;

    #[test]
    fn statements_are_in_columns_7_to_72() {
        let free = "! head\nsubroutine a(x, &\n        y)\n    x = y\n\nend subroutine a\n";
        let fixed = "! head\n      subroutine a(x, y)\n        x = y\n\n      end subroutine a\n";
        assert_eq!(form(free), fixed);
        let long = format!("    call f({})", vec!["argument"; 40].join(", "));
        let lines = form(&long);
        assert!(lines.lines().count() > 5 && lines.lines().all(|line| line.len() <= 72), "{lines}");
        assert!(lines.lines().skip(1).all(|line| line.starts_with("     &  ")), "{lines}");
        let statement: String = lines.lines().map(|line| line[6..].trim()).collect::<Vec<_>>().join(" ");
        assert_eq!(statement, long.trim());
        let uninterrupted = "x".repeat(100);
        let lines = form(&uninterrupted);
        assert_eq!(lines, format!("      {}\n     &{}\n", "x".repeat(66), "x".repeat(34)));
    }
}
