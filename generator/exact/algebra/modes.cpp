// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/algebra/modes.hpp"

#include <acb_mat.h>
#include <arb_mat.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "generator/exact/numbers/number_value.hpp"

namespace hvi::gen {

namespace {

constexpr Precision working_bits = 256;

/// A matrix of Arb, freed by the destructor.
class ComplexMatrix {
public:
    ComplexMatrix(slong rows, slong columns) { acb_mat_init(matrix_, rows, columns); }
    ComplexMatrix(const ComplexMatrix&) = delete;
    ComplexMatrix& operator=(const ComplexMatrix&) = delete;
    ~ComplexMatrix() { acb_mat_clear(matrix_); }

    [[nodiscard]] acb_mat_struct* get() { return matrix_; }
    [[nodiscard]] acb_ptr at(slong i, slong j) { return acb_mat_entry(matrix_, i, j); }

private:
    acb_mat_t matrix_;
};

class RealMatrix {
public:
    explicit RealMatrix(slong size) { arb_mat_init(matrix_, size, size); }
    RealMatrix(const RealMatrix&) = delete;
    RealMatrix& operator=(const RealMatrix&) = delete;
    ~RealMatrix() { arb_mat_clear(matrix_); }

    [[nodiscard]] arb_mat_struct* get() { return matrix_; }
    [[nodiscard]] arb_ptr at(slong i, slong j) { return arb_mat_entry(matrix_, i, j); }

private:
    arb_mat_t matrix_;
};

double middle(arb_srcptr ball) {
    if (arb_contains_zero(ball) != 0) {
        return 0;
    }  // else the last working_bits of the middle would show
    return arf_get_d(arb_midref(ball), ARF_RND_NEAR);
}

double size_of(acb_srcptr value) {
    return std::hypot(middle(acb_realref(value)), middle(acb_imagref(value)));
}

/// Computes eigenvalues and eigenvectors. Returns false where the eigenvalues are not isolated.
bool eigenvalues(acb_ptr values, ComplexMatrix& vectors, const NumberMatrix& C) {
    const auto n = static_cast<slong>(C.size());
    ComplexMatrix matrix(n, n), approximate_vectors(n, n);
    for (slong i = 0; i < n; ++i) {
        for (slong j = 0; j < n; ++j) {
            const Number& entry = C[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            acb_set_arb(matrix.at(i, j), enclosure(entry, working_bits).get());
        }
    }
    acb_ptr approximate = _acb_vec_init(n);
    acb_mat_approx_eig_qr(approximate, nullptr, approximate_vectors.get(), matrix.get(), nullptr, 0,
                          working_bits);
    const bool simple =
        acb_mat_eig_simple(values, nullptr, vectors.get(), matrix.get(), approximate,
                           approximate_vectors.get(), working_bits) != 0;
    _acb_vec_clear(approximate, n);
    return simple;
}

/// NOTE: normalised so that a component of nearly the largest size, the first such one, is 1. The
/// vector that Arb finds may be any multiple.
void normalise(ComplexMatrix& vectors, slong column, slong n) {
    double largest = 0;
    for (slong i = 0; i < n; ++i) { largest = std::max(largest, size_of(vectors.at(i, column))); }
    slong first = 0;
    while (size_of(vectors.at(first, column)) < 0.9 * largest) { ++first; }
    acb_t factor;
    acb_init(factor);
    acb_inv(factor, vectors.at(first, column), working_bits);
    for (slong i = 0; i < n; ++i) {
        acb_mul(vectors.at(i, column), vectors.at(i, column), factor, working_bits);
    }
    acb_clear(factor);
}

/// Place of a real eigenvalue, or of the one of a pair whose imaginary part is positive. NOTE:
/// where enclosures do not meet and one meets its own mirror image, its eigenvalue is its own
/// conjugate.
struct Place {
    slong column;
    bool is_real;
    double real, imaginary;
};

std::vector<Place> places(acb_srcptr values, slong n) {
    std::vector<Place> result;
    for (slong i = 0; i < n; ++i) {
        arb_srcptr imaginary = acb_imagref(values + i);
        const bool is_real = arb_contains_zero(imaginary) != 0;
        if (!is_real && arb_is_negative(imaginary) != 0) { continue; }
        result.push_back({i, is_real, middle(acb_realref(values + i)), middle(imaginary)});
    }
    std::sort(result.begin(), result.end(), [](const Place& a, const Place& b) {
        if (a.is_real != b.is_real) { return a.is_real; }
        return a.real != b.real ? a.real < b.real : a.imaginary < b.imaginary;
    });
    return result;
}

std::vector<std::vector<double>> doubles(RealMatrix& matrix, slong n) {
    std::vector<std::vector<double>> rows(static_cast<std::size_t>(n));
    for (slong i = 0; i < n; ++i) {
        for (slong j = 0; j < n; ++j) {
            rows[static_cast<std::size_t>(i)].push_back(middle(matrix.at(i, j)));
        }
    }
    return rows;
}

bool all_finite(const RealModes& modes) {
    const auto finite = [](const std::vector<double>& row) {
        return std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
    };
    return finite(modes.real_parts) && finite(modes.imaginary_parts) &&
           std::all_of(modes.to.begin(), modes.to.end(), finite) &&
           std::all_of(modes.from.begin(), modes.from.end(), finite);
}

/// Returns the modes. Columns are the vector of a real eigenvalue, or real and imaginary part of
/// that of a pair. C (u + iv) = (alpha + i beta)(u + iv) is C u = alpha u - beta v, C v = beta u +
/// alpha v.
std::optional<RealModes> modes_of(acb_srcptr values, ComplexMatrix& vectors, slong n) {
    RealModes modes;
    RealMatrix from(n), to(n);
    slong column = 0;
    const std::vector<Place> all = places(values, n);
    const auto columns =
        std::accumulate(all.begin(), all.end(), slong{0}, [](slong sum, const Place& place) {
            return sum + (place.is_real ? 1 : 2);
        });
    if (columns != n) { return std::nullopt; }
    for (const Place& place : all) {
        normalise(vectors, place.column, n);
        for (slong i = 0; i < n; ++i) {
            acb_ptr entry = vectors.at(i, place.column);
            arb_set(from.at(i, column), acb_realref(entry));
            if (!place.is_real) { arb_set(from.at(i, column + 1), acb_imagref(entry)); }
        }
        column += place.is_real ? 1 : 2;
        modes.real_ones += place.is_real ? 1 : 0;
        modes.real_parts.push_back(place.real);
        if (!place.is_real) { modes.imaginary_parts.push_back(place.imaginary); }
    }
    if (arb_mat_inv(to.get(), from.get(), working_bits) == 0) { return std::nullopt; }
    modes.from = doubles(from, n);
    modes.to = doubles(to, n);
    return all_finite(modes) ? std::optional(modes) : std::nullopt;
}

}  // namespace

std::optional<RealModes> real_modes(const NumberMatrix& C) {
    const auto n = static_cast<slong>(C.size());
    acb_ptr values = _acb_vec_init(n);
    ComplexMatrix vectors(n, n);
    std::optional<RealModes> modes;
    if (eigenvalues(values, vectors, C)) { modes = modes_of(values, vectors, n); }
    _acb_vec_clear(values, n);
    return modes;
}

}  // namespace hvi::gen
