//! Numbers that are the same in every run.

/// Numbers by shifts of 64 bits.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new() -> Self {
        Self(0x9E37_79B9_7F4A_7C15)
    }

    /// From -1 to 1.
    pub(super) fn next(&mut self) -> f64 {
        self.step();
        #[expect(clippy::cast_precision_loss, reason = "32 bits are enough")]
        let part = (self.0 >> 32) as f64 / f64::from(u32::MAX);
        2.0 * part - 1.0
    }

    /// An index below this count.
    pub(super) fn below(&mut self, count: usize) -> usize {
        self.step();
        usize::try_from(self.0 >> 40).unwrap_or_default() % count
    }

    fn step(&mut self) {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
    }
}
