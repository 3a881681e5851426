// Newton's method for the forces of stages of systems with many degrees of freedom.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include <hvi/detail/linear/gmres.hpp>
#include <hvi/detail/linear/sparse_matrix.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/solvers/newton_loop.hpp>
#include <hvi/detail/solvers/position_unknowns.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// Solves J x = b for J = 1 + h^2 (C x G K) by products with J. `times(j, v, out)` sets out = G v
/// with the G of stage j. NOTE: an inexact solution is enough for a correction, as the next one
/// corrects it.
template <class Vector>
class ProductsWithJacobian {
public:
    using Scalar = ScalarOf<Vector>;

    template <class Coupled, class Times, class Precondition>
    void solve(const Coupled& coupled, std::vector<Scalar>& b, Times&& times,
               Precondition&& precondition) {
        const auto apply = [&](const std::vector<Scalar>& x, std::vector<Scalar>& out) {
            multiply(coupled, x, out, times);
        };
        is_solved_ = gmres_.solve(b, power_of_two<Scalar>(-12), apply, precondition);
    }

    /// Returns whether the last solve() came to a solution.
    [[nodiscard]] bool is_solved() const { return is_solved_; }

private:
    /// NOTE: the factors of h^2 G K go one by one, see set_hGK().
    template <class Coupled, class Times>
    void multiply(const Coupled& coupled, const std::vector<Scalar>& x, std::vector<Scalar>& out,
                  Times& times) {
        const auto n = static_cast<std::size_t>(coupled.s.n);
        const auto& unknown = Coupled::unknown;
        out = x;
        for (Vector* v : {&sum_, &way_, &slope_}) { v->resize(n); }
        for (std::size_t row = 0; row < unknown.size(); ++row) {
            const std::size_t j = unknown[row];
            for (std::size_t k = 0; k < n; ++k) {
                Scalar sum = 0;
                for (std::size_t column = 0; column < unknown.size(); ++column) {
                    sum += Coupled::coefficient(j, unknown[column]) * x[column * n + k];
                }
                sum_[k] = coupled.s.h * sum;
            }
            coupled.system.inverse_mass(sum_, way_);
            times(j, way_, slope_);
            for (std::size_t k = 0; k < n; ++k) { out[row * n + k] += coupled.s.hb[j] * slope_[k]; }
        }
    }

    bool is_solved_ = true;
    Gmres<Scalar> gmres_;
    Vector sum_{}, way_{}, slope_{};
};

// ---- with factors ----

/// Equations of a NewtonLoop for PositionUnknowns, where G has few entries and K is diagonal.
///
/// At the start of a step all stages have the G of q. In the basis of Coupled::Modes, J falls apart
/// into 1 + alpha h^2 G K for each real eigenvalue alpha of C, and one complex system for each pair
/// of conjugate ones. These systems are factored. Where the iteration does not contract with the
/// factors, each stage gets the G of its own place. J is then solved by products with G,
/// preconditioned by the factors.
///
/// `FactorsOf<Number>` is BandFactors or SparseLuFactors.
template <class Vector, template <class> class FactorsOf>
class FactoredEquations : PositionUnknowns<Vector> {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        if (!this->make_room(coupled)) { return false; }
        const auto entries = [&](auto& out) { coupled.hessian_at_start(out); };
        start_.find_places(n_, entries);
        hGK_ = start_;
        order_ = Order(start_);
        K_.assign(n_, Scalar(0));
        coupled.system.inverse_mass(Vector(n_, Scalar(1)), K_);
        return true;
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        this->begin_at_rest(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        has_own_ = false;
        start_.set([&](auto& out) { coupled.hessian_at_start(out); });
        return factorise_modes<typename Coupled::Modes>(coupled.s.h);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        has_own_ = true;
        own_.resize(r<Coupled>, start_);
        for (std::size_t row = 0; row < r<Coupled>; ++row) {
            own_[row].set([&](auto& out) { coupled.hessian(Coupled::unknown[row], out); });
            if (!own_[row].is_finite()) { return false; }
        }
        return true;
    }

    /// Returns whether J is, or would have been, finite.
    [[nodiscard]] bool is_finite() const {
        bool is = start_.is_finite();
        for (const SparseMatrix<Scalar>& own : own_) { is = is && (!has_own_ || own.is_finite()); }
        return is;
    }

    [[nodiscard]] bool rounds_with_largest() const { return has_own_; }

    /// Corrects the forces; see PositionUnknowns.
    template <class Coupled>
    void correct(Coupled& coupled) {
        const auto by_factors = [&](std::vector<Scalar>& x) {
            solve_modes<typename Coupled::Modes>(x);
        };
        const auto own = [&](std::size_t j, const Vector& v, Vector& out) {
            multiply(own_[row_of<Coupled>(j)], v, out);
        };
        this->correct_by(
            coupled, [&](const Vector& v, Vector& out) { multiply(start_, v, out); },
            [&](std::vector<Scalar>& x) {
                if (has_own_) {
                    products_.solve(coupled, x, own, by_factors);
                } else {
                    by_factors(x);
                }
            });
        if (has_own_ && !products_.is_solved()) { this->count_as_unknown(coupled); }
    }

private:
    using typename PositionUnknowns<Vector>::Scalar;
    using PositionUnknowns<Vector>::n_;
    using Complex = std::complex<Scalar>;
    using Order = typename FactorsOf<Scalar>::Order;

    template <class Coupled>
    static constexpr std::size_t r = PositionUnknowns<Vector>::template r<Coupled>;

    template <class Coupled>
    [[nodiscard]] static std::size_t row_of(std::size_t stage) {
        std::size_t row = 0;
        while (Coupled::unknown[row] != stage) { ++row; }
        return row;
    }

    static void multiply(const SparseMatrix<Scalar>& G, const Vector& v, Vector& out) {
        for (std::size_t k = 0; k < G.size(); ++k) { out[k] = G.times(k, v); }
    }

    /// Factors the systems of the modes. NOTE: first h G K and then h times the eigenvalue, as h^2
    /// may be beyond the range of numbers. Factors of one kind take the compiler a second or more,
    /// so that none is instantiated in vain.
    template <class Modes>
    [[nodiscard]] bool factorise_modes(Scalar h) {
        hGK_ = start_;
        hGK_.for_each(
            [&](std::size_t, std::size_t j, Scalar& value) { value = h * value * K_[j]; });
        bool are_regular = true;
        if constexpr (Modes::real_ones > 0) {
            real_.resize(Modes::real_ones);
            for (std::size_t m = 0; m < Modes::real_ones; ++m) {
                const Scalar eigenvalue = h * Modes::real_parts[m];
                are_regular = real_[m].compute(hGK_, eigenvalue, order_) && are_regular;
            }
        }
        if constexpr (Modes::pairs > 0) {
            complex_.resize(Modes::pairs);
            for (std::size_t m = 0; m < Modes::pairs; ++m) {
                const Complex eigenvalue(h * Modes::real_parts[Modes::real_ones + m],
                                         -(h * Modes::imaginary_parts[m]));
                are_regular = complex_[m].compute(hGK_, eigenvalue, order_) && are_regular;
            }
        }
        return are_regular;
    }

    template <class Modes>
    void solve_modes(std::vector<Scalar>& x) {
        this->transform(Modes::to, x);
        Scalar* mode = x.data();
        if constexpr (Modes::real_ones > 0) {
            for (FactorsOf<Scalar>& factors : real_) {
                factors.solve(mode, order_);
                mode += n_;
            }
        }
        if constexpr (Modes::pairs > 0) {
            for (FactorsOf<Complex>& factors : complex_) {
                solve_pair(factors, mode, mode + n_);
                mode += 2 * n_;
            }
        }
        this->transform(Modes::from, x);
    }

    void solve_pair(FactorsOf<Complex>& factors, Scalar* real, Scalar* imaginary) {
        pair_.resize(n_);
        for (std::size_t k = 0; k < n_; ++k) { pair_[k] = Complex(real[k], imaginary[k]); }
        factors.solve(pair_.data(), order_);
        for (std::size_t k = 0; k < n_; ++k) {
            real[k] = pair_[k].real();
            imaginary[k] = pair_[k].imag();
        }
    }

    SparseMatrix<Scalar> start_, hGK_;       ///< G at the start of a step, and h G K
    std::vector<SparseMatrix<Scalar>> own_;  ///< G of each unknown
    Order order_;
    Vector K_{};
    std::vector<FactorsOf<Scalar>> real_;
    std::vector<FactorsOf<Complex>> complex_;
    std::vector<Complex> pair_;
    ProductsWithJacobian<Vector> products_;
    bool has_own_ = false;
};

// ---- without factors ----

/// Equations of a NewtonLoop for PositionUnknowns, where G has too many entries to be kept. J is
/// solved by products with the G of q at the start of a step, or with the G of all stages at their
/// own places.
template <class Vector>
class ProductEquations : PositionUnknowns<Vector> {
public:
    template <class Coupled>
    [[nodiscard]] bool fit(const Coupled& coupled) {
        return this->make_room(coupled);
    }

    template <class Coupled>
    void begin(Coupled& coupled) {
        this->begin_at_rest(coupled);
    }

    template <class Coupled>
    [[nodiscard]] bool factorise_start(const Coupled& coupled) {
        places_.assign(1, coupled.s.at.q);
        return true;
    }

    template <class Coupled>
    [[nodiscard]] bool factorise(const Coupled& coupled) {
        places_.resize(coupled.s.Q.size());
        for (const std::size_t j : Coupled::unknown) { places_[j] = coupled.s.position(j); }
        return true;
    }

    /// NOTE: a value that is not finite shows in the stages.
    [[nodiscard]] bool is_finite() const { return true; }
    [[nodiscard]] bool rounds_with_largest() const { return true; }

    /// Corrects the forces; see PositionUnknowns.
    template <class Coupled>
    void correct(Coupled& coupled) {
        this->correct_by(
            coupled,
            [&](const Vector& v, Vector& out) {
                coupled.hessian_at_start_times(places_.front(), v, out);
            },
            [&](std::vector<Scalar>& x) {
                products_.solve(
                    coupled, x,
                    [&](std::size_t j, const Vector& v, Vector& out) {
                        if (places_.size() == 1) {
                            coupled.hessian_at_start_times(places_.front(), v, out);
                        } else {
                            coupled.hessian_times(j, places_[j], v, out);
                        }
                    },
                    [](const std::vector<Scalar>&) {});
            });
        if (!products_.is_solved()) { this->count_as_unknown(coupled); }
    }

private:
    using typename PositionUnknowns<Vector>::Scalar;

    std::vector<Vector> places_;  ///< of second derivatives: one for all stages, or for each
    ProductsWithJacobian<Vector> products_;
};

}  // namespace hvi::detail
