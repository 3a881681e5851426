// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/starting_slopes.hpp"

namespace hvi::gen {

namespace {

/// Returns component k of all vectors.
Doubles components_at(const DoubleMatrix& vectors, std::size_t k) {
    Doubles result;
    for (const Doubles& vector : vectors) result.push_back(vector[k]);
    return result;
}

}  // namespace

StartingSlopes::StartingSlopes(const Iteration& iteration)
    : exist_(!iteration.extrapolation.empty()) {
    if (!exist_) return;
    const Extrapolation& from = iteration.extrapolation.front();
    last_ = rough_doubles(from.last);
    takes_two_ = from.before.has_value();
    if (takes_two_) before_ = rough_doubles(*from.before);
}

void StartingSlopes::extrapolate(DoubleMatrix& slopes, Before& before,
                                 const std::vector<std::size_t>& unknown) const {
    for (std::size_t k = 0; k < slopes.front().size(); ++k) {
        const Doubles now = components_at(slopes, k);
        Doubles was;
        if (takes_two_) {
            was = components_at(before.slopes, k);
            for (std::size_t j = 0; j < now.size(); ++j) before.slopes[j][k] = now[j];
        }
        for (const std::size_t i : unknown) {
            double sum = last_[i][0] * now[0];
            for (std::size_t j = 1; j < now.size(); ++j) sum += last_[i][j] * now[j];
            for (std::size_t j = 0; j < was.size(); ++j) sum += before_[i][j] * was[j];
            slopes[i][k] = sum;
        }
    }
}

}  // namespace hvi::gen
