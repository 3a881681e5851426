// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/function_list.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include "generator/emit/system/loop_writer.hpp"

namespace hvi::gen {

namespace {

/// Returns whether a function is inlined. NOTE: no lane lives through a call, and g++ does not
/// inline by itself what a composition calls twenty times. In a large function the call does not
/// matter. And the constants of several sin that are inlined into a loop would occupy registers
/// that other values need.
bool is_inlined(const Kernel& kernel, const Step& step) {
    constexpr std::size_t small = 32;
    const std::size_t most_calls = step.layout == Layout::stages ? 1 : 0;
    return step.has_lanes() && kernel.counts.calls <= most_calls && kernel.nodes.size() <= small;
}

}  // namespace

bool uses_any(const Kernel& kernel, const std::vector<Node>& nodes) {
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](Node node) { return kernel.uses[node] != 0; });
}

std::vector<std::string> components(std::string_view letter, std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) { names.push_back(fmt::format("{}[{}]", letter, k)); }
    return names;
}

SystemFunction& FunctionList::add(std::string name, Takes takes, FunctionBody body,
                                  std::vector<Argument> others, std::string doc) {
    std::vector<Argument> arguments = variables(takes, body);
    std::move(others.begin(), others.end(), std::back_inserter(arguments));
    functions_.push_back({std::move(name), std::move(arguments), std::move(body), std::move(doc)});
    return functions_.back();
}

std::vector<Argument> FunctionList::variables(Takes takes, const FunctionBody& body) const {
    const auto* code = std::get_if<StraightCode>(&body);
    const bool are_lanes = code != nullptr && code->takes_lanes;
    const bool calls = std::holds_alternative<Statements>(body);
    const bool are_named = std::holds_alternative<BodyOfSums>(body);
    const bool have_places = code != nullptr && rotations_of(system_) > 0;
    const std::string_view vectors = are_lanes ? "Values" : "Vector";
    const std::string_view places = !have_places ? vectors : are_lanes ? "Places" : "Positions";
    const std::string_view of = are_named ? "_of" : "";
    std::vector<Argument> result;
    if (takes.q) {
        result.push_back(
            {fmt::format("const {}& q{}", places, of),
             code != nullptr ? uses_any(code->kernel, coordinate_nodes(system_)) : calls});
    }
    if (takes.p) {
        result.push_back(
            {fmt::format("const {}& {}{}", vectors, system_.conjugate_letter(), of),
             code != nullptr ? uses_any(code->kernel, conjugate_nodes(system_)) : calls});
    }
    if (takes.time) {
        result.push_back({are_lanes ? "const hvi::detail::ScalarOf<Values>& t" : "Scalar t",
                          code != nullptr ? uses_any(code->kernel, {*system_.time}) : calls});
    }
    return result;
}

SystemFunction& FunctionList::add_of_lanes(std::string name, Takes takes, StraightCode code,
                                           std::vector<Argument> others) {
    code.takes_lanes = step_.has_lanes();
    const bool inlined = is_inlined(code.kernel, step_);
    SystemFunction& function = add(std::move(name), takes, std::move(code), std::move(others));
    function.is_inlined = inlined;
    if (step_.has_lanes()) {
        function.parameters =
            rotations_of(system_) > 0
                ? "class Places, class Values, class Value = hvi::detail::ScalarOf<Values>"
                : "class Values, class Value = hvi::detail::ScalarOf<Values>";
    }
    return function;
}

SystemFunction& FunctionList::add_slope(std::string name, Takes takes, const Kernel& kernel) {
    const std::size_t n = system_.degrees_of_freedom();
    return add_of_lanes(std::move(name), takes, {kernel, components("out", n)},
                        {{reference("out")}});
}

void FunctionList::add_block(std::string name, Takes takes,
                             const std::optional<BlockKernel>& block) {
    if (!block) { return; }
    StraightCode code{block->kernel};
    for (const auto& [row, column] : block->places) {
        code.targets.push_back(fmt::format("out({}, {})", row, column));
        code.is_mirrored = code.is_mirrored || (block->is_symmetric && row != column);
    }
    add(std::move(name), takes, std::move(code), {{"Matrix& out", !block->places.empty()}})
        .parameters = "class Matrix";
}

SystemFunction& FunctionList::add_scattered(const Scatter& scatter,
                                            const std::vector<SystemSum>& sums, Numbers numbers) {
    std::vector<std::string> names, passed;
    std::vector<Argument> arguments;
    for (const auto& [array, is_argument] : scatter.arrays) {
        names.push_back(array);
        passed.push_back(is_argument ? array + ".data()" : "nullptr");
        if (is_argument) { arguments.push_back({"const Vector& " + array, false}); }
    }
    if (scatter.has_time) { arguments.push_back({"Scalar t", false}); }
    arguments.push_back({"Vector& out"});
    ScatteredSums all{{}, fmt::format("{}", fmt::join(passed, ", "))};
    for (std::size_t s = 0; s < sums.size(); ++s) {
        const auto& slopes = scatter.by_q ? sums[s].by_q : sums[s].by_conjugates;
        if (slopes.empty()) { continue; }
        const std::size_t number = numbers == Numbers::of_all ? s : all.sums.size();
        all.sums.push_back({fmt::format("{}_{}", scatter.each, number + 1), &sums[s], &slopes,
                            names, scatter.has_time, needs_totals(system_, values(slopes))});
        add_derivatives(all.sums.back());
    }
    return add(scatter.name, no_variables, std::move(all), std::move(arguments), scatter.doc);
}

void FunctionList::add_derivatives(const DerivativesOfSum& derivatives) {
    std::vector<Argument> arguments;
    for (const std::string& array : derivatives.arrays) {
        arguments.push_back({"const Scalar* " + array, false});
    }
    if (derivatives.has_time) { arguments.push_back({"Scalar t", false}); }
    if (derivatives.has_totals) { arguments.push_back({"const Scalar* totals"}); }
    arguments.push_back({"Scalar* out"});
    const std::size_t loops = derivatives.sum->loops.size();
    if (loops > 0) { arguments.insert(arguments.end(), {{"Place from"}, {"Place to"}}); }
    if (loops > 1) { arguments.push_back({"Place stride"}); }
    add(derivatives.name, no_variables, derivatives, std::move(arguments));
}

}  // namespace hvi::gen
