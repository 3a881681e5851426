// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/starting_values.hpp"

#include <algorithm>

#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

namespace {

/// NOTE: starting values need not be good to the last bit.
RoundedMatrix nearest_or_small(const NumberMatrix& exact) {
    RoundedMatrix values;
    for (const NumberVector& row : exact) {
        std::vector<Rounded>& rounded = values.emplace_back();
        for (const Number& entry : row) { rounded.push_back(nearest_or_small(entry)); }
    }
    return values;
}

}  // namespace

void open_predict(Writer& writer, const Iteration& iteration, std::string_view slopes) {
    const std::optional<Extrapolation>& from = iteration.extrapolation;
    writer.comment(
        from ? fmt::format("Starting values: the polynomial through the {0} of the last {1}, else "
                           "{0} as at the start of this one.",
                           slopes, from->before ? "two steps" : "step")
             : fmt::format("Starting values: {} as at the start of the step.", slopes),
        "/// ");
    writer.open("void predict() {{");
}

std::string extrapolation_text(const Iteration& iteration) {
    if (!iteration.extrapolation) { return {}; }
    const Extrapolation& from = *iteration.extrapolation;
    Writer writer(1);
    const auto write = [&](std::string_view name, const NumberMatrix& exact) {
        table(writer, name, constants(name, exact, nearest_or_small(exact)));
    };
    writer.blank();
    if (!from.before) {
        writer.comment("Slopes of the next step are about N times those of this one.");
        write("N", from.last);
        return writer.str();
    }
    writer.comment("Slopes of the next step are about N times those of this one, and N_before "
                   "times those of the one before.");
    write("N", from.last);
    write("N_before", *from.before);
    return writer.str();
}

std::vector<std::string_view> predicted_slopes(const Step& step) {
    if (std::holds_alternative<VelocityStep>(step.form)) {
        return {step.layout == Layout::stages ? "Lp" : "W"};
    }
    const auto are_unknown = [&](StageNode::Kind kind) {
        return std::any_of(step.blocks.begin(), step.blocks.end(), [&](const Block& block) {
            return block.coupled && !block.of(kind).empty();
        });
    };
    std::vector<std::string_view> slopes;
    // NOTE: for separable H those of p are enough.
    if (!step.is_separable() && are_unknown(StageNode::Kind::Lq)) { slopes.push_back("Lq"); }
    if (are_unknown(StageNode::Kind::Lp)) { slopes.push_back("Lp"); }
    return slopes;
}

void open_extrapolation(Writer& writer, const Extrapolation& from) {
    if (from.before) {
        writer.line("const bool goes_on = s_.h == s_.h_before;");
        writer.open("if (goes_on && has_slopes_before_) {{");
    } else {
        writer.open("if (s_.h == s_.h_before) {{");
    }
}

void close_extrapolation(Writer& writer, const Extrapolation& from,
                         const std::vector<std::string_view>& slopes) {
    writer.line("return;").close();
    if (!from.before) { return; }
    writer.line("has_slopes_before_ = goes_on;");
    for (const std::string_view slope : slopes) { writer.line("{0}_before_ = s_.{0};", slope); }
}

void declare_slopes_before(Writer& writer, const Step& step) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr || !iteration->extrapolation || !iteration->extrapolation->before) {
        return;
    }
    for (const std::string_view slope : predicted_slopes(step)) {
        writer.line("decltype(s_.{0}) {0}_before_{{}};  // of the step before the last", slope);
    }
    writer.line(
        "bool has_slopes_before_ = false;  // it was of the same size, and led to the last");
}

std::string extrapolated(const Extrapolation& from, std::size_t i, std::string_view slope) {
    std::string sum;
    const auto add = [&](std::string_view table, std::string_view of) {
        for (std::size_t j = 0; j < from.last.size(); ++j) {
            sum += fmt::format("{}{}[{}][{}] * {}{}_{}", sum.empty() ? "" : " + ", table, i, j,
                               slope, of, j + 1);
        }
    };
    add("N", "");
    if (from.before) { add("N_before", "_before"); }
    return sum;
}

void recall_slopes(Writer& writer, const Extrapolation& from, std::string_view slope) {
    const std::size_t s = from.last.size();
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("const Scalar {0}_{1} = s_.{0}[{2}][k];", slope, j + 1, j);
    }
    if (!from.before) { return; }
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("const Scalar {0}_before_{1} = {0}_before_[{2}][k];", slope, j + 1, j);
    }
    for (std::size_t j = 0; j < s; ++j) {
        writer.line("{0}_before_[{2}][k] = {0}_{1};", slope, j + 1, j);
    }
}

}  // namespace hvi::gen
