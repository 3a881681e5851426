// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/system/loop_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "generator/emit/system/scene_code.hpp"
#include "generator/emit/text/names.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

std::string member_of(const std::string& name) { return member_name(name); }

namespace {

/// The names of parameters and sizes, in the constructor.
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

}  // namespace

LoopNames::LoopNames(const System& system)
    : GivenNames(system.graph, inputs_of(system)), system_(system) {}

/// NOTE: other names in the code are q, p, way, way_p, totals, out, e, k, V, h, x, t1, t2, ... and
/// the tables b, c, m and n of a stepper, or end in an underscore.
std::string LoopNames::index(const std::string& name) const {
    const bool is_free =
        name.size() == 1 && std::string("adfgijlorsuvwyz").find(name) != std::string::npos;
    return is_free ? name : "index_" + name;
}

std::string LoopNames::whole(const AffineForm& form) const {
    std::string text;
    const auto add = [&](bool is_negative, const std::string& size) {
        text += text.empty() ? (is_negative ? "-" : "") : (is_negative ? " - " : " + ");
        text += size;
    };
    for (const auto& [name, coefficient] : form.coefficients) {
        const bool is_size =
            std::any_of(system_.sizes.begin(), system_.sizes.end(),
                        [&, &known = name](const SystemSize& size) { return size.name == known; });
        const std::string called = is_size ? member_of(name) + "_" : index(name);
        const long size = std::labs(coefficient);
        add(coefficient < 0, size == 1 ? called : fmt::format("{} * {}", size, called));
    }
    if (form.constant != 0 || text.empty()) {
        add(form.constant < 0, std::to_string(std::labs(form.constant)));
    }
    return text;
}

std::string LoopNames::count(const LoopRange& range) const {
    return fmt::format("hvi::detail::count_of({}, {})", whole(range.first), whole(range.last));
}

std::string LoopNames::count(const SystemFamily& family) const {
    std::string text;
    for (const LoopRange& range : family.ranges) {
        text += (text.empty() ? "" : " * ") + count(range);
    }
    return text.empty() ? "1" : text;
}

std::string LoopNames::place(const Access& access) const {
    const SystemFamily& family = system_.family(access);
    const std::string name = member_of(family.name);
    std::string text = name + "_at_";
    for (std::size_t d = 0; d < access.indices.size(); ++d) {
        const auto& [form, modulus, offset] = access.indices[d];
        std::string index = whole(form);
        if (modulus) {
            index = fmt::format("hvi::detail::remainder({}, {})", index, whole(*modulus));
            if (offset != AffineForm{}) { index += " + (" + whole(offset) + ")"; }
        }
        const bool is_last = d + 1 == access.indices.size();
        text += is_last ? fmt::format(" + ({})", index)
                        : fmt::format(" + ({}) * {}_step_{}_", index, name, d + 1);
    }
    return text;
}

std::string LoopNames::array(const Access& access) const {
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
