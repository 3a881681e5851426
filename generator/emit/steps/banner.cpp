// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/banner.hpp"

#include "generator/emit/text/text.hpp"
#include "generator/plan/facts.hpp"
#include "generator/support/error.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {
namespace {

std::string method_title(const Provenance& provenance) {
    const std::string& name = provenance.name;
    return name.empty() ? "A method of its own basis and nodes" : name;
}

void list(Writer& writer, std::string_view letter, const NumberVector& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        writer.comment(fmt::format("{}_{} = {}", letter, i + 1, exact_text(values[i])), "//     ",
                       4);
    }
}

void list(Writer& writer, std::string_view letter, const NumberMatrix& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        for (std::size_t j = 0; j < values[i].size(); ++j) {
            writer.comment(
                fmt::format("{}_{},{} = {}", letter, i + 1, j + 1, exact_text(values[i][j])),
                "//     ", 4);
        }
    }
}

constexpr std::string_view paper =
    "in Leok & Zhang, Discrete Hamiltonian variational integrators, exactly:";

/// Returns the flows of a step in their order.
std::string numbers_of_flows(const FlowStep& form) {
    Writer writer(0);
    writer.comment("The flows of a step, over these fractions of h, exactly:").line("//");
    for (const auto& [moves, times] : form.rounds) {
        const bool is_repeated = times > 1;
        if (is_repeated) { writer.comment(fmt::format("{} times:", times), "//     "); }
        for (const auto& [part, fraction] : moves) {
            writer.comment(
                fmt::format("part {}: {}", part + 1, exact_text(form.fractions[part][fraction])),
                is_repeated ? "//         " : "//     ", 4);
        }
    }
    if (form.joined) {
        const std::size_t part = form.rounds.front().moves.front().part;
        writer.line("//").comment(fmt::format("These are {} flows. advance() makes the last one "
                                              "and the first one of the next step at "
                                              "once, part {} over {}: {} a step.",
                                              form.flows(), part + 1,
                                              exact_text(form.fractions[part][*form.joined]),
                                              form.flows() - 1));
    }
    return writer.str();
}

std::string numbers_text(const Tableau& tableau, const Step& step) {
    if (const auto* flows = std::get_if<FlowStep>(&step.form)) { return numbers_of_flows(*flows); }
    Writer writer(0);
    writer.comment(fmt::format("The tableau of (4.18) {}", paper)).line("//");
    list(writer, "c", tableau.c);
    list(writer, "b", tableau.b);
    list(writer, "a", tableau.A);
    if (step.partner == Partner::same) {
        writer.comment("a~_i,j = a_i,j", "//     ", 4);
    } else {
        list(writer, "a~", tableau.A_tilde);
    }
    return writer.str();
}

std::string numbers_of_rule(const GalerkinRule& rule) {
    Writer writer(0);
    writer.comment(fmt::format("The rule of (4.6) {}", paper)).line("//");
    list(writer, "c", rule.c);
    list(writer, "b", rule.b);
    list(writer, "A", rule.A_psi);
    list(writer, "B", rule.B);
    return writer.str();
}

std::string numbers_text(const GalerkinRule& rule, const Step& step) {
    if (std::holds_alternative<GalerkinStep>(step.form)) { return numbers_of_rule(rule); }
    Writer writer(0);
    writer.comment(fmt::format("The rule of (4.6) and n_ij = c_i - A_i G^-1 A_j^T {}", paper));
    writer.line("//");
    list(writer, "c", rule.c);
    list(writer, "b", rule.b);
    list(writer, "n", rule.n);
    return writer.str();
}

std::string negative_weights(const NumberVector& b) {
    std::string names;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (!b[i].has_parameters() && b[i].sign() < 0) {
            names += fmt::format("{}b_{}", names.empty() ? "" : ", ", i + 1);
        }
    }
    return names;
}

std::string conserved_text(const Step& step, const std::vector<std::string>& kept) {
    if (std::holds_alternative<ChartStep>(step.form)) {
        return "In natural charts, which conserves momentum maps of rotations of space.";
    }
    if (std::holds_alternative<FlowStep>(step.form)) {
        return fmt::format("Flows of parts of H in turn, which conserve what all parts "
                           "conserve{}{}.",
                           kept.empty() ? "" : ": ", fmt::join(kept, ", "));
    }
    switch (step.partner) {
    case Partner::same:
        return "A == A~: a Runge-Kutta method, which conserves all quadratic invariants.";
    case Partner::different:
        return "A != A~: a partitioned method, which conserves q^T C p for constant C.";
    case Partner::undecided: break;
    }
    return "A and A~ agree as far as they were compared; that they are equal is not proved. The "
           "method conserves q^T C p for constant C.";
}

/// Returns what steps of counted sweeps are; empty where none are counted.
std::string counted_text(const Step& step) {
    const Iteration* iteration = step.iteration();
    if (iteration == nullptr || !iteration->counts_sweeps()) { return {}; }
    return fmt::format("Explicit: exactly {} sweep{} a step, from extrapolated slopes; symplectic, "
                       "and conserving, up to the last change alone.",
                       iteration->sweeps, iteration->sweeps == 1 ? "" : "s");
}

/// Returns a description of the method: its kind, its basis, its conserved quantities, negative
/// weights, and what sweeps leave of all that.
std::string described(const Provenance& provenance, const std::string& kind,
                      std::string_view conserved, const NumberVector& b, const Step& step) {
    Writer writer(0);
    std::string basis;
    for (const Expression& psi : provenance.basis) {
        basis += (basis.empty() ? "" : ", ") + to_text(psi);
    }
    writer.comment(fmt::format("{}: {}.", method_title(provenance), kind));
    if (!basis.empty()) { writer.comment(fmt::format("Basis functions of tau: {}.", basis)); }
    writer.comment(conserved);
    if (const std::string names = negative_weights(b); !names.empty()) {
        writer.comment(fmt::format("Negative weights: {}.", names));
    }
    if (const std::string counted = counted_text(step); !counted.empty()) {
        writer.comment(counted);
    }
    return writer.str();
}

/// Returns the kind of functions that the step is for.
std::string_view functions_of(const Step& step) {
    const auto* galerkin = std::get_if<GalerkinStep>(&step.form);
    if (galerkin != nullptr && galerkin->side == Side::lagrangian) { return "Lagrangians"; }
    if (std::holds_alternative<ChartStep>(step.form)) { return "Hamiltonians of rotating bodies"; }
    if (std::holds_alternative<FlowStep>(step.form)) { return "sums of parts with exact flows"; }
    return step.is_separable() ? "separable Hamiltonians" : "general Hamiltonians";
}

std::string method_text(const Tableau& tableau, const Step& step,
                        const std::vector<std::string>& kept) {
    return described(tableau.provenance,
                     fmt::format("symplectic, {} stage{}, for {}", tableau.stages(),
                                 tableau.stages() == 1 ? "" : "s", functions_of(step)),
                     conserved_text(step, kept), tableau.b, step);
}

std::string method_text(const GalerkinRule& rule, const Step& step,
                        const std::vector<std::string>& /*kept*/) {
    const bool is_general = std::holds_alternative<GalerkinStep>(step.form);
    return described(rule.provenance,
                     fmt::format("symplectic, {} function{} and {} nodes, for {}", rule.functions(),
                                 rule.functions() == 1 ? "" : "s", rule.nodes(),
                                 is_general ? functions_of(step) : "H = p^T K p/2 + U(q)"),
                     "The general Galerkin form (4.6), which conserves q^T C p for constant C.",
                     rule.b, step);
}

std::string choices_text(const Step& step) {
    if (step.decisions.empty()) { return {}; }
    Writer writer(0);
    writer.line("//").comment("Choices:").line("//");
    for (const Decision& decision : step.decisions) {
        writer.comment(fmt::format("{}: {}", decision.what, decision.why), "//     ", 4);
    }
    return writer.str();
}

/// Returns the facts found in the H of a scene, and the costs of a step.
std::string scene_text(const Step& step, const System& system, const Evaluations& evaluations) {
    Writer writer(0);
    writer.line("//").comment(fmt::format("Found in {}:", system.function_letter())).line("//");
    for (const std::string& fact : facts(system)) { writer.comment(fact, "//     ", 4); }
    writer.line("//").comment("Cost:").line("//");
    for (const std::string& cost : costs(system, step, evaluations)) {
        writer.comment(cost, "//     ", 4);
    }
    return writer.str();
}

/// Returns the command as one line that neither ends a comment nor continues one.
std::string one_line(std::string_view command) {
    std::string text;
    for (const char c : command) { text += static_cast<unsigned char>(c) < ' ' ? ' ' : c; }
    while (!text.empty() && text.back() == '\\') { text.pop_back(); }
    return "//     " + text;
}

std::string note_text(const EmitOptions& options) {
    return options.note.empty() ? "" : "\n// " + options.note;
}

}  // namespace

std::string banner(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    const auto of_base = [&](auto text) {
        return std::visit([&](const auto& base) { return text(base); }, method.base);
    };
    std::string text =
        fill("banner.hpp.in",
             {{"version", std::string(version)},
              {"command", one_line(options.command) + note_text(options)},
              {"method",
               of_base([&](const auto& base) { return method_text(base, step, options.kept); })},
              {"numbers", of_base([&](const auto& base) { return numbers_text(base, step); })},
              {"scene", options.evaluations == nullptr
                            ? std::string()
                            : scene_text(step, *options.system, *options.evaluations)},
              {"choices", choices_text(step)}});
    text.pop_back();
    return text;
}

}  // namespace hvi::gen
