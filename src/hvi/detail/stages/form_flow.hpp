// Flows of quadratic forms, as matrices of twice the digits.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_FORM_FLOW_HPP
#define HVI_FORM_FLOW_HPP

#include <array>
#include <cstddef>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/compensated.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/numbers/two_product.hpp>

namespace hvi::detail {

template <class S, std::size_t N>
using PairMatrix = std::array<std::array<Pair<S>, N>, N>;

/// Returns the larger of the numbers, or NaN where one of them is that.
template <class S>
[[nodiscard]] constexpr S larger_or_nan(S a, S b) {
    return a != a || a > b ? a : b;
}

/// Returns the largest sum of the sizes in a row.
template <class S, std::size_t N>
[[nodiscard]] S norm(const PairMatrix<S, N>& matrix) {
    S result = 0;
    for (const auto& row : matrix) {
        S sum = 0;
        for (const Pair<S>& entry : row) { sum += abs(entry.hi); }
        result = larger_or_nan(sum, result);
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

/// Units of variables, which are powers of two.
template <class S, std::size_t N>
using Units = std::array<S, N>;

/// Measures the variable k in units of `unit`.
template <class S, std::size_t N>
void change_unit(PairMatrix<S, N>& matrix, std::size_t k, S unit) {
    for (std::size_t j = 0; j < N; ++j) {
        matrix[j][k] = {matrix[j][k].hi * unit, matrix[j][k].lo * unit};
        matrix[k][j] = {matrix[k][j].hi / unit, matrix[k][j].lo / unit};
    }
}

/// Returns the unit in which a variable takes part with as much as others take from it: `taken` by
/// them, and `given` by them. Where one of them is 0, the other one becomes about 1.
template <class S>
[[nodiscard]] S balanced_unit(S taken, S given) {
    S unit = 1;
    if (!is_finite(taken) || !is_finite(given) || (taken == 0 && given == 0)) { return unit; }
    if (taken == 0) { return 1 / balanced_unit(given, taken); }
    const S step = given == 0 ? S(2) : S(4);
    const S aim = given == 0 ? S(1) : given;
    for (; taken * 2 < aim; taken *= step) { unit *= 2; }
    for (; taken > aim * 2; taken /= step) { unit /= 2; }
    return unit;
}

/// Chooses units such that rows and columns are of a size, as far as a few sweeps go, and returns
/// them (Parlett and Reinsch 1969). NOTE: in units of users, kilograms of an electron, the time
/// would be halved a hundred times.
template <class S, std::size_t N>
[[nodiscard]] Units<S, N> balance(PairMatrix<S, N>& matrix) {
    constexpr int most_sweeps = 16;
    Units<S, N> units;
    units.fill(1);
    bool is_done = false;
    for (int sweep = 0; sweep < most_sweeps && !is_done; ++sweep) {
        is_done = true;
        for (std::size_t k = 0; k < N; ++k) {
            S taken = 0, given = 0;
            for (std::size_t j = 0; j < N; ++j) {
                taken += j == k ? S(0) : abs(matrix[j][k].hi);
                given += j == k ? S(0) : abs(matrix[k][j].hi);
            }
            const S unit = balanced_unit(taken, given);
            if (unit == 1) { continue; }
            change_unit(matrix, k, unit);
            units[k] *= unit;
            is_done = false;
        }
    }
    return units;
}

/// Returns exp(X) - 1, whose series is that of X/2^s, and (1 + E)^2 - 1 = 2 E + E^2 s times after
/// that. The error is about 2^s epsilon^2 beside the norm.
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
    constexpr S negligible = epsilon<S> * epsilon<S> / 64;
    const S least = norm(X) * negligible;
    PairMatrix<S, N> sum = X, term = X;
    for (int n = 2; norm(term) > least; ++n) {
        term = product(term, X);
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                term[i][j] = term[i][j] / Pair<S>{S(n)};
                sum[i][j] = sum[i][j] + term[i][j];
            }
        }
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
template <class Scalar, std::size_t n>
class FormFlow {
    static constexpr std::size_t size = 2 * n, N = size + 1;

public:
    /// The rows of (S l), each from the diagonal on.
    using Form = std::array<Scalar, n*(size + 3)>;
    using Matrix = std::array<std::array<Pair<Scalar>, N>, size>;

    FormFlow() = default;
    FormFlow(Scalar time, const Form& form) {
        PairMatrix<S, N> X = slopes(static_cast<S>(time), form);
        const Units<S, N> units = balance(X);
        const PairMatrix<S, N> D = exp_minus_one(X);
        for (std::size_t i = 0; i < size; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                const S unit = units[i] / units[j];
                const S hi = D[i][j].hi * unit, lo = D[i][j].lo * unit;
                Pair<Scalar>& entry = rows_[i][j];
                entry.hi = static_cast<Scalar>(hi);
                entry.lo = static_cast<Scalar>((hi - static_cast<S>(entry.hi)) + lo);
            }
        }
    }

    /// Returns the rows of (D d).
    [[nodiscard]] const Matrix& rows() const { return rows_; }

    /// Moves the degrees of freedom with these numbers.
    template <class Path>
    void operator()(Path& at, const std::array<std::size_t, n>& degrees) const {
        std::array<Scalar, size> z;
        for (std::size_t k = 0; k < n; ++k) {
            z[k] = at.x.q[degrees[k]];
            z[n + k] = at.x.p[degrees[k]];
        }
        for (std::size_t k = 0; k < n; ++k) {
            const Sum<Scalar> of_q = change(rows_[k], z), of_p = change(rows_[n + k], z);
            at.move_q(degrees[k], of_q.value, of_q.remainder);
            at.move_p(degrees[k], of_p.value, of_p.remainder);
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

    [[nodiscard]] static Sum<Scalar> change(const std::array<Pair<Scalar>, N>& row,
                                            const std::array<Scalar, size>& z) {
        Sum<Scalar> all{row[size].hi, row[size].lo};
        for (std::size_t j = 0; j < size; ++j) {
            const Sum<Scalar> sum = two_sum(all.value, row[j].hi * z[j]);
            all.value = sum.value;
            all.remainder += sum.remainder + row[j].lo * z[j];
        }
        return all;
    }

    Matrix rows_{};
};

}  // namespace hvi::detail

#endif  // HVI_FORM_FLOW_HPP
