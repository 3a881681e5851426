// A real interval with proven bounds: Arb's midpoint-radius balls with value semantics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <arb.h>

#include <string>

namespace hvi::gen {

/// An enclosure: the enclosed number lies in it, at any working precision.
class Ball {
public:
    Ball() { arb_init(ball_); }
    Ball(const Ball& other) : Ball() { arb_set(ball_, other.ball_); }
    Ball(Ball&& other) noexcept : Ball() { arb_swap(ball_, other.ball_); }
    Ball& operator=(Ball other) noexcept {
        arb_swap(ball_, other.ball_);
        return *this;
    }
    ~Ball() { arb_clear(ball_); }

    [[nodiscard]] arb_ptr get() { return ball_; }
    [[nodiscard]] arb_srcptr get() const { return ball_; }

    /// Returns -1 or 1 when every number in the ball has that sign, 0 when it contains zero.
    [[nodiscard]] int sign() const;

private:
    arb_t ball_;
};

/// Working precision in bits.
using Precision = slong;

/// Precisions at which refining begins, and at which it gives up: a decision that needs more than
/// this many bits is reported as undecided.
inline constexpr Precision first_precision = 128;
inline constexpr Precision last_precision = 1 << 15;

/// Cache of the tightest enclosure of a number that was asked for.
class TightestBall {
public:
    /// Returns the enclosure, and calls `enclose` when the cached one was made with less precision.
    template <class Enclose>
    [[nodiscard]] const Ball& at(Precision bits, Enclose enclose) {
        if (bits_ < bits) {
            ball_ = enclose(bits);
            bits_ = bits;
        }
        return ball_;
    }

private:
    Precision bits_ = 0;
    Ball ball_;
};

/// Returns the rational given by its decimal digits, rounded outwards.
[[nodiscard]] Ball ball_of_rational(const std::string& fraction, Precision bits);

}  // namespace hvi::gen
