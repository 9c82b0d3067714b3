//! Figures made by the build: each from what the library computes.

mod arm;
mod cardan;
pub(crate) mod chart;
mod mechanism;
mod newton;
mod signs;
mod sketch;
mod slide_line;
mod slider;
mod thread;

/// Every figure, by the name that `{{#figure name}}` gives.
pub(crate) fn all() -> Vec<(String, String)> {
    let mut charts = vec![
        cardan::beta_near_90(),
        arm::twist(),
        arm::axial(),
        arm::apart(),
        slide_line::line(),
        slide_line::pressure_laws(),
        slide_line::damping_coefficient(),
        thread::torque_of_a_thread(),
        thread::tilted_flank(),
        newton::steps_of_two_rods(),
        newton::steps_of_a_slider_crank(),
        newton::lead_of_a_double_cardan(),
        newton::shares_of_the_turns(),
    ];
    charts.extend(slider::charts());
    let charts = charts.iter().map(|chart| (chart.name.to_owned(), chart.svg()));
    charts.chain([(signs::NAME.to_owned(), signs::svg())]).collect()
}

/// Every figure that moves.
pub(crate) fn moving() -> Vec<kit::Moving> {
    mechanism::all()
}

/// Every table, by the name that `{{#output name}}` gives.
pub(crate) fn outputs() -> Vec<(String, String)> {
    slider::outputs()
}
