// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/starting_values.hpp"

#include <algorithm>

#include "generator/emit/steps/implicit_parts.hpp"

namespace hvi::gen {

void open_predict(Writer& writer, const Iteration& iteration, std::string_view slopes) {
    const std::vector<Extrapolation>& from = iteration.extrapolation;
    writer.comment(
        from.empty()
            ? fmt::format("Starting values: {} as at the start of the step.", slopes)
            : fmt::format("Starting values: the polynomial through the {0} of the last {1}, else "
                          "{0} as at the start of this one.",
                          slopes, from.front().before ? "two steps" : "step"),
        "/// ");
    writer.open("void predict({}) {{", iteration.takes_parts() ? "std::size_t part" : "");
}

namespace {

std::string meaning_of_tables(bool takes_parts, bool takes_two) {
    if (!takes_parts) {
        return fmt::format("Slopes of the next step are about N times those of this one{}.",
                           takes_two ? ", and N_before times those of the one before" : "");
    }
    return fmt::format("Slopes of the k-th of the steps in a row are about N_k times those of the "
                       "one before{}.",
                       takes_two ? ", and N_before_k times those of the one before that" : "");
}

}  // namespace

/// NOTE: starting values need not be good to the last bit, and nobody checks their closed forms.
void starting_table(Writer& writer, std::string_view name, const NumberMatrix& exact) {
    RoundedMatrix values;
    for (const NumberVector& row : exact) {
        std::vector<Rounded>& rounded = values.emplace_back();
        for (const Number& entry : row) { rounded.push_back(rough_value(entry)); }
    }
    table_of_doubles(writer, name, values);
}

std::string extrapolation_text(const Iteration& iteration) {
    const std::vector<Extrapolation>& all = iteration.extrapolation;
    if (all.empty()) { return {}; }
    const bool takes_two = all.front().before.has_value();
    Writer writer(1);
    writer.blank().comment(meaning_of_tables(iteration.takes_parts(), takes_two));
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string part = iteration.takes_parts() ? fmt::format("_{}", k + 1) : "";
        starting_table(writer, "N" + part, all[k].last);
        if (takes_two) { starting_table(writer, "N_before" + part, *all[k].before); }
    }
    return writer.str();
}

void columns(Writer& writer, std::string_view name) {
    writer.line("static constexpr auto {0}_lanes = hvi::detail::lane_columns({0});", name);
}

namespace {

/// Writes `name`_lanes of the tables `name`_1, ..., `name`_k.
void columns_of_each(Writer& writer, std::string_view name, std::size_t k) {
    writer.open("static constexpr std::array {}_lanes{{", name);
    for (std::size_t i = 1; i <= k; ++i) {
        writer.line("hvi::detail::lane_columns({}_{}),", name, i);
    }
    writer.close("};");
}

}  // namespace

void columns_of_extrapolation(Writer& writer, const Iteration& iteration) {
    const std::vector<Extrapolation>& all = iteration.extrapolation;
    if (all.empty()) { return; }
    const auto write = [&](std::string_view name) {
        if (iteration.takes_parts()) { return columns_of_each(writer, name, all.size()); }
        columns(writer, name);
    };
    write("N");
    if (all.front().before) { write("N_before"); }
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
    // NOTE: for separable H the slopes of p are enough.
    if (!step.is_separable() && are_unknown(StageNode::Kind::Lq)) { slopes.push_back("Lq"); }
    if (are_unknown(StageNode::Kind::Lp)) { slopes.push_back("Lp"); }
    return slopes;
}

void open_extrapolation(Writer& writer, const Extrapolation& from) {
    writer.open("if (s_.goes_on{}) {{", from.before ? " && has_slopes_before_" : "");
}

void close_extrapolation(Writer& writer, const Extrapolation& from,
                         const std::vector<std::string_view>& slopes) {
    writer.line("return;").close();
    if (!from.before) { return; }
    writer.line("has_slopes_before_ = s_.goes_on;");
    for (const std::string_view slope : slopes) { writer.line("{0}_before_ = s_.{0};", slope); }
}

void declare_slopes_before(Writer& writer, const Step& step) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr || iteration->extrapolation.empty()) { return; }
    if (!iteration->extrapolation.front().before) { return; }
    for (const std::string_view slope : predicted_slopes(step)) {
        writer.line("decltype(s_.{0}) {0}_before_{{}};  // of the step before the last", slope);
    }
    writer.line("bool has_slopes_before_ = false;  // the last step went on from it");
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
