// The numerical experiments of the paper's Section 6: the degenerate Hamiltonian H = q p and the
// harmonic oscillator, each with Cheby4 (Example 4.7 (iii)) and GauLe4 (4.7 (ii)).
// SPDX-License-Identifier: MIT
//
// Prints errors, the slopes of their logarithms, and the largest errors of q, p and the energy, and
// writes the data of Figures 2 to 7 as CSV. Usage: section6 [DIRECTORY]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "chebyshev_3.hpp"
#include "gauss_2.hpp"

namespace {

using Vector = std::array<double, 1>;
using State = hvi::State<Vector>;

/// Example 6.1: H = q p.
struct Degenerate {
    using Vector = ::Vector;
    void dHdq(const Vector& /*q*/, const Vector& p, Vector& out) const { out[0] = p[0]; }
    void dHdp(const Vector& q, const Vector& /*p*/, Vector& out) const { out[0] = q[0]; }

    static double energy(const State& x) { return x.q[0] * x.p[0]; }
    static State start() { return {{2.0}, {2.0}}; }
    static State solution(double t) { return {{2 * std::exp(t)}, {2 * std::exp(-t)}}; }
};

/// Example 6.2: H = (p^2 + q^2)/2.
struct Oscillator {
    using Vector = ::Vector;
    void dHdq(const Vector& q, const Vector& /*p*/, Vector& out) const { out[0] = q[0]; }
    void dHdp(const Vector& /*q*/, const Vector& p, Vector& out) const { out[0] = p[0]; }

    static double energy(const State& x) { return (x.p[0] * x.p[0] + x.q[0] * x.q[0]) / 2; }
    static State start() { return {{2.0}, {1.0}}; }
    static State solution(double t) {
        return {{2 * std::cos(t) + std::sin(t)}, {std::cos(t) - 2 * std::sin(t)}};
    }
};

template <class System>
using Cheby4 = hvi::generated::Chebyshev3<System>;
template <class System>
using GauLe4 = hvi::generated::Gauss2<System>;

/// By what (6.2) and (6.3) multiply q in a step of H = q p.
long double factor_of_cheby4(long double h) {
    return -(((h + 10) * h + 48) * h + 96) / (((h - 10) * h + 48) * h - 96);
}
long double factor_of_gaule4(long double h) { return ((h + 6) * h + 12) / ((h - 6) * h + 12); }

/// Takes so many steps, and shows `see` the number and the state after each.
template <class System, class Stepper, class See>
State integrate(Stepper stepper, double h, int steps, See see) {
    State x = System::start();
    for (int step = 1; step <= steps; ++step) {
        const hvi::Status status = stepper.step(x, h);
        if (!status.ok()) {
            std::fprintf(stderr, "error: step %d with h = %g: %s\n", step, h, status.message());
            std::exit(1);
        }
        see(step, x);
    }
    return x;
}

struct Errors {
    double q;
    double p;
};

template <class System>
Errors errors_of(const State& x, double t) {
    const State exact = System::solution(t);
    return {x.q[0] - exact.q[0], x.p[0] - exact.p[0]};
}

template <class System, class Stepper>
Errors errors_at(double t, int steps) {
    const State x =
        integrate<System>(Stepper{System{}}, t / steps, steps, [](int, const State&) {});
    const Errors errors = errors_of<System>(x, t);
    return {std::abs(errors.q), std::abs(errors.p)};
}

/// The slope of log y over log x, by least squares.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double u = std::log(x[i]);
        const double v = std::log(y[i]);
        sx += u, sy += v, sxx += u * u, sxy += u * v;
    }
    const auto n = static_cast<double>(x.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Figures 2 and 5: errors at t = 3 for six step sizes.
template <class System>
void show_convergence(const std::string& file) {
    std::ofstream csv(file);
    csv.precision(17);
    csv << "h,cheby4_q,cheby4_p,gaule4_q,gaule4_p\n";
    std::printf("  errors at t = 3     Cheby4                GauLe4\n"
                "           h          q          p          q          p\n");
    std::vector<double> steps;
    std::array<std::vector<double>, 4> columns;
    for (const int n : {5, 10, 20, 40, 80, 160}) {
        const double h = 3.0 / n;
        const auto cheby4 = errors_at<System, Cheby4<System>>(3.0, n);
        const auto gaule4 = errors_at<System, GauLe4<System>>(3.0, n);
        const std::array row = {cheby4.q, cheby4.p, gaule4.q, gaule4.p};

        steps.push_back(h);
        for (std::size_t i = 0; i < row.size(); ++i) columns[i].push_back(row[i]);
        std::printf("  %10.5f %10.2e %10.2e %10.2e %10.2e\n", h, row[0], row[1], row[2], row[3]);
        csv << h << ',' << row[0] << ',' << row[1] << ',' << row[2] << ',' << row[3] << '\n';
    }
    std::printf("       slope %10.4f %10.4f %10.4f %10.4f\n", slope(steps, columns[0]),
                slope(steps, columns[1]), slope(steps, columns[2]), slope(steps, columns[3]));
}

/// The errors of q and p at the start and after each step.
template <class System, class Stepper>
std::vector<Errors> errors_along(double h, int steps) {
    std::vector<Errors> errors = {{0.0, 0.0}};
    integrate<System>(Stepper{System{}}, h, steps, [&](int step, const State& x) {
        errors.push_back(errors_of<System>(x, step * h));
    });
    return errors;
}

Errors largest(const std::vector<Errors>& errors) {
    Errors result{0.0, 0.0};
    for (const Errors& error : errors) {
        result.q = std::max(result.q, std::abs(error.q));
        result.p = std::max(result.p, std::abs(error.p));
    }
    return result;
}

/// Figures 3 and 6: errors of q and p along the way. Returns those of q at the end.
template <class System>
std::array<double, 2> show_errors(const std::string& file, double h, int steps) {
    const auto cheby4 = errors_along<System, Cheby4<System>>(h, steps);
    const auto gaule4 = errors_along<System, GauLe4<System>>(h, steps);
    std::ofstream csv(file);
    csv.precision(17);
    csv << "t,cheby4_q,cheby4_p,gaule4_q,gaule4_p\n";
    for (std::size_t i = 0; i < cheby4.size(); ++i)
        csv << static_cast<double>(i) * h << ',' << cheby4[i].q << ',' << cheby4[i].p << ','
            << gaule4[i].q << ',' << gaule4[i].p << '\n';
    const Errors of_cheby4 = largest(cheby4);
    const Errors of_gaule4 = largest(gaule4);
    std::printf("  largest errors, h = %g to t = %g: Cheby4 q %.2e p %.2e, GauLe4 q %.2e p %.2e\n",
                h, h * steps, of_cheby4.q, of_cheby4.p, of_gaule4.q, of_gaule4.p);
    return {cheby4.back().q, gaule4.back().q};
}

/// How far an error of q in H = q p is from the error of exact arithmetic, relative to that.
double part_of_rounding(double error, double h, int steps, long double factor) {
    // 2 (factor^n - e^t), which loses digits as it stands.
    const long double t = static_cast<long double>(h) * steps;
    const long double exact = 2 * std::exp(t) * std::expm1(steps * std::log(factor) - t);
    return static_cast<double>(std::abs(static_cast<long double>(error) / exact - 1));
}

/// The energy errors after every tenth step.
template <class System, class Stepper>
std::vector<double> energy_errors(double h, int steps) {
    std::vector<double> errors = {0.0};
    const double start = System::energy(System::start());
    integrate<System>(Stepper{System{}}, h, steps, [&](int step, const State& x) {
        if (step % 10 == 0) errors.push_back(System::energy(x) - start);
    });
    return errors;
}

double largest(const std::vector<double>& errors) {
    double result = 0;
    for (const double error : errors) result = std::max(result, std::abs(error));
    return result;
}

/// Figures 4 and 7: energy errors over a long time.
template <class System>
void show_energy(const std::string& file, double h, int steps) {
    const auto cheby4 = energy_errors<System, Cheby4<System>>(h, steps);
    const auto gaule4 = energy_errors<System, GauLe4<System>>(h, steps);
    std::ofstream csv(file);
    csv.precision(17);
    csv << "t,cheby4,gaule4\n";
    for (std::size_t i = 0; i < cheby4.size(); ++i)
        csv << 10 * static_cast<double>(i) * h << ',' << cheby4[i] << ',' << gaule4[i] << '\n';
    std::printf("  largest energy error, h = %g to t = %g: Cheby4 %.4e, GauLe4 %.1e\n", h,
                h * steps, largest(cheby4), largest(gaule4));
}

}  // namespace

int main(int argc, char** argv) {
    const std::string directory = argc > 1 ? argv[1] : ".";

    std::printf("Example 6.1: H = q p, (q, p) = (2, 2)\n");
    show_convergence<Degenerate>(directory + "/figure_2.csv");
    const auto [cheby4, gaule4] = show_errors<Degenerate>(directory + "/figure_3.csv", 0.4, 50);
    constexpr auto h = static_cast<long double>(0.4);
    std::printf("  of the error of q at t = 20 rounding makes: Cheby4 %.0e, GauLe4 %.0e\n",
                part_of_rounding(cheby4, 0.4, 50, factor_of_cheby4(h)),
                part_of_rounding(gaule4, 0.4, 50, factor_of_gaule4(h)));
    show_energy<Degenerate>(directory + "/figure_4.csv", 0.4, 1000);

    std::printf("\nExample 6.2: H = (p^2 + q^2)/2, (q, p) = (2, 1)\n");
    show_convergence<Oscillator>(directory + "/figure_5.csv");
    show_errors<Oscillator>(directory + "/figure_6.csv", 0.5, 100);
    show_energy<Oscillator>(directory + "/figure_7.csv", 0.5, 10000);
}
