//! The errors of both routes, documented and direct, for difficult lines: near the x axis, short, far away, or with m far out.

use jointproof::Octuple;
use jointproof::connector::slider::{Eliminate, Increment, KeptCoordinate, KeptIncrement, Pivots, documented};
use jointproof::formula::{Fields, Formula};
use jointproof::toolkit::verify::exactly;
use nalgebra::Vector3;

/// A line, and the position of m on it. Every number is used as given, so that the results are the same on every machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setting {
    /// The tangent of the angle between the line and the x axis; 0 for a line along it.
    pub(crate) tilt: f64,
    /// The extent of the line along the x axis.
    pub(crate) length: f64,
    /// The position ξ of m between node 1 and node n.
    pub(crate) share: f64,
    /// The size of the coordinates of node 1.
    pub(crate) offset: f64,
}

/// An ordinary line: at 45° to the x axis, of unit extent, one unit from the origin.
impl Default for Setting {
    fn default() -> Self {
        Self { tilt: 1.0, length: 1.0, share: 0.5, offset: 1.0 }
    }
}

/// The largest errors of the two routes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RouteErrors {
    /// Through t1, t2 and the system of two equations ([`documented`]).
    pub(crate) documented: f64,
    /// By the ratios n_i/n_k.
    pub(crate) direct: f64,
}

impl Setting {
    /// The largest errors of the increments of m for 64 lines and motions, relative to the largest component of that
    /// increment. The exact result is [`Increment`] in 237 bits, for the same doubles: positions of m are rounded, so
    /// that m is off the line by a rounding error, as in any program.
    pub(crate) fn increment_errors(&self) -> RouteErrors {
        self.worst(|i| {
            let exact = Increment::eval(&exactly::<Increment>(i)).components();
            [documented::increment(i), Increment::eval(i)].map(|found| error(&found.components(), &exact, i.dxmk))
        })
    }

    /// The largest errors of the position of m for the same lines, relative to its largest coordinate.
    pub(crate) fn eliminate_errors(&self) -> RouteErrors {
        self.worst(|i| {
            let kept = KeptCoordinate { x1: i.x1, xn: i.xn, xmk: i.xm[Pivots::new(&i.x1, &i.xn).k] };
            let exact = Eliminate::eval(&exactly::<Eliminate>(&kept)).components();
            [documented::eliminate(&kept), Eliminate::eval(&kept)]
                .map(|found| error(&found.components(), &exact, kept.xmk))
        })
    }

    fn worst(&self, errors: impl Fn(&KeptIncrement<f64>) -> [f64; 2]) -> RouteErrors {
        let [documented, direct] =
            self.scenes().iter().map(errors).fold([0.0_f64; 2], |worst, [a, b]| [worst[0].max(a), worst[1].max(b)]);
        RouteErrors { documented, direct }
    }

    /// Four lines about the x axis, four motions, four positions of m.
    pub(crate) fn scenes(&self) -> Vec<KeptIncrement<f64>> {
        let x1 = Vector3::new(0.3, -0.7, 0.9) * self.offset;
        let lines = [[1.0, 0.6, 0.8], [-1.0, 0.96, -0.28], [1.0, -0.8, 0.6], [-1.0, -0.28, -0.96]];
        let motions = [
            ([0.01, -0.02, 0.035], [-0.015, 0.03, 0.0125], 0.02),
            ([0.03, 0.01, -0.02], [0.025, -0.02, 0.015], -0.01),
            ([0.0, 0.0, 0.0], [0.01, 0.03, -0.035], 0.005),
            ([-0.02, 0.015, 0.01], [0.0, 0.0, 0.0], 0.015),
        ];
        let mut scenes = Vec::new();
        for [x, y, z] in lines {
            let d = Vector3::new(x, y * self.tilt, z * self.tilt) * self.length;
            for (dx1, dxn, dxmk) in motions {
                for part in [0.7, 0.9, 1.1, 1.3] {
                    let xm = x1 + d * (self.share * part);
                    scenes.push(KeptIncrement { x1, xn: x1 + d, xm, dx1: dx1.into(), dxn: dxn.into(), dxmk });
                }
            }
        }
        scenes
    }
}

/// The largest error of a component, relative to the largest component, including the kept one.
fn error(found: &[f64], exact: &[Octuple], kept: f64) -> f64 {
    let size = exact.iter().fold(kept.abs(), |size, x| size.max(x.to_f64().abs()));
    let errors = found.iter().zip(exact).map(|(&found, &exact)| (exact - found).to_f64().abs());
    errors.fold(0.0, f64::max) / size
}

#[cfg(test)]
mod tests {
    use super::*;

    const SETTING: Setting = Setting { tilt: 0.5, length: 4.0, share: 0.25, offset: 2.0 };

    fn is_at(found: Vector3<f64>, expected: [f64; 3]) {
        assert!((found - Vector3::from(expected)).amax() < 1e-14, "{found}, expected {expected:?}");
    }

    #[test]
    fn an_ordinary_line_is_as_steep_as_long_as_far_and_halved() {
        assert_eq!(Setting::default(), Setting { tilt: 1.0, length: 1.0, share: 0.5, offset: 1.0 });
    }

    /// Two lines forwards and two backwards from one point, each in a separate quadrant.
    #[test]
    fn lines_go_from_one_point_into_all_quarters() {
        let scenes = SETTING.scenes();
        assert_eq!(scenes.len(), 64);
        let ends = [[4.0, 1.2, 1.6], [-4.0, 1.92, -0.56], [4.0, -1.6, 1.2], [-4.0, -0.56, -1.92]];
        for (scenes, end) in scenes.chunks(16).zip(ends) {
            for (scene, share) in scenes.iter().zip([0.175, 0.225, 0.275, 0.325].iter().cycle()) {
                is_at(scene.x1, [0.6, -1.4, 1.8]);
                is_at(scene.xn - scene.x1, end);
                is_at(scene.xm - scene.x1, end.map(|x| x * share));
            }
        }
    }

    /// Of all nodes together, of either end alone, and of the node on the line less than of the ends.
    #[test]
    fn every_line_is_moved_in_four_ways() {
        let motions = [
            ([0.01, -0.02, 0.035], [-0.015, 0.03, 0.0125], 0.02),
            ([0.03, 0.01, -0.02], [0.025, -0.02, 0.015], -0.01),
            ([0.0; 3], [0.01, 0.03, -0.035], 0.005),
            ([-0.02, 0.015, 0.01], [0.0; 3], 0.015),
        ];
        for scenes in SETTING.scenes().chunks(16) {
            for (scenes, (dx1, dxn, dxmk)) in scenes.chunks(4).zip(motions) {
                for scene in scenes {
                    is_at(scene.dx1, dx1);
                    is_at(scene.dxn, dxn);
                    assert!((scene.dxmk - dxmk).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn an_error_is_a_part_of_the_largest_component_or_of_the_kept_one() {
        let exact = [1.0, -4.0].map(Octuple::from);
        assert_eq!(error(&[1.5, -3.0], &exact, 0.5), 0.25);
        assert_eq!(error(&[0.5, -4.0], &exact, -8.0), 0.0625);
        assert_eq!(error(&[1.0, -4.0], &exact, 0.5), 0.0);
        let worst = SETTING.worst(|scene| [scene.dxmk, -scene.dxmk]);
        assert_eq!(worst, RouteErrors { documented: 0.02, direct: 0.01 });
    }
}
