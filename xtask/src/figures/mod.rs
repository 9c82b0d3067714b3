//! Figures made by the build: each from what the library computes.

mod cardan;
mod chart;
mod slider;

/// Every figure, by the name that `{{#figure name}}` gives.
pub(crate) fn all() -> Vec<(String, String)> {
    let mut charts = vec![cardan::beta_near_90()];
    charts.extend(slider::charts());
    charts.iter().map(|chart| (chart.name.to_owned(), chart.svg())).collect()
}

/// Every table, by the name that `{{#output name}}` gives.
pub(crate) fn outputs() -> Vec<(String, String)> {
    slider::outputs()
}
