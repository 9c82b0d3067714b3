/*
 * Tests your own formula against a golden file. C99 and its library only; copy it and replace line().
 *
 *     cc -std=c99 read_golden.c -lm && ./a.out golden/slider.line.json
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Numbers of the formula; those of the Jacobian are in the order of "jac": for every output and input a block, row by row. */
enum { inputs = 6, outputs = 4, entries = 24 };
struct jacobian { double n_x1[3][3], n_xn[3][3], l_x1[3], l_xn[3]; };

/* Your code: n = (xn - x1) / l and l = |xn - x1|; 0 where the input is refused. */
static int line(const double x1[3], const double xn[3], double n[3], double *l, struct jacobian *jac)
{
    double d[3], largest = 0;
    for (int i = 0; i < 3; ++i) {
        d[i] = xn[i] - x1[i];
        if (!isfinite(d[i])) return 0;
        largest = fmax(largest, fabs(d[i]));
    }
    if (largest < 2.2250738585072014e-308) return 0;
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += d[i] / largest * (d[i] / largest);
    *l = largest * sqrt(sum);
    for (int i = 0; i < 3; ++i) n[i] = d[i] / largest / sqrt(sum);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double a = n[(i + 1) % 3], b = n[(i + 2) % 3];
            jac->n_xn[i][j] = (i == j ? a * a + b * b : -n[i] * n[j]) / *l; /* 1 - n[i]^2 would cancel */
            jac->n_x1[i][j] = -jac->n_xn[i][j];
        }
    for (int j = 0; j < 3; ++j) jac->l_x1[j] = -(jac->l_xn[j] = n[j]);
    return 1;
}

/* The numbers of the object behind a key, in order, up to `most`; their count, 0 where there is no such key. */
static int numbers(const char *from, const char *end, const char *key, double x[], int most)
{
    const char *at = strstr(from, key);
    int count = 0, depth = 0;
    if (!at || at >= end) return 0;
    at += strlen(key);
    do {
        char *next = (char *)at + 1;
        if (*at == '{') ++depth;
        if (*at == '}') --depth;
        if (*at == '"') { /* a key, or what stands for a number that JSON does not have */
            next = strchr(at + 1, '"') + 1;
            if (*next != ':' && count < most)
                x[count++] = at[1] == 'N' ? NAN : at[1] == '-' ? -INFINITY : INFINITY;
        } else if ((*at == '-' || (*at >= '0' && *at <= '9')) && count < most) {
            x[count++] = strtod(at, &next);
        }
        at = next;
    } while (depth > 0 && at < end);
    return count;
}

/* The largest backward error: |mine - golden| / (u scale + 2^-1075) with u = 2^-53. */
static double eta(const double mine[], const double golden[], const double scale[], int count)
{
    double largest = 0;
    for (int k = 0; k < count; ++k) {
        const double error = fabs(mine[k] - golden[k]) / (scale[k] + 2.2250738585072014e-308) * 9007199254740992.0;
        largest = error <= largest ? largest : isnan(error) ? INFINITY : error;
    }
    return largest;
}

/* Whether one case is right. The golden numbers are rounded, too, by which eta may grow by 1. */
static int check(const char *from, const char *end, const double bound[2])
{
    double x[inputs], out[outputs], out_scale[outputs], jac[entries], jac_scale[entries], mine[outputs];
    struct jacobian own;
    if (numbers(from, end, "\"in\": ", x, inputs) != inputs) return 0;
    const int accepted = line(x, x + 3, mine, mine + 3, &own);
    if (numbers(from, end, "\"out\": ", out, outputs) != outputs) return !accepted; /* it has an "error" */
    numbers(from, end, "\"out_scale\": ", out_scale, outputs);
    if (!accepted || eta(mine, out, out_scale, outputs) > bound[0] + 1) return 0;
    if (numbers(from, end, "\"jac\": ", jac, entries) != entries) return 1; /* on a kink */
    numbers(from, end, "\"jac_scale\": ", jac_scale, entries);
    return eta((const double *)&own, jac, jac_scale, entries) <= bound[1] + 1;
}

int main(int count, char **arguments)
{
    static char text[1 << 22];
    FILE *file = fopen(count > 1 ? arguments[1] : "golden/slider.line.json", "r");
    if (!file || fread(text, 1, sizeof text - 1, file) == 0) return 2;
    fclose(file);
    double bound[2];
    int passed = 0, failed = 0;
    if (numbers(text, text + sizeof text, "\"eta\": ", bound, 2) != 2) return 2;
    for (const char *at = strstr(text, "\"id\": "), *next; at; at = next) {
        next = strstr(at + 1, "\"id\": ");
        const char *end = next ? next : at + strlen(at);
        if (check(at, end, bound)) ++passed;
        else {
            ++failed;
            printf("wrong: %.*s\n", (int)strcspn(at + 7, "\""), at + 7);
        }
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed > 0 || passed == 0;
}
