/*
 * Whether the compiler has kept the order of operations.
 * Printed by jointproof; free of conditions (CC0-1.0).
 */
#include "jointproof.h"
#include "jp_runtime.h"

/* 0; 1 if sums are reordered, 2 if a product and a sum are rounded once, 3 if NaN is taken for a
 * number. */
int jp_self_test(void)
{
    volatile double large = 9007199254740992.0, one = 1.0, beside = 1.0 + 0x1p-30, zero = 0.0;
    const double a = large, b = one, c = beside, nan = zero / zero;
    if ((a + b) - a != 0.0) return 1;
    if (c * c - (1.0 + 0x1p-29) != 0.0) return 2;
    return fabs(nan) <= DBL_MAX ? 3 : 0;
}
