//! Results of a scene, collected.

use super::evaluate::Number;
use super::model::Scene;
use super::plan::Plan;
use super::run::{Problems, Run};
use crate::Octuple;
use serde::Serialize;

/// An output of an element over the states.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// The element.
    pub element: String,
    /// The output.
    pub output: &'static str,
    /// The components in every state.
    pub values: Vec<Vec<f64>>,
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
}

fn as_object<S: serde::Serializer>(counts: &[(&'static str, usize)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(counts.iter().copied())
}

impl Results {
    /// Evaluates a scene in `f64`.
    ///
    /// # Errors
    /// A formula that is undefined in some state.
    pub fn of(scene: &Scene) -> Result<Self, Problems> {
        Self::in_number::<f64>(&Plan::new(scene))
    }

    /// Evaluates a scene in 237 bits and rounds once: the same bytes on every machine.
    ///
    /// # Errors
    /// As [`Results::of`].
    pub fn exact(scene: &Scene) -> Result<Self, Problems> {
        let plan = Plan::new(scene);
        // Whether inputs are allowed is asked in doubles.
        Self::in_number::<f64>(&plan)?;
        Self::in_number::<Octuple>(&plan)
    }

    fn in_number<T: Number>(plan: &Plan<'_>) -> Result<Self, Problems> {
        Self::collect::<T>(plan, usize::MAX, || ())
    }

    /// Evaluates a plan and keeps the results of the first elements; `each` is called after every state.
    ///
    /// # Errors
    /// As [`Results::of`].
    pub fn collect<T: Number>(plan: &Plan<'_>, elements: usize, mut each: impl FnMut()) -> Result<Self, Problems> {
        let mut run = Run::<T>::new(plan)?;
        let mut series: Vec<Series> = Vec::new();
        let mut times = Vec::new();
        for time in plan.scene.times() {
            run.advance()?;
            each();
            times.push(time);
            let mut of_state = Vec::new();
            run.for_each_result(elements, |element, output, components| {
                of_state.push((element, output, components.iter().map(|value| value.rounded()).collect()));
            });
            if series.is_empty() {
                let named = |&(element, output, _): &(&str, _, _)| Series {
                    element: element.into(),
                    output,
                    values: Vec::new(),
                };
                series = of_state.iter().map(named).collect();
            }
            for (series, (.., values)) in series.iter_mut().zip(of_state) {
                series.values.push(values);
            }
        }
        Ok(Self { title: plan.scene.title().into(), counts: run.counts(), times, series })
    }

    /// The components of an element's output in a state counted from 0.
    pub fn get(&self, element: &str, output: &str, state: usize) -> Option<&[f64]> {
        let series = self.series.iter().find(|series| series.element == element && series.output == output);
        series.and_then(|series| series.values.get(state)).map(Vec::as_slice)
    }

    /// The golden form: JSON with a series a line, numbers that read back bit for bit.
    ///
    /// # Errors
    /// None that JSON of numbers and names can have; `serde_json` says.
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
