// Linear equations by products with the matrix alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <hvi/detail/numbers/arithmetic.hpp>
#include <hvi/detail/numbers/math.hpp>

namespace hvi::detail {

/// The generalised minimal residual method (Saad & Schultz 1986), restarted after `most_vectors`
/// products, with a right preconditioner. NOTE: sums run over components in their order, so that
/// the bits do not depend on threads.
template <class Scalar>
class Gmres {
public:
    static constexpr std::size_t most_vectors = 40;
    static constexpr std::size_t most_rounds = 25;

    /// Replaces the right side b by x, with a residual below tolerance |b|. Returns false where
    /// that is not reached; b is then the best solution found. `apply(x, out)` sets out = A x, and
    /// `precondition(x)` replaces x by about A^-1 x.
    template <class Apply, class Precondition>
    bool solve(std::vector<Scalar>& b, Scalar tolerance, Apply&& apply,
               Precondition&& precondition) {
        // NOTE: scaled by the largest, as squares may be beyond the range of numbers where these
        // are not.
        Scalar unit = 0;
        for (const Scalar& each : b) { unit = larger(unit, abs(each)); }
        if (!(unit > 0)) { return unit == 0; }
        residual_ = b;
        for (Scalar& each : residual_) { each /= unit; }
        b.assign(b.size(), Scalar(0));
        const Scalar goal = tolerance * norm(residual_);
        const bool is_reached = improve(b, goal, apply, precondition);
        for (Scalar& each : b) { each *= unit; }
        return is_reached;
    }

private:
    template <class Apply, class Precondition>
    [[nodiscard]] bool improve(std::vector<Scalar>& x, Scalar goal, Apply& apply,
                               Precondition& precondition) {
        for (std::size_t round = 0; round < most_rounds; ++round) {
            const Scalar size = norm(residual_);
            if (!(size > goal)) { return size <= goal; }
            step_.assign(x.size(), Scalar(0));
            expand(size, goal, apply, precondition);
            precondition(step_);
            for (std::size_t i = 0; i < x.size(); ++i) { x[i] += step_[i]; }
            apply(step_, product_);
            for (std::size_t i = 0; i < x.size(); ++i) { residual_[i] -= product_[i]; }
        }
        return norm(residual_) <= goal;
    }

    [[nodiscard]] static Scalar dot(const std::vector<Scalar>& x, const std::vector<Scalar>& y) {
        Scalar sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) { sum += x[i] * y[i]; }
        return sum;
    }
    [[nodiscard]] static Scalar norm(const std::vector<Scalar>& x) { return math::sqrt(dot(x, x)); }

    /// Sets step_ to the combination of the first products that lessens the residual most.
    template <class Apply, class Precondition>
    void expand(Scalar size, Scalar goal, Apply& apply, Precondition& precondition) {
        set_vector(0, residual_, size);
        right_[0] = size;
        std::size_t count = 0;
        Scalar left = size;
        while (count < most_vectors && left > goal) {
            scratch_ = vectors_[count];
            precondition(scratch_);
            apply(scratch_, product_);
            const Scalar length = orthogonalise(count);
            rotate(count, length);
            left = abs(right_[++count]);
            if (!(length > 0) || count == most_vectors) { break; }
            set_vector(count, product_, length);
        }
        combine(count);
    }

    void set_vector(std::size_t k, const std::vector<Scalar>& from, Scalar length) {
        if (vectors_.size() == k) { vectors_.emplace_back(); }
        vectors_[k].resize(from.size());
        for (std::size_t i = 0; i < from.size(); ++i) { vectors_[k][i] = from[i] / length; }
    }

    /// Subtracts from product_ its components along the vectors. Returns the length of the rest.
    [[nodiscard]] Scalar orthogonalise(std::size_t last) {
        for (std::size_t k = 0; k <= last; ++k) {
            const std::vector<Scalar>& v = vectors_[k];
            h_[k][last] = dot(v, product_);
            for (std::size_t i = 0; i < v.size(); ++i) { product_[i] -= h_[k][last] * v[i]; }
        }
        return norm(product_);
    }

    /// Makes the matrix of the products triangular by Givens rotations.
    void rotate(std::size_t k, Scalar length) {
        for (std::size_t i = 0; i < k; ++i) {
            const Scalar above = h_[i][k], below = h_[i + 1][k];
            h_[i][k] = cosine_[i] * above + sine_[i] * below;
            h_[i + 1][k] = cosine_[i] * below - sine_[i] * above;
        }
        const Scalar radius = math::sqrt(h_[k][k] * h_[k][k] + length * length);
        cosine_[k] = radius > 0 ? h_[k][k] / radius : Scalar(1);
        sine_[k] = radius > 0 ? length / radius : Scalar(0);
        h_[k][k] = radius;
        right_[k + 1] = -sine_[k] * right_[k];
        right_[k] = cosine_[k] * right_[k];
    }

    void combine(std::size_t count) {
        for (std::size_t k = count; k-- > 0;) {
            for (std::size_t j = k + 1; j < count; ++j) { right_[k] -= h_[k][j] * right_[j]; }
            right_[k] = h_[k][k] > 0 ? right_[k] / h_[k][k] : Scalar(0);
            for (std::size_t i = 0; i < step_.size(); ++i) {
                step_[i] += right_[k] * vectors_[k][i];
            }
        }
    }

    std::vector<std::vector<Scalar>> vectors_;
    std::vector<Scalar> residual_, step_, product_, scratch_;
    Scalar h_[most_vectors + 1][most_vectors] = {};
    Scalar cosine_[most_vectors] = {}, sine_[most_vectors] = {}, right_[most_vectors + 1] = {};
};

}  // namespace hvi::detail
