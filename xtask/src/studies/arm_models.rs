//! The models of the arm side by side.

use jointproof::Octuple;
use jointproof::connector::ujoint::{Arm, AxialFactors, AxialShares, TwistFactors, TwistShares, arm};
use jointproof::formula::Formula;
use num_dual::DualNum;

/// The four factors of one model of the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Model {
    /// Share of the twisting moment that bends a hinge.
    pub(crate) alpha_twist: f64,
    /// Transverse force on a hinge per twisting moment over arm length.
    pub(crate) beta_twist: f64,
    /// Share of an axial force on a hinge of the loaded axis.
    pub(crate) alpha_axial: f64,
    /// Share of an axial force on a hinge of the other axis.
    pub(crate) beta_axial: f64,
}

impl Model {
    /// From α_twist and the ratio of bending to axial stiffness of an arm; both equilibria determine the rest.
    fn new(alpha_twist: f64, bent_to_stretched: f64) -> Self {
        let alpha_axial = 0.5 / (1.0 + bent_to_stretched);
        Self { alpha_twist, beta_twist: 0.25 + alpha_twist, alpha_axial, beta_axial: bent_to_stretched * alpha_axial }
    }
}

/// The models of the arm at one slenderness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Models {
    /// λ = La/Rp.
    pub(crate) lambda: f64,
    /// The model used here: [`TwistFactors`] and [`AxialFactors`].
    pub(crate) used: Model,
    /// A rigid arm.
    pub(crate) rigid: Model,
    /// A clamped Timoshenko beam. Below λ = √4.4 its α_twist is negative, against the source.
    pub(crate) timoshenko: Model,
    /// A clamped Euler–Bernoulli beam.
    pub(crate) euler_bernoulli: Model,
}

/// All models of the arm at `count` slendernesses, evenly spaced on a logarithmic scale from 10^`first` to 10^`last`:
/// the data of the plot in the book. They are the same on every machine.
pub(crate) fn curves(first: i32, last: i32, count: u32) -> Vec<Models> {
    let (first, last) = (Octuple::from(f64::from(first)), Octuple::from(f64::from(last)));
    let at = |k: u32| {
        let exponent = first + (last - first) * f64::from(k) / f64::from(count.saturating_sub(1).max(1));
        models(Octuple::from(10.0).powd(exponent).to_f64())
    };
    (0..count).map(at).collect()
}

/// All models at one slenderness.
fn models(lambda: f64) -> Models {
    let cross = Arm { la: lambda, rp: 1.0 };
    let TwistShares { alpha_twist, beta_twist } = TwistFactors::eval(&cross);
    let AxialShares { alpha_axial, beta_axial } = AxialFactors::eval(&cross);
    let (phi, bent_to_stretched) = (arm::phi(&cross), 3.0 / (lambda * lambda));
    Models {
        lambda,
        used: Model { alpha_twist, beta_twist, alpha_axial, beta_axial },
        rigid: Model::new(0.0, 1.0),
        timoshenko: Model::new(arm::timoshenko(phi), bent_to_stretched / (1.0 + phi)),
        euler_bernoulli: Model::new(0.125, bent_to_stretched),
    }
}

#[cfg(test)]
mod tests {
    use super::{Model, Models, curves, models};
    use jointproof::connector::ujoint::{Arm, arm};

    #[test]
    fn the_ends_are_the_printed_limits_but_for_timoshenko() {
        let curves = curves(-1, 3, 101);
        assert!((curves[50].lambda - 10.0).abs() < 1e-14 && curves.len() == 101, "{:?}", curves[50]);
        let (first, last) = (curves.first().unwrap(), curves.last().unwrap());
        assert_eq!((first.lambda, last.lambda), (0.1, 1000.0));
        assert!(first.used.alpha_twist < 2e-4 && (first.used.beta_twist - 0.25).abs() < 2e-4);
        assert!((last.used.alpha_twist - 0.125).abs() < 2e-6 && (last.used.beta_twist - 0.375).abs() < 2e-6);
        assert!(first.timoshenko.alpha_twist < -0.24);
        // A short arm is nearly rigid; a long one has the factors of the Euler–Bernoulli beam.
        let factors = |model: &Model| [model.alpha_twist, model.beta_twist, model.alpha_axial, model.beta_axial];
        for (used, model) in [(&first.used, &first.rigid), (&last.used, &last.euler_bernoulli)] {
            let off = factors(used).into_iter().zip(factors(model)).map(|(used, model)| (used - model).abs());
            assert!(off.clone().all(|off| off < 5e-3), "{:?}", off.collect::<Vec<_>>());
        }
    }

    #[test]
    fn curves_of_few_points_have_the_ends() {
        let lambdas = |count: u32| curves(-1, 3, count).iter().map(|models| models.lambda).collect::<Vec<_>>();
        assert_eq!((lambdas(0), lambdas(1), lambdas(2)), (vec![], vec![0.1], vec![0.1, 1000.0]));
    }

    /// An arm as long as its cross is wide: it is three times as stiff in bending as in tension; shear makes it softer.
    #[test]
    fn a_short_arm_is_stiffer_when_it_is_bent() {
        let Models { timoshenko, euler_bernoulli, used, .. } = models(1.0);
        assert_eq!([euler_bernoulli.alpha_axial, euler_bernoulli.beta_axial], [0.125, 0.375]);
        let phi = arm::phi(&Arm { la: 1.0, rp: 1.0 });
        let ratio = timoshenko.beta_axial / timoshenko.alpha_axial;
        assert!((ratio * (1.0 + phi) - 3.0).abs() < 1e-12, "{ratio}, φ = {phi}");
        assert!(used.alpha_twist > 0.0 && used.alpha_twist < 0.125, "{used:?}");
    }

    #[test]
    fn every_model_is_in_equilibrium() {
        for Models { lambda, used, rigid, timoshenko, euler_bernoulli } in curves(-1, 3, 21) {
            for Model { alpha_twist, beta_twist, alpha_axial, beta_axial } in [used, rigid, timoshenko, euler_bernoulli]
            {
                let off = [beta_twist - alpha_twist - 0.25, alpha_axial + beta_axial - 0.5];
                assert!(off.iter().all(|off| off.abs() < 1e-12), "{lambda}: {off:?}");
            }
        }
    }
}
