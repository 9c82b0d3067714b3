/*
 * Formulas with their Jacobians, and elements, printed by jointproof from the program that it
 * proves.
 *
 * ..._value gives the outputs; ..._jacobian, where it is in closed form, the outputs and
 * every derivative, output by output, each over all inputs in order; ..._step all results of
 * an element, matrices row by row. A return code is 0, or says why inputs are refused, as each
 * header tells; nothing is written then. A result that is too large for a double is infinite.
 *
 * Compile as C99 or as C++17, without fused operations and without -ffast-math:
 * -ffp-contract=off, and -fp-model=precise for Intel's compilers, whose default reorders sums.
 * jp_self_test gives 0 if the compiler has kept the order of operations.
 */
#ifndef JOINTPROOF_H
#define JOINTPROOF_H

#ifdef __cplusplus
extern "C" {
#endif
int jp_self_test(void);
#ifdef __cplusplus
}
#endif

{includes}
#endif
