// Newton's method for the slopes of positions and momenta.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/joint_slopes.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Whether stages have times, and second derivatives take them.
template <class Coupled, class = void>
struct HasClock : std::false_type {};
template <class Coupled>
struct HasClock<Coupled, std::void_t<decltype(std::declval<const Coupled&>().clock)>>
    : std::true_type {};

/// The equations of a NewtonLoop whose unknowns are the slopes Lq and Lp. `Algebra` is what it
/// computes with: the n x n matrices Hqq, Hqp and Hpp, which clear() sets to zero and the system
/// fills, and the Jacobian, entry by entry, with set_identity(), factorise() and solve(b).
template <class Vector, class Algebra>
class PairEquations {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        const auto n = static_cast<std::size_t>(coupled.s.n);
        const std::size_t size = unknowns<Coupled>() * n;
        if (slopes_.size() == size) { return false; }
        n_ = n;
        algebra_.resize(n_, size);
        for (std::vector<Scalar>* v : {&slopes_, &correction_}) { v->resize(size); }
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        slopes_.assign(slopes_.size(), Scalar(0));
        scatter(coupled);
        coupled.momenta();
        coupled.positions();
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        return factorise(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        algebra_.set_identity();
        std::size_t row = 0;
        for (const std::size_t j : Coupled::unknown_q) { velocity_rows(coupled, j, row++); }
        for (const std::size_t i : Coupled::unknown_p) { force_rows(coupled, i, row++); }
        return algebra_.factorise();
    }

    /// Whether J was, or should have been.
    [[nodiscard]] bool is_finite() const { return algebra_.is_finite(); }
    [[nodiscard]] bool rounds_with_largest() const { return false; }

    /// L -= J^-1 (L - slopes at the stages of L).
    ///
    /// NOTE: the corrected slopes are what the step adds up, not gradients evaluated at the
    /// corrected stages: those would carry the rounding of the stages times (h omega)^2.
    template <class Coupled>
    void correct(Coupled& coupled) {
        if constexpr (HasJointSlopes<Coupled>::value) {
            coupled.slopes();
        } else {
            coupled.velocities();
            coupled.forces();
        }
        gather(coupled, correction_);
        for (std::size_t i = 0; i < slopes_.size(); ++i) {
            correction_[i] = slopes_[i] - correction_[i];
        }
        algebra_.solve(correction_.data());
        for (std::size_t i = 0; i < slopes_.size(); ++i) { slopes_[i] -= correction_[i]; }
        scatter(coupled);
        coupled.momenta();
        coupled.positions();
        measure(coupled);
    }

private:
    using Scalar = ScalarOf<Vector>;

    template <class Coupled>
    static constexpr std::size_t unknowns() {
        return Coupled::unknown_q.size() + Coupled::unknown_p.size();
    }

    template <class Coupled>
    void measure(Coupled& coupled) {
        auto& change = coupled.s.change;
        for (std::size_t k = 0; k < n_; ++k) {
            at(change.q, k) = 0;
            at(change.p, k) = 0;
            for (std::size_t i = 0; i < unknowns<Coupled>(); ++i) {
                Vector& changes = i < Coupled::unknown_q.size() ? change.q : change.p;
                at(changes, k) += abs(correction_[i * n_ + k]);
            }
        }
    }

    /// Derivatives of Lq_j - h b_j dH/dp(Q_j, P_j).
    template <class Coupled>
    void velocity_rows(const Coupled& coupled, std::size_t j, std::size_t row) {
        const auto& s = coupled.s;
        algebra_.clear();
        if constexpr (Coupled::separable) {
            coupled.system.d2Hdp2(s.momentum(j), algebra_.Hpp);
        } else {
            with_time(coupled, j, [&](const auto&... t) {
                coupled.system.d2Hdp2(s.position(j), s.momentum(j), t..., algebra_.Hpp);
                coupled.system.d2Hdqdp(s.position(j), s.momentum(j), t..., algebra_.Hqp);
            });
        }
        const Scalar hb = s.h * coupled.weight_q(j);
        std::size_t column = 0;
        for (const std::size_t i : Coupled::unknown_q) {
            if constexpr (!Coupled::separable) {
                const Scalar factor = -hb * coupled.coefficient_q(j, i);
                add(row, column, [&](std::size_t k, std::size_t l) {
                    return factor * entry(algebra_.Hqp, l, k);
                });
            }
            static_cast<void>(i);
            ++column;
        }
        for (const std::size_t i : Coupled::unknown_p) {
            const Scalar factor = -hb * coupled.coefficient_p(j, i);
            add(row, column++,
                [&](std::size_t k, std::size_t l) { return factor * entry(algebra_.Hpp, k, l); });
        }
    }

    /// Derivatives of Lp_i + h b_i dH/dq(Q_i, P_i).
    template <class Coupled>
    void force_rows(const Coupled& coupled, std::size_t i, std::size_t row) {
        const auto& s = coupled.s;
        algebra_.clear();
        with_time(coupled, i, [&](const auto&... t) {
            if constexpr (Coupled::separable) {
                coupled.system.d2Hdq2(s.position(i), t..., algebra_.Hqq);
            } else {
                coupled.system.d2Hdq2(s.position(i), s.momentum(i), t..., algebra_.Hqq);
                coupled.system.d2Hdqdp(s.position(i), s.momentum(i), t..., algebra_.Hqp);
            }
        });
        const Scalar hb = s.h * coupled.weight_p(i);
        std::size_t column = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            const Scalar factor = hb * coupled.coefficient_q(i, j);
            add(row, column++,
                [&](std::size_t k, std::size_t l) { return factor * entry(algebra_.Hqq, k, l); });
        }
        for (const std::size_t j : Coupled::unknown_p) {
            if constexpr (!Coupled::separable) {
                const Scalar factor = hb * coupled.coefficient_p(i, j);
                add(row, column, [&](std::size_t k, std::size_t l) {
                    return factor * entry(algebra_.Hqp, k, l);
                });
            }
            static_cast<void>(j);
            ++column;
        }
    }

    /// Calls f with the time of stage i, or with nothing where H does not depend on it.
    template <class Coupled, class F>
    static void with_time([[maybe_unused]] const Coupled& coupled, [[maybe_unused]] std::size_t i,
                          F f) {
        if constexpr (HasClock<Coupled>::value) {
            f(coupled.clock.t[i]);
        } else {
            f();
        }
    }

    /// Adds entry(k, l) to a block of J.
    template <class Entry>
    void add(std::size_t row, std::size_t column, Entry entry_of) {
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t l = 0; l < n_; ++l) {
                algebra_.jacobian(row * n_ + k, column * n_ + l) += entry_of(k, l);
            }
        }
    }

    template <class Matrix>
    [[nodiscard]] static Scalar entry(const Matrix& matrix, std::size_t k, std::size_t l) {
        using Index = typename Algebra::Index;
        return matrix(static_cast<Index>(k), static_cast<Index>(l));
    }

    template <class Coupled>
    void gather(const Coupled& coupled, std::vector<Scalar>& slopes) const {
        std::size_t offset = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            for (std::size_t k = 0; k < n_; ++k) { slopes[offset++] = coupled.s.slope_q(j, k); }
        }
        for (const std::size_t i : Coupled::unknown_p) {
            for (std::size_t k = 0; k < n_; ++k) { slopes[offset++] = coupled.s.slope_p(i, k); }
        }
    }

    template <class Coupled>
    void scatter(Coupled& coupled) const {
        std::size_t offset = 0;
        for (const std::size_t j : Coupled::unknown_q) {
            for (std::size_t k = 0; k < n_; ++k) { coupled.s.set_slope_q(j, k, slopes_[offset++]); }
        }
        for (const std::size_t i : Coupled::unknown_p) {
            for (std::size_t k = 0; k < n_; ++k) { coupled.s.set_slope_p(i, k, slopes_[offset++]); }
        }
    }

    Algebra algebra_;
    std::vector<Scalar> slopes_, correction_;
    std::size_t n_ = 0;
};

}  // namespace detail

/// Solver policy of steppers of scenes, whose second derivatives take any matrix.
struct NewtonOfPairs {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<
        Vector, detail::PairEquations<Vector, detail::DenseAlgebra<detail::ScalarOf<Vector>>>>;
};

}  // namespace hvi
