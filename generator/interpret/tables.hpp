// Coefficients of a step as the doubles of its header.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/exact/numbers/formats.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

using Doubles = std::vector<double>;
using DoubleMatrix = std::vector<Doubles>;

[[nodiscard]] double as_double(const Rounded& value);
[[nodiscard]] Doubles as_doubles(const std::vector<Rounded>& values);
[[nodiscard]] DoubleMatrix as_doubles(const RoundedMatrix& values);

/// Return the weights of stage values, and the c_i of stages where H depends on the time.
[[nodiscard]] Doubles weights_of(const std::vector<StageValue>& values);
[[nodiscard]] Doubles times_of(const Step& step);

/// Returns a table for the extrapolation of starting values.
[[nodiscard]] DoubleMatrix rough_doubles(const NumberMatrix& exact);

/// A sum of coefficients times vectors, in the order of the vectors. NOTE: coefficients that are 0
/// are left out, as in a header.
class WeightedSum {
public:
    /// `values` are the coefficients in doubles.
    WeightedSum(const NumberVector& exact, const Doubles& values);

    /// Returns component k of first + coefficient * vector + ...
    [[nodiscard]] double from(double first, const DoubleMatrix& vectors, std::size_t k) const {
        for (const auto& [index, value] : terms_) first += value * vectors[index][k];
        return first;
    }

    /// Returns component k of the sum; 0 for an empty sum.
    [[nodiscard]] double at(const DoubleMatrix& vectors, std::size_t k) const {
        if (terms_.empty()) return 0;
        double sum = terms_.front().value * vectors[terms_.front().index][k];
        for (std::size_t i = 1; i < terms_.size(); ++i)
            sum += terms_[i].value * vectors[terms_[i].index][k];
        return sum;
    }

private:
    struct Term {
        std::size_t index;
        double value;
    };
    std::vector<Term> terms_;
};

}  // namespace hvi::gen
