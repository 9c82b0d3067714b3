//! Results of a scene, collected.

use super::abaqus::own_name;
use super::model::Scene;
use super::plan::Plan;
use super::run::{Run, Stopped};
use super::values::Values;
use crate::Octuple;
use crate::element::table::Number;
use serde::Serialize;
use std::sync::OnceLock;

/// An output of an element over the states.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// The element.
    pub element: String,
    /// The output.
    pub output: &'static str,
    /// The components in every state.
    pub values: Values,
}

/// All results of a scene over its states.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Results {
    /// The scene's title.
    pub title: String,
    /// The times of the states.
    pub times: Vec<f64>,
    /// Formulas, and how often each was evaluated.
    #[serde(serialize_with = "as_object")]
    pub counts: Vec<(&'static str, usize)>,
    /// Elements in the order of the file, and the outputs of each in the order of its kind.
    pub series: Vec<Series>,
    /// What was ambiguous, in words.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
    #[serde(skip)]
    order: Order,
}

/// The indices of series, sorted by element and output; created on demand. Series are public, so each entry is verified before it
/// is used.
#[derive(Debug, Default)]
struct Order(OnceLock<Vec<usize>>);

/// A copy may be modified.
impl Clone for Order {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Equality of results does not depend on this cache.
impl PartialEq for Order {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Order {
    /// The index of a series.
    fn find(&self, series: &[Series], element: &str, output: &str) -> Option<usize> {
        let name = |place: usize| series.get(place).map(|series| (series.element.as_str(), series.output));
        let order = self.0.get_or_init(|| {
            let mut order: Vec<_> = (0..series.len()).collect();
            order.sort_by_key(|&place| name(place));
            order
        });
        let wanted = Some((element, output));
        let at = order.partition_point(|&place| name(place) < wanted);
        let known = order.get(at).copied().filter(|&place| name(place) == wanted);
        known.or_else(|| (0..series.len()).find(|&place| name(place) == wanted))
    }
}

fn as_object<S: serde::Serializer>(counts: &[(&'static str, usize)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(counts.iter().copied())
}

impl Results {
    /// Evaluates a scene in `f64`.
    ///
    /// # Errors
    /// A formula that is undefined in some state, or an array of the history that cannot be read.
    pub fn of(scene: &Scene) -> Result<Self, Stopped> {
        Self::in_number::<f64>(&Plan::new(scene))
    }

    /// Evaluates a scene in 237 bits and rounds once: the same bytes on every machine.
    ///
    /// # Errors
    /// As [`Results::of`].
    pub fn exact(scene: &Scene) -> Result<Self, Stopped> {
        let plan = Plan::new(scene);
        // The validity of inputs is checked in doubles.
        Self::in_number::<f64>(&plan)?;
        Self::in_number::<Octuple>(&plan)
    }

    fn in_number<T: Number>(plan: &Plan<'_>) -> Result<Self, Stopped> {
        Self::collect::<T>(plan, usize::MAX, || ())
    }

    /// Evaluates a plan and keeps the results of the first elements; `each` is called after every state.
    ///
    /// # Errors
    /// As [`Results::of`].
    pub fn collect<T: Number>(plan: &Plan<'_>, elements: usize, mut each: impl FnMut()) -> Result<Self, Stopped> {
        let mut run = Run::<T>::new(plan)?;
        let mut series: Vec<Series> = Vec::new();
        let mut times = Vec::new();
        for time in plan.scene.times() {
            run.advance()?;
            each();
            times.push(time);
            // The order is the same in every state.
            let (is_first, mut place) = (series.is_empty(), 0);
            run.for_each_result(elements, |element, output, components| {
                if is_first {
                    series.push(Series { element: element.into(), output, values: Values::default() });
                }
                series[place].values.push(components.iter().map(|value| value.rounded()));
                place += 1;
            });
        }
        let mut warnings = plan.scene.warnings();
        warnings.extend(run.warnings().iter().map(ToString::to_string));
        let title = plan.scene.title().into();
        Ok(Self { title, counts: run.counts(), times, series, warnings, order: Order::default() })
    }

    /// The components of an element's output, by its name here or [in Abaqus](super::SAME_OUTPUTS), in a state counted from 0.
    pub fn get(&self, element: &str, output: &str, state: usize) -> Option<&[f64]> {
        self.series[self.order.find(&self.series, element, own_name(output))?].values.get(state)
    }

    /// The golden form: JSON with one series per line, and numbers that are read back bit for bit.
    ///
    /// # Errors
    /// None for JSON of numbers and names; the type is that of `serde_json`.
    pub fn golden(&self) -> serde_json::Result<String> {
        let series: Vec<_> = self.series.iter().map(serde_json::to_string).collect::<Result<_, _>>()?;
        let head = serde_json::json!({ "title": self.title, "times": self.times });
        let mut text = serde_json::to_string(&head)?;
        text.pop();
        let counts: serde_json::Map<_, _> = self.counts.iter().map(|&(id, count)| (id.into(), count.into())).collect();
        let counts = serde_json::to_string(&counts)?;
        Ok(format!("{text},\n\"counts\":{counts},\n\"series\":[\n{}\n]}}\n", series.join(",\n")))
    }
}

#[cfg(test)]
mod tests {
    use super::{Order, Series};
    use crate::scene::values::Values;

    #[test]
    fn series_are_found_wherever_they_stand() {
        let named = |element: &str, output| Series { element: element.into(), output, values: Values::default() };
        let mut series = vec![named("b", "U1"), named("b", "FN"), named("a", "U1"), named("a", "FN"), named("c", "U1")];
        let order = Order::default();
        let places = |series: &[Series]| {
            let all = [("a", "FN"), ("a", "U1"), ("b", "FN"), ("b", "U1"), ("c", "U1"), ("c", "FN"), ("d", "U1")];
            all.map(|(element, output)| order.find(series, element, output))
        };
        assert_eq!(places(&series), [Some(3), Some(2), Some(1), Some(0), Some(4), None, None]);
        // The cached order is not that of the remaining series.
        series.remove(1);
        assert_eq!(places(&series), [Some(2), Some(1), None, Some(0), Some(3), None, None]);
    }
}
