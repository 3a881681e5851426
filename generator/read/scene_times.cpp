// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/scene_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/scene_words.hpp"

namespace hvi::gen {

SceneTimes times_of(const Scene& scene) {
    SceneWords words(scene);
    words.declare_stems();
    SceneTimes times;
    times.parameters = words.declare_parameters(false);
    words.define();
    times.sizes = words.sizes();
    times.place = scene.place;
    const IndexedRun& run = scene.run;
    if (run.step) { times.step = words.expression("step", run.step->expression, step_rules); }
    if (run.until) { times.until = words.expression("until", run.until->expression, until_rules); }
    return times;
}

NamedExpression expression_of_parameters(const SceneTimes& times, std::string name,
                                         std::shared_ptr<const Source> text) {
    return expression_of_parameters(times, std::move(name), whole(std::move(text)));
}

NamedExpression expression_of_parameters(const SceneTimes& times, std::string name, Place part) {
    const std::shared_ptr<const Source>& text = part.source;
    Expression read = unrolled(parse_indexed_expression(text, part.range), times.sizes);
    check_functions(read, text, "this");
    std::vector<std::string> names;
    for (const Parameter& parameter : times.parameters) { names.push_back(parameter.name); }
    walk(read, [&](const Expression& symbol) {
        const bool is_known = symbol.kind != Expression::Kind::symbol || is_constant(symbol.name) ||
                              contains(names, symbol.name);
        if (!is_known) {
            throw InputError(fmt::format("the scene has no parameter `{}`", symbol.name),
                             Place{text, symbol.range},
                             did_you_mean(symbol.name, {names.begin(), names.end()},
                                          "it may depend on parameters, pi and e"));
        }
        return true;
    });
    return {std::move(name), std::move(read), std::move(part)};
}

}  // namespace hvi::gen
