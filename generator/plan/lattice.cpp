// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

double on_lattice(const Number& m) {
    const double larger =
        std::max(std::abs(m.nearest_double()), std::abs((Number(1) - m).nearest_double()));
    const int ulp = std::ilogb(larger) - (std::numeric_limits<double>::digits - 1);
    return m.nearest_multiple(ulp);
}

}  // namespace

RoundedCoefficients rounded(const Scheme& scheme) {
    const std::size_t rows = scheme.positions.size();
    const std::size_t columns = scheme.momenta.size();
    RoundedCoefficients result{DoubleMatrix(rows, std::vector<double>(columns)),
                               DoubleMatrix(columns, std::vector<double>(rows))};
    const bool mirrored = scheme.one_tableau() && rows == columns;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = 0; j < columns; ++j) {
            if (mirrored && i < j) { continue; }
            const double m = mirrored && i == j ? 0.5 : on_lattice(scheme.m[i][j]);
            result.m[i][j] = m;
            result.mt[j][i] = 1.0 - m;
            HVI_CHECK(1.0 - result.mt[j][i] == m);
            if (mirrored) {
                result.m[j][i] = 1.0 - m;
                result.mt[i][j] = m;
            }
        }
    }
    return result;
}

}  // namespace hvi::gen
