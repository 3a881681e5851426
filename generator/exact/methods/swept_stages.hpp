// The stages of a step that makes a counted number of sweeps.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "generator/exact/methods/trees.hpp"

namespace hvi::gen {

/// The ways in which a sweep takes its slopes, each at all stages. They are those of the runtime:
/// `sweep()` of src/hvi/detail/solvers/sweep.hpp.
enum class SweepForm {
    in_turn,    ///< P from Lp, Lq at these, Q from Lq, Lp at these
    at_once,    ///< P and Q, then Lq and Lp at both
    positions,  ///< in turn, and a last Lq: H = p^T K p/2 + U(q), where Lp alone is kept
};

/// Stages after K sweeps that begin with the slopes at the start of the step. The elementary weight
/// of a tree is that of the method where K sweeps reach its leaves, and else 0:
///
/// - The slopes at the start have the tree of one vertex, and no others: after 0 sweeps.
/// - A slope has a tree after as many sweeps as the slopes of its children, and one more where it
///   takes those of the sweep before. Where one of its children is not there yet, the factor 0 is.
///
/// (Jackson, Kvaerno & Norsett, Appl. Numer. Math. 15 (1994) 341, for iterations of Runge-Kutta
/// equations; with all slopes at once the sweeps count the height of a tree.)
///
/// `Base` is the arithmetic of the method: NumberStages, GalerkinStages or PolynomialStages.
template <class Base>
class SweptStages {
public:
    using Scalar = typename Base::Scalar;

    struct Function {
        typename Base::Function value;
        /// Sweeps after which the slope of a root with these children has the tree, by its colour.
        std::array<int, 2> sweeps{};
    };

    SweptStages(const Base& base, SweepForm form, int sweeps)
        : base_(base),
          form_(form),
          most_{form == SweepForm::positions ? sweeps + 1 : sweeps, sweeps},
          zero_(base.apply(Colour::f, base.one(), 0)) {}

    [[nodiscard]] auto count() const { return base_.count(); }

    [[nodiscard]] Function one() const { return {base_.one(), {}}; }

    [[nodiscard]] Function product(const Function& left, const Function& right) const {
        return {
            base_.product(left.value, right.value),
            {std::max(left.sweeps[0], right.sweeps[0]), std::max(left.sweeps[1], right.sweeps[1])}};
    }

    /// Returns `times` sum_i b_i function_i - 1 of the last slopes.
    [[nodiscard]] Scalar defect(Colour colour, const Function& function, long times) const {
        return base_.defect(colour, is_cut(colour, function) ? zero_ : function.value, times);
    }

    [[nodiscard]] Function apply(Colour colour, const Function& function, long times) const {
        const int child = function.sweeps[index(colour)];
        const bool is_of_this_sweep = form_ != SweepForm::at_once && colour == Colour::f;
        return {base_.apply(colour, function.value, times),
                {within(child + 1), within(is_of_this_sweep ? std::max(child, 1) : child + 1)}};
    }

    /// Returns whether the step has the weight 0 in place of the method's.
    [[nodiscard]] bool is_cut(Colour root, const Function& function) const {
        return function.sweeps[index(root)] > most_[index(root)];
    }

    /// Returns `times` sum_i b_i function_i of the last slopes.
    [[nodiscard]] Scalar weight(Colour colour, const Function& function, long times) const {
        return defect(colour, function, times) - base_.defect(colour, zero_, times);
    }

    /// Returns the same of the method.
    [[nodiscard]] Scalar weight_of_method(Colour colour, const Function& function,
                                          long times) const {
        return base_.defect(colour, function.value, times) - base_.defect(colour, zero_, times);
    }

    struct Less {
        bool operator()(const Function& left, const Function& right) const {
            if (left.sweeps != right.sweeps) { return left.sweeps < right.sweeps; }
            return typename Base::Less()(left.value, right.value);
        }
    };

private:
    static constexpr std::size_t index(Colour colour) { return static_cast<std::size_t>(colour); }

    /// NOTE: slopes that come too late need not be told apart.
    [[nodiscard]] int within(int sweeps) const { return std::min(sweeps, most_[0] + 1); }

    const Base& base_;
    SweepForm form_;
    std::array<int, 2> most_;  ///< sweeps of the slopes that the step ends with, by colour
    typename Base::Function zero_;
};

}  // namespace hvi::gen
