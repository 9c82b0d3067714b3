//! β by the two-argument arc tangent, accurate up to ±90°.
