// Power series with enclosures for coefficients.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <arb_poly.h>

#include <cstddef>

#include "generator/exact/numbers/ball.hpp"

namespace hvi::gen {

/// A power series: Arb's polynomials, with value semantics.
class BallSeries {
public:
    BallSeries() { arb_poly_init(series_); }
    BallSeries(const BallSeries& other) : BallSeries() { arb_poly_set(series_, other.series_); }
    BallSeries& operator=(BallSeries other) noexcept {
        arb_poly_swap(series_, other.series_);
        return *this;
    }
    ~BallSeries() { arb_poly_clear(series_); }

    [[nodiscard]] arb_poly_struct* get() { return series_; }
    [[nodiscard]] const arb_poly_struct* get() const { return series_; }

    [[nodiscard]] Ball coefficient(std::size_t index) const {
        Ball result;
        arb_poly_get_coeff_arb(result.get(), series_, static_cast<slong>(index));
        return result;
    }

private:
    arb_poly_t series_;
};

}  // namespace hvi::gen
