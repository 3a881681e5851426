// The source of the library that calls MPI, which is part of hvi-gen.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/support/embedded.hpp"

namespace hvi::gen {

/// Returns one file, templates/mpi.cpp.
[[nodiscard]] std::span<const EmbeddedFile> embedded_mpi();

}  // namespace hvi::gen
