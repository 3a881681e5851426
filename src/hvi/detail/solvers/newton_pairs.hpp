// Newton's method for the slopes of positions and momenta.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/solvers/slope_unknowns.hpp>

namespace hvi {
namespace detail {

/// Equations of a NewtonLoop whose unknowns are the slopes Lq and Lp. `Algebra` has the n x n
/// matrices Hqq, Hqp and Hpp, which clear() sets to zero and the system fills. It also has the
/// Jacobian, entry by entry, with set_identity(), factorise() and solve(b).
template <class Vector, class Algebra>
class PairEquations : SlopeUnknowns<Vector> {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        if (!this->make_room(coupled)) { return false; }
        algebra_.resize(n_, SlopeUnknowns<Vector>::template unknowns<Coupled>() * n_);
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        this->begin_at_rest(coupled);
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

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return algebra_.is_finite(); }
    [[nodiscard]] bool rounds_with_largest() const { return false; }

    /// Corrects the slopes; see SlopeUnknowns.
    template <class Coupled>
    void correct(Coupled& coupled) {
        this->correct_by(coupled, [&](std::vector<Scalar>& x) { algebra_.solve(x.data()); });
    }

private:
    using typename SlopeUnknowns<Vector>::Scalar;
    using SlopeUnknowns<Vector>::n_;

    /// Adds derivatives of Lq_j - h b_j dH/dp(Q_j, P_j).
    template <class Coupled>
    void velocity_rows(const Coupled& coupled, std::size_t j, std::size_t row) {
        const auto& s = coupled.s;
        algebra_.clear();
        if constexpr (Coupled::separable) {
            coupled.system.d2Hdp2(s.momentum(j), algebra_.Hpp);
        } else {
            this->with_time(coupled, j, [&](const auto&... t) {
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

    /// Adds derivatives of Lp_i + h b_i dH/dq(Q_i, P_i).
    template <class Coupled>
    void force_rows(const Coupled& coupled, std::size_t i, std::size_t row) {
        const auto& s = coupled.s;
        algebra_.clear();
        this->with_time(coupled, i, [&](const auto&... t) {
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

    Algebra algebra_;
};

}  // namespace detail

/// Solver policy of steppers of scenes, whose second derivatives fill matrices of any type.
struct NewtonOfPairs {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<
        Vector, detail::PairEquations<Vector, detail::DenseAlgebra<detail::ScalarOf<Vector>>>>;
};

}  // namespace hvi
