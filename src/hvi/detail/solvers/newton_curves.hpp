// Newton's method for the curve of a step, of a Hamiltonian or of a Lagrangian.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/end_of_corrections.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// A node of a curve, linearised with the right sides E_i:
///
///     dY_i = M_i Z_i - N_i dQ_i,    dLp_i = R_i dQ_i - N_i^T Z_i,    Z_i = sum_j X_ij dW_j + E_i.
template <class Vector>
struct LinearNode {
    using Scalar = ScalarOf<Vector>;

    explicit LinearNode(std::size_t n) : M(n), N(n), R(n) {}

    SquareMatrix<Scalar> M, N, R;
    Vector E{};
};

/// Nodes of CurveStages with their momenta eliminated. E_i = 0 and the derivatives of H at the node
/// give
///
///     M_i = Hpp^-1/(h b_i),    N_i = Hpp^-1 Hpq,    R_i = h b_i (Hqp Hpp^-1 Hpq - Hqq),
///
/// which are the second derivatives of the Legendre transform.
template <class Vector>
class HamiltonianNodes {
public:
    void resize(std::size_t n) {
        n_ = n;
        Hqq_ = Hqp_ = Hpp_ = SquareMatrix<Scalar>(n);
        column_.resize(n);
    }

    [[nodiscard]] bool is_finite() const {
        return Hqq_.is_finite() && Hqp_.is_finite() && Hpp_.is_finite();
    }

    /// Linearises node i. Returns false where d2H/dp2 is singular or not finite.
    template <class Coupled>
    [[nodiscard]] bool linearise(const Coupled& coupled, std::size_t i, LinearNode<Vector>& node) {
        for (SquareMatrix<Scalar>* block : {&Hqq_, &Hqp_, &Hpp_}) { block->set_zero(); }
        coupled.second_derivatives(i, Hqq_, Hqp_, Hpp_);
        if (!is_finite() || !inverse_.compute(Hpp_)) { return false; }
        const Scalar hb = coupled.s.hb[i];
        for (std::size_t l = 0; l < n_; ++l) {
            for (std::size_t k = 0; k < n_; ++k) { column_[k] = k == l ? 1 : 0; }
            inverse_.solve(column_.data());
            for (std::size_t k = 0; k < n_; ++k) { node.M(k, l) = column_[k] / hb; }
            for (std::size_t k = 0; k < n_; ++k) { column_[k] = Hqp_(l, k); }
            inverse_.solve(column_.data());
            for (std::size_t k = 0; k < n_; ++k) { node.N(k, l) = column_[k]; }
        }
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t l = 0; l < n_; ++l) {
                Scalar sum = -Hqq_(k, l);
                for (std::size_t m = 0; m < n_; ++m) { sum += Hqp_(k, m) * node.N(m, l); }
                node.R(k, l) = hb * sum;
            }
        }
        return true;
    }

    template <class Coupled>
    [[nodiscard]] static Vector right_side(const Coupled& coupled, std::size_t i) {
        return coupled.s.defect_of_velocity(i, coupled.table_X());
    }

private:
    using Scalar = ScalarOf<Vector>;

    SquareMatrix<Scalar> Hqq_, Hqp_, Hpp_;
    Factors<Scalar> inverse_;
    std::vector<Scalar> column_;
    std::size_t n_ = 0;
};

/// Nodes of LagrangianStages, where E_i = 0 and
///
///     M_i = Lvv/(h b_i),    N_i = -Lvq,    R_i = h b_i Lqq.
template <class Vector>
class LagrangianNodes {
public:
    void resize(std::size_t n) {
        n_ = n;
        Lqq_ = Lqv_ = Lvv_ = SquareMatrix<Scalar>(n);
    }

    [[nodiscard]] bool is_finite() const {
        return Lqq_.is_finite() && Lqv_.is_finite() && Lvv_.is_finite();
    }

    template <class Coupled>
    [[nodiscard]] bool linearise(const Coupled& coupled, std::size_t i, LinearNode<Vector>& node) {
        for (SquareMatrix<Scalar>* block : {&Lqq_, &Lqv_, &Lvv_}) { block->set_zero(); }
        coupled.second_derivatives(i, Lqq_, Lqv_, Lvv_);
        const Scalar hb = coupled.s.hb[i];
        for (std::size_t k = 0; k < n_; ++k) {
            for (std::size_t l = 0; l < n_; ++l) {
                node.M(k, l) = Lvv_(k, l) / hb;
                node.N(k, l) = -Lqv_(l, k);
                node.R(k, l) = hb * Lqq_(k, l);
            }
        }
        return is_finite();
    }

    template <class Coupled>
    [[nodiscard]] static Vector right_side(const Coupled& coupled, std::size_t i) {
        Vector none = coupled.s.Y[i];
        for (IndexOf<Vector> k = 0; k < none.size(); ++k) { none[k] = 0; }
        return none;
    }

private:
    using Scalar = ScalarOf<Vector>;

    SquareMatrix<Scalar> Lqq_, Lqv_, Lvv_;
    std::size_t n_ = 0;
};

/// Equations F_j = 0 of a NewtonLoop whose unknowns are the W_j; see Curve. `Nodes` linearises the
/// nodes.
template <class Vector, class Nodes>
class CurveEquations {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        const auto n = static_cast<std::size_t>(coupled.s.n);
        const std::size_t size = Coupled::functions * n;
        if (correction_.size() == size) { return false; }
        n_ = n;
        J_ = SquareMatrix<Scalar>(size);
        nodes_.assign(Coupled::nodes, LinearNode<Vector>(n));
        derivatives_.resize(n);
        correction_.resize(size);
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        coupled.s.rest();
        coupled.positions();
        coupled.s.momenta();
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        return factorise(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        J_.set_zero();
        for (std::size_t i = 0; i < Coupled::nodes; ++i) {
            if (!derivatives_.linearise(coupled, i, nodes_[i])) { return false; }
            for (std::size_t j = 0; j < Coupled::functions; ++j) {
                for (std::size_t k = 0; k < Coupled::functions; ++k) { add(coupled, i, j, k); }
            }
        }
        return factors_.compute(J_);
    }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return derivatives_.is_finite() && J_.is_finite(); }
    [[nodiscard]] bool rounds_with_largest() const { return false; }

    /// Corrects the W_j. NOTE: the corrected Lp_i are what the step adds up: see PairEquations.
    template <class Coupled>
    void correct(Coupled& coupled) {
        auto& s = coupled.s;
        coupled.slopes();
        for (std::size_t i = 0; i < Coupled::nodes; ++i) {
            nodes_[i].E = Nodes::right_side(coupled, i);
        }
        set_right_side(coupled);
        factors_.solve(correction_.data());
        for (std::size_t j = 0; j < Coupled::functions; ++j) {
            for (std::size_t k = 0; k < n_; ++k) { at(s.W[j], k) += correction_[j * n_ + k]; }
        }
        for (std::size_t i = 0; i < Coupled::nodes; ++i) { correct_node(coupled, i); }
        coupled.positions();
        s.momenta();
    }

private:
    using Scalar = ScalarOf<Vector>;

    /// Adds the part of node i to dF_j/dW_k.
    template <class Coupled>
    void add(const Coupled& coupled, std::size_t i, std::size_t j, std::size_t k) {
        const Scalar X_j = coupled.table_X()[i][j], D_j = coupled.table_D()[i][j];
        const Scalar X_k = coupled.table_X()[i][k], A_k = coupled.table_A()[i][k];
        const auto& [M, N, R, E] = nodes_[i];
        for (std::size_t row = 0; row < n_; ++row) {
            for (std::size_t column = 0; column < n_; ++column) {
                J_(j * n_ + row, k * n_ + column) +=
                    X_j * (X_k * M(row, column) - A_k * N(row, column)) +
                    D_j * (X_k * N(column, row) - A_k * R(row, column));
            }
        }
    }

    /// Sets the right side to -F_j at the Y_i and Lp_i that dW = 0 leads to.
    template <class Coupled>
    void set_right_side(const Coupled& coupled) {
        for (std::size_t j = 0; j < Coupled::functions; ++j) {
            const Vector F = coupled.s.defect(j, coupled.table_X(), coupled.table_D());
            for (std::size_t k = 0; k < n_; ++k) {
                Scalar sum = -at(F, k);
                for (std::size_t i = 0; i < Coupled::nodes; ++i) {
                    const auto& [M, N, R, E] = nodes_[i];
                    for (std::size_t l = 0; l < n_; ++l) {
                        sum -= (coupled.table_X()[i][j] * M(k, l) +
                                coupled.table_D()[i][j] * N(l, k)) *
                               at(E, l);
                    }
                }
                correction_[j * n_ + k] = sum;
            }
        }
    }

    /// Corrects Y_i and Lp_i by the corrections of the W_j.
    template <class Coupled>
    void correct_node(Coupled& coupled, std::size_t i) {
        auto& [M, N, R, Z] = nodes_[i];
        Vector dQ = Z;
        for (std::size_t k = 0; k < n_; ++k) {
            at(dQ, k) = 0;
            for (std::size_t j = 0; j < Coupled::functions; ++j) {
                at(dQ, k) += coupled.table_A()[i][j] * correction_[j * n_ + k];
                at(Z, k) += coupled.table_X()[i][j] * correction_[j * n_ + k];
            }
        }
        for (std::size_t k = 0; k < n_; ++k) {
            Scalar dY = 0, dLp = 0;
            for (std::size_t l = 0; l < n_; ++l) {
                dY += M(k, l) * at(Z, l) - N(k, l) * at(dQ, l);
                dLp += R(k, l) * at(dQ, l) - N(l, k) * at(Z, l);
            }
            at(coupled.s.Y[i], k) += dY;
            at(coupled.s.Lp[i], k) += dLp;
        }
    }

    Nodes derivatives_;
    std::vector<LinearNode<Vector>> nodes_;
    SquareMatrix<Scalar> J_;
    Factors<Scalar> factors_;
    std::vector<Scalar> correction_;
    std::size_t n_ = 0;
};

/// A NewtonLoop that, where it fails, goes from shorter steps to the whole one. Each begins with
/// the curve of the one before it, so that it ends at the solution that h -> 0 leads to.
///
/// NOTE: Newton's corrections at rest may be so long that the next ones are taken where d2H/dp2 is
/// as good as singular, though it is regular at the solution. Merely shortened corrections get
/// stuck on steps that are still solved in this way.
template <class Vector, class Equations>
class NewtonAlongSteps {
public:
    template <class Coupled>
    [[nodiscard]] Status solve(Coupled coupled) {
        const Status status = loop_.solve(coupled);
        return status.ok() ? status : solve_along(coupled, status);
    }

private:
    using Scalar = ScalarOf<Vector>;
    using Now = typename EndOfCorrections<Vector>::Now;

    /// Solves the step by way of shorter ones. `failed`: status of the whole step.
    template <class Coupled>
    [[nodiscard]] Status solve_along(Coupled& coupled, const Status& failed) {
        constexpr Scalar shortest = Scalar(1) / 256;
        auto& s = coupled.s;
        const auto hb = s.hb;
        static_cast<void>(equations_.fit(coupled));
        equations_.begin(coupled);
        auto W = s.W;
        auto Y = s.Y;
        iterations_ = failed.iterations;
        Scalar reached = 0, length = Scalar(1) / 2;  // parts of the whole step
        while (reached < 1 && length >= shortest) {
            const Scalar next = reached + length < 1 ? reached + length : Scalar(1);
            const Scalar growth = reached > 0 ? next / reached : Scalar(0);
            for (std::size_t i = 0; i < hb.size(); ++i) { s.hb[i] = next * hb[i]; }
            set_multiple(s.W, growth, W);
            set_multiple(s.Y, growth, Y);
            if (converges(coupled)) {
                reached = next;
                W = s.W;
                Y = s.Y;
            }
            length = reached == next ? 2 * length : length / 2;
        }
        s.hb = hb;
        return reached < 1 ? reason(failed) : Status(Status::Code::ok, iterations_);
    }

    template <class Vectors>
    static void set_multiple(Vectors& result, Scalar factor, const Vectors& of) {
        for (std::size_t i = 0; i < of.size(); ++i) {
            for (IndexOf<Vector> k = 0; k < of[i].size(); ++k) { result[i][k] = factor * of[i][k]; }
        }
    }

    /// Returns whether a shorter step converges. NOTE: where corrections do not contract at once,
    /// they may lead to another solution.
    template <class Coupled>
    [[nodiscard]] bool converges(Coupled& coupled) {
        constexpr int most = 15;
        coupled.positions();
        coupled.s.momenta();
        end_.begin(coupled.s.n);
        for (int iteration = 0; iteration < most; ++iteration) {
            if (!equations_.factorise(coupled)) { return false; }
            equations_.correct(coupled);
            ++iterations_;
            const Now now = end_.judge(coupled);
            if (now != Now::go_on) { return now == Now::ended; }
            if (!end_.contracts()) { return false; }
        }
        return false;
    }

    /// Returns the status of a failure. A step is singular, or not finite, where it is so at its
    /// beginning; otherwise the iteration has only been led astray.
    [[nodiscard]] Status reason(const Status& failed) const {
        const int at_start = failed.code() == Status::Code::singular ? 0 : 1;
        const bool is_astray = failed.iterations > at_start;
        return Status(is_astray ? Status::Code::not_converged : failed.code(), iterations_);
    }

    NewtonLoop<Vector, Equations> loop_;
    Equations equations_;
    EndOfCorrections<Vector> end_;
    int iterations_ = 0;
};

}  // namespace detail

/// Solver policy of steppers of the general Galerkin form.
struct NewtonOfCurves {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration =
        detail::NewtonAlongSteps<Vector,
                                 detail::CurveEquations<Vector, detail::HamiltonianNodes<Vector>>>;
};

/// Solver policy of steppers of the general Galerkin form of Lagrangians.
struct NewtonOfLagrangians {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration =
        detail::NewtonAlongSteps<Vector,
                                 detail::CurveEquations<Vector, detail::LagrangianNodes<Vector>>>;
};

}  // namespace hvi
