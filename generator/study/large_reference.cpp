// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/study/large_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "generator/exact/methods/composed_method.hpp"
#include "generator/exact/numbers/exact_number.hpp"
#include "generator/simulate/simulation.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

constexpr double enough = 1e-16;  // errors of runs in double are above that

// Of these two the first needs less memory, and fewer evaluations where bodies come near.
constexpr const char* explicit_method = "stormer-verlet-kahan-li:8";
constexpr const char* implicit_method = "gauss:6";

/// Whether each variable has a solution.
void check_complete(const Scene& scene) {
    const std::vector<IndexedValue>& solutions = scene.exact->values;
    for (const IndexedValue& value : scene.initial->values) {
        const auto has_name = [&](const IndexedValue& each) { return each.name == value.name; };
        if (std::any_of(solutions.begin(), solutions.end(), has_name)) continue;
        throw InputError(fmt::format("an exact solution is missing: that of `{}`", value.name),
                         scene.exact->place);
    }
}

/// The scene that begins where its exact solution is at that time.
Scene exact_at(Scene scene, double until) {
    const std::map<std::string, Expression> time{{"t", exact_number(until).closed_form().value()}};
    const auto put_in = [&](IndexedExpression& solution) {
        solution.written = replaced(solution.written, time);
    };
    check_complete(scene);
    scene.initial = scene.exact;
    for (Definition& definition : scene.definitions) put_in(definition.value);
    for (IndexedValue& value : scene.initial->values) {
        if (auto* one = std::get_if<IndexedExpression>(&value.value)) put_in(*one);
        if (auto* rule = std::get_if<ValueRule>(&value.value)) put_in(rule->value);
        if (auto* list = std::get_if<ValueList>(&value.value))
            std::for_each(list->values.begin(), list->values.end(), put_in);
        if (auto* rotation = std::get_if<RotationValue>(&value.value))
            std::for_each(rotation->entries.begin(), rotation->entries.end(), put_in);
    }
    return scene;
}

SceneStepper stepper_by(const char* method, const Scene& scene) {
    const auto name = std::make_shared<const Source>(Source{"--methods", method});
    const ComposedMethod composed = composed_method(name);
    return scene_stepper(composed.method, scene,
                         {.unroll = Unroll::no, .composition = composed.composition});
}

/// A stepper of high order.
SceneStepper fine_stepper(const Scene& scene) {
    SceneStepper stepper = stepper_by(explicit_method, scene);
    if (stepper.step.is_separable()) return stepper;
    return stepper_by(implicit_method, scene);
}

std::filesystem::path temporary_files() { return std::filesystem::temp_directory_path(); }

}  // namespace

LargeReference::LargeReference(Builds& builds, const Scene& scene, double until)
    : until_(until),
      directory_(temporary_files(), "hvi-gen-reference"),
      file_(directory_.path() / "end") {
    const SceneStepper stepper =
        scene.exact ? stepper_by(explicit_method, exact_at(scene, until)) : fine_stepper(scene);
    if (!scene.exact) method_ = stepper.method.title();
    build_ = builds.order(reference_program(stepper));
}

Reference LargeReference::compute(std::int64_t count, double seconds) const {
    if (method_.empty()) {
        write_start(Program{built(build_)}, file_);
        return {"exact", 0, {}};
    }
    const auto found =
        write_reference(Program{built(build_)}, file_, until_, count, enough, seconds);
    if (!found)
        throw MathError(fmt::format("there is no reference solution: {} does not come to the end "
                                    "in {:.3g} s",
                                    method_, seconds),
                        {}, "give the scene an [exact] solution, or an earlier end by `until`");
    return {fmt::format("{} in {} bits", method_, found->bits), found->error, {}};
}

MeasureSteps LargeReference::measured(const Contender& contender) const {
    return [contender, until = until_, file = file_](std::int64_t count, double seconds) {
        return measure(contender.module.target(), {until / static_cast<double>(count), count},
                       seconds, until, file);
    };
}

}  // namespace hvi::gen
