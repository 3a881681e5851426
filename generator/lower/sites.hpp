// A lattice seen from its sites.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the system with its sites, where it is a lattice; their values are added to the graph.
/// Precondition: the slopes are there.
[[nodiscard]] System with_sites(System system);

}  // namespace hvi::gen
