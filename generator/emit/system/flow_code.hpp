// Flows of parts of H in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Returns the class Flow1, Flow2, ... of a part: its constructor takes the parameters and the time
/// of the flow, and computes what these alone decide; its call moves a state `at`, a FlowPath of
/// the runtime. `library` is the namespace of functions; `is_inlined`: whether the
/// call is, where it is taken. Precondition: the system has parts.
[[nodiscard]] std::string flow_text(const System& system, std::size_t part,
                                    std::string_view library, bool is_inlined);

}  // namespace hvi::gen
