// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/splitting_orders.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "generator/exact/numbers/ball.hpp"
#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

constexpr Precision bits = 320;

/// The largest order that is looked for in words of two letters B and more, of which there are
/// many.
constexpr std::size_t longest_of_more_letters = 9;

using Words = std::map<std::string, Ball>;

/// Series of words in A and B, with at most `most` letters B and `longest` letters.
class Series {
public:
    Series(std::size_t most, std::size_t longest) : most_(most), longest_(longest) {
        words_[""] = number(1);
    }

    /// Multiplies by exp(x letter).
    void times_exponential(char letter, const Ball& x) {
        Words result;
        for (const auto& [word, coefficient] : words_) {
            std::string longer = word;
            Ball term = coefficient;
            for (unsigned k = 1; holds(longer); ++k) {
                Ball& sum = result[longer];
                arb_add(sum.get(), sum.get(), term.get(), bits);
                longer += letter;
                arb_mul(term.get(), term.get(), x.get(), bits);
                arb_div_ui(term.get(), term.get(), k, bits);
            }
        }
        words_ = std::move(result);
    }

    /// Returns the logarithm, X - X^2/2 + X^3/3 - ..., with the series 1 + X.
    [[nodiscard]] Words logarithm() const {
        Words X = words_;
        X.erase("");
        Words power = X, result = X;
        for (unsigned k = 2; k <= longest_; ++k) {
            power = product(power, X);
            for (const auto& [word, coefficient] : power) {
                Ball term = coefficient;
                arb_div_si(term.get(), term.get(), k % 2 == 0 ? -static_cast<long>(k) : k, bits);
                Ball& sum = result[word];
                arb_add(sum.get(), sum.get(), term.get(), bits);
            }
        }
        return result;
    }

private:
    [[nodiscard]] static Ball number(long value) {
        Ball result;
        arb_set_si(result.get(), value);
        return result;
    }

    [[nodiscard]] bool holds(std::string_view word) const {
        const auto count = std::count(word.begin(), word.end(), 'B');
        return word.size() <= longest_ && static_cast<std::size_t>(count) <= most_;
    }

    [[nodiscard]] Words product(const Words& left, const Words& right) const {
        Words result;
        for (const auto& [first, a] : left) {
            for (const auto& [second, b] : right) {
                const std::string word = first + second;
                if (!holds(word)) { continue; }
                arb_addmul(result[word].get(), a.get(), b.get(), bits);
            }
        }
        return result;
    }

    std::size_t most_, longest_;
    Words words_;
};

/// Returns whether a number is less than 10^-50 for certain.
bool is_small(const Ball& ball) {
    Ball least, size;
    arb_set_ui(least.get(), 10);
    arb_pow_ui(least.get(), least.get(), 50, bits);
    arb_inv(least.get(), least.get(), bits);
    arb_abs(size.get(), ball.get());
    return arb_lt(size.get(), least.get()) != 0;
}

/// Returns the logarithm of a step, with so many letters.
Words modified_hamiltonian(const Splitting& splitting, std::size_t most, std::size_t longest) {
    Series series(most, longest);
    for (std::size_t k = 0; k < splitting.b.size(); ++k) {
        series.times_exponential('A', enclosure(splitting.a[k], bits));
        series.times_exponential('B', enclosure(splitting.b[k], bits));
    }
    series.times_exponential('A', enclosure(splitting.a.back(), bits));
    return series.logarithm();
}

/// Returns the order of the words with so many letters B: their letters, at most, for which all
/// coefficients but those of A and B are zero; `longest` where all are.
std::size_t order_of_words(const Splitting& splitting, std::size_t count, std::size_t longest) {
    std::size_t order = longest;
    for (const auto& [word, coefficient] : modified_hamiltonian(splitting, count, longest)) {
        const auto letters = std::count(word.begin(), word.end(), 'B');
        if (word.size() < 2 || static_cast<std::size_t>(letters) != count) { continue; }
        if (!is_small(coefficient)) { order = std::min(order, word.size() - 1); }
    }
    return order;
}

}  // namespace

std::vector<std::size_t> splitting_orders(const Splitting& splitting) {
    std::vector<std::size_t> orders{order_of_words(splitting, 1, longest_splitting_order)};
    std::size_t longest = std::min(orders.front(), longest_of_more_letters);
    for (std::size_t count = 2; count <= longest; ++count) {
        longest = std::min(longest, order_of_words(splitting, count, longest + 1));
        if (longest == orders.back() && orders.size() > 1) { break; }
        orders.push_back(longest);
    }
    return orders;
}

}  // namespace hvi::gen
