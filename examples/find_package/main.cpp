// A mass on a spring, H = p^2/2 + q^2/2, with the explicit Stormer-Verlet method.
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>

#include <hvi/generated/stormer_verlet_separable.hpp>

struct Spring {
    using Vector = std::array<double, 1>;
    void dHdq(const Vector& q, Vector& out) const { out = q; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};

int main() {
    hvi::generated::StormerVerletSeparable<Spring> stepper{Spring{}};
    hvi::State<Spring::Vector> x{{1.0}, {0.0}};
    for (int step = 0; step < 628; ++step) {
        if (const hvi::Status status = stepper.step(x, 0.01); !status.ok()) return 1;
    }
    std::printf("after one turn: q = %.6f  p = %.6f\n", x.q[0], x.p[0]);
}
