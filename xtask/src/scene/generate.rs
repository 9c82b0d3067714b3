//! Scenes of any size for measurements: sliding connectors side by side, each with friction and its own motion.

use jointproof::scene::npz::Writer;
use serde_json::json;
use std::fmt::Write as _;
use std::io::{BufWriter, Write};

/// The default number of states of a generated scene.
pub(crate) const STATES: usize = 5;

/// The connector of a generated scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Connector {
    /// The cheapest connector: about ten nanoseconds per evaluation
    Slot,
    /// TRANSLATOR, with angles and with friction from forces and moments
    Translator,
}

impl Connector {
    /// Its kind in the scene.
    pub(crate) fn kind(self) -> &'static str {
        match self {
            Self::Slot => "slot",
            Self::Translator => "translator",
        }
    }

    /// Its requested outputs, in order.
    pub(crate) fn outputs(self) -> &'static [&'static str] {
        match self {
            Self::Slot => &["U1", "GY", "GZ", "CSF1", "CASU1"],
            Self::Translator => &["U1", "GY", "GZ", "UR1", "UR2", "UR3", "CSF1", "CASU1"],
        }
    }

    /// The forces and moments that load it, selected from those in [`loads`].
    fn loads(self) -> &'static [&'static str] {
        match self {
            Self::Slot => &["f2", "f3"],
            Self::Translator => &["f2", "f3", "m1", "m2", "m3"],
        }
    }

    /// Parameters in addition to those of every connector, with the separator before them.
    fn levers(self) -> String {
        match self {
            Self::Slot => String::new(),
            Self::Translator => format!(",\"rr\":{RADIUS},\"l\":{LENGTH}"),
        }
    }
}

/// Stick stiffness of every connector.
pub(crate) const K_STICK: f64 = 1e5;

/// The orientation of the rail of every connector.
pub(crate) const RAIL: [[f64; 3]; 3] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];

/// The orientation of the sliding node of a translator.
pub(crate) const CAR: [[f64; 3]; 3] = [[0.0, 0.8, 0.6], [0.0, -0.6, 0.8], [1.0, 0.0, 0.0]];

/// The levers of a translator's moments.
pub(crate) const RADIUS: f64 = 0.25;
pub(crate) const LENGTH: f64 = 2.0;

/// The initial positions of the nodes of a connector: the rail, and the sliding node.
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

/// The displacement of the sliding node in a state.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
pub(crate) fn displacement(state: usize, connector: usize) -> [f64; 3] {
    [0.001, (10 * state + connector % 10) as f64 / 1000.0, 0.0]
}

/// The transverse forces f2 and f3 on a connector in a state, and the moments.
#[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
pub(crate) fn loads(state: usize, connector: usize) -> [f64; 5] {
    let (force, moment) = ((connector % 100) as f64, state as f64);
    [force + 0.5, -moment, moment + 0.25, force, -0.75]
}

/// A generated scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Generated {
    pub(crate) of: Connector,
    pub(crate) connectors: usize,
    pub(crate) states: usize,
}

impl Generated {
    /// Writes the part before the nodes, whose numbers may be in a file of columns.
    fn write_head(self, columns: Option<&str>, out: &mut impl Write) -> anyhow::Result<()> {
        let ([first, second, _], [car, beside, _]) = (RAIL, CAR);
        let Self { of, connectors, .. } = self;
        let columns = columns.map_or_else(String::new, |file| format!("\"columns\":{},\n", json!(file)));
        write!(
            out,
            "{{\"title\":\"{connectors} connectors of kind {}\",\n\"dimension\":\"3d\",\n{columns}\
            \"orientations\":{{\"rail\":{{\"axes\":[{first:?},{second:?}]}},\"car\":{{\"axes\":[{car:?},{beside:?}]}}}},\n\"nodes\":{{",
            of.kind()
        )?;
        Ok(())
    }

    /// Writes the scene as it is generated.
    pub(crate) fn write(self, out: &mut impl Write) -> anyhow::Result<()> {
        let mut out = BufWriter::with_capacity(1 << 20, out);
        let comma = |index: usize| if index == 0 { "" } else { "," };
        let Self { of, connectors, states } = self;
        let kind = of.kind();
        self.write_head(None, &mut out)?;
        for i in 0..connectors {
            let [a, b] = nodes(i);
            write!(
                out,
                "{}\n\"a{i}\":{{\"at\":{a:?},\"orientation\":\"rail\"}},\"b{i}\":{{\"at\":{b:?},\"orientation\":\"car\"}}",
                comma(i)
            )?;
        }
        write!(out, "}},\n\"elements\":{{")?;
        for i in 0..connectors {
            write!(
                out,
                "{}\n\"s{i}\":{{\"kind\":\"{kind}\",\"nodes\":[\"a{i}\",\"b{i}\"],\"mu\":{},\"k_stick\":{K_STICK}{}}}",
                comma(i),
                mu(i),
                of.levers(),
            )?;
        }
        write!(out, "}},\n\"frames\":[")?;
        for state in 0..states {
            write!(out, "{}\n{{\"time\":{state},\"nodes\":{{", comma(state))?;
            for i in 0..connectors {
                write!(out, "{}\"b{i}\":{{\"u\":{:?}}}", comma(i), displacement(state, i))?;
            }
            write!(out, "}},\"loads\":{{")?;
            for i in 0..connectors {
                let mut given = String::new();
                for (load, value) in of.loads().iter().zip(loads(state, i)) {
                    write!(given, "{}\"{load}\":{value}", if given.is_empty() { "" } else { "," })?;
                }
                write!(out, "{}\"s{i}\":{{{given}}}", comma(i))?;
            }
            write!(out, "}}}}")?;
        }
        writeln!(out, "],\n\"outputs\":{:?}}}", of.outputs())?;
        Ok(out.flush()?)
    }

    /// Writes the scene without its numbers, which are in a file of arrays with this name.
    pub(crate) fn write_description(self, columns: &str, out: &mut impl Write) -> anyhow::Result<()> {
        let of = self.of;
        let loads: serde_json::Map<_, _> = of.loads().iter().map(|&load| (load.into(), load.into())).collect();
        self.write_head(Some(columns), out)?;
        writeln!(
            out,
            "\n\"a\":{{\"at\":\"a\",\"orientation\":\"rail\"}},\"b\":{{\"at\":\"b\",\"orientation\":\"car\"}}}},\n\
            \"elements\":{{\"s\":{{\"kind\":\"{}\",\"nodes\":[\"a\",\"b\"],\"mu\":\"mu\",\"k_stick\":{K_STICK}{}}}}},\n\
            \"frames\":{{\"time\":\"time\",\"nodes\":{{\"b\":{{\"u\":\"u\"}}}},\"loads\":{{\"s\":{}}}}},\n\
            \"outputs\":{:?}}}",
            of.kind(),
            of.levers(),
            serde_json::Value::Object(loads),
            of.outputs()
        )?;
        Ok(())
    }

    /// Writes the numbers to which [`Self::write_description`] refers.
    #[expect(clippy::cast_precision_loss, reason = "counts far below 2^53")]
    pub(crate) fn write_arrays(self, out: impl Write) -> std::io::Result<()> {
        let Self { of, connectors, states } = self;
        let mut arrays = Writer::new(out);
        for (node, name) in ["a", "b"].into_iter().enumerate() {
            let at: Vec<_> = (0..connectors).flat_map(|i| nodes(i)[node]).collect();
            arrays.write(name, &[connectors, 3], &at)?;
        }
        arrays.write("mu", &[connectors], &(0..connectors).map(mu).collect::<Vec<_>>())?;
        arrays.write("time", &[states], &(0..states).map(|state| state as f64).collect::<Vec<_>>())?;
        let each = || (0..states).flat_map(|state| (0..connectors).map(move |i| (state, i)));
        let u: Vec<_> = each().flat_map(|(state, i)| displacement(state, i)).collect();
        arrays.write("u", &[states, connectors, 3], &u)?;
        for (load, name) in of.loads().iter().enumerate() {
            let values: Vec<_> = each().map(|(state, i)| loads(state, i)[load]).collect();
            arrays.write(name, &[states, connectors], &values)?;
        }
        arrays.finish()
    }
}
