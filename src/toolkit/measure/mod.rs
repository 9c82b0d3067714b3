//! Speed and error: every method of computing a formula, timed and compared with the exact value.
//!
//! | method | value | Jacobian |
//! |---|---|---|
//! | `closed` | `eval` in `f64` | `jacobian` in `f64` |
//! | `checked` | [`value`](crate::formula::value), as a program calls it | [`value_and_jacobian`](crate::formula::value_and_jacobian) |
//! | `single` | `eval` in [`Single`](crate::Single) | `jacobian` in it |
//! | `ad` | | forward automatic differentiation of `eval` in `f64` |
//! | `complex` | | complex step: one evaluation of `eval` in complex numbers an input |
//! | `forward`, `central`, `fourth` | | differences of `eval` in `f64` |
//! | `octuple` | `eval` in 237 bits, rounded | `jacobian` in 237 bits, rounded |
//! | `octuple-ad` | | automatic differentiation in 237 bits, rounded |
//! | the formula's own, see [`Proved::methods`] | as given | its automatic differentiation in `f64` |
//!
//! Batches of many points are timed separately, see [`Columns`].
//!
//! Errors are the same on every machine with the same mathematical library; they are measured first, and can be
//! measured for many formulas in parallel. Timing requires an otherwise idle machine. It is done over random points,
//! and for `closed` and `checked` also at every single hard point: see [`Figures::hardest`].
//!
//! ```
//! use jointproof::toolkit::measure::{Options, measure};
//! use jointproof::connector::slot::ContactForce;
//!
//! let measured = measure::<ContactForce>(&Options::quick());
//! let closed = measured.method("closed").unwrap();
//! let eta = closed.jacobian.as_ref().unwrap().random.eta;
//! assert!(eta.median <= eta.max && eta.max < 2.0);
//! ```

mod clock;
mod columns;
mod complex;
mod difference;
mod exact;
mod figures;
mod methods;
mod options;
mod quantile;

pub use difference::Scheme;
pub use figures::{Columns, Curve, Errors, Figures, Measurement, MethodFigures, PointTime, Quantiles, Time};
pub use options::Options;

use crate::formula::Field;
use crate::formula::proof::{Method, Proved};
use crate::toolkit::verify::Subject;

/// Measures one formula: its errors, then its times.
pub fn measure<F: Proved>(options: &Options) -> Measurement {
    let mut measurement = errors::<F>(options);
    times::<F>(options, &mut measurement);
    measurement
}

/// The errors of every method; times are still missing.
pub fn errors<F: Proved>(options: &Options) -> Measurement {
    let subject = Subject::of::<F>();
    let points = exact::Points::new(&subject, options);
    let curves = curves(&methods::differences::<F>, &points, options);
    let methods = methods::all::<F>(&curves);
    measured(&subject, &points, &methods, curves)
}

fn curves(method: &dyn Fn(Scheme, f64) -> Method, points: &exact::Points, options: &Options) -> Vec<Curve> {
    Scheme::ALL.iter().map(|&scheme| methods::curve(scheme, method, points, options)).collect()
}

fn measured(subject: &Subject, points: &exact::Points, methods: &[Method], curves: Vec<Curve>) -> Measurement {
    Measurement {
        formula: subject.spec.id.into(),
        inputs: subject.inputs.iter().map(Field::len).sum(),
        outputs: subject.outputs.iter().map(Field::len).sum(),
        random_points: points.random.len(),
        hard_points: points.hard.len(),
        copy: None,
        yardstick: None,
        columns: None,
        methods: methods.iter().map(|method| methods::errors(method, points)).collect(),
        curves,
    }
}

/// Times every method of a measurement whose errors are known.
pub fn times<F: Proved>(options: &Options, measurement: &mut Measurement) {
    let methods = methods::all::<F>(&measurement.curves);
    let subject = Subject::of::<F>();
    let points = clock::Points { random: options.timing_inputs(&subject), hard: exact::hard(&subject) };
    let clock = clock::clock();
    clock::time(&methods, clock::beside::<F>(&points), &points, (options, &clock), measurement);
    measurement.columns = columns::time::<F>(options, &clock);
}
