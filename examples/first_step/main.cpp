// A pendulum, H = p^2/2 - cos(q), swinging for a thousand seconds with the two-stage Gauss method.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdio>

#include <hvi/generated/gauss_2.hpp>

struct Pendulum {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, const Vector& /*p*/, Vector& out) const { out[0] = std::sin(q[0]); }
    void dHdp(const Vector& /*q*/, const Vector& p, Vector& out) const { out[0] = p[0]; }
};

double energy(const hvi::State<Pendulum::Vector>& x) {
    return x.p[0] * x.p[0] / 2 - std::cos(x.q[0]);
}

int main() {
    hvi::generated::Gauss2<Pendulum> stepper{Pendulum{}};
    hvi::State<Pendulum::Vector> x{{1.5}, {0.0}};
    const double energy_at_start = energy(x);

    for (int step = 1; step <= 100'000; ++step) {
        const hvi::Status status = stepper.step(x, 0.01);
        if (!status.ok()) {
            std::fprintf(stderr, "step %d: %s\n", step, status.message());
            return 1;
        }
    }
    std::printf("q = %.12f  p = %.12f  energy error = %.1e\n", x.q[0], x.p[0],
                energy(x) - energy_at_start);
}
