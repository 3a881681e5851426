// The step of a quadratic H = T(p) + U(q), or of one degree of freedom, as a product of shears.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_LINEAR_MAP_HPP
#define HVI_LINEAR_MAP_HPP

#include <array>
#include <cstddef>

#include <hvi/detail/linear/linear_increments.hpp>
#include <hvi/detail/linear/linear_stages.hpp>
#include <hvi/detail/linear/linear_system.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>
#include <hvi/detail/numbers/pair.hpp>
#include <hvi/detail/numbers/scalar.hpp>
#include <hvi/detail/stages/system.hpp>
#include <hvi/state.hpp>

namespace hvi::detail {

/// x' = R x + r for x = (q, p): one step of a quadratic H with n degrees of freedom.
///
/// R = (A B; C D) is a product of shears, p += Y q, q += B p, p += X q, where Y = B^-1 (A - 1) and
/// X = (D - 1) B^-1. The three matrices are symmetric: for H = p^T K p/2 + q^T G q/2 they are, in
/// powers of h, made of products K G K ... K and G K G ... G. A shear with a symmetric matrix is
/// symplectic whatever its entries were rounded to. So the energy does not drift, as it does with
/// rounded entries of R, which is then not symplectic. The last shear of a step and the first of
/// the next one become one, p += (X + Y) q. Where B is singular, as for H = q p, or R is nearly -1,
/// there are no such shears, and the step is that of LinearIncrements. `shifted`: r is not zero.
///
/// NOTE: a step waits only for the q and for the momentum between the shears of the step before.
/// For n = 1 that momentum is measured in units of 1/B: an addition then moves q.
template <class Scalar, std::size_t n, bool shifted>
class LinearMap {
public:
    using Vector = std::array<Scalar, n>;  ///< type of its own; states may hold others

    LinearMap() = default;

    /// Computes the map from the tables of LinearIncrements. Precondition: H.qp is zero, or n is 1
    /// and, for stages, r is s.
    template <class... Tables>
    LinearMap(Scalar h, const Quadratic<Scalar, n>& H, const Tables&... tables)
        : increments_(h, H, tables...) {
        is_sheared_ = status().ok() && set_shears(increments_.rows);
    }

    /// Returns the status. Where it is not ok there is no map.
    [[nodiscard]] const Status& status() const { return increments_.status; }

    /// Returns the step without shears.
    [[nodiscard]] const LinearIncrements<Scalar, n>& increments() const { return increments_; }

    /// Returns whether there are shears, and so a momentum `middle` between them.
    [[nodiscard]] bool is_sheared() const { return is_sheared_; }

    /// End of a step, and the momentum between its shears.
    struct End {
        Vector q{}, p{}, middle{};
    };

    /// Returns the end of a step from q, where the last step ended with `middle`. Precondition:
    /// there are shears.
    template <class AnyVector>
    [[nodiscard]] End after(const AnyVector& q, const Vector& middle) const {
        End end;
        end.middle = plus(moved(middle, between_), XY_, q);
        if constexpr (n == 1) {
            end.q[0] = q[0] + end.middle[0];
            end.p[0] = unit_ * end.middle[0];
        } else {
            end.q = plus(own(q), B_, end.middle);
            end.p = end.middle;
        }
        end.p = plus(moved(end.p, after_), X_, end.q);
        return end;
    }

    /// Returns a vector of the own type with the components of another.
    template <class AnyVector>
    [[nodiscard]] static Vector own(const AnyVector& v) {
        Vector copy{};
        for (std::size_t i = 0; i < n; ++i) { copy[i] = at(v, i); }
        return copy;
    }

    /// Takes a step from any (q, p). `is_last` says that the last step ended here and left
    /// `middle`. Unless the status is ok nothing is changed. Precondition: there are shears.
    [[nodiscard, gnu::cold]] Status step(Vector& q, Vector& p, Vector& middle, bool is_last) const {
        const End end = after(q, is_last ? middle : middle_before(q, p));
        for (std::size_t k = 0; k < n; ++k) {
            if (!is_finite(end.q[k]) || !is_finite(end.p[k])) {
                return Status(Status::Code::not_finite);
            }
        }
        q = end.q;
        p = end.p;
        middle = end.middle;
        return {};
    }

private:
    using Matrix = std::array<Vector, n>;  // by columns
    using Number = Pair<Scalar>;

    /// Returns the value of `middle` that a last step ending at (q, p) would have left.
    [[nodiscard]] Vector middle_before(const Vector& q, const Vector& p) const {
        const Vector last = plus(shifted ? after_ : Vector{}, X_, q);
        Vector middle{};
        for (std::size_t i = 0; i < n; ++i) { middle[i] = (p[i] - last[i]) / unit_; }
        return middle;
    }

    /// Returns x + M y.
    template <class AnyVector>
    [[nodiscard]] static Vector plus(Vector x, const Matrix& M, const AnyVector& y) {
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t i = 0; i < n; ++i) { x[i] += M[j][i] * at(y, j); }
        }
        return x;
    }

    [[nodiscard]] static Vector moved(Vector x, [[maybe_unused]] const Vector& shift) {
        if constexpr (shifted) {
            for (std::size_t i = 0; i < n; ++i) { x[i] += shift[i]; }
        }
        return x;
    }

    /// Linear equations B (Y, X^T, y) = (A - 1, (D - 1)^T, r_q).
    using Shears = LinearSystem<Scalar, n, 2 * n + 1>;

    /// Sets the shears. Returns false where there are none, or they would lose digits.
    [[nodiscard]] bool set_shears(const Increments<Scalar, n>& D) {
        Shears shears;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                shears.rows[i][j] = D[i][n + j];
                shears.rows[i][n + j] = D[i][j];
                shears.rows[i][2 * n + j] = D[n + j][n + i];
            }
            shears.rows[i][3 * n] = D[i][2 * n];
        }
        if (!shears.solve()) { return false; }
        const auto B = [&](std::size_t i, std::size_t j) { return D[i][n + j]; };
        const auto Y = [&](std::size_t i, std::size_t j) { return shears.rows[i][n + j]; };
        const auto X = [&](std::size_t i, std::size_t j) { return shears.rows[j][2 * n + i]; };
        if (!keeps_digits(D, Y) || !keeps_digits(D, X)) { return false; }
        const Number one{Scalar(1)};
        const Number scale = n == 1 ? B(0, 0) : one;
        unit_ = (one / scale).hi;
        if (!math::isnormal(unit_)) { return false; }
        B_ = symmetric(B);
        X_ = symmetric(X);
        XY_ = symmetric([&](std::size_t i, std::size_t j) { return (X(i, j) + Y(i, j)) * scale; });
        // The offset r becomes a shift of p before q moves, and one after it.
        for (std::size_t i = 0; i < n; ++i) {
            Number between = D[n + i][2 * n];
            for (std::size_t j = 0; j < n; ++j) { between = between - X(i, j) * D[j][2 * n]; }
            between_[i] = (between * scale).hi;
            after_[i] = (between - shears.rows[i][3 * n]).hi;
        }
        return true;
    }

    /// Returns a matrix from its upper triangle, mirrored.
    template <class Entry>
    [[nodiscard]] static Matrix symmetric(Entry entry) {
        Matrix result{};
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i; j < n; ++j) { result[i][j] = result[j][i] = entry(i, j).hi; }
        }
        return result;
    }

    /// Returns whether S = X or Y is not large against the frequencies, the square roots of -C
    /// B^-1, and is symmetric up to rounding. It is neither where B is nearly singular. The test
    /// goes row by row, and over products with B, which have no dimension.
    template <class Entry>
    [[nodiscard]] static bool keeps_digits(const Increments<Scalar, n>& D, Entry S) {
        constexpr Scalar most = 1024;
        for (std::size_t i = 0; i < n; ++i) {
            Scalar of_shear = 0, of_R = 0, asymmetry = 0;
            for (std::size_t j = 0; j < n; ++j) {
                const Scalar B = abs(D[j][n + i].hi);
                of_shear += abs(S(i, j).hi) * B;
                of_R += abs(D[n + i][j].hi) * B;
                asymmetry += abs((S(i, j) - S(j, i)).hi) * B;
            }
            if (!(of_shear <= most * math::sqrt(of_R) && asymmetry <= epsilon<Scalar> * of_shear)) {
                return false;
            }
        }
        return true;
    }

    LinearIncrements<Scalar, n> increments_;
    Matrix B_{}, X_{}, XY_{};  // XY_ is X + Y, in units of `middle`
    Vector between_{}, after_{};
    Scalar unit_ = 1;  // of `middle`
    bool is_sheared_ = false;
};

}  // namespace hvi::detail

#endif  // HVI_LINEAR_MAP_HPP
