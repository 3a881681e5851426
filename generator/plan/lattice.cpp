// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/lattice.hpp"

#include <algorithm>

#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

const Dyadic one(1, 0);

/// Returns the power of two of the leading bit, once rounded to the format. That of zero is below
/// all others.
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

/// Rounds to multiples of 2^ulp. Returns whether the results have no more bits than the format.
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

namespace {

/// Multiples of one power of two.
using Multiples = std::vector<WideInteger>;

WideInteger multiple(const Number& value, int ulp) {
    const Dyadic nearest = value.nearest_multiple(ulp);
    return nearest.is_zero() ? 0 : nearest.integer() * (WideInteger(1) << (nearest.last() - ulp));
}

WideInteger size(WideInteger value) { return value < 0 ? -value : value; }

bool is_palindrome(const Multiples& values) {
    return std::equal(values.begin(), values.end(), values.rbegin());
}

void add_up_to(Multiples& X, WideInteger sum) {
    for (const WideInteger value : X) { sum -= value; }
    const std::size_t r = X.size();
    const auto largest = std::max_element(
        X.begin(), X.end(), [](WideInteger a, WideInteger b) { return size(a) < size(b); });
    if (!is_palindrome(X)) {
        *largest += sum;
    } else if (sum % 2 != 0) {
        X[r / 2] += sum;
    } else {
        const auto i = static_cast<std::size_t>(largest - X.begin());
        X[i] += sum / 2;
        X[r - 1 - i] += sum / 2;
    }
}

/// Column j in one format.
struct Column {
    WideInteger B;
    Multiples A, X;

    [[nodiscard]] bool fits(int bits) const {
        const WideInteger most = WideInteger(1) << bits;
        WideInteger sum = size(B);
        for (const WideInteger x : X) { sum += size(x); }
        return sum <= most && std::all_of(A.begin(), A.end(), [&](WideInteger a) {
                   return size(a) <= most && size(B - a) <= most;
               });
    }
};

Column column(const GalerkinForm& form, std::size_t j, int ulp) {
    Column result{multiple(form.B[j], ulp), {}, {}};
    for (std::size_t i = 0; i < form.nodes(); ++i) {
        result.A.push_back(multiple(form.A[i][j], ulp));
        result.X.push_back(multiple(form.b[i] * form.phi[i][j], ulp));
    }
    add_up_to(result.X, result.B);
    return result;
}

/// Returns a power of two above the leading bits of all entries, as far as that counts.
int magnitude_of_column(const GalerkinForm& form, std::size_t j) {
    constexpr int least = -40;
    int most = least;
    const auto look = [&](const Number& value) {
        const Dyadic coarse = value.nearest_multiple(least);
        if (!coarse.is_zero()) { most = std::max(most, coarse.leading()); }
    };
    look(form.B[j]);
    for (std::size_t i = 0; i < form.nodes(); ++i) {
        look(form.A[i][j]);
        look(form.b[i] * form.phi[i][j]);
    }
    return most;
}

}  // namespace

RoundedGalerkinForm rounded(const GalerkinForm& form) {
    const std::size_t r = form.nodes(), s = form.functions();
    const RoundedMatrix empty(r, std::vector<Rounded>(s));
    RoundedGalerkinForm result{empty, empty, empty, std::vector<Rounded>(s)};
    for (std::size_t j = 0; j < s; ++j) {
        const int magnitude = magnitude_of_column(form, j);
        for (std::size_t f = 0; f < formats.size(); ++f) {
            int ulp = magnitude - formats[f].bits;
            Column entries = column(form, j, ulp);
            while (!entries.fits(formats[f].bits)) { entries = column(form, j, ++ulp); }
            result.B[j][f] = Dyadic(entries.B, ulp);
            for (std::size_t i = 0; i < r; ++i) {
                result.X[i][j][f] = Dyadic(entries.X[i], ulp);
                result.A[i][j][f] = Dyadic(entries.A[i], ulp);
                result.D[i][j][f] = Dyadic(entries.B - entries.A[i], ulp);
            }
        }
    }
    return result;
}

}  // namespace hvi::gen
