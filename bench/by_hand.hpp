// Loops as one would write them by hand for one method and one system.
// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <cmath>

#include <hvi/detail/numbers/compensated.hpp>

#include "problems.hpp"

namespace bench {

/// Störmer-Verlet for the pendulum, the last force kept.
class VerletByHand {
public:
    VerletByHand(double q, double p) : q_(q), p_(p), force_(-std::sin(q)) {}
    void step(double h) {
        const double middle = p_ + 0.5 * h * force_;
        q_ += h * middle;
        force_ = -std::sin(q_);
        p_ = middle + 0.5 * h * force_;
    }
    [[nodiscard]] double q() const { return q_; }
    [[nodiscard]] double p() const { return p_; }

private:
    double q_, p_, force_;
};

/// Two-stage Gauss for Kepler's problem, all in scalars: the partitioned fixed point of gauss:2 for
/// general H, with equal starting values, stop at round-off and compensated sums.
class Gauss2ByHand {
public:
    explicit Gauss2ByHand(const hvi::State<std::array<double, 2>>& x)
        : qx_(x.q[0]), qy_(x.q[1]), px_(x.p[0]), py_(x.p[1]) {}

    /// False when there is no convergence.
    bool step(double h) {
        predict(h);
        Stage P1{}, P2{};
        Stage Q1 = position(m11, m12);
        Stage Q2 = position(m21, m22);
        Stage smallest_q{big, big}, smallest_p{big, big};
        int stalls = 0;
        for (int iteration = 1; iteration <= 200; ++iteration) {
            const Stage new_P1 = momentum(m11, m12);
            const Stage new_P2 = momentum(m21, m22);
            Stage change_p = difference(new_P1, P1, new_P2, P2);
            P1 = new_P1;
            P2 = new_P2;
            const double hb = 0.5 * h;
            Lq1_ = {hb * P1.x, hb * P1.y};
            Lq2_ = {hb * P2.x, hb * P2.y};
            const Stage new_Q1 = position(m11, m12);
            const Stage new_Q2 = position(m21, m22);
            Stage change_q = difference(new_Q1, Q1, new_Q2, Q2);
            Q1 = new_Q1;
            Q2 = new_Q2;
            bool stop = false;
            if (iteration > 1) {
                if (change_q.x + change_q.y + change_p.x + change_p.y == 0.0) { break; }
                const int falls = less(change_q.x, smallest_q.x) | less(change_q.y, smallest_q.y) |
                                  less(change_p.x, smallest_p.x) | less(change_p.y, smallest_p.y);
                stalls = falls != 0 ? 0 : stalls + 1;
                stop = stalls >= 2 && small(change_q, Q1, Q2, Lq1_, Lq2_) &&
                       small(change_p, P1, P2, Lp1_, Lp2_);
            }
            Lp1_ = force(Q1, hb);
            Lp2_ = force(Q2, hb);
            if (stop) { break; }
            if (iteration == 200) { return false; }
        }
        add(qx_, eqx_, Lq1_.x + Lq2_.x);
        add(qy_, eqy_, Lq1_.y + Lq2_.y);
        add(px_, epx_, Lp1_.x + Lp2_.x);
        add(py_, epy_, Lp1_.y + Lp2_.y);
        return std::isfinite(qx_) && std::isfinite(qy_) && std::isfinite(px_) && std::isfinite(py_);
    }

    [[nodiscard]] double qx() const { return qx_; }
    [[nodiscard]] double qy() const { return qy_; }
    [[nodiscard]] double px() const { return px_; }
    [[nodiscard]] double py() const { return py_; }

private:
    struct Stage {
        double x, y;
    };
    static constexpr double big = DBL_MAX;
    static constexpr double m11 = 0.5, m12 = -0.07735026918962573;
    static constexpr double m21 = 1.0773502691896257, m22 = 0.5;
    static constexpr double N11 = -0.7320508075688773, N12 = 1.7320508075688772;
    static constexpr double N21 = -1.7320508075688772, N22 = 2.732050807568877;

    void predict(double h) {
        if (h == h_) {
            const Stage q1 = Lq1_, q2 = Lq2_, p1 = Lp1_, p2 = Lp2_;
            Lq1_ = {N11 * q1.x + N12 * q2.x, N11 * q1.y + N12 * q2.y};
            Lq2_ = {N21 * q1.x + N22 * q2.x, N21 * q1.y + N22 * q2.y};
            Lp1_ = {N11 * p1.x + N12 * p2.x, N11 * p1.y + N12 * p2.y};
            Lp2_ = {N21 * p1.x + N22 * p2.x, N21 * p1.y + N22 * p2.y};
            return;
        }
        h_ = h;
        Lq1_ = Lq2_ = {0.5 * h * px_, 0.5 * h * py_};
        Lp1_ = Lp2_ = force({qx_, qy_}, 0.5 * h);
    }

    [[nodiscard]] Stage position(double a, double b) const {
        return {qx_ + (eqx_ + (a * Lq1_.x + b * Lq2_.x)), qy_ + (eqy_ + (a * Lq1_.y + b * Lq2_.y))};
    }
    [[nodiscard]] Stage momentum(double a, double b) const {
        return {px_ + (epx_ + (a * Lp1_.x + b * Lp2_.x)), py_ + (epy_ + (a * Lp1_.y + b * Lp2_.y))};
    }
    [[nodiscard]] static Stage force(const Stage& Q, double hb) {
        const double r2 = Q.x * Q.x + Q.y * Q.y;
        const double scale = 1.0 / (r2 * std::sqrt(r2));
        return {-hb * (scale * Q.x), -hb * (scale * Q.y)};
    }
    [[nodiscard]] static Stage difference(const Stage& a, const Stage& b, const Stage& c,
                                          const Stage& d) {
        return {std::abs(a.x - b.x) + std::abs(c.x - d.x),
                std::abs(a.y - b.y) + std::abs(c.y - d.y)};
    }
    static int less(double change, double& smallest) {
        const int falls = static_cast<int>(change > 0.0) & static_cast<int>(change < smallest);
        smallest = change < smallest ? change : smallest;
        return falls;
    }
    static bool small(const Stage& change, const Stage& a, const Stage& b, const Stage& c,
                      const Stage& d) {
        constexpr double rounding = 8 * DBL_EPSILON;
        return change.x <=
                   rounding * (std::abs(a.x) + std::abs(b.x) + std::abs(c.x) + std::abs(d.x)) &&
               change.y <=
                   rounding * (std::abs(a.y) + std::abs(b.y) + std::abs(c.y) + std::abs(d.y));
    }
    static void add(double& value, double& cut_off, double increment) {
        const hvi::Sum<double> sum = hvi::two_sum(value, cut_off + increment);
        value = sum.value;
        cut_off = sum.remainder;
    }

    double qx_, qy_, px_, py_;
    double eqx_ = 0.0, eqy_ = 0.0, epx_ = 0.0, epy_ = 0.0;
    Stage Lq1_{}, Lq2_{}, Lp1_{}, Lp2_{};
    double h_ = 0.0;
};

}  // namespace bench
