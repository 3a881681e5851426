// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/class_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/names.hpp"

namespace hvi::gen {

std::string member_of(const std::string& name) { return member_name(name); }

namespace {

/// Returns the names of parameters and sizes, in the constructor.
NodeNames inputs_of(const System& system) {
    NodeNames names = parameter_names(system);
    for (Node node = 0; node < system.graph.size(); ++node) {
        const Computation& computation = system.graph.at(node);
        const bool is_size =
            computation.operation == Operation::input &&
            std::any_of(system.sizes.begin(), system.sizes.end(),
                        [&](const SystemSize& size) { return size.name == computation.name; });
        if (!is_size) { continue; }
        names[node] =
            fmt::format("static_cast<Scalar>(parameters.{})", member_of(computation.name));
    }
    return names;
}

/// Converts the names of these values to a type.
void convert(NodeNames& names, const std::vector<Node>& values, std::string_view type) {
    for (const Node node : values) {
        const auto found = names.find(node);
        if (found != names.end()) { found->second = fmt::format("{}({})", type, found->second); }
    }
}

}  // namespace

std::string whole_number(const AffineForm& form,
                         const std::function<std::string(const std::string&)>& called) {
    std::string text;
    const auto add = [&](bool is_negative, const std::string& size) {
        text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
        text += size;
    };
    for (const auto& [name, coefficient] : form.coefficients) {
        const long size = std::labs(coefficient);
        const std::string text_of_name = called(name);
        add(coefficient < 0, size == 1 ? text_of_name : fmt::format("{} * {}", size, text_of_name));
    }
    if (form.constant != 0 || text.empty()) {
        add(form.constant < 0, std::to_string(std::labs(form.constant)));
    }
    return text;
}

NodeNames variable_names(const System& system) {
    NodeNames names;
    const auto add = [&](const std::vector<Node>& nodes, char letter) {
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            names[nodes[k]] = fmt::format("{}[{}]", letter, k);
        }
    };
    add(coordinate_nodes(system), 'q');
    add(conjugate_nodes(system), system.conjugate_letter());
    if (system.time) { names[*system.time] = "t"; }
    return names;
}

ClassNames::ClassNames(const System& system, Constants constants)
    : system_(system), graph_(system.graph), constants_of_(constants), inputs_(inputs_of(system)) {
    if (constants != Constants::are_of_device) { return; }
    for (auto& [node, name] : inputs_) { name = fmt::format("Scalar({})", name); }
}

void ClassNames::name_constants(const Kernel& kernel) {
    for (const Node node : kernel.given) {
        const bool is_constant = graph_.at(node).operation == Operation::constant;
        if (!is_constant || graph_.is_number({{1, 1}, node}) || names_.count(node) != 0) {
            continue;
        }
        constants_.push_back(node);
        names_[node] = fmt::format("k{}{}", constants_.size(),
                                   constants_of_ == Constants::are_of_device ? "()" : "");
    }
}

NodeNames ClassNames::given(const Kernel& kernel, const NodeNames& locals) {
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

NodeNames ClassNames::converted(NodeNames names, std::string_view value) const {
    if (constants_of_ != Constants::are_of_template) { return names; }
    convert(names, members_, value);
    return names;
}

NodeNames ClassNames::all_converted(NodeNames names, std::string_view value) const {
    convert(names, members_, value);
    convert(names, constants_, value);
    return names;
}

NodeNames ClassNames::given_inputs(const Kernel& kernel) {
    name_constants(kernel);
    NodeNames result = inputs_;
    for (const Node node : constants_) { result[node] = names_.at(node); }
    return result;
}

Kernel ClassNames::setup() const {
    std::vector<Scaled> results;
    for (const Node node : members_) { results.push_back({{1, 1}, node}); }
    return kernel_of_inputs(graph_, results);
}

bool ClassNames::uses_inputs() const {
    const Kernel all = setup();
    return std::any_of(all.given.begin(), all.given.end(),
                       [&](Node node) { return inputs_.count(node) != 0; });
}

void ClassNames::write_setup(Writer& writer, std::string_view library) {
    const Kernel all = setup();
    const auto results = write_code(writer, graph_, all, given_inputs(all), library);
    for (std::size_t k = 0; k < results.size(); ++k) {
        writer.line("c{}_ = {};", k + 1, results[k]);
    }
}

void ClassNames::write_copy_to_lane(Writer& writer) const {
    for (std::size_t k = 0; k < members_.size(); ++k) {
        writer.line("c{0}_.set(lane, one.c{0}_);", k + 1);
    }
}

void ClassNames::write_data(Writer& writer) const {
    const bool are_of_template = constants_of_ == Constants::are_of_template;
    const std::string_view type = are_of_template ? "Constant" : "Scalar";
    const std::string_view zero = are_of_template ? "{}" : " = 0";
    for (std::size_t k = 0; k < constants_.size(); ++k) {
        const Expression& value = graph_.at(constants_[k]).constant;
        if (constants_of_ == Constants::are_of_device) {
            writer.line("HVI_DEVICE static constexpr Scalar k{}() {{ return {}; }}  // {}", k + 1,
                        device_initializer(value), to_text(value));
            continue;
        }
        writer.line("static constexpr Scalar k{} = {};  // {}", k + 1, initializer(value),
                    to_text(value));
    }
    for (std::size_t k = 0; k < members_.size(); ++k) {
        writer.line("{} c{}_{};", type, k + 1, zero);
    }
}

/// NOTE: other names in the code are q, p, way, way_p, totals, out, e, k, V, h, x, t1, t2, ... and
/// the tables b, c, m and n of a stepper, or end in an underscore.
std::string ClassNames::index(const std::string& name) const {
    const bool is_free =
        name.size() == 1 && std::string("adfgijlorsuvwyz").find(name) != std::string::npos;
    // NOTE: an index of a sum in a definition is `i'bonds`, so that it is no index around the sum.
    const std::size_t stem = name.find('\'');
    if (stem != std::string::npos)
        return fmt::format("inner{}_{}_{}", stem, name.substr(0, stem), name.substr(stem + 1));
    return is_free ? name : "index_" + name;
}

std::string ClassNames::whole(const AffineForm& form) const {
    return whole_number(form, [&](const std::string& name) {
        const bool is_size = std::any_of(system_.sizes.begin(), system_.sizes.end(),
                                         [&](const SystemSize& size) { return size.name == name; });
        return is_size ? member_of(name) + "_" : index(name);
    });
}

std::string ClassNames::count(const LoopRange& range) const {
    return fmt::format("hvi::detail::count_of({}, {})", whole(range.first), whole(range.last));
}

std::string ClassNames::count(const SystemFamily& family) const {
    std::string text;
    for (const LoopRange& range : family.ranges) {
        text += (text.empty() ? "" : " * ") + count(range);
    }
    return text.empty() ? "1" : text;
}

std::string ClassNames::place(const SystemFamily& family, const std::vector<std::string>& indices) {
    const std::string name = member_of(family.name);
    std::string text = name + "_at_";
    for (std::size_t d = 0; d < indices.size(); ++d) {
        text += " + " + indices[d];
        if (d + 1 < indices.size()) { text += fmt::format(" * {}_step_{}_", name, d + 1); }
    }
    return text;
}

std::string ClassNames::place(const Access& access) const {
    std::vector<std::string> indices;
    for (const auto& [form, modulus, offset] : access.indices) {
        std::string index = whole(form);
        if (modulus) {
            index = fmt::format("hvi::detail::remainder({}, {})", index, whole(*modulus));
            if (offset != AffineForm{}) { index += " + (" + whole(offset) + ")"; }
        }
        indices.push_back("(" + index + ")");
    }
    return place(system_.family(access), indices);
}

std::string ClassNames::array(const Access& access) const {
    switch (access.kind) {
    case FamilyKind::coordinate: return "q";
    case FamilyKind::conjugate: return "p";
    case FamilyKind::direction: return "way";
    case FamilyKind::direction_of_conjugate: return "way_p";
    case FamilyKind::table:
    case FamilyKind::turn: break;
    }
    return member_of(system_.family(access).name) + "_values_.data()";
}

}  // namespace hvi::gen
