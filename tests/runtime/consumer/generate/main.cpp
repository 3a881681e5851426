// Takes a step with each stepper.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>

#include "deep/fitted.hpp"
#include "mine.hpp"
#include "verlet.hpp"

using Vector = std::array<double, 1>;

struct Separable {
    using Vector = ::Vector;
    void dHdq(const Vector& q, Vector& out) const { out = q; }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
};

struct General {
    using Vector = ::Vector;
    void dHdq(const Vector& q, const Vector&, Vector& out) const { out = q; }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};

template <class Stepper>
bool steps(Stepper stepper) {
    hvi::State<Vector> x{{1.0}, {0.0}};
    return stepper.step(x, 0.1).ok() && x.q[0] < 1 && x.p[0] < 0;
}

int main() {
    using namespace hvi::generated;
    const bool all = steps(Verlet<Separable>{Separable{}}) && steps(Fitted<General>{General{}}) &&
                     steps(Mine<General>{General{}});
    return all ? 0 : 1;
}
