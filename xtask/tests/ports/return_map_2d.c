/* coulomb.return_map_2d: return to the friction circle, with the consistent tangent. */
#include <math.h>
#include <stdio.h>

static void answer(double x, double y, double mu, double n)
{
    double f[2] = {x, y};
    double t[2][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}};
    double length = sqrt(x * x + y * y);
    double limit = mu * n;
    if (length >= limit) {
        double d[2] = {1, 0};
        if (length > 0) {
            d[0] = x / length;
            d[1] = y / length;
        }
        double ratio = length > 0 ? limit / length : 0;
        for (int i = 0; i < 2; i++) {
            f[i] = limit * d[i];
            for (int j = 0; j < 2; j++) t[i][j] = ratio * ((i == j) - d[i] * d[j]);
            t[i][2] = n * d[i];
            t[i][3] = mu * d[i];
        }
    }
    printf("%.17g %.17g", f[0], f[1]);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 4; j++) printf(" %.17g", t[i][j]);
    putchar('\n');
}

int main(void)
{
    double x, y, mu, n;
    while (scanf("%lf %lf %lf %lf", &x, &y, &mu, &n) == 4) {
        if (!(mu >= 0) || !(n >= 0) || !isfinite(x + y + mu + n))
            puts("refuse");
        else
            answer(x, y, mu, n);
        fflush(stdout);
    }
    return 0;
}
