// Newton's method for the stages of a step with rotations.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <hvi/detail/groups/chart.hpp>
#include <hvi/detail/groups/chart_space.hpp>
#include <hvi/detail/linear/dense.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/state.hpp>

namespace hvi {
namespace detail {

/// Derivatives of the slopes (Lq, Lp) and the torques of one stage by its place (x, y), that is by
/// (Q, xi) and (P, pi), from the second derivatives of H at the stage; see ChartStages.
template <class Space>
class ChartDerivatives {
public:
    using Scalar = typename Space::Scalar;
    static constexpr std::size_t dimension = Space::degrees_of_freedom;
    using Matrix = std::array<std::array<Scalar, dimension>, dimension>;

    Matrix q_by_x{}, q_by_y{};            ///< derivatives of dH~/d(p, pi)
    Matrix p_by_x{}, p_by_y{};            ///< derivatives of dH~/d(q, xi)
    Matrix torque_by_x{}, torque_by_y{};  ///< derivatives of exp(hat xi) D, behind the coordinates

    /// Computes the derivatives of stage i.
    template <class Stages, class Square>
    ChartDerivatives(const Stages& s, std::size_t i, const Square& Hqq, const Square& Hqp,
                     const Square& Hpp) {
        set_places(s, i);
        multiply(Hqq, Hqp, Hpp);
        for (std::size_t r = 0; r < Space::rotations; ++r) { set_rotation(s, i, r); }
    }

private:
    using Part = Vector3<Scalar>;
    static constexpr std::size_t coordinates = Space::coordinates;

    /// Sets d(q, theta) = X dx and d(p, L) = Y dy + Z dx, where theta turns the body.
    template <class Stages>
    void set_places(const Stages& s, std::size_t i) {
        for (std::size_t k = 0; k < coordinates; ++k) { X_[k][k] = Y_[k][k] = Scalar(1); }
        for (std::size_t r = 0; r < Space::rotations; ++r) {
            const auto& point = s.point(i, r);
            const Part L = Space::part(s.slopes_of_stage(i).momentum, r);
            const Matrix3<Scalar> K = point.derivative_of_T_transposed(L);
            for (std::size_t j = 0; j < 3; ++j) {
                set_column(X_, r, j, point.T(unit(j)));
                set_column(Y_, r, j, point.T_inverse_transposed(unit(j)));
                set_column(Z_, r, j, point.T_inverse_transposed(Scalar(-1) * column(K, j)));
            }
        }
    }

    /// Sets the derivatives of (dH/dq, D) and (dH/dp, Omega) by x and y.
    template <class Square>
    void multiply(const Square& Hqq, const Square& Hqp, const Square& Hpp) {
        for (std::size_t i = 0; i < dimension; ++i) {
            for (std::size_t k = 0; k < dimension; ++k) {
                for (std::size_t j = 0; j < dimension; ++j) {
                    p_by_x[i][j] += Hqq(i, k) * X_[k][j] + Hqp(i, k) * Z_[k][j];
                    p_by_y[i][j] += Hqp(i, k) * Y_[k][j];
                    q_by_x[i][j] += Hqp(k, i) * X_[k][j] + Hpp(i, k) * Z_[k][j];
                    q_by_y[i][j] += Hpp(i, k) * Y_[k][j];
                }
            }
        }
    }

    /// Turns derivatives of D and Omega into those of w = T^-1 Omega, g = T^T D - df/dxi and
    /// exp(hat xi) D.
    template <class Stages>
    void set_rotation(const Stages& s, std::size_t i, std::size_t r) {
        const auto& point = s.point(i, r);
        const auto& slope = s.slopes_of_stage(i);
        const Part L = Space::part(slope.momentum, r), D = Space::part(slope.by_q, r);
        const Part w = point.T_inverse(Space::part(slope.by_p, r));
        const Matrix3<Scalar> W = point.derivative_of_T(w);
        const Matrix3<Scalar> K = point.derivative_of_T_transposed(L);
        const Matrix3<Scalar> K_of_D = point.derivative_of_T_transposed(D);
        const Matrix3<Scalar> F = point.hessian(L, w);
        const Part torque = point.turned(D);
        for (std::size_t j = 0; j < dimension; ++j) {
            for (const bool is_by_x : {true, false}) {
                Matrix& of_q = is_by_x ? q_by_x : q_by_y;
                Matrix& of_p = is_by_x ? p_by_x : p_by_y;
                const bool moves_xi = is_by_x && begin(r) <= j && j < begin(r) + 3;
                const Part dxi = moves_xi ? unit(j - begin(r)) : Part{};
                const Part dL = get_column(is_by_x ? Z_ : Y_, r, j);
                const Part dD = get_column(of_p, r, j);
                const Part dw = point.T_inverse(get_column(of_q, r, j) - times(W, dxi));
                const Part dg = point.T_transposed(dD) + times(K_of_D, dxi) - times(F, dxi) -
                                transposed_times(W, dL) - transposed_times(K, dw);
                const Part dn = point.turned(dD) + cross(point.T_transposed(dxi), torque);
                put_column(of_q, r, j, dw);
                put_column(of_p, r, j, dg);
                put_column(is_by_x ? torque_by_x : torque_by_y, r, j, dn);
            }
        }
    }

    static constexpr std::size_t begin(std::size_t r) { return coordinates + 3 * r; }
    [[nodiscard]] static Part unit(std::size_t j) {
        Part e{};
        e[j] = Scalar(1);
        return e;
    }
    [[nodiscard]] static Part column(const Matrix3<Scalar>& A, std::size_t j) {
        return {A[j], A[3 + j], A[6 + j]};
    }
    [[nodiscard]] static Part get_column(const Matrix& A, std::size_t r, std::size_t j) {
        return {A[begin(r)][j], A[begin(r) + 1][j], A[begin(r) + 2][j]};
    }
    static void put_column(Matrix& A, std::size_t r, std::size_t j, const Part& column) {
        for (std::size_t k = 0; k < 3; ++k) { A[begin(r) + k][j] = column[k]; }
    }
    static void set_column(Matrix& A, std::size_t r, std::size_t j, const Part& column) {
        put_column(A, r, begin(r) + j, column);
    }

    Matrix X_{}, Y_{}, Z_{};
};

/// Equations of a NewtonLoop whose unknowns are Lq and Lp of all stages and pi_1 of each rotation.
/// A rotation has three unknowns more than slopes, as the momentum of the chart at the start of the
/// step is not known before its end.
template <class Vector>
class ChartEquations {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        using At = Unknowns<Coupled>;
        constexpr std::size_t size = At::end(At::dimension);
        if (values_.size() == size) { return false; }
        algebra_.resize(coupled.s.n, size);
        for (std::vector<Scalar>* v : {&values_, &correction_}) { v->resize(size); }
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        coupled.begin_without_slopes();
        gather(coupled, values_);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(Coupled& coupled) {
        return factorise(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(Coupled& coupled) {
        coupled.slopes();
        scatter(coupled);
        algebra_.set_identity();
        for (std::size_t i = 0; i < Unknowns<Coupled>::stages; ++i) { add_stage(coupled, i); }
        add_end(coupled);
        return algebra_.factorise();
    }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const { return algebra_.is_finite(); }
    [[nodiscard]] bool rounds_with_largest() const { return false; }

    /// Corrects the unknowns by -J^-1 (unknowns - values that the stages give them).
    template <class Coupled>
    void correct(Coupled& coupled) {
        auto& s = coupled.s;
        const auto turns = s.turns();
        coupled.slopes();
        s.balance(turns);
        gather(coupled, correction_);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            correction_[i] = values_[i] - correction_[i];
        }
        algebra_.solve(correction_.data());
        for (std::size_t i = 0; i < values_.size(); ++i) { values_[i] -= correction_[i]; }
        scatter(coupled);
        coupled.move();
    }

private:
    using Scalar = ScalarOf<Vector>;

    /// Places of the unknowns.
    template <class Coupled>
    struct Unknowns {
        using Stages = typename Coupled::Stages;
        using Space = typename Stages::Of;
        static constexpr std::size_t stages = Stages::count, dimension = Stages::degrees_of_freedom;
        static constexpr std::size_t coordinates = Stages::coordinates;

        static constexpr std::size_t q(std::size_t i, std::size_t k) {
            return 2 * i * dimension + k;
        }
        static constexpr std::size_t p(std::size_t i, std::size_t k) {
            return (2 * i + 1) * dimension + k;
        }
        /// Returns the place of pi_1 for component k of the momenta, which belongs to a rotation.
        static constexpr std::size_t end(std::size_t k) {
            return 2 * stages * dimension + k - coordinates;
        }
    };

    /// Sets the values to the unknowns as the stages have them.
    template <class Coupled>
    static void gather(const Coupled& coupled, std::vector<Scalar>& values) {
        using At = Unknowns<Coupled>;
        for (std::size_t k = 0; k < At::dimension; ++k) {
            for (std::size_t i = 0; i < At::stages; ++i) {
                values[At::q(i, k)] = coupled.s.slope_q(i, k);
                values[At::p(i, k)] = coupled.s.slope_p(i, k);
            }
            if (k >= At::coordinates) { values[At::end(k)] = coupled.s.pi_end[k]; }
        }
    }
    /// Gives the stages the unknowns.
    template <class Coupled>
    void scatter(Coupled& coupled) const {
        using At = Unknowns<Coupled>;
        for (std::size_t k = 0; k < At::dimension; ++k) {
            for (std::size_t i = 0; i < At::stages; ++i) {
                coupled.s.set_slope_q(i, k, values_[At::q(i, k)]);
                coupled.s.set_slope_p(i, k, values_[At::p(i, k)]);
            }
            if (k >= At::coordinates) { coupled.s.pi_end[k] = values_[At::end(k)]; }
        }
    }

    /// Adds derivatives of Lq_i - h b_i dH~/d(p, pi) and Lp_i + h b_i dH~/d(q, xi), and the
    /// torque's part of the derivatives of pi_1.
    template <class Coupled>
    void add_stage(const Coupled& coupled, std::size_t i) {
        using At = Unknowns<Coupled>;
        using Space = typename At::Space;
        const auto& s = coupled.s;
        algebra_.clear();
        coupled.second_derivatives(i, algebra_.Hqq, algebra_.Hqp, algebra_.Hpp);
        const ChartDerivatives<Space> by(s, i, algebra_.Hqq, algebra_.Hqp, algebra_.Hpp);
        const Scalar hb = s.hb[i];
        for (std::size_t k = 0; k < At::dimension; ++k) {
            add_row(coupled, i, At::q(i, k), by.q_by_x[k], by.q_by_y[k], -hb);
            add_row(coupled, i, At::p(i, k), by.p_by_x[k], by.p_by_y[k], hb);
        }
        const auto turns = s.turns();
        for (std::size_t k = At::coordinates; k < At::dimension; ++k) {
            const std::size_t r = (k - At::coordinates) / 3, first = At::coordinates + 3 * r;
            Vector3<Scalar> unit{};
            unit[k - first] = Scalar(1);
            // row k of T^T exp(-hat xi_1)
            const Vector3<Scalar> row = turns[r].turned(turns[r].T(unit));
            Vector by_x{}, by_y{};
            for (std::size_t l = 0; l < At::dimension; ++l) {
                for (std::size_t a = 0; a < 3; ++a) {
                    by_x[l] += row[a] * by.torque_by_x[first + a][l];
                    by_y[l] += row[a] * by.torque_by_y[first + a][l];
                }
            }
            add_row(coupled, i, At::end(k), by_x, by_y, hb);
        }
    }

    /// Adds factor (by_x dx_i + by_y dy_i) to a row, where x_i = sum_j m_ij Lq_j, and y_i is made
    /// of Lp with mt for momenta, and of Lp and pi_1 for rotations.
    template <class Coupled, class Row>
    void add_row(const Coupled& coupled, std::size_t i, std::size_t row, const Row& by_x,
                 const Row& by_y, const Scalar& factor) {
        using At = Unknowns<Coupled>;
        for (std::size_t k = 0; k < At::dimension; ++k) {
            const bool is_flat = k < At::coordinates;
            for (std::size_t j = 0; j < At::stages; ++j) {
                algebra_.jacobian(row, At::q(j, k)) += factor * by_x[k] * coupled.m[i][j];
                algebra_.jacobian(row, At::p(j, k)) +=
                    factor * by_y[k] * (is_flat ? coupled.mt[i][j] : -coupled.m[j][i]);
            }
            if (!is_flat) { algebra_.jacobian(row, At::end(k)) += factor * by_y[k]; }
        }
    }

    /// Adds derivatives of pi_1 - T(xi_1)^T L_1 by xi_1, with L_1 = exp(-hat xi_1)(L_0 - torques).
    template <class Coupled>
    void add_end(const Coupled& coupled) {
        using At = Unknowns<Coupled>;
        const auto turns = coupled.s.turns();
        for (std::size_t r = 0; r < At::Space::rotations; ++r) {
            const Vector3<Scalar> L = coupled.s.momentum_at_end(r, turns[r]);
            const Matrix3<Scalar> K = turns[r].derivative_of_T_transposed(L);
            for (std::size_t b = 0; b < 3; ++b) {
                Vector3<Scalar> unit{};
                unit[b] = Scalar(1);
                const Vector3<Scalar> column =
                    turns[r].T_transposed(cross(turns[r].T(unit), L)) - times(K, unit);
                for (std::size_t a = 0; a < 3; ++a) {
                    const std::size_t row = At::end(At::coordinates + 3 * r + a);
                    for (std::size_t j = 0; j < At::stages; ++j) {
                        algebra_.jacobian(row, At::q(j, At::coordinates + 3 * r + b)) += column[a];
                    }
                }
            }
        }
    }

    DenseAlgebra<Scalar> algebra_;
    std::vector<Scalar> values_, correction_;
};

}  // namespace detail

/// Solver policy of steppers of scenes with rotations.
struct NewtonOfCharts {
    static constexpr bool takes_starting_values = false;

    template <class Vector>
    using Iteration = detail::NewtonLoop<Vector, detail::ChartEquations<Vector>>;
};

}  // namespace hvi
