//! Threads that survive a fork: a child has the parent's memory and none of its threads, so each process makes a pool of its own.

use pyo3::Python;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::{Arc, Mutex};
use std::{process, thread};

/// The pool, and the process whose threads it has.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// How often a lock is asked for that is held for a moment only.
const TRIES: usize = 10_000;

/// Does work on all cores, without the interpreter's lock. What splits work within is distributed among the threads of this process.
pub(crate) fn on_all_cores<R: Send>(py: Python<'_>, work: impl FnOnce() -> R + Send) -> R {
    py.detach(|| match pool() {
        Some(pool) => pool.install(work),
        None => work(),
    })
}

/// The pool of this process; `None` if the machine gives no threads.
fn pool() -> Option<Arc<ThreadPool>> {
    let make = || ThreadPoolBuilder::new().build().ok().map(Arc::new);
    // Another thread holds the lock for a moment only. If that was the moment of a fork, it is held forever in the child, which then
    // makes a pool for each call.
    let free = (0..TRIES).find_map(|_| POOL.try_lock().inspect_err(|_| thread::yield_now()).ok());
    let Some(mut kept) = free else { return make() };
    let process = process::id();
    if let Some((_, pool)) = kept.as_ref().filter(|(of, _)| *of == process) {
        return Some(Arc::clone(pool));
    }
    let pool = make()?;
    // The threads of the parent's pool are not here to be ended.
    std::mem::forget(kept.replace((process, Arc::clone(&pool))));
    Some(pool)
}
