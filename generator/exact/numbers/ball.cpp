// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/ball.hpp"

#include <flint/fmpq.h>

#include "generator/support/error.hpp"

namespace hvi::gen {

int Ball::sign() const {
    if (arb_is_positive(ball_)) return 1;
    if (arb_is_negative(ball_)) return -1;
    return 0;
}

Ball ball_of_rational(const std::string& fraction, Precision bits) {
    fmpq_t value;
    fmpq_init(value);
    const bool read = fmpq_set_str(value, fraction.c_str(), 10) == 0;
    Ball result;
    arb_set_fmpq(result.get(), value, bits);
    fmpq_clear(value);
    HVI_CHECK(read);
    return result;
}

}  // namespace hvi::gen
