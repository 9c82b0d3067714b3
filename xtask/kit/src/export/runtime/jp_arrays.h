/*
 * Arrays that results are written to: they do not overlap with any other argument.
 * Printed by jointproof; free of conditions (CC0-1.0).
 */
#ifndef JP_ARRAYS_H
#define JP_ARRAYS_H

#if defined(__cplusplus)
#if defined(__GNUC__) || defined(_MSC_VER)
#define JP_RESTRICT __restrict
#else
#define JP_RESTRICT
#endif
#define JP_ARRAY(name, length) name[length]
#elif defined(_MSC_VER)
#define JP_RESTRICT __restrict
#define JP_ARRAY(name, length) name[length]
#else
#define JP_RESTRICT restrict
#define JP_ARRAY(name, length) name[restrict length]
#endif

#endif
