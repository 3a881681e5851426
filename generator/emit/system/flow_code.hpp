// Flows of parts of H in C++.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/emit/system/class_names.hpp"
#include "generator/ir/step.hpp"
#include "generator/ir/system.hpp"

namespace hvi::gen {

/// Ways that a compiler treats calls of flows.
enum class FlowCalls { inlined, called };

/// Returns the class Flow1, Flow2, ... of a part: its constructor takes the parameters and the time
/// of the flow, and computes what these alone decide; its call moves a state `at`, a FlowPath of
/// the runtime, in whose numbers it computes where steps carry directions. Where constants are of
/// a template it is a class of these, Flow1Of, and Flow1 and LaneFlow1 are those of one trajectory
/// and of eight, whose call moves a TrajectoryPath. `library` is the namespace of functions.
/// Precondition: the system has parts.
[[nodiscard]] std::string flow_text(const System& system, std::size_t part,
                                    std::string_view library, FlowCalls calls, Constants constants,
                                    Carries carries);

}  // namespace hvi::gen
