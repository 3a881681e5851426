// The Jacobian of all stages with one Hessian, in the basis in which the stages decouple.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <hvi/detail/lanes/lane_products.hpp>
#include <hvi/detail/lanes/lane_tables.hpp>
#include <hvi/detail/lanes/lanes.hpp>
#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/scalar.hpp>

namespace hvi::detail {

/// Complex numbers side by side.
template <class Lane>
struct ComplexLanes {
    Lane re, im;

    /// Adds x y. NOTE: in four operations, each a product and a sum.
    [[gnu::always_inline]] void add_product(const ComplexLanes& x, const ComplexLanes& y) {
        re = re + x.re * y.re;
        im = im + x.re * y.im;
        re = re - x.im * y.im;
        im = im + x.im * y.re;
    }

    [[nodiscard]] friend ComplexLanes operator-(const ComplexLanes& x) { return {-x.re, -x.im}; }
    [[nodiscard]] friend ComplexLanes operator-(const ComplexLanes& x, const ComplexLanes& y) {
        return {x.re - y.re, x.im - y.im};
    }
    [[nodiscard]] friend ComplexLanes operator*(const ComplexLanes& x, const ComplexLanes& y) {
        return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
    }

    /// Returns |re| + |im|.
    [[nodiscard]] friend Lane size(const ComplexLanes& x) { return abs(x.re) + abs(x.im); }

    /// Returns 1/x. NOTE: scaled first, as squares may be beyond the range of numbers.
    [[nodiscard]] friend ComplexLanes inverse(const ComplexLanes& x) {
        const Lane unit = Lane(1) / size(x);
        const ComplexLanes y{unit * x.re, unit * x.im};
        const Lane scale = unit / (y.re * y.re + y.im * y.im);
        return {scale * y.re, -(scale * y.im)};
    }
};

/// Inverse of 1 + C x S, applied to slopes of the stages in lanes, where S is a matrix of
/// `dimension` rows. In the basis of `Modes`, known when the header was written, C has complex
/// eigenvalues lambda, real ones among them. A lane for each eigenvalue holds the inverse of 1 +
/// lambda S.
///
/// NOTE: rows are not exchanged, as each lane would need other exchanges; where a pivot is small
/// beside its row, compute() returns false. Inverses are kept rather than factors: they are applied
/// ten times a step, and have no chains of operations that wait for each other.
template <class Scalar, std::size_t stages, std::size_t dimension, class Modes,
          std::size_t most = widest>
class ModeLanes {
public:
    using Slopes = LaneRows<Scalar, stages, dimension>;

    /// Computes the inverses; `S(k, l)` is an entry of S. Allocates the first time. Returns false
    /// where some 1 + lambda S is singular, nearly so, or not finite.
    template <class Entry>
    [[nodiscard]] bool compute(Entry S) {
        inverse_.resize(dimension);
        for (std::size_t k = 0; k < dimension; ++k) {
            for (std::size_t l = 0; l < dimension; ++l) {
                const Scalar entry = S(k, l);
                const Lane one(Scalar(k == l ? 1 : 0));
                put({one + entry * Lane(real), entry * Lane(imaginary)}, inverse_[k][l]);
            }
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            if (!eliminate(k)) { return false; }
        }
        return true;
    }

    /// Sets x to (1 + C x S)^-1 x. Precondition: compute() was true.
    void solve(Slopes& x) const {
        std::array<Pair, dimension> modes, solved;
        for (std::size_t k = 0; k < dimension; ++k) {
            product(to_real, x[k], Lane(Scalar(0))).store(modes[k].re);
            product(to_imaginary, x[k], Lane(Scalar(0))).store(modes[k].im);
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            Number sum = get(inverse_[k][0]) * get(modes[0]);
            for (std::size_t l = 1; l < dimension; ++l) {
                sum.add_product(get(inverse_[k][l]), get(modes[l]));
            }
            put(sum, solved[k]);
        }
        for (std::size_t k = 0; k < dimension; ++k) {
            const StageLane real_part = product(from_real, solved[k].re, StageLane(Scalar(0)));
            product(from_imaginary, solved[k].im, real_part).store(x[k]);
        }
    }

private:
    static constexpr std::size_t modes_count = Modes::real_ones + Modes::pairs;
    using Lane = Lanes<Scalar, modes_count, most>;
    using StageLane = Lanes<Scalar, stages, most>;
    using Row = typename Lane::Row;
    using Number = ComplexLanes<Lane>;

    /// Complex numbers in memory, one for each mode.
    struct Pair {
        Row re, im;
    };

    [[nodiscard, gnu::always_inline]] static Number get(const Pair& from) {
        return {Lane(from.re), Lane(from.im)};
    }
    static void put(const Number& x, Pair& to) {
        x.re.store(to.re);
        x.im.store(to.im);
    }

    /// Takes a step of Gauss-Jordan elimination, in place.
    [[nodiscard]] bool eliminate(std::size_t k) {
        constexpr Scalar least = power_of_two<Scalar>(-bits<Scalar> / 3);
        Lane row(Scalar(0));
        for (std::size_t l = k; l < dimension; ++l) { row = row + size(get(inverse_[k][l])); }
        const Number pivot = get(inverse_[k][k]);
        // NOTE: a comparison with a NaN is false, and infinity is not below infinity.
        if (!all((Lane(least) * row < size(pivot)) & (row < Lane(infinity<Scalar>)))) {
            return false;
        }
        const Number by_pivot = inverse(pivot);
        for (std::size_t l = 0; l < dimension; ++l) {
            put(l == k ? by_pivot : by_pivot * get(inverse_[k][l]), inverse_[k][l]);
        }
        for (std::size_t i = 0; i < dimension; ++i) {
            if (i == k) { continue; }
            const Number factor = get(inverse_[i][k]);
            for (std::size_t l = 0; l < dimension; ++l) {
                const Number change = factor * get(inverse_[k][l]);
                put(l == k ? -change : get(inverse_[i][l]) - change, inverse_[i][l]);
            }
        }
        return true;
    }

    // ---- the basis, as columns of lanes ----

    template <std::size_t rows, std::size_t columns>
    using Table = std::array<LaneRow<Scalar, rows>, columns>;

    /// Returns the place of the real part of a mode among the vectors of the basis; see RealModes
    /// of the generator. The imaginary part is next to it.
    [[nodiscard]] static constexpr std::size_t place(std::size_t mode) {
        return mode < Modes::real_ones ? mode : 2 * mode - Modes::real_ones;
    }
    [[nodiscard]] static constexpr bool is_pair(std::size_t mode) {
        return mode >= Modes::real_ones;
    }

    [[nodiscard]] static constexpr Table<modes_count, stages> columns_to(bool imaginary_part) {
        Table<modes_count, stages> table{};
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t m = 0; m < modes_count; ++m) {
                const bool is_zero = imaginary_part && !is_pair(m);
                table[i].set(m, is_zero ? Scalar(0) : Modes::to[place(m) + imaginary_part][i]);
            }
        }
        return table;
    }

    [[nodiscard]] static constexpr Table<stages, modes_count> columns_from(bool imaginary_part) {
        Table<stages, modes_count> table{};
        for (std::size_t m = 0; m < modes_count; ++m) {
            for (std::size_t i = 0; i < stages; ++i) {
                const bool is_zero = imaginary_part && !is_pair(m);
                table[m].set(i, is_zero ? Scalar(0) : Modes::from[i][place(m) + imaginary_part]);
            }
        }
        return table;
    }

    [[nodiscard]] static constexpr Row eigenvalues(bool imaginary_part) {
        Row row{};
        for (std::size_t m = 0; m < modes_count; ++m) {
            // NOTE: the blocks (alpha beta; -beta alpha) are products with alpha - i beta.
            row.set(m, !imaginary_part ? Modes::real_parts[m]
                       : is_pair(m)    ? -Modes::imaginary_parts[m - Modes::real_ones]
                                       : Scalar(0));
        }
        return row;
    }

    static constexpr auto to_real = columns_to(false), to_imaginary = columns_to(true);
    static constexpr auto from_real = columns_from(false), from_imaginary = columns_from(true);
    static constexpr Row real = eigenvalues(false), imaginary = eigenvalues(true);

    std::vector<std::array<Pair, dimension>> inverse_;  ///< empty until it is computed
};

}  // namespace hvi::detail
