/* slot.friction: as a textbook writes it. */
#include <math.h>
#include <stdio.h>

static double sign(double x) { return (x > 0) - (x < 0); }

int main(void)
{
    double f1, f2, f3, f_int, mu;
    while (scanf("%lf %lf %lf %lf %lf", &f1, &f2, &f3, &f_int, &mu) == 5) {
        if (!(mu >= 0) || !isfinite(f1 + f2 + f3 + f_int + mu)) {
            puts("refuse");
            fflush(stdout);
            continue;
        }
        double force = sqrt(f2 * f2 + f3 * f3);
        double sum = force + f_int;
        double normal = fabs(sum);
        double p = fabs(f1);
        double phi = p - mu * normal;
        double s1 = sign(f1), s = sign(sum);
        double n2 = 0, n3 = 0;
        if (force > 0) {
            n2 = f2 / force;
            n3 = f3 / force;
        }
        double jacobian[3][5] = {
            {s1, 0, 0, 0, 0},
            {0, s * n2, s * n3, s, 0},
            {s1, -mu * s * n2, -mu * s * n3, -mu * s, -normal},
        };
        printf("%.17g %.17g %.17g", p, normal, phi);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 5; j++) printf(" %.17g", jacobian[i][j]);
        putchar('\n');
        fflush(stdout);
    }
    return 0;
}
