// The matrix of a quadratic Hamiltonian.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// H as a quadratic form, or an obstacle.
struct QuadraticProof {
    std::optional<QuadraticForm> form;
    /// The coefficient of a quadratic H that is no number of the field, and why; else empty.
    std::string obstacle;
};

/// Returns the form with coefficients in the field of `ground`. The Structure of a stepper's H
/// decides whether H is quadratic, and constant in time. Throws InputError as lower() does.
[[nodiscard]] QuadraticProof quadratic_form(const Hamiltonian& hamiltonian, const Ground& ground);

}  // namespace hvi::gen
