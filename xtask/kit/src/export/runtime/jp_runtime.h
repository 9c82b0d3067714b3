/*
 * What the formulas call: lengths that neither overflow nor underflow, sums of products that
 * lose nothing, and the closest place of a curve.
 * Printed by jointproof; free of conditions (CC0-1.0).
 */
#ifndef JP_RUNTIME_H
#define JP_RUNTIME_H

#ifdef __FAST_MATH__
#error "-ffast-math changes the results: sums are reordered, and NaN is no longer told from numbers"
#endif

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__GNUC__)
#define JP_UNUSED __attribute__((unused))
#else
#define JP_UNUSED
#endif

/* The square root of a sum of squares that is rescaled where it would leave the range of
 * doubles. */
JP_UNUSED static double jp_norm(double sum, const double *x, int n)
{
    if (sum > 0x1p-900 && sum < 0x1p1000) return sqrt(sum);
    int large = 0;
    for (int k = 0; k < n; ++k) large = large || fabs(x[k]) > 1.0;
    const double factor = large ? 0x1p-600 : 0x1p600;
    sum = 0.0;
    for (int k = 0; k < n; ++k) sum = sum + (x[k] * factor) * (x[k] * factor);
    return sqrt(sum) / factor;
}

JP_UNUSED static double jp_norm2(double x, double y)
{
    const double all[2] = {x, y};
    return jp_norm(x * x + y * y, all, 2);
}

JP_UNUSED static double jp_norm3(double x, double y, double z)
{
    const double all[3] = {x, y, z};
    return jp_norm((x * x + y * y) + z * z, all, 3);
}

JP_UNUSED static double jp_norm4(double x, double y, double z, double w)
{
    const double all[4] = {x, y, z, w};
    return jp_norm(((x * x + y * y) + z * z) + w * w, all, 4);
}

/* z P(z), in parts that do not wait for each other. */
JP_UNUSED static double jp_beyond(const double *p, double z)
{
    const double z2 = z * z, z4 = z2 * z2;
    const double p0 = (p[0] + p[1] * z) + (p[2] + p[3] * z) * z2;
    const double p4 = (p[4] + p[5] * z) + (p[6] + p[7] * z) * z2;
    const double p8 = (p[8] + p[9] * z) + (p[10] + p[11] * z) * z2;
    return z * ((p0 + p4 * z4) + p8 * (z4 * z4));
}

/* The angle of (x, y): beside the nearest sixteenth of a turn the arc tangent is a polynomial. */
JP_UNUSED static double jp_angle(double y, double x)
{
    static const double p[12] = {
        -0.3333333333333333, 0.19999999999999804, -0.1428571428565978,
        0.11111111105150588, -0.09090908753259112, 0.07692296368042296,
        -0.0666642476020052, 0.05878927554473807, -0.05230443640686948,
        0.045515447340221615, -0.03456931506332609, 0.016284375050043393};
    const double across = fabs(y), along = fabs(x);
    const double large = across > along ? across : along;
    const double small = along < across ? along : across;
    if (!(large > 0.0 && large < 1e300)) return atan2(y, x);
    const double steep = across > along ? 1.0 : 0.0, back = x < 0.0 ? 1.0 : 0.0;
    const double wide = small > 0.41421356237309503 * large ? 1.0 : 0.0;
    const double t = (small - large * wide) / (large + small * wide);
    const double rest = t * jp_beyond(p, t * t);
    const double way = (1.0 - 2.0 * steep) * (1.0 - 2.0 * back);
    const double eighths = (2.0 * steep + (4.0 * back) * (1.0 - steep)) + way * wide;
    const double low = (way * eighths) * 3.061616997868383e-17;
    return copysign(eighths * 0.7853981633974483 + way * (t + (rest + low)), y);
}

/* The arc sine: up to 1/2 a polynomial, beyond what twice another one leaves of a quarter turn. */
JP_UNUSED static double jp_asin(double x)
{
    static const double p[12] = {
        0.16666666666665653, 0.0750000000029469, 0.04464285685604654,
        0.030381958187905646, 0.022371777525770062, 0.017359447897278054,
        0.013887491270956195, 0.012155871500411723, 0.006580488107098665,
        0.01939632260033307, -0.016032766254421116, 0.03179011988382487};
    const double size = fabs(x), missing = (1.0 - size) * 0.5;
    const int wide = size > 0.5;
    const double z = wide ? missing : size * size, s = wide ? sqrt(missing) : size;
    const double turn = wide ? 1.5707963267948966 : 0.0, way = wide ? -2.0 : 1.0;
    const double rest = s * jp_beyond(p, z) - (wide ? 3.061616997868383e-17 : 0.0);
    const double sum = turn + way * s, lost = (turn - sum) + way * s;
    return copysign(sum + (lost + way * rest), x);
}

/* e^x - 1: with x = k ln 2 + r it is 2^k (e^r - 1) + (2^k - 1), and e^r - 1 is r and a
 * polynomial. */
JP_UNUSED static double jp_expm1(double x)
{
    static const double p[12] = {
        0.5, 0.16666666666666666, 0.04166666666666667, 0.008333333333333333,
        0.0013888888888883748, 0.00019841269841266415, 2.4801587325547743e-05,
        2.7557319239957097e-06, 2.75572736431103e-07, 2.5052078002329456e-08,
        2.0914686968086876e-09, 1.6084327883952603e-10};
    if (!(fabs(x) > 1e-300 && fabs(x) < 700.0)) return expm1(x);
    const double shifted = x * 1.4426950408889634 + 0x1.8p52, k = shifted - 0x1.8p52;
    const double above = x - k * 0.6931471803691238, below = k * 1.9082149292705877e-10;
    const double r = above - below;
    const double power = ldexp(1.0, (int)k);
    const double more = power * r, most = power - 1.0, sum = most + more;
    const double lost = power * ((above - r) - below) + ((most - sum) + more);
    return sum + (more * jp_beyond(p, r) + lost);
}

/* The largest power of two that is not above a positive number, within 2^-1022 and 2^1022. */
JP_UNUSED static double jp_power_of_two(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits &= UINT64_C(0x7ff0000000000000);
    if (bits > UINT64_C(0x7fd0000000000000)) bits = UINT64_C(0x7fd0000000000000);
    memcpy(&x, &bits, sizeof bits);
    return x;
}

/* An exact sum, kept as parts that do not overlap, smaller ones first, none of them 0
 * (Shewchuk). */
typedef struct {
    double part[144];
    int n;
} jp_expansion;

JP_UNUSED static void jp_add(jp_expansion *sum, double x)
{
    int kept = 0;
    double carried = x;
    if (x == 0.0) return;
    for (int k = 0; k < sum->n; ++k) {
        const double a = carried, b = sum->part[k];
        const double high = a + b;
        const double b_part = high - a;
        const double low = (a - (high - b_part)) + (b - b_part);
        carried = high;
        if (low != 0.0) sum->part[kept++] = low;
    }
    if (carried != 0.0) sum->part[kept++] = carried;
    sum->n = kept;
}

/* Dekker's product, with Veltkamp's splitting. */
JP_UNUSED static void jp_add_product(jp_expansion *sum, double a, double b)
{
    if (a == 0.0 || b == 0.0) return;
    const double high = a * b;
    const double a_large = a * 134217728.0 + a, b_large = b * 134217728.0 + b;
    const double a1 = a_large - (a_large - a), b1 = b_large - (b_large - b);
    const double a2 = a - a1, b2 = b - b1;
    const double low = a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2);
    jp_add(sum, low);
    jp_add(sum, high);
}

/* A sum of products of four numbers each: nothing is rounded but the sum in the end. */
JP_UNUSED static double jp_exact_sum(int n, const double product[][4])
{
    jp_expansion sum = {{0.0}, 0};
    double value = 0.0;
    for (int k = 0; k < n; ++k) {
        jp_expansion two = {{0.0}, 0}, three = {{0.0}, 0};
        jp_add_product(&two, product[k][0], product[k][1]);
        for (int i = 0; i < two.n; ++i) jp_add_product(&three, two.part[i], product[k][2]);
        for (int i = 0; i < three.n; ++i) jp_add_product(&sum, three.part[i], product[k][3]);
    }
    for (int i = 0; i < sum.n; ++i) value = value + sum.part[i];
    return value;
}

/* A polynomial, its constant term first, and its slope: Horner's scheme. */
JP_UNUSED static double jp_polynomial(const double *p, int n, double u, double *slope)
{
    double value = 0.0;
    *slope = 0.0;
    for (int k = n - 1; k >= 0; --k) {
        *slope = *slope * u + value;
        value = value * u + p[k];
    }
    return value;
}

/* The place between two others where a polynomial without an extremum there changes sign: by
 * Newton's method where that halves the step, else by halving the interval. */
JP_UNUSED static double jp_crossing(
    const double *p, int n, double from, double to, double low, double high)
{
    double u = from + (to - from) * 0.5, step = to - from, slope;
    int looked_for_short = 0;
    if (high == 0.0) return to;
    for (int k = 0; k < 1200; ++k) {
        const double value = jp_polynomial(p, n, u, &slope);
        if (value == 0.0) return u;
        if ((value > 0.0) == (low > 0.0)) from = u;
        else to = u;
        const double newton = u - value / slope;
        const int halves = fabs(newton - u) <= fabs(step) * 0.5;
        const int good = from < newton && newton < to && halves;
        const double next = good ? newton : from + (to - from) * 0.5;
        step = next - u;
        if (step == 0.0 || next == from || next == to) return next;
        u = next;
        if (!looked_for_short && fabs(step) < 0x1p-40) {
            const double shorter = round(u * 0x1p20) * 0x1p-20;
            looked_for_short = 1;
            if (jp_polynomial(p, n, shorter, &slope) == 0.0) return shorter;
        }
    }
    return u;
}

/* The places between two others where a polynomial falls through zero, or changes sign either
 * way; those of its derivative part them. Its values at the two are given. Returns how many
 * there are. */
JP_UNUSED static int jp_crossings(
    const double *p, int n, const double ends[2], const double values[2], int falls,
    double place[5])
{
    double inner[5] = {0.0}, slope;
    int parts = 0, found = 0;
    while (n > 0 && p[n - 1] == 0.0) --n;
    if (n > 2) {
        double rate[5];
        int m = n - 1;
        for (int k = 0; k < m; ++k) rate[k] = p[k + 1] * (k + 1);
        while (m > 0 && rate[m - 1] == 0.0) --m;
        const double rates[2] = {
            jp_polynomial(rate, m, ends[0], &slope), jp_polynomial(rate, m, ends[1], &slope)};
        parts = jp_crossings(rate, m, ends, rates, 0, inner);
    }
    double from = ends[0], low = values[0];
    for (int k = 0; k <= parts; ++k) {
        const double to = k < parts ? inner[k] : ends[1];
        const double high = k < parts ? jp_polynomial(p, n, to, &slope) : values[1];
        const int changes = (low < 0.0) != (high < 0.0);
        const int sinks = low > 0.0 && (k < parts ? high <= 0.0 : high < 0.0);
        if (falls ? sinks : changes) place[found++] = jp_crossing(p, n, from, to, low, high);
        from = to;
        low = high;
    }
    return found;
}

/* c Y(u) along one axis, with the coefficients of u, u^2, u^3 in Y. */
JP_UNUSED static double jp_reach(double y1, double y2, double y3, double factor, double u)
{
    return (((y3 * u + y2) * u + y1) * u) * factor;
}

/* The closest place of a curve X(0) + c Y(u) between two coordinates, given the gap xs - X(0)
 * and the residuals (xs - X).Y' at the two, by which either one of them counts or a root
 * between them is found. A number before the first coordinate stands for that end, one behind
 * the last for the other. */
JP_UNUSED static double jp_nearest_place(
    double gx, double gy, double factor, double x1, double y1, double x2, double y2, double x3,
    double y3, double from, double to, double low, double high)
{
    const double p[6] = {
        gx * x1 + gy * y1,
        (gx * x2 + gy * y2) * 2.0 - factor * (x1 * x1 + y1 * y1),
        ((gx * x3 + gy * y3) - factor * (x1 * x2 + y1 * y2)) * 3.0,
        -((factor * ((x1 * x3 + y1 * y3) * 2.0 + (x2 * x2 + y2 * y2))) * 2.0),
        -((factor * (x2 * x3 + y2 * y3)) * 5.0),
        -((factor * (x3 * x3 + y3 * y3)) * 3.0)};
    const double ends[2] = {from, to}, residuals[2] = {low, high};
    double place[7], inside[5];
    int is_end[7] = {0}, n = 0, best = 0;
    if (low <= 0.0) {
        is_end[n] = 1;
        place[n++] = from;
    }
    const int roots = jp_crossings(p, 6, ends, residuals, 1, inside);
    for (int k = 0; k < roots; ++k) place[n++] = inside[k];
    if (high >= 0.0 || n == 0) {
        is_end[n] = 1;
        place[n++] = to;
    }
    for (int k = 1; k < n; ++k) {
        /* |G_u|^2 - |G_v|^2 = (G_u - G_v).(G_u + G_v), against what rounding does to it. */
        const double ux = jp_reach(x1, x2, x3, factor, place[k]);
        const double uy = jp_reach(y1, y2, y3, factor, place[k]);
        const double vx = jp_reach(x1, x2, x3, factor, place[best]);
        const double vy = jp_reach(y1, y2, y3, factor, place[best]);
        const double step_x = vx - ux, step_y = vy - uy, twice_x = gx * 2.0, twice_y = gy * 2.0;
        const double excess = step_x * (twice_x - (ux + vx)) + step_y * (twice_y - (uy + vy));
        const double size_x = (fabs(twice_x) + fabs(ux)) + fabs(vx);
        const double size_y = (fabs(twice_y) + fabs(uy)) + fabs(vy);
        const double blur = (fabs(step_x) * size_x + fabs(step_y) * size_y) * 0x1p-48;
        if (excess < -blur) best = k;
    }
    if (!is_end[best]) return place[best];
    return place[best] == from ? from - 1.0 : to + 1.0;
}

#endif
