//! Fetching values from memory before they are read.

/// Bytes of a cache line, the unit in which memory is fetched.
pub(crate) const LINE: usize = 64;

/// Asks the processor to fetch a value into its cache because it will be read soon. It is a hint: it does nothing on
/// processors without such an instruction.
#[cfg_attr(test, mutants::skip)] // No result depends on it.
#[inline]
pub(crate) fn prefetch<V>(value: &V) {
    #[cfg(target_arch = "x86_64")]
    safe_arch::prefetch_t0(value);
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}
