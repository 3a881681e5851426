// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/given_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

void GivenNames::name_constants(const Kernel& kernel) {
    for (const Node node : kernel.given) {
        const bool is_constant = graph_.at(node).operation == Operation::constant;
        if (!is_constant || graph_.is_number({{1, 1}, node}) || names_.count(node) != 0) {
            continue;
        }
        constants_.push_back(node);
        names_[node] = fmt::format("k{}", constants_.size());
    }
}

NodeNames GivenNames::given(const Kernel& kernel, const NodeNames& locals) {
    name_constants(kernel);
    NodeNames result = locals;
    for (const Node node : kernel.given) {
        if (graph_.is_number({{1, 1}, node}) || locals.count(node) != 0) { continue; }
        if (names_.count(node) == 0) {
            members_.push_back(node);
            names_[node] = fmt::format("c{}_", members_.size());
        }
        result[node] = names_.at(node);
    }
    return result;
}

NodeNames GivenNames::given_inputs(const Kernel& kernel) {
    name_constants(kernel);
    NodeNames result = inputs_;
    for (const Node node : constants_) { result[node] = names_.at(node); }
    return result;
}

Kernel GivenNames::setup() const {
    std::vector<Scaled> results;
    for (const Node node : members_) { results.push_back({{1, 1}, node}); }
    return kernel_of_inputs(graph_, results);
}

bool GivenNames::uses_inputs() const {
    const Kernel all = setup();
    return std::any_of(all.given.begin(), all.given.end(),
                       [&](Node node) { return inputs_.count(node) != 0; });
}

void GivenNames::write_setup(Writer& writer, std::string_view library) {
    const Kernel all = setup();
    const auto results = write_code(writer, graph_, all, given_inputs(all), library);
    for (std::size_t k = 0; k < results.size(); ++k) {
        writer.line("c{}_ = {};", k + 1, results[k]);
    }
}

void GivenNames::write_data(Writer& writer) const {
    for (std::size_t k = 0; k < constants_.size(); ++k) {
        const Expression& value = graph_.at(constants_[k]).constant;
        writer.line("static constexpr Scalar k{} = {};  // {}", k + 1, initializer(value),
                    to_text(value));
    }
    for (std::size_t k = 0; k < members_.size(); ++k) { writer.line("Scalar c{}_ = 0;", k + 1); }
}

}  // namespace hvi::gen
