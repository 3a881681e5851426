// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/loop_starts.hpp"

#include <fmt/format.h>

#include <utility>

#include "generator/lower/accesses.hpp"
#include "generator/lower/loop_elements.hpp"
#include "generator/lower/loop_terms.hpp"
#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"

namespace hvi::gen {

namespace {

class StartLowering {
public:
    StartLowering(System& system, const Declarations& names, const Scene& scene)
        : system_(system), names_(names), scene_(scene) {}

    [[nodiscard]] SystemStart start(const SystemFamily& family);

private:
    void check_count(const SystemFamily& family, std::size_t given, const Place& place) const;
    void refuse_one_by_one(const SystemFamily& family) const;
    [[nodiscard]] SystemStart start(const SystemFamily& family, const IndexedValue& value);
    [[nodiscard]] SystemStart points(const SystemFamily& family, const IndexedValue& value,
                                     const RotationValue& rotation);

    System& system_;
    const Declarations& names_;
    const Scene& scene_;
};

void StartLowering::check_count(const SystemFamily& family, std::size_t given,
                                const Place& place) const {
    const std::size_t wanted = element_count(family, names_.sizes);
    if (given == wanted) { return; }
    throw InputError(fmt::format("`{}` has {} {}, and here are {} values", family.name, wanted,
                                 wanted == 1 ? "index" : "indices", given),
                     place);
}

SystemStart StartLowering::start(const SystemFamily& family, const IndexedValue& value) {
    if (const auto* file = std::get_if<ValueFile>(&value.value)) {
        check_count(family, count(*file), value.place_of_value);
        return {numbers_in(*file)};
    }
    if (const auto* list = std::get_if<ValueList>(&value.value)) {
        check_count(family, list->values.size(), value.place_of_value);
        SystemStart::List result;
        for (const IndexedExpression& each : list->values) {
            const IndexedExpression put = names_.meant(each, initial_rules);
            const Expression number = without_sums(put);
            result.values.push_back(
                value_of_term(system_, names_, {{}, number}, put.source, names_.symbols));
        }
        result.accesses = accesses_in(system_, result.values);
        return {std::move(result)};
    }
    if (const auto* rotation = std::get_if<RotationValue>(&value.value)) {
        return points(family, value, *rotation);
    }
    const auto* rule = std::get_if<ValueRule>(&value.value);
    const IndexedExpression& written =
        rule != nullptr ? rule->value : std::get<IndexedExpression>(value.value);
    const std::vector<std::string> indices =
        rule != nullptr ? rule->indices : std::vector<std::string>{};
    check_dimension(family.name, family.ranges.size(), indices.size(), value.place,
                    "give a rule for all indices: \"x[i]\" = \"sin(i)\"");
    const IndexedExpression whole = names_.meant(written, initial_rules, indices);
    LoopTerm term{{}, without_sums(whole)};
    for (std::size_t d = 0; d < indices.size(); ++d) {
        term = within_loop(std::move(term), indices[d], family.ranges[d], names_.taken);
    }
    SystemStart::Rule result;
    for (const Loop& loop : term.loops) { result.indices.push_back(loop.index); }
    result.value = value_of_term(system_, names_, term, whole.source, names_.symbols);
    result.accesses = accesses_in(system_, {result.value});
    return {std::move(result)};
}

/// Throws NoLoops where bodies begin one by one: `"R[2]" = "identity"`.
void StartLowering::refuse_one_by_one(const SystemFamily& family) const {
    for (const IndexedValue& value : scene_.initial->values) {
        if (value.name == family.name || without_index(value.name) != family.name) { continue; }
        throw NoLoops("where sums stay loops, bodies begin by a rule for all of them", value.place,
                      "write for example \"R[k]\" = {axis = [0, 0, 1], angle = \"k/10\"}");
    }
}

/// Returns the initial values of bodies. NOTE: without indices all bodies begin alike.
SystemStart StartLowering::points(const SystemFamily& family, const IndexedValue& value,
                                  const RotationValue& rotation) {
    const std::size_t dimension = family.ranges.size() - component_dimensions(family.space);
    std::vector<std::string> indices = rotation.indices;
    if (indices.empty()) { indices.assign(dimension, "k"); }
    check_dimension(family.name, dimension, indices.size(), value.place);
    SystemStart::Points result;
    for (const IndexedExpression& entry : rotation.entries) {
        const IndexedExpression whole = names_.meant(entry, initial_rules, rotation.indices);
        LoopTerm term{{}, without_sums(whole)};
        for (std::size_t d = 0; d < dimension; ++d) {
            term = within_loop(std::move(term), indices[d], family.ranges[d], names_.taken);
        }
        result.indices.clear();
        for (const Loop& loop : term.loops) { result.indices.push_back(loop.index); }
        result.values.push_back(value_of_term(system_, names_, term, whole.source, names_.symbols));
    }
    result.accesses = accesses_in(system_, result.values);
    return {std::move(result)};
}

SystemStart StartLowering::start(const SystemFamily& family) {
    for (const IndexedValue& value : scene_.initial->values) {
        if (value.name == family.name) { return start(family, value); }
    }
    refuse_one_by_one(family);
    throw InputError(fmt::format("an initial value is missing: that of `{}`", family.name),
                     scene_.initial->place);
}

}  // namespace

std::vector<SystemStart> starts_of(System& system, const Declarations& names, const Scene& scene) {
    StartLowering lowering(system, names, scene);
    std::vector<SystemStart> result;
    for (const auto* families : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& each : *families) { result.push_back(lowering.start(each)); }
    }
    for (const IndexedValue& value : scene.initial->values) {
        const auto found = names.families.find(value.name);
        if (found == names.families.end() || found->second.kind == FamilyKind::table) {
            throw InputError(fmt::format("`{}` is no variable", value.name), value.place);
        }
    }
    return result;
}

}  // namespace hvi::gen
