// Counted sweeps as plain loops over the tableau of Gauss' two stages, in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sweeps_test {

using Real = long double;
using Stages = std::array<Real, 2>;

/// The way in which stages wait for slopes.
enum class Order {
    positions,  ///< Q from forces alone: H = p^2/2 + U(q)
    in_turn,    ///< P, then dH/dp at it, then Q, then dH/dq
    jointly,    ///< P and Q, then both gradients
};

/// Steps of Gauss' two stages with one degree of freedom. `Force` is -dH/dq(q, p, t), and
/// `Velocity` is dH/dp(q, p, t).
template <class Force, class Velocity>
class Model {
public:
    Model(Force force, Velocity velocity, Order order, Real q_0, Real p_0)
        : force_(force), velocity_(velocity), order_(order), q(q_0), p(p_0) {}

    void step(Real h, int sweeps) {
        const Real root = std::sqrt(Real(3)) / 6;
        c_ = {Real(1) / 2 - root, Real(1) / 2 + root};
        A_ = {{{Real(1) / 4, Real(1) / 4 - root}, {Real(1) / 4 + root, Real(1) / 4}}};
        for (std::size_t i = 0; i < 2; ++i) { times_[i] = t + c_[i] * h; }
        predict();
        // NOTE: slopes at the start of the first two steps are swept 16 times more.
        const int count = past_.size() < 2 ? sweeps + 16 : sweeps;
        Stages Q{}, P{};
        if (order_ == Order::in_turn) { Q = moved(q, h, V_); }
        for (int k = 0; k < count; ++k) {
            P = moved(p, h, F_);
            if (order_ == Order::positions) { V_ = P; }
            if (order_ == Order::in_turn) { evaluate(V_, velocity_, Q, P); }
            Q = moved(q, h, V_);
            if (order_ == Order::jointly) { evaluate(V_, velocity_, Q, P); }
            evaluate(F_, force_, Q, P);
        }
        if (order_ == Order::positions) { V_ = moved(p, h, F_); }
        q += h / 2 * (V_[0] + V_[1]);
        p += h / 2 * (F_[0] + F_[1]);
        t += h;
        past_.push_back({times_, F_, V_});
        if (past_.size() > 2) { past_.erase(past_.begin()); }
    }

private:
    struct Past {
        Stages times, F, V;
    };

    Stages moved(Real start, Real h, const Stages& slopes) const {
        return {start + h * (A_[0][0] * slopes[0] + A_[0][1] * slopes[1]),
                start + h * (A_[1][0] * slopes[0] + A_[1][1] * slopes[1])};
    }

    template <class Function>
    void evaluate(Stages& slopes, Function function, const Stages& Q, const Stages& P) const {
        for (std::size_t i = 0; i < 2; ++i) { slopes[i] = function(Q[i], P[i], times_[i]); }
    }

    /// Sets the slopes to those of the polynomial through those of the last two steps, else to
    /// those at the start.
    void predict() {
        if (past_.size() < 2) {
            F_.fill(force_(q, p, t));
            V_.fill(velocity_(q, p, t));
            return;
        }
        for (std::size_t i = 0; i < 2; ++i) {
            F_[i] = interpolated(times_[i], &Past::F);
            V_[i] = interpolated(times_[i], &Past::V);
        }
    }

    /// Lagrange's formula over the four slopes.
    Real interpolated(Real at, Stages Past::*slopes) const {
        std::vector<Real> nodes, values;
        for (const Past& past : past_) {
            for (std::size_t i = 0; i < 2; ++i) {
                nodes.push_back(past.times[i]);
                values.push_back((past.*slopes)[i]);
            }
        }
        Real sum = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            Real product = values[i];
            for (std::size_t j = 0; j < nodes.size(); ++j) {
                if (j != i) { product *= (at - nodes[j]) / (nodes[i] - nodes[j]); }
            }
            sum += product;
        }
        return sum;
    }

    Force force_;
    Velocity velocity_;
    Order order_;
    std::array<Stages, 2> A_{};
    Stages c_{}, times_{}, F_{}, V_{};
    std::vector<Past> past_;

public:
    Real q, p, t = 0;
};

}  // namespace sweeps_test
