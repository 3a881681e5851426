// Newton's method for the forces of stages whose momenta are eliminated.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/solvers/position_unknowns.hpp>
#include <hvi/detail/solvers/stiffness.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Equations of a NewtonLoop for PositionUnknowns.
///
/// At the start of a step all stages have one matrix G of second derivatives, taken at q, and the C
/// of J is similar to A A~. In the basis of the eigenvectors of C, known when the header was
/// written, J falls apart into a system of n equations for each real eigenvalue and one of 2n for
/// each pair of conjugate ones (Coupled::Modes). No system is singular where G K has no negative
/// eigenvalue and C has no real negative one, which holds for Gauss and Lobatto methods. Where the
/// iteration does not contract with these factors, each stage gets the matrix G of its own place,
/// and J is factored as a whole.
template <class Vector>
class PositionEquations : PositionUnknowns<Vector> {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        if (!this->make_room(coupled)) { return false; }
        G_ = hGK_ = SquareMatrix<Scalar>(n_);
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        this->begin_at_rest(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        G_.set_zero();
        coupled.hessian_at_start(G_);
        set_hGK(coupled, G_, hGK_);
        is_decoupled_ = Coupled::Modes::exist;
        if constexpr (Coupled::Modes::exist) {
            return factorise_modes<typename Coupled::Modes>(coupled.s.h);
        } else {
            return factorise_all(coupled, [](std::size_t) {});
        }
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        is_decoupled_ = false;
        SquareMatrix<Scalar> G(n_);
        return factorise_all(coupled, [&](std::size_t j) {
            G.set_zero();
            coupled.hessian(j, G);
            set_hGK(coupled, G, hGK_);
        });
    }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return hGK_.is_finite(); }
    [[nodiscard]] bool rounds_with_largest() const { return false; }

    /// Corrects the forces; see PositionUnknowns.
    template <class Coupled>
    void correct(Coupled& coupled) {
        this->correct_by(
            coupled, [&](const Vector& v, Vector& out) { multiply_by_G(v, out); },
            [&](std::vector<Scalar>& x) {
                if constexpr (Coupled::Modes::exist) {
                    if (is_decoupled_) { return solve_modes<typename Coupled::Modes>(x); }
                }
                factors_.front().solve(x.data());
            });
    }

private:
    using typename PositionUnknowns<Vector>::Scalar;
    using PositionUnknowns<Vector>::n_;

    template <class Coupled>
    static constexpr std::size_t r = PositionUnknowns<Vector>::template r<Coupled>;

    void multiply_by_G(const Vector& v, Vector& out) const {
        for (std::size_t k = 0; k < n_; ++k) {
            Scalar sum = 0;
            for (std::size_t l = 0; l < n_; ++l) { sum += G_(k, l) * at(v, l); }
            at(out, k) = sum;
        }
    }

    /// Factors J as a whole; `set` puts h G K at stage j into hGK_.
    template <class Coupled, class Set>
    [[nodiscard]] bool factorise_all(const Coupled& coupled, Set set) {
        const auto& s = coupled.s;
        SquareMatrix<Scalar> J(r<Coupled> * n_);
        J.set_identity();
        for (std::size_t row = 0; row < r<Coupled>; ++row) {
            const std::size_t j = Coupled::unknown[row];
            set(j);
            for (std::size_t column = 0; column < r<Coupled>; ++column) {
                const Scalar n_ji = Coupled::coefficient(j, Coupled::unknown[column]);
                add(J, row, column, s.hb[j] * n_ji);
            }
        }
        factors_.resize(1);
        return factors_.front().compute(J);
    }

    /// Adds factor h G K to a block of J.
    void add(SquareMatrix<Scalar>& J, std::size_t row, std::size_t column, Scalar factor) const {
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t l = 0; l < n_; ++l) {
                J(row * n_ + k, column * n_ + l) += factor * hGK_(k, l);
            }
        }
    }

    template <class Modes>
    [[nodiscard]] bool factorise_modes(Scalar h) {
        factors_.resize(Modes::real_ones + Modes::pairs);
        bool regular = true;
        for (std::size_t m = 0; m < factors_.size(); ++m) {
            const Scalar alpha = h * Modes::real_parts[m];
            const bool is_pair = m >= Modes::real_ones;
            SquareMatrix<Scalar> J(is_pair ? 2 * n_ : n_);
            J.set_identity();
            add(J, 0, 0, alpha);
            if (is_pair) {
                const Scalar beta = h * Modes::imaginary_parts[m - Modes::real_ones];
                add(J, 0, 1, beta);
                add(J, 1, 0, -beta);
                add(J, 1, 1, alpha);
            }
            regular = factors_[m].compute(J) && regular;
        }
        return regular;
    }

    template <class Modes>
    void solve_modes(std::vector<Scalar>& x) {
        this->transform(Modes::to, x);
        Scalar* mode = x.data();
        for (std::size_t m = 0; m < factors_.size(); ++m) {
            factors_[m].solve(mode);
            mode += m < Modes::real_ones ? n_ : 2 * n_;
        }
        this->transform(Modes::from, x);
    }

    SquareMatrix<Scalar> G_, hGK_;
    std::vector<Factors<Scalar>> factors_;  ///< of the modes, or one for all of J
    bool is_decoupled_ = false;
};

}  // namespace detail

/// Solver policy of steppers of scenes with quadratic kinetic energy.
struct NewtonOfPositions {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<Vector, detail::PositionEquations<Vector>>;
};

}  // namespace hvi
