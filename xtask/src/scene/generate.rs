//! Scenes of any size, to measure with.

use std::io::{BufWriter, Write};

/// States of a generated scene.
pub(crate) const STATES: usize = 5;

/// A scene of sliding connectors side by side, each with friction, stops and its own motion. Written as it is made.
pub(crate) fn write(elements: usize, out: &mut impl Write) -> anyhow::Result<()> {
    let mut out = BufWriter::with_capacity(1 << 20, out);
    let comma = |index: usize| if index == 0 { "" } else { "," };
    write!(
        out,
        "{{\"title\":\"{elements} sliding connectors\",\n\"dimension\":\"3d\",\n\
        \"orientations\":{{\"rail\":{{\"rotation\":[0.1,0.2,0.3]}}}},\n\"nodes\":{{"
    )?;
    for i in 0..elements {
        let (row, column) = (i / 1000, i % 1000);
        write!(
            out,
            "{}\n\"a{i}\":{{\"at\":[{column},{row},0],\"orientation\":\"rail\"}},\"b{i}\":{{\"at\":[{column}.5,{row}.25,1]}}",
            comma(i)
        )?;
    }
    write!(out, "}},\n\"elements\":{{")?;
    for i in 0..elements {
        write!(
            out,
            "{}\n\"s{i}\":{{\"kind\":\"slot\",\"nodes\":[\"a{i}\",\"b{i}\"],\"mu\":0.{},\"k_stick\":1e5}}",
            comma(i),
            1 + i % 9
        )?;
    }
    write!(out, "}},\n\"frames\":[")?;
    for state in 0..STATES {
        write!(out, "{}\n{{\"time\":{state},\"nodes\":{{", comma(state))?;
        for i in 0..elements {
            write!(out, "{}\"b{i}\":{{\"u\":[0.0{state}{},0,0.001]}}", comma(i), i % 10)?;
        }
        write!(out, "}},\"loads\":{{")?;
        for i in 0..elements {
            write!(out, "{}\"s{i}\":{{\"f2\":{}.5,\"f3\":-{state}}}", comma(i), i % 100)?;
        }
        write!(out, "}}}}")?;
    }
    writeln!(out, "],\n\"outputs\":[\"GY\",\"GZ\",\"U1\",\"CSF1\",\"CASU1\"]}}")?;
    Ok(out.flush()?)
}
