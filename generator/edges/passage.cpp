// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/passage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/exact/methods/order.hpp"
#include "generator/exact/methods/rule_properties.hpp"

namespace hvi::gen {

namespace {

/// Returns E - sin E by its series, without cancellation. Precondition: |E| is at most about 2.
double without_sine(double E) {
    double term = E * E * E / 6, sum = 0;
    for (int k = 4; sum + term != sum; k += 2) {
        sum += term;
        term *= -E * E / (k * (k + 1));
    }
    return sum;
}

}  // namespace

// The time is by Kepler's equation 2 (E - e sin E), where tan(E/2) = sqrt((1 - e)/(1 + e))
// tan(pi/4).
Passage::Passage(double e) : e_(e), l_((1 - e) * (1 + e)) {
    const double E = 2 * std::atan(std::sqrt((1 - e) / (1 + e)));
    time_ = 2 * ((1 - e) * E + e * without_sine(E));
}

std::vector<double> Passage::begin() const {
    return {0, -l_, 1 / std::sqrt(l_), e_ / std::sqrt(l_)};
}

std::vector<double> Passage::end() const { return {0, l_, -1 / std::sqrt(l_), e_ / std::sqrt(l_)}; }

double Passage::error(const std::vector<double>& state) const {
    const std::vector<double> exact = end();
    double result = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double unit = i < 2 ? l_ : 1 / std::sqrt(l_);
        result = std::max(result, std::abs(state.at(i) - exact[i]) / unit);
    }
    return result;
}

double passage_rounding(long steps, std::size_t parts) {
    return 4 * 15 * static_cast<double>(steps) * static_cast<double>(parts) *
           std::numeric_limits<double>::epsilon();
}

Refinement refined(const Passage& passage, const EdgeProgram& program, std::size_t parts,
                   const std::vector<double>& start, const std::vector<double>& values,
                   const std::function<std::vector<double>(const std::vector<double>&)>& relative) {
    constexpr long first = 4, last = 8192;
    Refinement result{parts};
    for (long steps = first; steps <= last; steps *= 2) {
        const Heard heard = program.ask("advance", passage.time() / static_cast<double>(steps),
                                        steps, start, values);
        result.failure = heard.failure;
        const bool ok = result.failure.empty() && heard.answers.text("status") == "ok";
        if (result.failure.empty() && !ok && result.errors.empty()) continue;  // steps too large
        if (result.failure.empty() && !ok)
            result.failure = fmt::format("{} steps: {}", steps, heard.answers.text("status"));
        if (!result.failure.empty()) return result;
        const double error = passage.error(relative(heard.answers.numbers("end")));
        result.errors.emplace_back(static_cast<double>(steps), error);
        if (error <= passage_rounding(steps, parts)) return result;
    }
    return result;
}

namespace {

OrderConditions nystrom_conditions(const Tableau& tableau, int highest) {
    return orders(tableau, highest).nystrom;
}

OrderConditions nystrom_conditions(const GalerkinRule& rule, int highest) {
    return nystrom_order(rule, highest);
}

}  // namespace

KnownOrder known_order(const ExactMethod& method) {
    constexpr int highest = 8;
    const auto conditions = [](const auto& derived) {
        return nystrom_conditions(derived, highest);
    };
    const OrderConditions found = std::visit(conditions, method.base);
    return {composed_order(found.order, method.composition), found.is_at_least};
}

// Compares the last two errors that are clear of round-off, as the other terms of the error fall
// faster.
EdgeCheck order_check(const std::string& method, const KnownOrder& known, const std::string& scene,
                      const std::string& what, const Refinement& refinement) {
    const std::string order =
        fmt::format("{}{}", known.is_at_least ? "at least " : "", known.order);
    EdgeCheck check{method, scene, what, "errors that fall with order " + order, refinement.failure,
                    false};
    if (!refinement.failure.empty()) return check;
    const auto& errors = refinement.errors;
    const auto is_clear = [&](const std::pair<double, double>& point) {
        return point.second >
               10 * passage_rounding(static_cast<long>(point.first), refinement.parts);
    };
    auto finer = std::find_if_not(errors.begin(), errors.end(), is_clear);
    if (finer - errors.begin() < 2) {
        const bool ends = finer != errors.end();
        check.seen = ends ? fmt::format("round-off from {} steps on", finer->first) : "no errors";
        check.agrees = ends && known.is_at_least;
        return check;
    }
    --finer;
    const double seen = std::log2((finer - 1)->second / finer->second);
    check.seen = fmt::format("order {:.2f} at {} steps; at {} steps {:.1e}", seen, finer->first,
                             errors.back().first, errors.back().second);
    check.agrees = seen > known.order - 0.5 && (known.is_at_least || seen < known.order + 0.5);
    return check;
}

}  // namespace hvi::gen
