// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/class_includes.hpp"

#include <algorithm>
#include <iterator>

#include "generator/emit/system/class_functions.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/expr/functions.hpp"

namespace hvi::gen {

namespace {

/// Whether H calls what src/hvi/detail/lanes/lane_functions.hpp has, which others need not include.
bool calls_lane_functions(const System& system) {
    constexpr std::string_view without_library[] = {"sin", "cos", "tan"};
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        if (computation.operation != Operation::call) { continue; }
        const Function* const function = find_function(computation.name);
        const bool is_needed = function != nullptr && function->nature == Nature::analytic &&
                               std::count(std::begin(without_library), std::end(without_library),
                                          computation.name) == 0;
        if (is_needed) { return true; }
    }
    return false;
}

std::string include_of_arrays(const System& system, const Step& step, const SceneWishes& wishes) {
    std::string text = "#include <array>\n#include <cmath>";
    if (wishes.evaluations) { text += "\n#include <cstdint>"; }
    // NOTE: explicit steppers have it as a part of their own.
    if (!step.is_explicit() && calls_more_math(system, wishes)) {
        text += "\n#include <hvi/detail/numbers/more_math.hpp>";
    }
    if (step.has_lanes() && calls_lane_functions(system)) {
        text += "\n#include <hvi/detail/lanes/lane_functions.hpp>";
    }
    return text;
}

/// NOTE: explicit steppers include of hvi what they have in copies too.
std::string include_of_loops(const System& system, const SceneWishes& wishes, const Step& step) {
    std::string text = "#include <algorithm>\n#include <array>\n#include <cstdint>\n"
                       "#include <limits>\n#include <type_traits>\n#include <vector>\n\n"
                       "#include <hvi/detail/coefficients/rounded.hpp>\n"
                       "#include <hvi/detail/lanes/lane_functions.hpp>\n"
                       "#include <hvi/detail/loops/along.hpp>\n"
                       "#include <hvi/detail/loops/ranges.hpp>\n";
    text += include_of_files(system);
    if (!scattered_sums(functions_of_class(system, wishes, step, nullptr)).empty()) {
        text += "#include <hvi/detail/loops/chunks.hpp>\n";
    }
    if (system.sites) { text += "#include <hvi/detail/loops/sites.hpp>\n"; }
    if (step.layout == Layout::components) {
        text += "#include <hvi/detail/loops/stage_sweeps.hpp>\n";
    }
    return text;
}

}  // namespace

std::string includes_of_class(const System& system, const SceneWishes& wishes, const Step& step,
                              const Evaluations* evaluations) {
    return evaluations != nullptr ? include_of_arrays(system, step, wishes)
                                  : include_of_loops(system, wishes, step);
}

}  // namespace hvi::gen
