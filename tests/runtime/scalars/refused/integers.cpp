// Must not compile: there are no coefficients in integers.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>

#include <hvi/generated/gauss_2.hpp>

struct Whole {
    using Vector = std::array<long, 1>;
    void dHdq(const Vector& q, const Vector&, Vector& out) const { out = q; }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { out = p; }
};

hvi::generated::Gauss2<Whole> stepper;
