// Stage equations whose sweeps contract as one wishes.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <hvi/detail/solvers/corrected_sweeps.hpp>
#include <hvi/state.hpp>

namespace contracting {

using Vector = std::array<double, 1>;

/// The equations Q = 1 + W, W = rate Q: a sweep changes Q by `rate` times the change of the sweep
/// before.
struct Stages {
    double rate = 0.5;
    bool goes_on = true;
    double h = 1;
    std::size_t n = 1;
    hvi::State<Vector> change;
    double Q = 0, W = 0;
    int sweeps = 0, newtons = 0;
};

template <class Stages>
struct Coupled {
    Stages& s;

    static constexpr bool separable = true;
    static constexpr bool has_q = true;
    static constexpr bool has_p = false;

    void momenta() {}
    void velocities() {}
    void positions() {
        const double before = s.Q;
        s.Q = 1 + s.W;
        s.change.q[0] = std::abs(s.Q - before);
    }
    void forces() {
        ++s.sweeps;
        s.W = s.rate * s.Q;
    }
    [[nodiscard]] double size_q(std::size_t) const { return std::abs(s.Q) + std::abs(s.W); }
};

struct CountedNewton {
    template <class>
    struct Iteration {
        template <class Coupled>
        [[nodiscard]] hvi::Status solve(Coupled coupled) const {
            ++coupled.s.newtons;
            return hvi::Status(hvi::Status::Code::ok, 1);
        }
    };
    template <class Vector>
    using Corrected = hvi::detail::CorrectedSweeps<Vector>;
};

}  // namespace contracting
