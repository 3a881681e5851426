// Parts of headers whose trajectories are threads of a GPU.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "generator/emit/text/text.hpp"
#include "generator/ir/step.hpp"

namespace hvi::gen {

/// Parts of the header; see templates/threads.hpp.in.
struct ThreadParts {
    std::vector<std::string> runtime;
    std::string state, steps, step, constants, coupled;
};

/// Degrees of freedom, and the name of the class.
struct ThreadSizes {
    std::size_t dimension;
    std::string_view class_name;
};

/// Returns the parts of a step that solves for its stages.
[[nodiscard]] ThreadParts thread_parts(const Step& step, const PairStep& form,
                                       const ThreadSizes& sizes);

// ---- what every form has ----

/// Writes the members of a state that each step moves.
void write_state(Writer& writer, const Step& step, std::size_t dimension);

/// Writes what rounding has cut off from the time.
void write_remainder_of_time(Writer& writer, const Step& step);

/// Writes the lines that begin a step, before anything is computed.
void begin_step(Writer& writer);

/// Writes the check of the end, where `q` and `p` are the values there, and what moves x.
void end_step(Writer& writer, const Step& step, std::string_view q, std::string_view p);

}  // namespace hvi::gen
