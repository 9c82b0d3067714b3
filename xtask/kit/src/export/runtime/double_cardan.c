/*
 * A double cardan shaft by Newton's method with the exported element UJOINT: an intermediate shaft,
 * inclined by 40 degrees, between a driving and a driven shaft, which are parallel. The driving one
 * is turned; a torque acts on the driven one, whose elastic bearing pushes it against the others.
 * Unknowns are translation and spin of the intermediate shaft, translation and turn of the driven
 * one, and four multipliers of each joint.
 *
 *     make double_cardan && ./double_cardan
 *
 * The yokes of the intermediate shaft are in phase, so both shafts turn alike. From step to step
 * the error is squared. The exit code is 0 if both are so.
 * Printed by jointproof; free of conditions (CC0-1.0).
 */
#include "jointproof.h"
#include <math.h>
#include <stdio.h>

enum { MOTIONS = 10, HELD = 4, ALL = MOTIONS + 2 * HELD, INCREMENTS = 24 };

static const double PI = 3.141592653589793, LENGTH = 2.0, TORQUE = 5.0, BEARING = 50.0;
static const double UNIT[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, NONE[3] = {0, 0, 0};

/* The axes of a shaft, and the place of its node. */
struct Shaft { double axes[3][3], x[3]; };

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0, i = 1, j = 2; k < 3; i = j, j = k++) c[k] = a[i] * b[j] - a[j] * b[i];
}

/* Turns axes by a rotation vector. */
static void turn(double axes[3][3], const double by[3])
{
    const double angle = sqrt(by[0] * by[0] + by[1] * by[1] + by[2] * by[2]);
    if (angle == 0.0) return;
    const double sine = sin(angle) / angle, half = sin(angle / 2) / angle;
    for (int k = 0; k < 3; ++k) {
        double once[3], twice[3];
        cross(by, axes[k], once);
        cross(by, once, twice);
        for (int i = 0; i < 3; ++i) axes[k][i] += sine * once[i] + 2 * half * half * twice[i];
    }
}

/* A shaft along the second axis, turned about it. */
static struct Shaft shaft(const double x[3], double angle)
{
    struct Shaft found = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {x[0], x[1], x[2]}};
    const double by[3] = {0, angle, 0};
    turn(found.axes, by);
    return found;
}

/* Adds a joint between a and the end of an arm of b. By a unit of the unknown q the degrees of
 * freedom of its nodes move by motions[q]. Gives the torque on a. */
static int add(const struct Shaft *a, const struct Shaft *b, const double arm[3],
               double motions[MOTIONS][12], const double *lambda, int held,
               double system[ALL][ALL + 1], double *torque)
{
    const double end[3] = {b->x[0] + arm[0], b->x[1] + arm[1], b->x[2] + arm[2]};
    double residuals[HELD], rows[HELD * 12], forces[12], stiffness[144], by_multipliers[12 * HELD];
    const int code = jp_element_ujoint_smooth_step(
        a->axes[0], a->axes[1], a->axes[2], b->axes[0], b->axes[1], b->axes[2], a->x, end,
        lambda[held], lambda[held + 1], lambda[held + 2], lambda[held + 3], NONE, 0, 0, 0,
        residuals, rows, forces, stiffness, by_multipliers);
    for (int q = 0; q < MOTIONS; ++q)
        for (int i = 0; i < 12; ++i) {
            double *row = system[q], motion = motions[q][i];
            row[ALL] -= motion * forces[i];
            for (int p = 0; p < MOTIONS * 12; ++p)
                row[p / 12] += motion * stiffness[12 * i + p % 12] * motions[p / 12][p % 12];
            for (int m = 0; m < HELD; ++m) {
                row[MOTIONS + held + m] += motion * by_multipliers[HELD * i + m];
                system[MOTIONS + held + m][q] += rows[12 * m + i] * motion;
            }
        }
    for (int m = 0; m < HELD; ++m) system[MOTIONS + held + m][ALL] = -residuals[m];
    /* The force at the end of the arm has another moment as the arm turns. */
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            double once[3], twice[3];
            cross(UNIT[j], arm, once);
            cross(UNIT[k], once, twice);
            for (int i = 0; i < 3; ++i) system[3 + k][3 + j] += twice[i] * forces[6 + i];
        }
    *torque = forces[4];
    return code;
}

/* Gauss's elimination: the right-hand side is the last column, then the solution. */
static void solve(double a[ALL][ALL + 1])
{
    for (int k = 0; k < ALL; ++k) {
        int pivot = k;
        for (int i = k; i < ALL; ++i)
            if (fabs(a[i][k]) > fabs(a[pivot][k])) pivot = i;
        for (int j = ALL; j >= 0; --j) {
            const double x = a[pivot][j];
            a[pivot][j] = a[k][j];
            a[k][j] = x;
        }
        for (int j = ALL; j >= k; --j) a[k][j] /= a[k][k];
        for (int i = 0; i < ALL; ++i)
            for (int j = ALL; i != k && j >= k; --j) a[i][j] -= a[i][k] * a[k][j];
    }
}

int main(void)
{
    struct Shaft middle = shaft(NONE, 0);
    const double inclined[3] = {2 * PI / 9, 0, 0};
    turn(middle.axes, inclined);
    double lambda[2 * HELD] = {0}, angle = 0, x[3] = {0}, step[ALL];
    for (int k = 0; k < 3; ++k) x[k] = LENGTH * middle.axes[1][k];
    const double bearing[3] = {x[0], x[1] - 0.25, x[2]};
    int failed = jp_self_test();
    for (int increment = 0; increment <= INCREMENTS; ++increment) {
        const double input = 2 * PI * increment / INCREMENTS;
        double before = 1, size = 1, torque[2] = {0, 0};
        int steps = 0;
        for (; size > 1e-12 && steps < 20; ++steps) {
            const struct Shaft driving = shaft(NONE, input), driven = shaft(x, angle);
            double system[ALL][ALL + 1] = {{0}}, arm[3], motions[2][MOTIONS][12] = {{{0}}};
            for (int k = 0; k < 3; ++k) arm[k] = LENGTH * middle.axes[1][k];
            for (int k = 0; k < 6; ++k) motions[0][k][6 + k] = motions[1][k][6 + k] = 1;
            for (int k = 0; k < 3; ++k) cross(UNIT[k], arm, motions[1][3 + k] + 6);
            for (int k = 0; k < 3; ++k) motions[1][6 + k][k] = 1;
            motions[1][9][4] = 1;
            failed |= add(&driving, &middle, NONE, motions[0], lambda, 0, system, torque);
            failed |= add(&driven, &middle, arm, motions[1], lambda, HELD, system, torque + 1);
            for (int k = 0; k < 3; ++k) {
                system[6 + k][6 + k] -= BEARING;
                system[6 + k][ALL] += BEARING * (x[k] - bearing[k]);
            }
            system[9][ALL] += TORQUE;
            solve(system);
            before = size, size = 0;
            for (int k = 0; k < ALL; ++k) size = fmax(size, fabs(step[k] = system[k][ALL]));
            for (int k = 0; k < 3; ++k) middle.x[k] += step[k], x[k] += step[6 + k];
            turn(middle.axes, step + 3);
            angle += step[9];
            for (int k = 0; k < 2 * HELD; ++k) lambda[k] += step[MOTIONS + k];
            failed |= before < 0.1 && size > 10 * before * before + 1e-12;
        }
        printf("%6.1f %6.1f degrees, torque %9.6f, %d steps, the last two %.1e %.1e\n",
               input * 180 / PI, angle * 180 / PI, -torque[0], steps, before, size);
        failed |= steps == 20 || fabs(angle - input) > 1e-12 || fabs(torque[0] + TORQUE) > 1e-10;
    }
    return failed;
}
