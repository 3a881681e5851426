// Two-stage Gauss of a scene against rk4imp of the GNU Scientific Library, the same method.
// SPDX-License-Identifier: MIT
//
// Kepler's problem up to t = 100. rk4imp takes each step a second time as two halves, to estimate
// the error, and goes on from those. It is given steps of twice our size, and so both end with the
// same error, which the program checks to 1 % before it times them.

#include <benchmark/benchmark.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <gsl/gsl_odeiv2.h>
#include <hvi/state.hpp>

#include "report.hpp"
#include "scene/gauss_2_kepler.hpp"

namespace {

using Stepper = hvi::generated::Gauss2Kepler;

constexpr double until = 100.0;
constexpr int steps = 20000;  // of ours; half as many of rk4imp

/// The distance of q(until) from the orbit's: x = cos E - e, y = sqrt(1 - e^2) sin E, where
/// E - e sin E = t.
double error_of(double x, double y) {
    constexpr double e = 0.6;
    double E = until;
    for (int i = 0; i < 100; ++i) { E -= (E - e * std::sin(E) - until) / (1.0 - e * std::cos(E)); }
    return std::hypot(x - (std::cos(E) - e), y - std::sqrt(1.0 - e * e) * std::sin(E));
}

double error_of_generated() {
    Stepper stepper;
    Stepper::State x = Stepper::initial();
    for (int i = 0; i < steps; ++i) {
        const hvi::Status status = stepper.step(x, until / steps);
        if (!status.ok()) { throw std::runtime_error(status.message()); }
    }
    return error_of(x.q[0], x.q[1]);
}

/// y is (x, y, px, py).
int right_side(double, const double y[], double f[], void*) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double scale = -1.0 / (r2 * std::sqrt(r2));
    f[0] = y[2];
    f[1] = y[3];
    f[2] = scale * y[0];
    f[3] = scale * y[1];
    return GSL_SUCCESS;
}

int jacobian(double, const double y[], double* dfdy, double dfdt[], void*) {
    const double r2 = y[0] * y[0] + y[1] * y[1];
    const double scale = 1.0 / (r2 * std::sqrt(r2));
    std::fill_n(dfdy, 16, 0.0);
    std::fill_n(dfdt, 4, 0.0);
    dfdy[0 * 4 + 2] = 1.0;
    dfdy[1 * 4 + 3] = 1.0;
    dfdy[2 * 4 + 0] = scale * (3.0 * y[0] * y[0] / r2 - 1.0);
    dfdy[2 * 4 + 1] = scale * (3.0 * y[0] * y[1] / r2);
    dfdy[3 * 4 + 0] = dfdy[2 * 4 + 1];
    dfdy[3 * 4 + 1] = scale * (3.0 * y[1] * y[1] / r2 - 1.0);
    return GSL_SUCCESS;
}

double error_of_gsl() {
    constexpr double tolerance = 1e-8;  // of Newton's method: ten times more and the error grows
    constexpr double h = 2.0 * until / steps;
    gsl_odeiv2_system system{right_side, jacobian, 4, nullptr};
    gsl_odeiv2_driver* driver =
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk4imp, h, tolerance, 0.0);
    const Stepper::State start = Stepper::initial();
    double y[4] = {start.q[0], start.q[1], start.p[0], start.p[1]};
    double errors[4];
    int status = GSL_SUCCESS;
    for (int i = 0; i < steps / 2 && status == GSL_SUCCESS; ++i) {
        status = gsl_odeiv2_step_apply(driver->s, i * h, h, y, errors, nullptr, nullptr, &system);
    }
    gsl_odeiv2_driver_free(driver);
    if (status != GSL_SUCCESS) { throw std::runtime_error(gsl_strerror(status)); }
    return error_of(y[0], y[1]);
}

/// run() gives its error.
template <double (*run)()>
void time(benchmark::State& state) {
    double error = 0.0;
    for (auto _ : state) {
        error = run();
        benchmark::ClobberMemory();
    }
    state.counters["error"] = error;
}

}  // namespace

int main(int argc, char** argv) {
    const double ours = error_of_generated();
    const double theirs = error_of_gsl();
    if (std::abs(ours / theirs - 1.0) > 0.01) {
        std::fprintf(stderr, "error: our error is %.3e, that of rk4imp %.3e\n", ours, theirs);
        return 1;
    }
    benchmark::RegisterBenchmark("gauss_2_kepler", time<error_of_generated>);
    benchmark::RegisterBenchmark("rk4imp_of_gsl", time<error_of_gsl>);
    return bench::time_all(argc, argv, {{"rk4imp_of_gsl", "gauss_2_kepler", "at least 15"}});
}
