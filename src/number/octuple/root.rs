//! The square root, correctly rounded in a quarter of the time that `f256` takes; square roots are a fifth of an
//! audit's computation.

use super::bits::{exponent, leading_bits, nearest_f64};
use f256::f256;

/// The exponents for which doubles suffice, squares included.
const EXPONENTS: std::ops::Range<i32> = -1000..1000;

/// √x by Newton's method from the root in `f64`, checked by its residual x − s²; where that does not settle the last
/// bit, by `f256`.
pub(super) fn sqrt(x: f256) -> f256 {
    if x.is_sign_negative() || !EXPONENTS.contains(&exponent(x)) {
        return x.sqrt();
    }
    // 53, 106 and 212 digits.
    let mut reciprocal = f256::from(nearest_f64(leading_bits(x), exponent(x)).sqrt().recip());
    for _ in 0..2 {
        let error = f256::ONE - x * (reciprocal * reciprocal);
        reciprocal += (reciprocal * error).div2();
    }
    let near = x * reciprocal;
    let root = near + (left(x, near) * reciprocal).div2();
    if is_nearest(root, left(x, root)) { root } else { x.sqrt() }
}

/// x − s², rounded once.
fn left(x: f256, s: f256) -> f256 {
    (-s).mul_add(s, x)
}

/// Whether s is less than half an ulp from the root: |x − s²| < s ulp(s), since s ± ½ ulp(s) have the squares s² ± s ulp(s) + ¼
/// ulp(s)², and x − s² is a multiple of ulp(s)². Just below a power of two the spacing of numbers is halved.
fn is_nearest(s: f256, left: f256) -> bool {
    let limit = s * s.ulp();
    if left.is_sign_negative() && is_power_of_two(s) { -left < limit.div2() } else { left.abs() < limit }
}

fn is_power_of_two(s: f256) -> bool {
    s == super::bits::power_of_two(exponent(s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::octuple::bits::power_of_two;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    /// Compared with `f256`, which needs no starting value: at random numbers, at squares, near squares of midpoints
    /// between two numbers, where rounding is hardest, and near powers of two.
    #[test]
    fn every_bit_is_that_of_f256() {
        let mut random = ChaCha8Rng::seed_from_u64(1);
        let mut fraction = || {
            let words = [(); 4].map(|()| u128::from(random.next_u64()));
            let bits = ((words[0] << 64 | words[1]) >> 20, words[2] << 64 | words[3]);
            f256::from_bits((power_of_two(0).to_bits().0 | bits.0, bits.1))
        };
        for k in 0..2000 {
            let s = fraction();
            let steps = f256::from(k % 9 - 4);
            let beside = |x: f256| x + x.ulp().div2() * steps;
            let hard = [s, s * s, s * s + s * s.ulp(), beside(s * s), beside(power_of_two(k % 7 - 3))];
            for x in hard.into_iter().flat_map(|x| [x, x * power_of_two(k - 1000)]) {
                assert_eq!(sqrt(x), x.sqrt(), "{x:?}");
            }
        }
    }

    /// Roots as near as 2⁻²³⁴ ulp to the midpoint between two numbers: those of x = m² + m − j for small j, in units
    /// of the last place, where (2m + 1)² = 1 + 4j modulo 2²³⁹, found by lifting digit by digit. Newton's method alone
    /// cannot tell their side.
    #[test]
    fn the_hardest_roots_are_right() {
        let number = |e: i32, (high, low): Fraction| f256::from_bits((power_of_two(e).to_bits().0 | high, low));
        for (e, x, root) in HARDEST {
            for twice in [-400, 0, 300] {
                let x = number(e + 2 * twice, x);
                assert_eq!(sqrt(x), number(twice, root), "{x:?}");
                // The check rejects both neighbours, so the result is not due to luck in Newton's method.
                let beside = [root.1 - 1, root.1 + 1].map(|low| number(twice, (root.0, low)));
                assert!(beside.into_iter().all(|s| !is_nearest(s, left(x, s))), "{x:?}");
            }
        }
    }

    /// The root of 1 − 2⁻²³⁷ is slightly nearer to that number itself than to 1.
    #[test]
    fn below_a_power_of_two_the_next_number_is_at_half_the_distance() {
        for k in [-6, 0, 7] {
            let (s, x) = (power_of_two(k), power_of_two(2 * k).next_down());
            assert!(is_nearest(s, left(power_of_two(2 * k), s)) && !is_nearest(s, left(x, s)));
            assert!(sqrt(x) == s.next_down() && sqrt(power_of_two(2 * k).next_up()) == s);
        }
    }

    /// The bits after the point, the upper ones first.
    type Fraction = (u128, u128);

    /// x = 1.fraction · 2^e given by e and the fraction, and the fraction of its root.
    const HARDEST: [(i32, Fraction, Fraction); 9] = [
        (
            0,
            (0xac8_2050_6461_7c49_40d4_bb8e_2019, 0x77b7_92ce_c790_9134_2ebb_2839_bab1_96e1),
            (0x4b3_4f84_a6d7_4677_9d21_1dda_3474, 0xe929_5e69_5fdb_29f1_bd2e_df06_6616_6c8b),
        ),
        (
            1,
            (0x74a_219a_3daa_eabd_c907_0438_72ae, 0x005f_ae2b_4436_cac4_dfd0_f709_ab15_85ce),
            (0xb4c_b07b_5928_b988_62de_e225_cb8b, 0x16d6_a196_a024_d60e_42d1_20f9_99e9_9374),
        ),
        (
            0,
            (0xe6a_4576_9995_c848_1bd6_378d_b187, 0x314e_5c70_372a_d7d7_cad6_4c22_43de_0fb1),
            (0x60f_59b8_dfee_d919_267c_1129_0c25, 0x9ca6_9b2c_af5a_4118_7157_c825_3abf_ead5),
        ),
        (
            1,
            (0x507_1590_acfe_58d8_9a76_e84b_b452, 0xc2b3_5cb2_0d86_a8a2_9163_cda1_71af_4758),
            (0x9f0_a647_2011_26e6_d983_eed6_f3da, 0x6359_64d3_50a5_bee7_8ea8_37da_c540_152a),
        ),
        (
            1,
            (0x0df_7d05_1cac_7a36_abd3_a80e_f594, 0x1eab_9bb9_bf9c_30b5_ba10_893c_de17_acfe),
            (0x73c_8cd5_4390_5956_ad10_a451_8f6e, 0x751c_f8df_b9e0_291d_0cda_5db1_ce4c_605b),
        ),
        (
            0,
            (0x567_e377_fe42_dc55_5424_3690_57a5, 0xa2a0_5605_5f6b_00a8_3943_8474_1f91_f92d),
            (0x281_ae65_857c_5a83_563f_8e69_0760, 0x830c_9397_788a_4003_4c0a_f845_ee2f_5448),
        ),
        (
            1,
            (0xb2e_e68b_6eac_5ea0_a753_700d_15b1, 0x482a_703c_4616_c04a_3880_d968_453a_ffc0),
            (0xd7e_519a_7a83_a57c_a9c0_7196_f89f, 0x7cf3_6c68_8775_bffc_b3f5_07ba_11d0_abb9),
        ),
        (
            0,
            (0x648_4af7_eec7_0c7f_3c98_8804_7a14, 0x2b27_d01f_db44_9787_3caa_0aba_455e_7005),
            (0x2e1_b695_9a7e_a410_41f7_f11a_0d63, 0x339f_9508_085a_9baf_7325_19bb_16db_1f10),
        ),
        (
            1,
            (0xa7f_01bb_27e7_9a0e_d864_70b4_14e0, 0x7ab5_28f7_d492_78b5_44e5_b82b_de1d_dad1),
            (0xd1e_496a_6581_5bef_be08_0ee5_f29c, 0xcc60_6af7_f7a5_6450_8cda_e644_e924_e0ef),
        ),
    ];

    #[test]
    fn what_has_no_root_in_doubles_is_left_to_f256() {
        for x in [f256::ZERO, f256::NEG_ZERO, f256::INFINITY, f256::NEG_ONE, f256::NAN, f256::MIN_GT_ZERO, f256::MAX] {
            assert_eq!(sqrt(x).to_bits(), x.sqrt().to_bits());
        }
    }
}
