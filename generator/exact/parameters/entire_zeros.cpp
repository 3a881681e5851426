// Real zeros of entire functions, isolated by enclosures.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <string>
#include <utility>

#include "generator/exact/parameters/near_zero.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

class ZeroSearch {
public:
    ZeroSearch(const EntireFunction& function, const EntireGenerators& generators)
        : function_(function, generators, bits) {}

    /// Searches an interval. Throws MathError after so many intervals that one cannot wait for the
    /// rest: some hundred are usual.
    void search(double low, double high) {
        constexpr double narrowest = 1e-9;
        constexpr int most_intervals = 4096;
        if (++intervals_ > most_intervals) {
            throw MathError("the zeros of the denominators of the coefficients lie too close, or "
                            "come too near 0 without being there: " +
                                std::to_string(most_intervals) + " intervals do not isolate them",
                            {}, "give the parameter a value with --param, or choose simpler nodes");
        }
        const double middle = low + 0.4871 * (high - low);  // NOTE: hardly ever a zero itself
        const BallSeries whole = function_.at(interval(low, high), 2);
        const Ball slope = whole.coefficient(1);
        if (mean_value(middle, interval(low - middle, high - middle), slope).sign() != 0) {
            return;
        }
        if (slope.sign() != 0) {
            const int at_low = sign(low);
            const int at_high = sign(high);
            if (at_low * at_high > 0) { return; }
            if (at_low * at_high < 0) { return found(bisected(low, high, at_low)); }
        }
        if (high - low < narrowest) { return found(middle); }
        search(low, middle);
        search(middle, high);
    }

    [[nodiscard]] std::vector<double> zeros() && { return std::move(zeros_); }

private:
    static constexpr Precision bits = 192;

    static Ball interval(double low, double high) {
        arf_t a, b;
        arf_init(a);
        arf_init(b);
        arf_set_d(a, low);
        arf_set_d(b, high);
        Ball result;
        arb_set_interval_arf(result.get(), a, b, bits);
        arf_clear(a);
        arf_clear(b);
        return result;
    }

    [[nodiscard]] Ball value(double w) const {
        return function_.at(interval(w, w), 1).coefficient(0);
    }

    [[nodiscard]] int sign(double w) const { return value(w).sign(); }

    [[nodiscard]] Ball mean_value(double middle, const Ball& offset, const Ball& slope) const {
        Ball result = value(middle);
        arb_addmul(result.get(), offset.get(), slope.get(), bits);
        return result;
    }

    [[nodiscard]] double bisected(double low, double high, int at_low) const {
        for (int step = 0; step < 50; ++step) {
            const double middle = (low + high) / 2;
            (sign(middle) == at_low ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    void found(double zero) {
        constexpr double same = 1e-7;
        if (zeros_.empty() || zero - zeros_.back() > same) { zeros_.push_back(zero); }
    }

    EnclosedFunction function_;
    std::vector<double> zeros_;
    int intervals_ = 0;  ///< number of intervals seen
};

}  // namespace

std::vector<double> real_zeros(const EntireFunction& function, const EntireGenerators& generators,
                               double most) {
    // NOTE: near 0 intervals say little about a function that vanishes there; its series does.
    constexpr int smallest = -60;
    const NearZero near_zero(function, generators);
    int at = std::ilogb(most);
    while (at > smallest && !near_zero.is_dominated(at)) { --at; }
    const double least = std::ldexp(1.0, at);
    ZeroSearch search(function, generators);
    search.search(-most, -least);
    search.search(least, most);
    return std::move(search).zeros();
}

}  // namespace hvi::gen
