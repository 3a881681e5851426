// The stages of a partitioned Runge-Kutta method given by its coefficients.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "generator/exact/methods/tableau.hpp"
#include "generator/exact/methods/trees.hpp"
#include "generator/exact/numbers/verdict.hpp"

namespace hvi::gen {

/// Coefficients for q, and with a tilde those for p.
struct PartitionedMethod {
    NumberVector b, b_tilde;
    NumberMatrix A, A_tilde;

    [[nodiscard]] std::size_t stages() const { return b.size(); }
    [[nodiscard]] bool is_exact() const;  ///< whether all numbers have a place in the field
    [[nodiscard]] bool has_parameters() const;
};

[[nodiscard]] PartitionedMethod partitioned_method(const ButcherPair& pair);

/// Coefficients, some of them known to some digits only.
struct RoundedMethod {
    PartitionedMethod written;   ///< as they are written
    PartitionedMethod enclosed;  ///< enclosures by unrounded() (see rounded.hpp)
    Precision bits;              ///< precision of their digits
};

/// Functions on the stages as vectors of exact numbers. TooLarge is thrown where they do not stay
/// exact. Precondition: the method is exact.
class NumberStages {
public:
    using Function = NumberVector;
    using Scalar = Number;

    explicit NumberStages(PartitionedMethod method) : method_(std::move(method)) {}

    [[nodiscard]] std::size_t count() const { return method_.stages(); }
    [[nodiscard]] Function one() const { return Function(method_.stages(), Number(1)); }
    [[nodiscard]] Function product(const Function& left, const Function& right) const;
    /// Returns `times` sum_i b_i function_i - 1, with b~ for g.
    [[nodiscard]] Scalar defect(Colour colour, const Function& function, long times) const;
    /// Returns A, or A~ for g, applied to a function, times a number.
    [[nodiscard]] Function apply(Colour colour, const Function& function, long times) const;

    /// An order of normal forms.
    struct Less {
        bool operator()(const Function& left, const Function& right) const;
    };

private:
    PartitionedMethod method_;
};

/// Functions on the stages for Algorithm 4.3. A and A~ are applied by their factors: A g = A_psi
/// M^-T g, and A~ g = b.g - (M^-1 A_psi^T (b g))/b. Where the coefficients are long, their products
/// with the functions of short ones, which are short again, cost far more than this. Results are
/// remembered: families of trees share functions.
class GalerkinStages : public NumberStages {
public:
    /// Precondition: the coefficients are exact, as those with free parameters are.
    GalerkinStages(const ButcherPair& pair, const Galerkin& galerkin);

    [[nodiscard]] Scalar defect(Colour colour, const Function& function, long times) const;
    [[nodiscard]] Function apply(Colour colour, const Function& function, long times) const;

private:
    [[nodiscard]] Number integral(const Function& function) const;  ///< b.function
    [[nodiscard]] Function applied(Colour colour, const Function& function) const;

    using Applied = std::map<Function, Function, Less>;
    mutable std::array<Applied, 2> applied_;  ///< by colour
    mutable std::map<Function, Number, Less> integrals_;
    NumberMatrix to_basis_;  ///< M^-T
    NumberMatrix A_psi_;
    NumberMatrix moments_;     ///< A_psi^T diag(b)
    NumberMatrix from_basis_;  ///< diag(1/b) M^-1
    NumberVector b_;
};

/// Functions on the stages as vectors of enclosures, made with `bits` bits. No two are known to be
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

/// Functions on the stages where only some digits are known. Functions with the same enclosures, as
/// those that differ in A for A~ have when A~ = A, are not told apart.
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
