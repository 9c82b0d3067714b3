//! Work shared out to threads.

use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread;

/// What comes of every item, in their order.
///
/// # Errors
/// The first that occurs.
pub(super) fn in_parallel<T: Sync, R: Send>(
    jobs: usize,
    items: &[T],
    work: impl Fn(&T) -> anyhow::Result<R> + Sync,
) -> anyhow::Result<Vec<R>> {
    let next = AtomicUsize::new(0);
    let share = || {
        let mut done = Vec::new();
        while let Some((number, item)) = Some(next.fetch_add(1, Relaxed)).and_then(|n| Some((n, items.get(n)?))) {
            done.push((number, work(item)));
        }
        done
    };
    let mut all: Vec<_> = thread::scope(|scope| {
        let threads: Vec<_> = (0..jobs.max(1)).map(|_| scope.spawn(share)).collect();
        threads.into_iter().flat_map(|thread| thread.join().expect("the work does not panic")).collect()
    });
    all.sort_by_key(|(number, _)| *number);
    all.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_come_in_order_from_any_number_of_threads() {
        for jobs in [0, 1, 3] {
            assert_eq!(in_parallel(jobs, &[5, 3, 8], |x| Ok(10 * x)).unwrap(), [50, 30, 80]);
        }
        let one = in_parallel(1, &[0; 9], |_| Ok(thread::current().id())).unwrap();
        assert!(one.iter().all(|thread| *thread == one[0]), "one job is one thread");
        // One thread has the first and the third item, the other one the second.
        let begun = AtomicUsize::default();
        let waiting = |&item: &usize| {
            begun.fetch_max(item, Relaxed);
            while item < 2 && begun.load(Relaxed) <= item {
                thread::yield_now();
            }
            Ok(item)
        };
        assert_eq!(in_parallel(2, &[0, 1, 2], waiting).unwrap(), [0, 1, 2]);
        let refused = |x: &i32| if *x > 3 { anyhow::bail!("{x} is large") } else { Ok(*x) };
        assert_eq!(in_parallel(2, &[1, 5, 8], refused).unwrap_err().to_string(), "5 is large");
    }
}
