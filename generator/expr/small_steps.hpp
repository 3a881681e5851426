// Small steps of fast parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

namespace hvi::gen {

/// The first parts of H are fast: where the other parts take one step, these take several.
struct SmallSteps {
    std::size_t parts = 0;  ///< the number of fast parts; 0: there are none
    std::size_t count = 1;  ///< the number of small steps in a large one

    [[nodiscard]] bool exist() const { return parts > 0; }
    friend bool operator==(const SmallSteps&, const SmallSteps&) = default;
};

}  // namespace hvi::gen
