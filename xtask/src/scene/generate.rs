//! Scenes of any size, to measure with: sliding connectors side by side, each with friction and its own motion.

use std::io::{BufWriter, Write};

/// States of a generated scene.
pub(crate) const STATES: usize = 5;

/// Stick stiffness of every connector.
pub(crate) const K_STICK: f64 = 1e5;

/// How the rail of every connector stands.
pub(crate) const RAIL: [[f64; 3]; 3] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];

/// Where the nodes of a connector are initially: the rail, and what slides on it.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
pub(crate) fn nodes(connector: usize) -> [[f64; 3]; 2] {
    let (row, column) = ((connector / 1000) as f64, (connector % 1000) as f64);
    [[column, row, 0.0], [column + 0.5, row + 0.25, 1.0]]
}

/// The friction coefficient of a connector.
#[expect(clippy::cast_precision_loss, reason = "at most 9")]
pub(crate) fn mu(connector: usize) -> f64 {
    (1 + connector % 9) as f64 / 10.0
}

/// By how much what slides is displaced in a state.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
pub(crate) fn displacement(state: usize, connector: usize) -> [f64; 3] {
    [0.001, (10 * state + connector % 10) as f64 / 1000.0, 0.0]
}

/// The forces across a connector in a state.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
pub(crate) fn loads(state: usize, connector: usize) -> [f64; 2] {
    [(connector % 100) as f64 + 0.5, -(state as f64)]
}

/// Writes the scene as it is made.
pub(crate) fn write(connectors: usize, out: &mut impl Write) -> anyhow::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 20, out);
    let comma = |index: usize| if index == 0 { "" } else { "," };
    let [first, second, _] = RAIL;
    write!(
        out,
        "{{\"title\":\"{connectors} sliding connectors\",\n\"dimension\":\"3d\",\n\
        \"orientations\":{{\"rail\":{{\"axes\":[{first:?},{second:?}]}}}},\n\"nodes\":{{"
    )?;
    for i in 0..connectors {
        let [a, b] = nodes(i);
        write!(out, "{}\n\"a{i}\":{{\"at\":{a:?},\"orientation\":\"rail\"}},\"b{i}\":{{\"at\":{b:?}}}", comma(i))?;
    }
    write!(out, "}},\n\"elements\":{{")?;
    for i in 0..connectors {
        write!(
            out,
            "{}\n\"s{i}\":{{\"kind\":\"slot\",\"nodes\":[\"a{i}\",\"b{i}\"],\"mu\":{},\"k_stick\":{K_STICK}}}",
            comma(i),
            mu(i)
        )?;
    }
    write!(out, "}},\n\"frames\":[")?;
    for state in 0..STATES {
        write!(out, "{}\n{{\"time\":{state},\"nodes\":{{", comma(state))?;
        for i in 0..connectors {
            write!(out, "{}\"b{i}\":{{\"u\":{:?}}}", comma(i), displacement(state, i))?;
        }
        write!(out, "}},\"loads\":{{")?;
        for i in 0..connectors {
            let [f2, f3] = loads(state, i);
            write!(out, "{}\"s{i}\":{{\"f2\":{f2},\"f3\":{f3}}}", comma(i))?;
        }
        write!(out, "}}}}")?;
    }
    writeln!(out, "],\n\"outputs\":[\"GY\",\"GZ\",\"U1\",\"CSF1\",\"CASU1\"]}}")?;
    Ok(out.flush()?)
}
