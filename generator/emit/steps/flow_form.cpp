// Headers of steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/copies.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/system/flow_code.hpp"
#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

namespace {

std::string fractions_text(const FlowStep& form) {
    Writer writer(1);
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        std::vector<Constant> row;
        for (std::size_t i = 0; i < form.fractions[k].size(); ++i) {
            row.push_back(constant(fmt::format("of h, {}.{}", k + 1, i + 1), form.fractions[k][i]));
        }
        table(writer, fmt::format("fractions_{}", k + 1), row);
        refuse_float(writer, row);
    }
    return with_rounding(writer.str());
}

/// Returns the lines that compute the flows of all lengths.
std::string lengths_text(const FlowStep& form) {
    Writer writer(2);
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        writer.open("for (std::size_t i = 0; i < {}; ++i) {{", form.fractions[k].size());
        writer.line("flows_{0}_[i] = Flow{0}(parameters_, h * fractions_{0}[i]);", k + 1).close();
    }
    return writer.str();
}

std::string members_text(const FlowStep& form) {
    Writer writer(1);
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        writer.line("Flow{0} flows_{0}_[{1}];", k + 1, form.fractions[k].size());
    }
    return writer.str();
}

std::string moves_text(const FlowStep& form) {
    Writer writer(2);
    for (const auto& [part, fraction] : form.moves) {
        writer.line("flows_{}_[{}](path);", part + 1, fraction);
    }
    return writer.str();
}

std::string flows_text(const System& system, std::string_view library) {
    std::string text;
    for (std::size_t k = 0; k < system.parts->parts.size(); ++k) {
        text += (text.empty() ? "" : "\n\n") + flow_text(system, k, library);
    }
    return text;
}

/// Returns whether a part has a quadratic form that is moved by its matrix.
bool moves_forms(const System& system) {
    const std::vector<HamiltonianPart>& parts = system.parts->parts;
    return std::any_of(parts.begin(), parts.end(),
                       [](const HamiltonianPart& part) { return !part.forms.empty(); });
}

/// Returns the headers of the runtime: copies, which need the standard library alone, but where
/// bodies turn. `code`: all that calls functions.
std::string support(const System& system, std::string_view code) {
    const bool calls_math = code.find("hvi::math::") != std::string_view::npos;
    const bool has_forms = moves_forms(system);
    if (rotations_of(system) > 0) {
        return std::string("#include <hvi/detail/groups/chart_space.hpp>\n") +
               (calls_math ? "#include <hvi/detail/numbers/more_math.hpp>\n" : "") +
               "#include <hvi/detail/stages/flow_sums.hpp>\n" +
               (has_forms ? "#include <hvi/detail/stages/form_flow.hpp>\n" : "") +
               "#include <hvi/detail/stepper.hpp>\n\n";
    }
    std::vector<std::string> names{"state", "detail/numbers/scalar"};
    if (calls_math) {
        names.insert(names.end(), {"detail/numbers/math", "detail/numbers/more_math"});
    }
    if (are_rounded(code)) { names.emplace_back("detail/coefficients/rounded"); }
    names.insert(names.end(), {"detail/stages/system", "detail/numbers/arithmetic",
                               "detail/numbers/compensated", "detail/stages/flow_sums"});
    if (has_forms) {
        names.insert(names.end(), {"detail/numbers/two_product", "detail/numbers/pair",
                                   "detail/stages/form_flow"});
    }
    return copies_of(names);
}

}  // namespace

std::string emit_one(const OneStepMethod& method, const Step& step, const FlowStep& form,
                     const EmitOptions& options) {
    const System& system = *options.system;
    const bool are_in_members = rotations_of(system) > 0;
    const auto in_members = [&](std::string_view text, std::string_view otherwise) {
        return std::string(are_in_members ? text : otherwise);
    };
    const SystemPart part = system_part(method, step, options);
    const std::string fractions = fractions_text(form);
    const std::string flows = flows_text(system, library(options.wishes));
    Holes holes = holes_of(part);
    holes.merge(Holes{{"support", support(system, fractions + flows + part.types + part.construct)},
                      {"state", part.state},
                      {"numbers", in_members(numbers_of_bodies::type, "State")},
                      {"path", moves_forms(system) ? "LongFlowPath" : "FlowPath"},
                      {"begin", in_members(numbers_of_bodies::taken, "")},
                      {"at", in_members(numbers_of_bodies::name, "x")},
                      {"moves", moves_text(form)},
                      {"set", in_members(numbers_of_bodies::put_back, "")},
                      {"flows", flows},
                      {"fractions", fractions},
                      {"lengths", lengths_text(form)},
                      {"members", members_text(form)}});
    return fill("flows.hpp.in", holes);
}

}  // namespace hvi::gen
