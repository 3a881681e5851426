// From the METHOD of the command line to a tableau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/cli/options.hpp"
#include "generator/exact/tableau.hpp"
#include "generator/read/coefficients.hpp"
#include "generator/read/hamiltonian.hpp"

namespace hvi::gen {

/// Reads the method, and gives its parameters their values.
[[nodiscard]] Method method_of(const MethodOptions& options);

/// The same, and derives its tableau.
[[nodiscard]] Tableau tableau_of(const MethodOptions& options);

/// Reads a tableau in place of a method, and gives its parameters the same values.
[[nodiscard]] Coefficients coefficients_of(const std::filesystem::path& file,
                                           const MethodOptions& options);

/// A method and a Hamiltonian, read; the parameters of both have their values.
struct System {
    Method method;
    Hamiltonian hamiltonian;
};
[[nodiscard]] System read_system(const SchemeOptions& options);

}  // namespace hvi::gen
