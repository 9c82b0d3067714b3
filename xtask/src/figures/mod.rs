//! Figures made by the build: each from what the library computes.

mod arm;
mod cardan;
pub(crate) mod chart;
mod slide_line;
mod thread;

/// Every figure, by the name that `{{#figure name}}` gives.
pub(crate) fn all() -> Vec<(String, String)> {
    let charts = [
        cardan::beta_near_90(),
        arm::twist(),
        arm::axial(),
        slide_line::line(),
        slide_line::pressure_laws(),
        slide_line::damping_coefficient(),
        thread::torque_of_a_thread(),
        thread::tilted_flank(),
    ];
    charts.iter().map(|chart| (chart.name.to_owned(), chart.svg())).collect()
}
