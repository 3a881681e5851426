// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/plan/scheme.hpp"

namespace hvi::gen {
namespace {

std::string text(const Number& number) {
    const auto form = number.closed_form();
    return form ? to_text(*form) : number.decimal(20);
}

std::string_view text(StageValue::Place place) {
    switch (place) {
    case StageValue::Place::start: return "start";
    case StageValue::Place::inner: return "inner";
    case StageValue::Place::end: return "end";
    }
    HVI_CHECK(false);
    return {};
}

std::string_view text(StageNode::Kind kind) {
    switch (kind) {
    case StageNode::Kind::Q: return "Q";
    case StageNode::Kind::P: return "P";
    case StageNode::Kind::Lq: return "Lq";
    case StageNode::Kind::Lp: return "Lp";
    }
    HVI_CHECK(false);
    return {};
}

std::string lines(std::string_view letter, const std::vector<StageValue>& values) {
    std::string result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        result += fmt::format("{}_{}: {}, weight {}, stages", letter, i + 1, text(values[i].place),
                              text(values[i].weight));
        for (const std::size_t stage : values[i].stages) {
            result += fmt::format(" {}", stage + 1);
        }
        result += '\n';
    }
    return result;
}

std::string line(std::string_view name, const NumberVector& row) {
    std::string result = fmt::format("{}:", name);
    for (const Number& entry : row) { result += ' ' + text(entry); }
    return result + '\n';
}

std::string line(const Block& block) {
    std::string result = block.coupled ? "solve" : "evaluate";
    for (const StageNode& node : block.nodes) {
        result += fmt::format(" {}_{}", text(node.kind), node.index + 1);
    }
    return result + '\n';
}

}  // namespace

std::string dump(const Scheme& scheme) {
    std::string result = scheme.separable ? "separable\n" : "general\n";
    result += lines("Q", scheme.positions);
    result += lines("P", scheme.momenta);
    for (const NumberVector& row : scheme.m) { result += line("m", row); }
    if (scheme.velocity_form) {
        for (const NumberVector& row : scheme.velocity_form->n) { result += line("n", row); }
    }
    for (const Block& block : scheme.blocks) { result += line(block); }
    for (const Decision& decision : scheme.decisions) {
        result += fmt::format("{}: {}\n", decision.what, decision.why);
    }
    return result;
}

}  // namespace hvi::gen
