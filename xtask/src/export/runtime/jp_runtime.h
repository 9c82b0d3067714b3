/*
 * What the formulas call: lengths that neither overflow nor underflow, and sums of products that
 * lose nothing. Printed by jointproof; free of conditions (CC0-1.0).
 */
#ifndef JP_RUNTIME_H
#define JP_RUNTIME_H

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__GNUC__)
#define JP_UNUSED __attribute__((unused))
#else
#define JP_UNUSED
#endif

/* The square root of a sum of squares that is rescaled where it would leave the range of doubles. */
JP_UNUSED static double jp_norm(const double *x, int n)
{
    double sum = 0.0;
    for (int k = 0; k < n; ++k) sum = sum + x[k] * x[k];
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
    return jp_norm(all, 2);
}

JP_UNUSED static double jp_norm3(double x, double y, double z)
{
    const double all[3] = {x, y, z};
    return jp_norm(all, 3);
}

JP_UNUSED static double jp_norm4(double x, double y, double z, double w)
{
    const double all[4] = {x, y, z, w};
    return jp_norm(all, 4);
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

/* An exact sum, kept as parts that do not overlap, smaller ones first, none of them 0 (Shewchuk). */
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

#endif
