//! Bringing values from memory before they are read.

/// Bytes of a cache line, which come together.
pub(crate) const LINE: usize = 64;

/// Asks the processor to bring a value from memory into its cache, because it will be read soon. It is a hint: where there
/// is no such instruction nothing happens.
#[cfg_attr(test, mutants::skip)] // No result depends on it.
#[inline]
pub(crate) fn prefetch<V>(value: &V) {
    #[cfg(target_arch = "x86_64")]
    safe_arch::prefetch_t0(value);
    #[cfg(not(target_arch = "x86_64"))]
    let _ = value;
}
