// The matrix of a quadratic Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// H as a quadratic form, or what is in the way.
struct QuadraticProof {
    std::optional<QuadraticForm> form;
    /// Where H is quadratic, and a coefficient of it is no number of the field: which and why.
    std::string obstacle;
};

/// The form has its coefficients on the field of `ground`. Whether H is quadratic, and the same at
/// all times, is what its Structure says, as of the H of a stepper. Throws InputError as lower()
/// does.
[[nodiscard]] QuadraticProof quadratic_form(const Hamiltonian& hamiltonian, const Ground& ground);

}  // namespace hvi::gen
