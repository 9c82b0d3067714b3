//! Distribution of work over all cores.

use rayon::prelude::*;

/// The number of items in a task: at least as many as are worth a thread, and few enough for every thread to get several tasks.
pub(super) fn task(items: usize, least: usize) -> usize {
    items.div_ceil(8 * rayon::current_num_threads()).max(least)
}

/// Runs a job for all items, on all cores if there are many; `job` receives the index of its first item.
pub(super) fn shared<T: Send>(items: &mut [T], job: impl Fn(usize, &mut [T]) + Sync) {
    let share = task(items.len(), 4096);
    if items.len() <= share {
        job(0, items);
    } else {
        items.par_chunks_mut(share).enumerate().for_each(|(index, items)| job(index * share, items));
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_thread_gets_eight_tasks_that_are_worth_it() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let task = |items, least| pool.install(|| super::task(items, least));
        assert_eq!([task(1600, 1), task(1601, 1), task(1600, 100), task(1600, 101)], [100, 101, 100, 101]);
        assert_eq!([task(0, 16), task(10, 16)], [16; 2]);
    }
}
