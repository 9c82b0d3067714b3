//! Mistakes in decks: each is named by its line, and none causes a panic.

use crate::draw::Draw;
use jointproof::scene::{Deck, Faults, Results, Table, Tables};
use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The faults of a deck, or of its scene.
fn read(text: &str) -> Result<Deck, Faults> {
    let deck = Deck::parse(text)?;
    deck.scene()?;
    Ok(deck)
}

pub(crate) fn faults(text: &str) -> Vec<String> {
    let faults = read(text).err().unwrap_or_else(|| panic!("a wrong deck is read:\n{text}"));
    faults.list().iter().map(ToString::to_string).collect()
}

pub(crate) fn left_out(text: &str) -> Vec<String> {
    let deck = read(text).unwrap_or_else(|faults| panic!("{faults}"));
    deck.left_out().iter().map(|left_out| format!("{}{left_out}", if left_out.matters { "! " } else { "" })).collect()
}

const GUIDE: &str = "\
*NODE
1, 0., 0., 0.
2, 1., 2., 3.
*ELEMENT, TYPE=CONN3D2, ELSET=E
1, 1, 2
*ORIENTATION, NAME=O
1., 0., 0., 0., 1., 0.
*CONNECTOR SECTION, ELSET=E, BEHAVIOR=B
HINGE
O
*CONNECTOR BEHAVIOR, NAME=B
*CONNECTOR FRICTION, PREDEFINED, STICK STIFFNESS=10
0.01
*FRICTION
0.2
*CONNECTOR STOP, COMPONENT=4
-20., 20.
";

#[test]
fn a_mistake_is_named_by_its_keyword_line_and_column() {
    for (wrong, right, expected) in [
        ("2, 1., 2., 3.", "2, 1., x, 3.", "*NODE (line 3, column 8): \"x\"; allowed is a number"),
        (
            "2, 1., 2., 3.",
            "2, 1., 2d999",
            "*NODE (line 3, column 8): 2d999, which no double can hold; allowed is a finite number",
        ),
        ("2, 1., 2., 3.", "2., 1., 2.", "*NODE (line 3, column 1): \"2.\"; allowed is a whole number, at least 1"),
        (
            "2, 1., 2., 3.",
            "1, 1., 2., 3.",
            "*NODE (line 3, column 1): node 1 for the second time, elsewhere; allowed is each node once",
        ),
        ("\n1, 1, 2", "\n1, 1, 3", "*ELEMENT (line 5, column 7): no node 3; allowed is the number of a node"),
        (
            "\n1, 1, 2",
            "\n1, 1, 1",
            "*ELEMENT (line 5, column 1): node \"1\" for the second time; allowed is different nodes",
        ),
        ("\n1, 1, 2", "\n1", "*ELEMENT (line 5, column 1): 0 nodes; allowed is 2 nodes, or 1 and ground, for CONN3D2"),
        ("TYPE=CONN3D2", "ELSET=F", "*ELEMENT (line 4, column 1): no TYPE; allowed is TYPE=, followed by a name"),
        ("NAME=O", "NAME=P", "*CONNECTOR SECTION (line 10, column 1): no orientation \"O\"; allowed is one of \"P\""),
        (
            "\nO\n",
            "\n",
            "*CONNECTOR SECTION (line 8, column 1): no orientation at a, in whose axes HINGE measures; allowed is a second data line with the name of an orientation",
        ),
        (
            "0., 1., 0.\n",
            "2., 0., 0.\n",
            "*ORIENTATION (line 7, column 1): two vectors that are parallel, or zero; allowed is two vectors that span a plane",
        ),
        (
            ", ELSET=E, ",
            ", ELSET=G, ",
            "*CONNECTOR SECTION (line 8, column 21): no element set \"G\"; allowed is one of \"E\"",
        ),
        (
            "NAME=B",
            "NAME=C",
            "*CONNECTOR SECTION (line 8, column 30): no connector behavior \"B\"; allowed is one of \"C\"",
        ),
        (
            "\n0.01",
            "\n",
            "*CONNECTOR FRICTION (line 12, column 1): no \"rp\", needed for the friction of HINGE; allowed is a number in field 1, the ",
        ),
        ("\n0.01", "\n-1", "*CONNECTOR FRICTION (line 13, column 1): -1.0; allowed is a finite number > 0"),
        ("\n0.2", "\n-0.2", "*FRICTION (line 15, column 1): -0.2; allowed is a finite number ≥ 0"),
        (
            "*FRICTION\n0.2\n",
            "",
            "*CONNECTOR FRICTION (line 12, column 1): friction without a coefficient; allowed is *FRICTION below it",
        ),
        ("-20., 20.", "40., 20.", "*CONNECTOR SECTION (line 8, column 1): theta1_min = "),
        (
            "COMPONENT=4",
            "COMPONENT=7",
            "*CONNECTOR STOP (line 16, column 18): \"7\"; allowed is COMPONENT=, followed by a number from 1 to 6",
        ),
        (
            "STICK STIFFNESS=10",
            "STICK STIFFNESS=",
            "*CONNECTOR FRICTION (line 12, column 34): STICKSTIFFNESS without a value; allowed is ",
        ),
        ("*ELEMENT,", "*ELEM,", "*ELEM (line 4, column 1): an unknown keyword; allowed is *ELEMENT, spelled out"),
        ("BEHAVIOR=B", "BEHAV=B", "(line 8, column 30): the parameter BEHAV; allowed is BEHAVIOR, spelled out"),
        (
            "*FRICTION\n",
            "*FRICTOIN\n",
            "*FRICTOIN (line 14, column 1): an unknown keyword; allowed is *FRICTION, spelled out",
        ),
        (
            "*NODE\n",
            "*PARAMETER\nx = 1\n*NODE\n",
            "*PARAMETER (line 1, column 1): parameters, which are computed; allowed is their values where they are used",
        ),
        (
            "NAME=O\n",
            "NAME=O, SYSTEM=USER\n",
            "*ORIENTATION (line 6, column 15): orientation \"O\", by nodes of each element, a distribution, a program or several angles; allowed is points a and b, the origin, and one angle, for connectors",
        ),
        (
            "NAME=O\n",
            "NAME=O, SYSTEM=RADIAL\n",
            "SYSTEM=RECTANGULAR or Z RECTANGULAR or CYLINDRICAL or SPHERICAL or USER",
        ),
        (
            "*NODE\n",
            "",
            "(line 1, column 1): data before the first keyword; allowed is a line that begins with * or **",
        ),
    ] {
        assert!(GUIDE.contains(wrong), "{wrong}");
        let found = faults(&GUIDE.replacen(wrong, right, 1));
        assert!(found.iter().any(|fault| fault.contains(expected)), "{right}: {found:#?}\n{expected}");
    }
    assert!(read(GUIDE).is_ok());
}

#[test]
fn what_contradicts_on_slide_lines_is_a_fault() {
    let seal = "\
*NODE
1, 0., 0.
2, 0., 1.
3, 0., 2.
11, 1., .5
12, 1., 1.5
*ELEMENT, TYPE=ISL21A, ELSET=SEAL
1, 11, 12
*SLIDE LINE, ELSET=SEAL, TYPE=PARABOLIC
1, 2, 3
*INTERFACE, ELSET=SEAL
";
    for (right, wrong, expected) in [
        ("\n1, 2, 3", "\n1, 2", "*SLIDE LINE (line 9, column 1): 2 nodes"),
        ("\n1, 2, 3", "\n1, 2, 4", "*SLIDE LINE (line 10, column 7): no node 4"),
        (
            "TYPE=PARABOLIC",
            "TYPE=CUBIC",
            "*SLIDE LINE (line 9, column 26): TYPE=CUBIC; allowed is TYPE=LINEAR or PARABOLIC",
        ),
        ("*INTERFACE, ELSET=SEAL\n", "", "*ELEMENT (line 8, column 1): an element of no *INTERFACE"),
        (
            "TYPE=PARABOLIC\n1, 2, 3",
            "TYPE=LINEAR, GENERATE\n1, 4, 2",
            "*SLIDE LINE (line 10, column 4): \"4\"; allowed is 1 and a multiple of 2 more",
        ),
    ] {
        assert!(seal.contains(right), "{right}");
        let found = faults(&seal.replacen(right, wrong, 1));
        assert!(found[0].starts_with(expected), "{wrong}: {found:#?}");
    }
}

#[test]
fn what_is_left_out_is_listed_with_its_line() {
    let more = "\
*CONNECTOR ELASTICITY, COMPONENT=4
100.
*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*ELEMENT, TYPE=C3D8R
7, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=CONN3D2, ELSET=F
8, 1, 2
*CONNECTOR SECTION, ELSET=F
BUSHING
O
*STEP
*CONNECTOR MOTION
1, 4, 1.
*END STEP
";
    assert_eq!(
        left_out(&format!("{GUIDE}{more}")),
        [
            "! *CONNECTOR ELASTICITY (line 18): connectors depend on it",
            "*MATERIAL (line 20): not read",
            "*ELASTIC (line 21): not read",
            "*ELEMENT (line 23): elements of type C3D8R",
            "! *CONNECTOR SECTION (line 28): connectors of type BUSHING",
            "*STEP (line 30): a step: its motions and loads are those of a history",
            "*CONNECTOR MOTION (line 31): in a step",
        ]
    );
    let radians = GUIDE.replace("-20., 20.", "-20., 0.5");
    let found = left_out(&radians);
    assert!(found[0].starts_with("! *CONNECTOR STOP (line 17): 0.5, read in degrees"), "{found:?}");
}

/// A deck of 2000 lines: slots and hinges, each section with a behavior of its own.
fn long() -> Vec<String> {
    let mut text = String::from("*HEADING\nlong\n");
    for k in 0..100 {
        let (a, b) = (2 * k + 1, 2 * k + 2);
        let kind = ["SLOT", "HINGE"][k % 2];
        let (component, field) = [("1", "12.5"), ("4", "0.05")][k % 2];
        write!(
            text,
            "** connector {k}\n*NODE\n{a}, {k}., 0.5, 0.\n{b}, {k}., 0.5, 2.\n*ELEMENT, TYPE=CONN3D2, ELSET=E{k}\n{k}1, {a}, {b}\n\
             *ORIENTATION, NAME=O{k}\n1., 0., 0., 0., 1., 0.\n*CONNECTOR SECTION, ELSET=E{k}, BEHAVIOR=B{k}\n{kind}\nO{k}\n\
             *CONNECTOR BEHAVIOR, NAME=B{k}\n*CONNECTOR FRICTION, PREDEFINED, STICK STIFFNESS=1000.\n{field}\n*FRICTION\n0.15\n\
             *CONNECTOR STOP, COMPONENT={component}\n-30., 40.\n*MATERIAL, NAME=M{k}\n*DENSITY\n"
        )
        .unwrap();
    }
    text.lines().map(String::from).collect()
}

/// The ways to make a line wrong.
const WAYS: usize = 22;

/// A line made wrong, where it can be.
fn spoil(line: &str, how: usize) -> Option<String> {
    let data = !line.starts_with('*') && line.contains(|c: char| c.is_ascii_digit());
    match how {
        0 if data && line.contains('.') => Some(line.replacen('.', "..", 1)),
        1 if data && line.contains(", ") => Some(line.replacen(", ", " ", 1)),
        2 if line.contains("ELSET=E") && line.contains("SECTION") => Some(line.replace("ELSET=E", "ELSET=F")),
        3 if line.contains("BEHAVIOR=") => Some(line.replace("BEHAVIOR=B", "BEHAVIOR=X")),
        4 if line.starts_with('O') => Some(line.replace('O', "P")),
        5 if line == "0.15" => Some("-0.15".into()),
        6 if line.contains("COMPONENT=") => Some(line.replace("COMPONENT=", "COMPONENT=9")),
        7 if line.contains("ELSET=") && line.contains("TYPE=") => Some(line.replace("TYPE=CONN3D2", "TYPE=")),
        8 if line == "0.05" => Some("-0.05".into()),
        9 if line.contains("1, ") && line.matches(", ").count() == 2 && !line.contains('.') => {
            Some(line.replace("1, ", "1, 9"))
        }
        10 if line.contains("STIFFNESS=") => Some(line.replace("1000.", "1000..")),
        11 if data && line.contains(", ") => Some(line.replacen(", ", ", \"", 1)),
        12 if line.starts_with("*CONNECTOR") => Some(line.replacen("CONNECTOR", "CONNECTER", 1)),
        13 if line.starts_with("*ELEMENT") => Some(line.replacen("*ELEMENT", "*ELEM", 1)),
        14 if line.contains("BEHAVIOR=") => Some(line.replacen("BEHAVIOR=", "BEHAV=", 1)),
        15 if line.contains("PREDEFINED") => Some(line.replacen("PREDEFINED", "PREDEFINED, PREDEFINED", 1)),
        16 if line.ends_with("0.5, 0.") => Some(line.replacen("0.5, 0.", "0,5, 0., 0., 0., 1., 2.", 1)),
        17 if line.starts_with("*NODE") => Some("*PARAMETER".into()),
        18 if line == "HINGE" => Some("HINGE, SLOT, SLOT".into()),
        19 if line == "1., 0., 0., 0., 1., 0." => Some("1., 0., 0., 2., 0., 0.".into()),
        20 if line == "-30., 40." => Some("-30., 40., 50.".into()),
        21 if line.starts_with("*NODE") => Some("*INCLUDE, INPUT=none.inc".into()),
        _ => None,
    }
}

#[test]
fn a_fault_at_a_random_line_of_a_long_deck_is_named_by_that_line() {
    let lines = long();
    assert!(lines.len() >= 2000 && read(&lines.join("\n")).is_ok());
    let mut draw = Draw(23);
    for fault in 0..6 * WAYS {
        let (line, spoilt) = loop {
            let line = draw.below(lines.len());
            if let Some(spoilt) = spoil(&lines[line], fault % WAYS) {
                break (line, spoilt);
            }
        };
        let mut wrong = lines.clone();
        wrong[line].clone_from(&spoilt);
        let Err(faults) = read(&wrong.join("\n")) else { panic!("line {}, {spoilt:?}, is read", line + 1) };
        assert!(faults.list().iter().any(|fault| fault.line == line + 1), "line {}, {spoilt:?}: {faults}", line + 1);
    }
}

/// Decks from which mutants are made.
fn seeds() -> Vec<String> {
    let decks = [include_str!("scene_decks.rs"), include_str!("scene_deck_styles.rs")].concat();
    // The decks of the other files, as they are between quotes.
    let texts = decks.split("agree(\n").skip(1).filter_map(|call| call.trim_start().strip_prefix("\"\\\n"));
    let mut seeds: Vec<String> =
        texts.filter_map(|text| text.split("\",\n        &[").next()).map(|text| text.replace("\\\"", "\"")).collect();
    seeds.push(GUIDE.into());
    assert!(seeds.len() >= 20, "{}", seeds.len());
    seeds
}

/// Damages a deck or a table: fields, lines, bytes.
fn mutant(seed: &str, draw: &mut Draw) -> String {
    const ODD: [&str; 26] = [
        "",
        "0",
        "-1",
        "1e308",
        "-1e308",
        "5e-324",
        "1e999",
        "1d0",
        "4294967295",
        "99999999999",
        "\"",
        "\"a b\"",
        "*",
        "**",
        "=",
        "a.b",
        "GENERATE",
        "ELSET=",
        "x",
        ",",
        "1..",
        "é",
        "nan",
        "u1",
        "time",
        "\t;",
    ];
    let mut lines: Vec<String> = seed.lines().map(String::from).collect();
    for _ in 0..=draw.below(3) {
        let [one, other] = [draw.below(lines.len()), draw.below(lines.len())];
        match draw.below(7) {
            0 => drop(lines.remove(one)),
            1 => lines.swap(one, other),
            2 => lines.insert(one, lines[other].clone()),
            3 | 4 => {
                let mut fields: Vec<_> = lines[one].split(',').map(String::from).collect();
                let field = draw.below(fields.len());
                let odd = ODD[draw.below(ODD.len())];
                match fields[field].split_once('=') {
                    Some((name, _)) => fields[field] = format!("{name}={odd}"),
                    None => fields[field] = odd.into(),
                }
                lines[one] = fields.join(",");
            }
            5 => {
                let mut bytes = lines[one].clone().into_bytes();
                if !bytes.is_empty() {
                    let at = draw.below(bytes.len());
                    bytes[at] ^= 1 << draw.below(8);
                }
                lines[one] = String::from_utf8_lossy(&bytes).into_owned();
            }
            _ => {
                let end = lines[one].char_indices().nth(draw.below(8)).map_or(0, |(at, _)| at);
                lines[one].truncate(end);
            }
        }
        if lines.is_empty() {
            break;
        }
    }
    lines.join(if draw.below(8) == 0 { "\r\n" } else { "\n" })
}

/// What becomes of a mutant: refused, undefined, or evaluated.
fn outcome(text: &str, run: impl FnOnce() -> usize) -> usize {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| panic!("a panic about this text:\n{text}"))
}

fn of_deck(text: &str) -> usize {
    let check = |faults: &Faults| {
        assert!(!faults.list().is_empty());
        for fault in faults.list() {
            assert!(fault.line >= 1 && fault.line <= text.lines().count().max(1) + 1 && fault.column >= 1, "{fault}");
            assert!(!fault.found.is_empty() && !fault.allowed.is_empty(), "{fault}");
        }
        0
    };
    outcome(text, || match read(text) {
        Err(faults) => check(&faults),
        Ok(deck) => 1 + usize::from(Results::of(&deck.scene().unwrap()).is_ok()),
    })
}

/// Tables from which mutants are made, and the deck to which each is the history.
const TABLES: [(&str, &str); 3] = [
    (include_str!("../golden/decks/telescope.csv"), include_str!("../golden/decks/telescope.inp")),
    (include_str!("../golden/decks/telescope-loads.csv"), include_str!("../golden/decks/telescope.inp")),
    (include_str!("../golden/decks/thread.csv"), include_str!("../golden/decks/thread.inp")),
];

fn of_table(text: &str, which: usize) -> usize {
    outcome(text, || {
        let scene = Deck::parse(TABLES[which].1).unwrap().scene().unwrap();
        let table = Some(Table::text("mutant.csv", text.as_bytes()));
        let tables = match which {
            1 => Tables { loads: table, ..Tables::default() },
            _ => Tables { nodes: table, ..Tables::default() },
        };
        match scene.with_tables(tables) {
            Ok(scene) => 1 + usize::from(Results::of(&scene).is_ok()),
            Err(fault) => {
                let lines = u64::try_from(text.lines().count()).unwrap();
                assert!(fault.line >= 1 && fault.line <= lines.max(1) + 1 && fault.column.0 >= 1, "{fault}");
                assert!(!fault.found.is_empty() && !fault.allowed.is_empty(), "{fault}");
                0
            }
        }
    })
}

/// Mutants of decks, and as many of tables.
fn judge_mutants(count: u64) {
    let (seeds, mut of_decks, mut of_tables) = (seeds(), [0; 3], [0; 3]);
    for number in 0..count / 2 {
        let mut draw = Draw(number.wrapping_mul(0x1000_0001));
        let seed = draw.below(seeds.len());
        of_decks[of_deck(&mutant(&seeds[seed], &mut draw))] += 1;
        let which = draw.below(TABLES.len());
        of_tables[of_table(&mutant(TABLES[which].0, &mut draw), which)] += 1;
    }
    println!("decks {of_decks:?}, tables {of_tables:?}");
    for outcomes in [of_decks, of_tables] {
        assert!([0, 2].iter().all(|&outcome| outcomes[outcome] * 100 > count), "{outcomes:?}");
    }
}

#[test]
fn mutants_of_decks_and_tables_do_not_panic() {
    judge_mutants(3000);
}

#[test]
#[ignore = "takes minutes, and wants an optimised build: cargo test --release --test all scene_deck_faults:: -- --ignored"]
fn a_million_mutants_of_decks_and_tables_do_not_panic() {
    judge_mutants(1_000_000);
}
