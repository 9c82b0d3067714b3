//! The Pareto-optimal methods: no other is both faster and more accurate.

/// The indices of the Pareto-optimal points, from the fastest to the most accurate.
///
/// A point is (time, error), less being better. A point that is equal in one respect and worse in the other is
/// dominated; of two equal points the first is kept.
pub(crate) fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<_> = (0..points.len()).collect();
    let key = |k: usize| points[k];
    order.sort_by(|&a, &b| key(a).0.total_cmp(&key(b).0).then(key(a).1.total_cmp(&key(b).1)));
    let mut least = f64::INFINITY;
    order.retain(|&k| {
        let better = points[k].1 < least;
        least = least.min(points[k].1);
        better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_falls_from_fast_to_accurate() {
        let points = [(3.0, 1.0), (1.0, 9.0), (2.0, 9.5), (2.5, 4.0), (9.0, 1.0), (10.0, 0.0)];
        assert_eq!(front(&points), [1, 3, 0, 5]);
    }

    #[test]
    fn of_equals_the_first_stays_and_nothing_has_no_front() {
        assert_eq!(front(&[(1.0, 1.0), (1.0, 1.0)]), [0]);
        assert_eq!(front(&[]), [] as [usize; 0]);
    }

    #[test]
    fn one_point_may_beat_all() {
        assert_eq!(front(&[(2.0, 2.0), (1.0, 1.0), (1.0, 3.0)]), [1]);
    }
}
