// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/expressions/spline.hpp"

#include <algorithm>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// A polynomial for each of the intervals [j/m, (j+1)/m].
using Pieces = std::vector<RationalPolynomial>;

/// Returns knot number i of `count` B-splines of degree k, times the number m of intervals.
long knot(long i, long degree, long intervals) { return std::clamp(i - degree, 0L, intervals); }

/// Returns (tau - a/m)/(b/m - a/m), or its difference from 1.
RationalPolynomial ramp(long a, long b, long intervals, bool falling) {
    const std::string length = std::to_string(b - a);
    RationalPolynomial result;
    result.set_coefficient(1, std::to_string(falling ? -intervals : intervals) + "/" + length);
    result.set_coefficient(0, std::to_string(falling ? b : -a) + "/" + length);
    return result;
}

void add_product(Pieces& sum, const RationalPolynomial& factor, const Pieces& pieces) {
    for (std::size_t j = 0; j < sum.size(); ++j) sum[j] = sum[j] + factor * pieces[j];
}

/// Returns the B-splines of degree d that splines number `first` to `first + k - d` of degree k
/// depend on, by the recurrence of Cox and de Boor: N_i,d = (t - t_i)/(t_(i+d) - t_i) N_i,d-1 +
/// (t_(i+d+1) - t)/(t_(i+d+1) - t_(i+1)) N_(i+1),d-1, a term over 0 being 0.
Pieces pieces_of(const SplineIndex& which, long intervals) {
    const auto t = [&](long i) { return knot(i, which.degree, intervals); };
    std::vector<Pieces> splines;
    for (long i = which.index; i <= which.index + which.degree; ++i) {
        Pieces indicator(static_cast<std::size_t>(intervals));
        if (t(i) < t(i + 1)) indicator[static_cast<std::size_t>(t(i))] = RationalPolynomial(1);
        splines.push_back(std::move(indicator));
    }
    for (long d = 1; d <= which.degree; ++d) {
        for (std::size_t n = 0; n + 1 < splines.size(); ++n) {
            const long i = which.index + static_cast<long>(n);
            Pieces next(static_cast<std::size_t>(intervals));
            if (t(i) < t(i + d)) {
                add_product(next, ramp(t(i), t(i + d), intervals, false), splines[n]);
            }
            if (t(i + 1) < t(i + d + 1)) {
                add_product(next, ramp(t(i + 1), t(i + d + 1), intervals, true), splines[n + 1]);
            }
            splines[n] = std::move(next);
        }
        splines.pop_back();
    }
    return splines.front();
}

long whole_number(const Expression& literal) {
    HVI_CHECK(literal.kind == Expression::Kind::number && literal.denominator == "1");
    return std::stol(literal.numerator);
}

void count_splines(const Expression& expression, std::map<long, long>& counts) {
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::call && part.name == "bspline") {
            const SplineIndex which = spline_index(part);
            long& count = counts[which.degree];
            count = std::max(count, which.index + 1);
        }
        return true;
    });
}

}  // namespace

SplineIndex spline_index(const Expression& call) {
    return {whole_number(call.arguments.at(0)), whole_number(call.arguments.at(1))};
}

std::map<long, long> spline_counts(const List& list) {
    std::map<long, long> result;
    for (const Item& item : list.items) {
        const auto* expression = std::get_if<Expression>(&item.what);
        if (expression != nullptr) count_splines(*expression, result);
    }
    return result;
}

ExactFunction b_spline(const SplineIndex& which, long count, const Ground& ground) {
    HVI_CHECK(count > which.degree && which.index < count);
    const long intervals = count - which.degree;
    const Pieces pieces = pieces_of(which, intervals);
    ExactFunction result(with_numbers(pieces.front(), ground));
    for (long j = 1; j < intervals; ++j) {
        const auto here = static_cast<std::size_t>(j);
        const RationalPolynomial jump = pieces[here] - pieces[here - 1];
        const Number breakpoint = ground.rational(std::to_string(j), std::to_string(intervals));
        result =
            result + ExactFunction(with_numbers(jump, ground)) * ExactFunction::step(breakpoint);
    }
    return result;
}

}  // namespace hvi::gen
