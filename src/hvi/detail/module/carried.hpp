// Directions that the steps of a module carry along, as numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/integrate.hpp>

namespace hvi::detail {

/// Whether steps take directions along; see hvi::WithDirections.
template <class Stepper, class = void>
struct CarriesDirections : std::false_type {};
template <class Stepper>
struct CarriesDirections<Stepper, std::void_t<typename Stepper::Along>> : std::true_type {};

/// Directions of a stepper whose steps carry some.
template <class Stepper>
class CarriedNumbers {
public:
    using State = typename Stepper::State;
    using Scalar = typename Stepper::Scalar;

    /// Advances x by a step of size h, and so many directions along with it: their numbers stand
    /// one after the other, q and p of each. Unless the status is ok, all have kept their bits.
    [[nodiscard]] Status step(Stepper& stepper, State& x, double* numbers, std::size_t count,
                              Scalar h) {
        const std::size_t size = x.q.size() + x.p.size();
        directions_.resize(count, x);
        for (std::size_t k = 0; k < count; ++k) {
            read_numbers<Stepper>(directions_[k], numbers + k * size);
        }
        along_.take(directions_);
        const Status status = stepper.step(x, h, &along_);
        if (!status.ok()) { return status; }
        along_.give(directions_);
        for (std::size_t k = 0; k < count; ++k) {
            write_numbers<Stepper>(directions_[k], numbers + k * size);
        }
        return status;
    }

    void forget() { along_.forget(); }

private:
    typename Stepper::Along along_;
    std::vector<State> directions_;
};

}  // namespace hvi::detail
