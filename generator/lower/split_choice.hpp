// Choice of parts for splittings where a scene names none.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/ir/system.hpp"
#include "generator/lower/split_error.hpp"
#include "generator/read/written_out_scene.hpp"

namespace hvi::gen {

/// A way to take H apart.
struct SplitCandidate {
    std::string name;  ///< `in order`
    System system;     ///< with its parts
    double cost = 0;   ///< of a step of strang, where it is measured: see cost_of_strang()
    std::optional<double> error = {};  ///< of the energy, over h^2: see split_error()

    /// Returns the work of strang to a time with an error of H, but for a factor: its steps are as
    /// long as the square root of its error is small. Precondition: the error is known.
    [[nodiscard]] double work() const;
};

/// Returns the parts that the scene names, or those that are found in these ways:
///
/// - in order: see with_parts();
/// - in reverse: these in reverse;
/// - no matrix: as in order, but no quadratic form couples what its terms do not; and in reverse;
/// - T(p), U(q), and U(q), T(p), where H is such a sum and these are other parts.
///
/// They are not measured. Throws as with_parts() does. Precondition: that of with_parts().
[[nodiscard]] std::vector<SplitCandidate> split_candidates(const System& system,
                                                           const WrittenOutScene& scene);

/// Measures candidates along the motion from the start. There are no errors where the scene has no
/// initial state, for one part, where H depends on the time, and beyond 24 degrees of freedom.
void measure(std::vector<SplitCandidate>& all, const WrittenOutScene& scene);

/// Returns the place of the candidate that splittings take: that of the least work, if it takes
/// less than nine tenths of that of the first, and all errors are known; else the first.
[[nodiscard]] std::size_t chosen_split(const std::vector<SplitCandidate>& candidates);

}  // namespace hvi::gen
