// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/exact/numbers/number_text.hpp"
#include "generator/ir/step.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

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

std::string_view text(Slopes slopes) {
    switch (slopes) {
    case Slopes::of_parts: return "dH/dq(q), dH/dp(p)";
    case Slopes::one_by_one: return "dH/dq(q, p), dH/dp(q, p)";
    case Slopes::joint: return "(dH/dq, dH/dp)(q, p)";
    }
    HVI_CHECK(false);
    return {};
}

std::string_view text(Partner partner) {
    switch (partner) {
    case Partner::same: return "A == A~";
    case Partner::different: return "A != A~";
    case Partner::undecided: return "A == A~ is not decided";
    }
    HVI_CHECK(false);
    return {};
}

std::string_view text(Solver solver) {
    switch (solver) {
    case Solver::of_user: return "the user's";
    case Solver::fixed_point: return "fixed-point";
    case Solver::newton: return "newton";
    case Solver::newton_taylor: return "newton-taylor";
    case Solver::automatic: return "automatic";
    case Solver::sweeps: return "sweeps";
    }
    HVI_CHECK(false);
    return {};
}

std::string_view text(Layout layout) {
    switch (layout) {
    case Layout::one: return "one";
    case Layout::stages: return "stages";
    case Layout::trajectories: return "trajectories";
    case Layout::threads: return "threads";
    case Layout::components: return "components";
    case Layout::sites: return "sites";
    }
    HVI_CHECK(false);
    return {};
}

std::string lines(std::string_view letter, const std::vector<StageValue>& values) {
    std::string result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        result += fmt::format("{}_{}: {}, weight {}, stages", letter, i + 1, text(values[i].place),
                              dump(values[i].weight));
        for (const std::size_t stage : values[i].stages) {
            result += fmt::format(" {}", stage + 1);
        }
        result += '\n';
    }
    return result;
}

std::string line(std::string_view name, const NumberVector& row) {
    std::string result = fmt::format("{}:", name);
    for (const Number& entry : row) { result += ' ' + dump(entry); }
    return result + '\n';
}

std::string lines(std::string_view name, const NumberMatrix& rows) {
    std::string result;
    for (const NumberVector& row : rows) { result += line(name, row); }
    return result;
}

std::string line(const Block& block) {
    std::string result = block.coupled ? "solve" : "evaluate";
    for (const StageNode& node : block.nodes) {
        result += fmt::format(" {}_{}", text(node.kind), node.index + 1);
    }
    return result + '\n';
}

std::string lines(const Iteration& iteration) {
    std::string result = fmt::format("solver: {}\n", text(iteration.solver));
    if (iteration.counts_sweeps()) { result += fmt::format("sweeps: {}\n", iteration.sweeps); }
    for (const Extrapolation& from : iteration.extrapolation) {
        result += lines("N", from.last);
        if (from.before) { result += lines("N_before", *from.before); }
    }
    return result;
}

std::string lines(const RealModes& modes) {
    std::string result = "modes:";
    for (std::size_t i = 0; i < modes.real_parts.size(); ++i) {
        result += fmt::format(" {}", modes.real_parts[i]);
        if (i < modes.real_ones) { continue; }
        result += fmt::format("+-{}i", modes.imaginary_parts[i - modes.real_ones]);
    }
    return result + '\n';
}

/// A line on the form of d2H/dq2; none for few degrees of freedom, where it is a matrix.
std::string line(HessianForm form) {
    switch (form) {
    case HessianForm::dense: return "";
    case HessianForm::band: return "d2H/dq2: a band\n";
    case HessianForm::sparse: return "d2H/dq2: sparse\n";
    case HessianForm::products: return "d2H/dq2: products\n";
    case HessianForm::none: return "";
    }
    HVI_CHECK(false);
    return {};
}

/// `0x3ffffd000001*2^-46`, or `none`.
std::string text(const std::optional<Dyadic>& value) {
    if (!value) { return "none"; }
    return fmt::format("{:#x}*2^{}", value->integer(), value->last());
}

std::string line(std::string_view name, const std::vector<Rounded>& row, std::size_t format) {
    std::string result = fmt::format("{} in {} bits:", name, formats[format].bits);
    for (const Rounded& entry : row) { result += ' ' + text(entry[format]); }
    return result + '\n';
}

std::string lines(std::string_view name, const RoundedMatrix& rows) {
    std::string result;
    for (std::size_t f = 0; f < formats.size(); ++f) {
        for (const std::vector<Rounded>& row : rows) { result += line(name, row, f); }
    }
    return result;
}

std::string lines(const RoundedCoefficients& coefficients) {
    return lines("m", coefficients.m) + lines("mt", coefficients.mt);
}

std::string lines(const ExplicitStep& form) {
    return fmt::format("form: explicit, {} sums\n",
                       form.sums == Sums::plain ? "plain" : "compensated");
}

std::string lines(const FlowStep& form) {
    std::string result = "form: flows\n";
    if (form.moving == FlowStep::Moving::bodies) { result += "bodies turn\n"; }
    if (form.clock) { result += fmt::format("clock: part {}\n", *form.clock + 1); }
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        result += line(fmt::format("part {}", k + 1), form.fractions[k]);
    }
    for (const auto& [moves, times] : form.rounds) {
        result += times == 1 ? "moves:" : fmt::format("moves, {} times:", times);
        for (const auto& [part, fraction] : moves) {
            result += fmt::format(" {}.{}", part + 1, fraction + 1);
        }
        result += '\n';
    }
    if (form.joined) {
        result += fmt::format("joined: {}.{}\n", form.rounds.front().moves.front().part + 1,
                              *form.joined + 1);
    }
    return result;
}

std::string lines(const GalerkinForm& form) {
    return line("b", form.b) + lines("phi", form.phi) + lines("A", form.A) + line("B", form.B) +
           line("G", form.gram);
}

std::string lines(const RoundedGalerkinForm& form) {
    return lines("X", form.X) + lines("A", form.A) + lines("D", form.D) + lines("B", {form.B});
}

std::string line_of_steps(const NumberVector& steps) {
    return steps.empty() ? "" : line("steps", steps);
}

std::string lines(const TabulatedCurve& curve) {
    return lines(curve.form) + lines(curve.rounded) + line_of_steps(curve.steps);
}

std::string lines(const TabulatedStep& form) {
    return fmt::format("form: tabulated as {}\n",
                       form.as == TabulatedStep::As::shears ? "shears" : "a matrix") +
           std::visit([](const auto& tables) { return lines(tables); }, form.tables);
}

std::string lines(const PairStep& form) {
    return "form: pairs\n" + lines(form.coefficients) +
           (form.iteration ? lines(*form.iteration) : "");
}

std::string lines(const VelocityStep& form) {
    return "form: positions\n" + line("c", form.form.c) + lines("n", form.form.n) +
           lines("c", {form.rounded.c}) + lines("n", form.rounded.n) +
           (form.has_diagonal_mass ? "K is diagonal\n" : "") +
           (form.modes ? lines(*form.modes) : "") + line(form.hessian) + lines(form.iteration);
}

std::string lines(const CurveExtrapolation& from) {
    return lines("N_W", from.W) + (from.P ? lines("N_P", *from.P) : "");
}

std::string lines(const GalerkinStep& form) {
    const bool is_lagrangian = form.side == Side::lagrangian;
    std::string result = std::string("form: curves") + (is_lagrangian ? " of L\n" : "\n") +
                         lines(form.form) + lines(form.rounded) + lines(form.iteration);
    if (form.extrapolation) { result += lines(*form.extrapolation); }
    return result + (form.has_adjoint ? "of the adjoint too\n" : "");
}

std::string lines(const ChartStep& form) {
    return "form: natural charts\n" + lines(form.coefficients) + lines(form.iteration);
}

std::string lines(std::monostate) { return {}; }
std::string lines(CoupledConstants) { return "linear: all constant terms\n"; }
std::string lines(const StiffComponents& stiff) {
    std::string result;
    for (const std::size_t k : stiff.components) { result += fmt::format("stiff: {}\n", k + 1); }
    return result;
}

}  // namespace

std::string dump(const Step& step) {
    std::string result = fmt::format("slopes: {}\n", text(step.slopes));
    result += fmt::format("tables: {}\n", text(step.partner));
    result += lines("Q", step.positions);
    result += lines("P", step.momenta);
    if (!step.c.empty()) { result += line("times", step.c); }
    if (!step.momenta.empty()) { result += lines("m", step.m); }
    for (const Block& block : step.blocks) { result += line(block); }
    if (step.kept.force) { result += "kept: dH/dq\n"; }
    if (step.kept.velocity) { result += "kept: dH/dp\n"; }
    if (step.from_parameter) {
        result += fmt::format("parameter: {}\n", step.from_parameter->numbers.parameter);
    }
    result += std::visit([](const auto& form) { return lines(form); }, step.form);
    result += line_of_steps(step.in_a_row);
    result += fmt::format("vectors: {}\nlanes: {}\n", to_text(step.container), text(step.layout));
    if (step.layout == Layout::stages) {
        result += fmt::format("registers of: {}\n", step.register_width);
        result += fmt::format("shared slopes: {}\n", step.shared_slopes);
    }
    if (step.carries == Carries::directions) { result += "carries: directions\n"; }
    if (step.dual_parts > 0) {
        result += fmt::format("numbers: dual, with {} parts\n", step.dual_parts);
    }
    if (step.corrections) {
        const SolverCosts& costs = step.corrections->costs;
        result += lines(step.corrections->modes) +
                  fmt::format("costs: sweep {}, linear {}, correction {}, factors {}\n",
                              costs.sweep, costs.linear, costs.correction, costs.factors);
        result +=
            std::visit([](const auto& part) { return lines(part); }, step.corrections->linear);
    }
    for (const Decision& decision : step.decisions) {
        result += fmt::format("{}: {}\n", decision.what, decision.why);
    }
    return result;
}

}  // namespace hvi::gen
