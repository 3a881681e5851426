// How hvi-gen starts itself for a module, in a process of its own: a step may crash, or never end.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace hvi::gen {

/// The first word of such a command line: it is followed by the path of the library, that of its
/// solvers or no_solvers, the directory of the scene, the number of parameters, these, and a
/// command of drive().
inline constexpr const char* drive_word = "@drive";

inline constexpr const char* no_solvers = "-";

/// The exit status where a step calls for solvers that were not given.
inline constexpr int solver_is_apart = 6;

/// The word before a command that looks at invariants where rows are written, not at each step.
inline constexpr const char* rows_word = "rows";

}  // namespace hvi::gen
