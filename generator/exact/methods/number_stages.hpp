// The stages of a partitioned Runge-Kutta method given by its coefficients.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/methods/trees.hpp"
#include "generator/exact/numbers/verdict.hpp"

namespace hvi::gen {

/// The coefficients for q, and with a tilde those for p.
struct PartitionedMethod {
    NumberVector b, b_tilde;
    NumberMatrix A, A_tilde;

    [[nodiscard]] std::size_t stages() const { return b.size(); }
    [[nodiscard]] bool is_exact() const;  ///< all numbers have a place in the field
};

[[nodiscard]] PartitionedMethod partitioned_method(const Tableau& tableau);

/// Coefficients of which some are known to some digits only.
struct RoundedMethod {
    PartitionedMethod written;   ///< as they are written
    PartitionedMethod enclosed;  ///< the same, as unrounded() has them (see rounded.hpp)
    Precision bits;              ///< what their digits take
};

/// Functions on the stages as vectors of exact numbers. Precondition: the method is exact.
class NumberStages {
public:
    using Function = NumberVector;
    using Scalar = Number;

    explicit NumberStages(PartitionedMethod method) : method_(std::move(method)) {}

    [[nodiscard]] std::size_t count() const { return method_.stages(); }
    [[nodiscard]] Function one() const { return Function(method_.stages(), Number(1)); }
    [[nodiscard]] Function product(const Function& left, const Function& right) const;
    /// times sum_i b_i function_i - 1, with b~ for g.
    [[nodiscard]] Scalar defect(Colour colour, const Function& function, long times) const;
    /// A function, with A~ for g, times a number.
    [[nodiscard]] Function apply(Colour colour, const Function& function, long times) const;

    /// An order of normal forms.
    struct Less {
        bool operator()(const Function& left, const Function& right) const;
    };

private:
    PartitionedMethod method_;
};

/// Functions on the stages as vectors of enclosures, made with so many bits. No two are known to be
/// equal.
class BallStages {
public:
    using Function = std::shared_ptr<const std::vector<Ball>>;
    using Scalar = Ball;
    using Less = std::less<Function>;

    BallStages(const PartitionedMethod& method, Precision bits);

    [[nodiscard]] std::size_t count() const { return b_.size(); }
    [[nodiscard]] Function one() const;
    [[nodiscard]] Function product(const Function& left, const Function& right) const;
    [[nodiscard]] Scalar defect(Colour colour, const Function& function, long times) const;
    [[nodiscard]] Function apply(Colour colour, const Function& function, long times) const;

private:
    std::vector<Ball> b_, b_tilde_;
    std::vector<std::vector<Ball>> A_, A_tilde_;
    Precision bits_;
};

/// The same where only some digits are known. Functions with the same enclosures, as those that
/// differ in A for A~ have when A~ = A, are not told apart.
class RoundedStages : public BallStages {
public:
    explicit RoundedStages(const RoundedMethod& method)
        : BallStages(method.enclosed, method.bits) {}

    /// An order of enclosures.
    struct Less {
        bool operator()(const Function& left, const Function& right) const;
    };
};

}  // namespace hvi::gen
