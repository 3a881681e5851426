// Flows of quadratic forms, as matrices of twice the digits.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_FORM_FLOW_HPP
#define HVI_FORM_FLOW_HPP

#include <array>
#include <cstddef>
#include <type_traits>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi::detail {

template <class S, std::size_t N>
using PairMatrix = std::array<std::array<Pair<S>, N>, N>;

/// Returns the largest sum of the sizes in a row. A NaN is not seen.
template <class S, std::size_t N>
[[nodiscard]] S norm(const PairMatrix<S, N>& matrix) {
    S result = 0;
    for (const auto& row : matrix) {
        S sum = 0;
        for (const Pair<S>& entry : row) { sum += abs(entry.hi); }
        result = larger(sum, result);
    }
    return result;
}

template <class S, std::size_t N>
[[nodiscard]] PairMatrix<S, N> product(const PairMatrix<S, N>& a, const PairMatrix<S, N>& b) {
    PairMatrix<S, N> result{};
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t k = 0; k < N; ++k) {
            if (is_zero(a[i][k])) { continue; }
            for (std::size_t j = 0; j < N; ++j) { result[i][j] = result[i][j] + a[i][k] * b[k][j]; }
        }
    }
    return result;
}

/// Returns exp(X) - 1, whose series is that of X/2^s, and (1 + E)^2 - 1 = 2 E + E^2 s times after
/// that. Each of these adds some epsilon^2 to the relative error.
///
/// NOTE: no step depends on how large entries are beside others, so that rows and columns may have
/// any units: those of users, as kilograms of an electron, only add to s.
template <class S, std::size_t N>
[[nodiscard]] PairMatrix<S, N> exp_minus_one(PairMatrix<S, N> X) {
    int halvings = 0;
    S scale = 1;
    for (S size = norm(X); size > S(1) / 4 && is_finite(size); size /= 2) {
        ++halvings;
        scale /= 2;
    }
    for (auto& row : X) {
        for (Pair<S>& entry : row) { entry = {entry.hi * scale, entry.lo * scale}; }
    }
    PairMatrix<S, N> sum = X, term = X;
    S most = S(1) / 4;  // of the norm of a term
    for (int n = 2; most > epsilon<S> * epsilon<S> / 64; ++n) {
        term = product(term, X);
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                term[i][j] = term[i][j] / Pair<S>{S(n)};
                sum[i][j] = sum[i][j] + term[i][j];
            }
        }
        most /= S(4 * n);
    }
    for (; halvings > 0; --halvings) {
        const PairMatrix<S, N> square = product(sum, sum);
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                sum[i][j] = sum[i][j] + sum[i][j] + square[i][j];
            }
        }
    }
    return sum;
}

/// The flow of H = z^T S z/2 + l^T z over a time for z = (q, p) of n degrees of freedom: z + D z +
/// d, where (D d; 0 0) is exp(t (J S, J l; 0 0)) - 1.
///
/// NOTE: numbers of the matrix are rounded to twice the digits, so that it is symplectic to these.
/// Sums keep what rounding cuts off: where they do not, the energy drifts by up to 6e-18 of it a
/// step, and by 3e-17 with a rounded matrix.
///
/// `Entry` is a Scalar, or has one for each of several trajectories.
template <class Scalar, std::size_t n, class Entry = Scalar>
class FormFlow {
    static constexpr std::size_t size = 2 * n, N = size + 1, entries = n * (size + 3);

public:
    /// The rows of (S l), each from the diagonal on.
    using Form = std::array<Scalar, entries>;

    FormFlow() = default;
    FormFlow(Scalar time, const Form& form) {
        const PairMatrix<S, N> D = exp_minus_one(slopes(static_cast<S>(time), form));
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                const auto [hi, lo] = D[i][j];
                large_[j][i] = static_cast<Scalar>(hi);
                small_[j][i] = static_cast<Scalar>((hi - static_cast<S>(large_[j][i])) + lo);
            }
        }
    }

    /// Gives a lane the matrix of one trajectory.
    void set(std::size_t lane, const FormFlow<Scalar, n>& one) {
        for (std::size_t j = 0; j < N; ++j) {
            for (std::size_t i = 0; i < size; ++i) {
                const auto [hi, lo] = one.entry(i, j);
                large_[j][i].set(lane, hi);
                small_[j][i].set(lane, lo);
            }
        }
    }

    /// Returns an entry of (D d).
    [[nodiscard]] Pair<Scalar> entry(std::size_t i, std::size_t j) const {
        return {large_[j][i], small_[j][i]};
    }

    /// Moves the degrees of freedom with these numbers.
    template <class Path>
    void operator()(Path& at, const std::array<std::size_t, n>& degrees) const {
        using Number = std::decay_t<decltype(at.x.q[0])>;
        std::array<Number, size> change, remainder;
        for (std::size_t i = 0; i < size; ++i) {
            change[i] = large_[size][i];
            remainder[i] = small_[size][i];
        }
        for (std::size_t k = 0; k < n; ++k) { add(k, at.x.q[degrees[k]], change, remainder); }
        for (std::size_t k = 0; k < n; ++k) { add(n + k, at.x.p[degrees[k]], change, remainder); }
        for (std::size_t k = 0; k < n; ++k) {
            at.move_q(degrees[k], change[k], remainder[k]);
            at.move_p(degrees[k], change[n + k], remainder[n + k]);
        }
    }

private:
    using S = Work<Scalar>;

    /// Returns t (J S, J l; 0 0): z_i' is the slope by its partner, q' = dH/dp and p' = -dH/dq.
    [[nodiscard]] static PairMatrix<S, N> slopes(S time, const Form& form) {
        PairMatrix<S, N> X{};
        const auto set = [&](std::size_t slope, std::size_t j, const Pair<S>& value) {
            if (slope < n) { X[slope + n][j] = -value; }
            if (slope >= n && slope < size) { X[slope - n][j] = value; }
        };
        auto entry = form.begin();
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = i; j < N; ++j) {
                const Pair<S> value = two_product(time, static_cast<S>(*entry++));
                set(i, j, value);
                set(j, i, value);
            }
        }
        return X;
    }

    /// Adds z times the column j. NOTE: by columns, whose entries do not wait for each other.
    template <class Number>
    void add(std::size_t j, const Number& z, std::array<Number, size>& change,
             std::array<Number, size>& remainder) const {
        for (std::size_t i = 0; i < size; ++i) {
            const Sum<Number> sum = two_sum<Number>(change[i], Number(large_[j][i]) * z);
            change[i] = sum.value;
            remainder[i] += sum.remainder + Number(small_[j][i]) * z;
        }
    }

    using Column = std::array<Entry, size>;
    std::array<Column, N> large_{}, small_{};  ///< the columns of (D d), and what was cut off
};

}  // namespace hvi::detail

#endif  // HVI_FORM_FLOW_HPP
