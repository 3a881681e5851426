// Result of many steps.
// SPDX-License-Identifier: MIT
//
// NOTE: needs the standard library alone; see state.hpp.
#ifndef HVI_RUN_HPP
#define HVI_RUN_HPP

#include <cstdint>

#include <hvi/state.hpp>

namespace hvi {

/// Result of a run.
struct [[nodiscard]] Run {
    Status status;                ///< of the last step that was tried
    std::int64_t steps = 0;       ///< taken
    std::int64_t iterations = 0;  ///< of the solver, over all steps

    [[nodiscard]] bool ok() const { return status.ok(); }
};

}  // namespace hvi

#endif  // HVI_RUN_HPP
