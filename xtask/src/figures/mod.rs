//! Figures made by the build: each from what the library computes.

mod arm;
mod cardan;
pub(crate) mod chart;

/// Every figure, by the name that `{{#figure name}}` gives.
pub(crate) fn all() -> Vec<(String, String)> {
    let charts = [cardan::beta_near_90(), arm::twist(), arm::axial()];
    charts.iter().map(|chart| (chart.name.to_owned(), chart.svg())).collect()
}
