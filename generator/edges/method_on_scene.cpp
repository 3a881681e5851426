// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/method_on_scene.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/support/bar.hpp"

namespace hvi::gen {

void add_cases(EdgeChapter& chapter, const std::vector<ExactMethod>& methods,
               const std::vector<Scene>& scenes, const ProgramOf& program,
               const std::function<std::vector<EdgeCheck>(const MethodOnScene&)>& cases) {
    std::vector<MethodOnScene> all;
    for (const ExactMethod& method : methods)
        for (const Scene& scene : scenes) {
            if (auto refusal = refusal_of_general_form(method, scene))
                chapter.checks.push_back(*std::move(refusal));
            else
                all.push_back({method, scene, program(method, scene)});
        }
    Bar bar;
    double done = 0;
    for (const MethodOnScene& each : all) {
        bar.show(done++ / static_cast<double>(all.size()),
                 fmt::format("{}: {}, {}", chapter.name, each.method.name(), each.scene.name));
        for (EdgeCheck& check : cases(each)) chapter.checks.push_back(std::move(check));
    }
}

}  // namespace hvi::gen
