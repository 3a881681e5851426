// A value of a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

namespace hvi::gen {

/// A value of a step: a stage value, or a slope, Lq = h b dH/dp and Lp = -h b dH/dq.
struct StageNode {
    enum class Kind { Q, P, Lq, Lp };
    Kind kind;
    std::size_t index;         ///< the stage of a Q for Q and Lp, of a P for P and Lq
    std::size_t variable = 0;  ///< the degree of freedom, where they are distinguished

    friend bool operator==(const StageNode&, const StageNode&) = default;
};

}  // namespace hvi::gen
