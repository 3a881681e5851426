// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/lattice.hpp"

#include <algorithm>

#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

const Dyadic one(1, 0);

/// The power of two of the leading bit, once rounded to the format: no number is smaller than zero.
int magnitude(const Dyadic& value) {
    constexpr int of_zero = -100'000;
    return value.is_zero() ? of_zero : value.leading();
}

std::optional<Dyadic> on_lattice(const Number& m, const Format& format) {
    const int larger = std::max(magnitude(m.nearest_of(format.bits)),
                                magnitude((Number(1) - m).nearest_of(format.bits)));
    const int ulp = larger - (format.bits - 1);
    if (ulp > 0 || larger > format.most) { return std::nullopt; }
    return m.nearest_multiple(ulp);
}

std::optional<Dyadic> complement(const std::optional<Dyadic>& m, const Format& format) {
    if (!m) { return std::nullopt; }
    const Dyadic mt = one - *m;
    HVI_CHECK(one - mt == *m && m->bits() <= format.bits && mt.bits() <= format.bits);
    return mt;
}

}  // namespace

RoundedCoefficients rounded(const Step& step) {
    const std::size_t rows = step.positions.size();
    const std::size_t columns = step.momenta.size();
    RoundedCoefficients result{RoundedMatrix(rows, std::vector<Rounded>(columns)),
                               RoundedMatrix(columns, std::vector<Rounded>(rows))};
    const bool mirrored = step.partner == Partner::same && rows == columns;
    const auto round = [&](std::size_t i, std::size_t j, std::size_t f) {
        if (step.m[i][j].has_parameters()) { return; }
        const bool is_half = mirrored && i == j;
        const auto m = is_half ? Dyadic(1, -1) : on_lattice(step.m[i][j], formats[f]);
        const auto mt = complement(m, formats[f]);
        result.m[i][j][f] = m;
        result.mt[j][i][f] = mt;
        if (mirrored) {
            result.m[j][i][f] = mt;
            result.mt[i][j][f] = m;
        }
    };
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < (mirrored ? i + 1 : columns); ++j) {
            for (std::size_t f = 0; f < formats.size(); ++f) { round(i, j, f); }
        }
    }
    return result;
}

namespace {

/// Rounds to multiples of 2^ulp, and says whether the results have no more bits than the format.
bool round_in_format(RoundedVelocityForm& result, const VelocityForm& form, std::size_t f,
                     int ulp) {
    bool fits = true;
    const auto checked = [&](const Dyadic& value) {
        fits = fits && value.bits() <= formats[f].bits;
        return value;
    };
    const auto on_lattice = [&](const Number& value) { return value.nearest_multiple(ulp); };
    for (std::size_t i = 0; i < form.c.size(); ++i) {
        result.c[i][f] = checked(on_lattice(form.c[i]));
        (void)checked(one - *result.c[i][f]);
        for (std::size_t j = 0; j <= i; ++j) {
            const Dyadic difference = *result.c[i][f] - *result.c[j][f];
            const bool is_zero_above = equal(form.n[j][i], 0);
            const Dyadic below = is_zero_above ? difference : on_lattice(form.n[i][j]);
            result.n[i][j][f] = checked(below);
            result.n[j][i][f] = checked(below - difference);
        }
    }
    return fits;
}

}  // namespace

RoundedVelocityForm rounded(const VelocityForm& form) {
    const std::size_t r = form.c.size();
    RoundedVelocityForm result{std::vector<Rounded>(r), RoundedMatrix(r, std::vector<Rounded>(r))};
    for (std::size_t f = 0; f < formats.size(); ++f) {
        int ulp = -formats[f].bits;
        while (!round_in_format(result, form, f, ulp)) { HVI_CHECK(++ulp <= 0); }
    }
    return result;
}

}  // namespace hvi::gen
