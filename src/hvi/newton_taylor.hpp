// Fixed points with first-order corrections of the forces between evaluations.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <hvi/arithmetic.hpp>
#include <hvi/round_off.hpp>
#include <hvi/scalar.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Where dH/dq was last evaluated, what it was there, and what its derivative shares with it.
template <class System, std::size_t stages>
struct Tangents {
    std::array<typename System::Vector, stages> Q{}, Lp{};
    std::array<typename System::Tangent, stages> at{};
};

}  // namespace detail

/// Solver policy of steppers of scenes with quadratic kinetic energy. Between two evaluations of
/// dH/dq there is a sweep with dH/dq + d2H/dq2 (Q - Q_0), Q_0 being the place of the last
/// evaluation: the first term of the Neumann series of Newton's method. Fewer evaluations to the
/// same end; it pays where d2H/dq2 times a vector, and a sweep, cost much less than dH/dq. More
/// sweeps save fewer evaluations than they cost.
struct NewtonTaylor {
    static constexpr int most_iterations = 100;
    static constexpr bool takes_starting_values = true;

    template <class Vector>
    class Iteration {
    public:
        /// Preconditions: those of FixedPoint.
        template <class Coupled>
        [[nodiscard]] Status solve(Coupled coupled) {
            round_off_.begin(coupled.s.n);
            coupled.positions();  // what it changes is measured against values of no meaning
            for (int iteration = 2; iteration <= most_iterations; ++iteration) {
                coupled.forces_and_tangents();
                coupled.positions();
                switch (round_off_.template judge<true, false>(coupled.s.change, coupled)) {
                case detail::Verdict::go_on: break;
                case detail::Verdict::unchanged: return Status(Status::Code::ok, iteration);
                case detail::Verdict::at_noise:
                    coupled.forces();
                    return Status(Status::Code::ok, iteration);
                case detail::Verdict::not_finite:
                    return Status(iteration == 2 ? Status::Code::not_finite
                                                 : Status::Code::not_converged,
                                  iteration);
                }
                coupled.forces_by_tangents();
                coupled.positions();
            }
            return Status(Status::Code::not_converged, most_iterations);
        }

    private:
        detail::RoundOff<Vector> round_off_{8 * detail::epsilon<detail::ScalarOf<Vector>>};
    };
};

}  // namespace hvi
