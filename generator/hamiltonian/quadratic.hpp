// Which Hamiltonians are quadratic.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/exact/numbers/ground.hpp"
#include "generator/linear/quadratic_form.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// H as a quadratic form, where that is proved, or what is in the way.
struct QuadraticProof {
    std::optional<QuadraticForm> form;
    /// Where H is quadratic, and a coefficient of it is no number of the field: which and why.
    std::string obstacle;
};

/// The form has its coefficients on the field of `ground`. It is proved by exact algebra: the
/// second derivatives of H are the same for all values of the variables. There is none where that
/// is not so, cannot be proved (sqrt(q^4)), or where H has no value at q = p = 0 as it is written;
/// and for an H that depends on time, which has another form at each time.
/// Throws as `gradient` does.
[[nodiscard]] QuadraticProof quadratic_form(const Hamiltonian& hamiltonian, const Ground& ground);

}  // namespace hvi::gen
