/* A program in C99: half an orbit of a planet, and a table of it.
 * SPDX-License-Identifier: GPL-2.0-or-later */
#include <kepler.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(int is_right, const char* what) {
    if (is_right) { return; }
    ++failures;
    printf("wrong: %s\n", what);
}

int main(void) {
    const double ecc = 0.5, pi = 3.14159265358979323846;
    const double parameters[2] = {1.0, 0.5};
    enum { rows = 4, steps = 400 };
    kepler_stepper* planet = NULL;
    double x[4], energy = 0, momentum = 0, table[rows][3];
    size_t written = 0;

    check(kepler_abi_version() == 1, "version");
    check(strcmp(kepler_name(kepler_parameter, 1), "ecc") == 0, "name of a parameter");
    check(kepler_create(parameters, 2, &planet) == 0, "create");
    check(kepler_dof(planet) == 2 && kepler_size(planet) == 4, "sizes");
    check(kepler_initial(planet, x) == 0 && x[0] == 1 - ecc, "initial");
    check(kepler_integrate(planet, x, 0, pi / steps, steps, steps / rows, "t, x, energy", table[0],
                           rows, &written) == 0,
          "integrate");
    check(written == rows, "rows");
    /* Kepler: after half a period 2 pi it is farthest from the sun. */
    check(fabs(x[0] + 1 + ecc) < 1e-12 && fabs(x[1]) < 1e-12, "half an orbit");
    check(fabs(table[rows - 1][0] - pi) < 1e-14 && table[rows - 1][1] == x[0], "the last row");
    check(kepler_energy(planet, x, &energy) == 0 && fabs(energy + 0.5) < 1e-14, "energy");
    check(energy == table[rows - 1][2], "energy of a row");
    check(kepler_invariants(planet, x, &momentum) == 0, "invariants");
    check(fabs(momentum - sqrt(1 - ecc * ecc)) < 1e-14, "angular momentum");
    check(kepler_step(planet, NULL, 0.1) != 0, "a null pointer");
    check(kepler_destroy(planet) == 0, "destroy");
    check(kepler_destroy(planet) != 0, "a handle twice");
    check(strlen(kepler_status_text(kepler_step(planet, x, 0.1))) > 10, "text of a status");
    return failures;
}
