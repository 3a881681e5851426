// A stiff spring and a slow oscillation that pulls at it, in steps that are not small against the
// period of the spring: Gauss' method of three stages, and the method with the same nodes whose
// basis 1, cos(w tau), sin(w tau) is fitted to the spring by w = omega h.
// SPDX-License-Identifier: MIT
//
// Prints the error of both at t = 6, for steps of size h, and returns 1 unless the fitted method is
// the better one by a factor of ten up to omega h = 1.5.
#include <array>
#include <cmath>
#include <cstdio>

#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/newton.hpp>

#include "fitted_gauss.hpp"

namespace {

constexpr double omega = 50;

/// H = (p_1^2 + p_2^2)/2 + q_1^2/2 + omega^2 q_2^2/2 + q_1^2 q_2.
struct Spring {
    using Vector = std::array<double, 2>;
    void dHdq(const Vector& q, const Vector& /*p*/, Vector& out) const {
        out = {q[0] + 2 * q[0] * q[1], omega * omega * q[1] + q[0] * q[0]};
    }
    void dHdp(const Vector& /*q*/, const Vector& p, Vector& out) const { out = p; }
    void d2Hdq2(const Vector& q, const Vector& /*p*/, Eigen::MatrixXd& out) const {
        out(0, 0) = 1 + 2 * q[1];
        out(0, 1) = out(1, 0) = 2 * q[0];
        out(1, 1) = omega * omega;
    }
    void d2Hdqdp(const Vector& /*q*/, const Vector& /*p*/, Eigen::MatrixXd& /*out*/) const {}
    void d2Hdp2(const Vector& /*q*/, const Vector& /*p*/, Eigen::MatrixXd& out) const {
        out.setIdentity();
    }
};

using State = hvi::State<Spring::Vector>;

/// The state after so many steps; not a number where one fails.
template <class Stepper>
State integrate(Stepper stepper, double h, int steps) {
    State x{{1, 1 / omega}, {0, 1}};
    for (int step = 0; step < steps; ++step) {
        const hvi::Status status = stepper.step(x, h);
        if (!status.ok()) {
            std::fprintf(stderr, "error: h = %g: %s\n", h, status.message());
            return {{NAN, NAN}, {NAN, NAN}};
        }
    }
    return x;
}

/// The distance over all variables; those of the spring count as its amplitude.
double distance(const State& x, const State& y) {
    const double slow = std::hypot(x.q[0] - y.q[0], x.p[0] - y.p[0]);
    return std::hypot(slow, omega * (x.q[1] - y.q[1]), x.p[1] - y.p[1]);
}

}  // namespace

int main() {
    using hvi::generated::FittedGauss;
    using Gauss = hvi::generated::Gauss3<Spring, hvi::Newton>;
    using Accurate = hvi::generated::Gauss4<Spring, hvi::Newton>;
    constexpr double turns = 300;  // until t = turns/omega = 6
    constexpr int steps_of_accurate = 6000;
    const State exact = integrate(Accurate(), turns / omega / steps_of_accurate, steps_of_accurate);
    bool good = true;
    std::puts("omega h   steps   error of gauss:3   fitted");
    for (const double w : {0.25, 0.5, 1.0, 1.5, 2.0}) {
        const int steps = static_cast<int>(std::round(turns / w));
        const double h = w / omega;
        const double plain = distance(integrate(Gauss(), h, steps), exact);
        const FittedGauss<Spring, hvi::Newton> stepper(Spring(), w);
        const double fitted = distance(integrate(stepper, h, steps), exact);
        std::printf("%7.2f   %5d   %16.1e   %6.1e\n", w, steps, plain, fitted);
        good = good && (w > 1.5 || 10 * fitted < plain);
    }
    return good ? 0 : 1;
}
