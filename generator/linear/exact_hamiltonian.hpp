// The exact discrete right Hamiltonian of a quadratic H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"

namespace hvi::gen {

/// The Taylor series at h = 0 of the bordered H_d,exact^+ (4.1), a quadratic form in (q_0, p_1),
/// from the Type II Hamilton-Jacobi equation (2.7), which starts from q_0 p_1:
///
///     d/dh H_d,exact^+(q_0, p_1) = H(q_1, p_1),    q_1 = D_2 H_d,exact^+(q_0, p_1).
class ExactSeries {
public:
    explicit ExactSeries(const QuadraticForm& H);

    /// Returns the coefficient of h^k.
    [[nodiscard]] const NumberMatrix& operator[](std::size_t k);

private:
    void append();

    NumberMatrix H_;                      ///< bordered
    std::vector<NumberMatrix> E_;         ///< the coefficients that are known
    std::vector<NumberMatrix> end_of_E_;  ///< (q_1, p_1, 1) as functions of (q_0, p_1, 1)
};

/// Returns the exact discrete right Hamiltonian (4.1) where its closed form is known. One case is a
/// series that ends (free particles, also in a constant field). The other is one degree of freedom
/// with the frequency omega^2 = H_qq H_pp - H_qp^2, where the square root of omega^2 or -omega^2 is
/// in the field. There it is (q_0 p_1 + (H_pp p_1^2 + H_qq q_0^2) s/2)/(c - H_qp s) with c =
/// cos(omega h) and s = sin(omega h)/omega for H without a linear part. Precondition: the degrees
/// of freedom are coupled.
[[nodiscard]] std::optional<QuadraticForm> exact_discrete_hamiltonian(const QuadraticForm& H,
                                                                      const Ground& ground);

}  // namespace hvi::gen
