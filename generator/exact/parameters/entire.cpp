// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/parameters/entire.hpp"

#include <algorithm>

#include "generator/exact/parameters/near_zero.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

bool is_generator(const EntireFunction& function, std::size_t which) {
    if (function.terms.size() != 1) { return false; }
    const std::vector<unsigned>& powers = function.terms.front().powers;
    for (std::size_t g = 0; g < powers.size(); ++g) {
        if (powers[g] != (g == which ? 1U : 0U)) { return false; }
    }
    return true;
}

unsigned order_at_zero(const EntireFunction& function, const EntireGenerators& generators) {
    constexpr unsigned most = 60;
    const unsigned order = NearZero(function, generators).order();
    if (order > most || !vanishes_at_zero(function, generators, order)) {
        throw MathError("cannot decide how a coefficient behaves where the parameter is 0");
    }
    return order;
}

SeriesPlan series_plan(const std::vector<EntireFunction>& functions,
                       const EntireGenerators& generators) {
    constexpr int smallest = -24;
    constexpr int largest = 3;
    std::vector<NearZero> near_zero;
    for (const EntireFunction& function : functions) {
        near_zero.emplace_back(function, generators);
    }
    const auto all = [&](auto&& holds) {
        return std::all_of(near_zero.begin(), near_zero.end(), holds);
    };
    for (int at = smallest; at <= largest; ++at) {
        // NOTE: a sum of powers of w with positive coefficients, divided by a power of w, is a
        // convex function of log(w): its bounds at w = 2^at and 2^(at+1) hold between them.
        const bool good = all([&](const NearZero& f) {
            return f.is_good_as_written(at) && f.is_good_as_written(at + 1);
        });
        if (!good) { continue; }
        SeriesPlan plan{at, 1};
        const bool possible = all([&](const NearZero& f) {
            const auto length = f.needed(at);
            plan.length = std::max(plan.length, length.value_or(NearZero::longest));
            return length && f.is_dominated(at + 1) && f.is_good_as_series(at);
        });
        if (possible) { return plan; }
        break;
    }
    throw MathError(
        "no way is found to evaluate the coefficients for small values of the parameter");
}

}  // namespace hvi::gen
