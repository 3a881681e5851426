// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/forms.hpp"

#include <utility>

namespace hvi::gen {

std::vector<Form> forms(Builds& builds, const ComposedMethod& method, const Scene& scene) {
    std::vector<Form> result{
        {"as is", Solver::automatic, EdgeProgram(builds, method, scene, Solver::automatic)}};
    if (EdgeProgram iterated(builds, method, scene, Solver::fixed_point); !iterated.is_explicit()) {
        result.push_back({"fixed points", Solver::fixed_point, std::move(iterated)});
        result.push_back(
            {"Newton", Solver::newton, EdgeProgram(builds, method, scene, Solver::newton)});
    }
    return result;
}

}  // namespace hvi::gen
