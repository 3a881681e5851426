// The parameters and steps of the trajectories of an ensemble.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hvi::detail {

/// The wish that nobody sees steps.
struct NoWatch {};

/// Lists with a place for each trajectory, or with one for all.
template <class Stepper>
class Courses {
public:
    using Parameters = typename Stepper::Parameters;
    using Scalar = typename Stepper::Scalar;

    Courses(const std::vector<Parameters>& parameters, const std::vector<Scalar>& h,
            const std::vector<std::int64_t>& steps)
        : parameters_(parameters), h_(h), steps_(steps) {}

    [[nodiscard]] bool has_own_parameters() const { return parameters_.size() > 1; }
    [[nodiscard]] const Parameters& parameters(std::size_t i) const { return of(parameters_, i); }
    [[nodiscard]] Scalar h(std::size_t i) const { return of(h_, i); }
    [[nodiscard]] std::int64_t steps(std::size_t i) const { return of(steps_, i); }

private:
    template <class T>
    static const T& of(const std::vector<T>& list, std::size_t i) {
        return list[list.size() > 1 ? i : 0];
    }

    const std::vector<Parameters>& parameters_;
    const std::vector<Scalar>& h_;
    const std::vector<std::int64_t>& steps_;
};

}  // namespace hvi::detail
