// Headers of methods that solve nothing.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/copies.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Writes the kicks and drifts of a step in turn.
class PlainMoves {
public:
    PlainMoves(Writer& writer, const Step& step) : writer_(writer), step_(step) {}

    void write(const Move& move) {
        evaluate(move);
        carry(move);
        add(move, within(move.kick));
        (move.kick ? kicked_ : drifted_) = true;
    }

    /// The last move, into `end`, and the end of the step. NOTE: where the sum is finite it is
    /// computed once more, into x, which compilers see is the same. A copy of many components would
    /// be a call of memcpy; see hvi::detail::copy().
    void finish(const Move& last) {
        evaluate(last);
        carry(last);
        add(last, "end");
        const std::string other = within(!last.kick);
        writer_.blank();
        writer_.line("if (!hvi::detail::finite({}, end)) {{ {} }}", other,
                     "return Status(Status::Code::not_finite);");
        writer_.insert(end_of_moves(step_));
        if (step_.kept.any()) { writer_.line("known_ = true;"); }
        writer_.line("hvi::detail::copy({}, x.{});", other, other_names(last).moved);
        add(last, fmt::format("x.{}", names(last).moved));
    }

private:
    /// Where the variable is within the step that kicks, or drifts, move. NOTE: that which a kept
    /// slope belongs to is a member, as the slope is; the other is not, so that compilers keep it
    /// in registers.
    [[nodiscard]] std::string within(bool of_kick) const {
        return fmt::format("{}{}", of_kick ? "p" : "q", keeps(step_, !of_kick) ? "_" : "");
    }

    /// The sum of a move.
    void add(const Move& move, std::string_view target) {
        const bool is_moved = move.kick ? kicked_ : drifted_;
        const std::string from =
            is_moved ? within(move.kick) : fmt::format("x.{}", names(move).moved);
        writer_.open("for (Index k = 0; k < n; ++k) {{");
        if (from == target) {
            writer_.line("{}[k] {}= {};", target, names(move).sign, change(step_, move, "k"));
        } else {
            writer_.line("{}[k] = {}[k] {} {};", target, from, names(move).sign,
                         change(step_, move, "k"));
        }
        writer_.close();
    }

    /// Where the slope of a move is evaluated.
    [[nodiscard]] std::string point_of(const Move& move) const {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        return other_moved ? within(!move.kick) : fmt::format("x.{}", other_names(move).moved);
    }

    void carry(const Move& move) {
        writer_.insert(carry_by_move(step_, move, point_of(move), size(step_, move)));
    }

    void evaluate(const Move& move) {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        const std::string at = point_of(move);
        const std::string call = evaluation(step_, move, at);
        if (!keeps(step_, move.kick) || other_moved) {
            writer_.line("{}", call);
            return;
        }
        // NOTE: known_ is false while the step is under way, should the system throw.
        const std::string kept_at = within(!move.kick);
        writer_.line("const bool kept = known_ && hvi::detail::same_bits({}, {});", kept_at, at);
        writer_.line("known_ = false;");
        writer_.open("if (!kept) {{").line("hvi::detail::fit({}, n);", kept_at);
        writer_.line("{}", call).close();
    }

    Writer& writer_;
    const Step& step_;
    bool kicked_ = false, drifted_ = false;  // whether p, and q, have been moved
};

/// The vectors that a step of plain sums computes in and leaves nothing in.
std::vector<std::string> plain_scratch(const Step& step) {
    std::vector<Move> before = moves(step);
    before.pop_back();
    std::vector<std::string> result;
    for (const bool of_kick : {false, true}) {
        const bool is_moved = std::any_of(before.begin(), before.end(),
                                          [&](const Move& move) { return move.kick == of_kick; });
        if (is_moved && !keeps(step, !of_kick)) { result.push_back(of_kick ? "p" : "q"); }
    }
    if (!step.kept.force || !step.kept.velocity) { result.push_back("slope"); }
    result.push_back("end");
    return result;
}

std::string plain_moves_text(const Step& step) {
    Writer writer(2);
    writer.insert(scratch_text(plain_scratch(step)));
    PlainMoves code(writer, step);
    const std::vector<Move> all = moves(step);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) { code.write(all[i]); }
    code.finish(all.back());
    return writer.str();
}

// ---- what depends on how a step sums ----

/// Parts of the class of the stepper.
struct ExplicitParts {
    std::vector<std::string> runtime;  ///< headers of hvi that not every one has
    std::vector<std::string> scratch;  ///< vectors that a step leaves nothing in
    std::string moves;
    std::string forget;                ///< in reset()
    std::string sums;                  ///< members
    std::vector<std::string> vectors;  ///< members, without the underscore
    std::string force, velocity;       ///< what is said of where these were evaluated
};

ExplicitParts plain_parts(const Step& step) {
    ExplicitParts parts;
    parts.scratch = plain_scratch(step);
    parts.moves = plain_moves_text(step);
    if (step.kept.any()) { parts.forget = "known_ = false;"; }
    // NOTE: in this order. In others g++ finds it harder to keep the state in registers.
    parts.vectors = parts.scratch;
    if (step.kept.velocity) { parts.vectors.insert(parts.vectors.begin(), "p"); }
    if (step.kept.force) { parts.vectors.insert(parts.vectors.begin(), "q"); }
    parts.force = ", at q_";
    parts.velocity = ", at p_";
    return parts;
}

/// NOTE: a slope is kept for a step that goes on with the sums.
ExplicitParts compensated_parts(const Step& step) {
    ExplicitParts parts;
    parts.runtime = {"detail/stages/step_sums", "detail/coefficients/weights"};
    parts.scratch = compensated_scratch(step);
    parts.moves = compensated_moves_text(step);
    parts.forget = "sums_.forget();";
    parts.sums = "hvi::detail::StepSums<Vector> sums_;\n" + weights_member(step);
    parts.vectors = parts.scratch;
    return parts;
}

/// NOTE: what a kept slope belongs to is fitted where that is not known: see PlainMoves.
std::string fits_text(const Step& step, const ExplicitParts& parts) {
    Writer writer(2);
    const auto fit = [&](std::string_view vector) {
        writer.line("hvi::detail::fit({}_, n);", vector);
    };
    for (const std::string& name : parts.scratch) { fit(name); }
    if (step.kept.force) { fit("force"); }
    if (step.kept.velocity) { fit("velocity"); }
    return writer.str();
}

/// The headers of the runtime that the stepper is made of, as one text.
std::string support(const Step& step, const ExplicitParts& parts, const EmitOptions& options,
                    bool with_rounded) {
    const SceneWishes& wishes = options.wishes;
    const bool calls_more =
        step.container == Container::arrays && calls_more_math(*options.system, wishes);
    std::vector<std::string> names{"state", "detail/numbers/scalar"};
    const auto add = [&](const std::vector<std::string>& more) {
        names.insert(names.end(), more.begin(), more.end());
    };
    const std::vector<std::string> clock = clock_runtime(step);
    if (wishes.float128 || calls_more) { names.emplace_back("detail/numbers/math"); }
    if (calls_more) { names.emplace_back("detail/numbers/more_math"); }
    if (with_rounded) { names.emplace_back("detail/coefficients/rounded"); }
    names.emplace_back("detail/stages/system");
    if (step.from_parameter || !clock.empty() || !parts.runtime.empty()) {
        add({"detail/numbers/arithmetic", "detail/numbers/compensated"});
    }
    if (step.from_parameter) {
        add({"detail/numbers/two_product", "detail/numbers/pair", "detail/coefficients/series",
             "detail/coefficients/parameter"});
    }
    add(clock);
    add(parts.runtime);
    return copies_of(names);
}

std::string members_text(const Step& step, const ExplicitParts& parts) {
    Writer writer(1);
    writer.line("System system_;");
    writer.insert(coefficients_member(step)).insert(clock_member(step)).insert(parts.sums);
    writer.line("Vector {}_{{}};", fmt::join(parts.vectors, "_{}, "));
    const auto slope = [&](std::string_view name, std::string_view what, std::string_view where) {
        writer.line("Vector {}{{}};  // {} where the last step ended{}", name, what, where);
    };
    if (step.kept.force) { slope("force_", "dH/dq", parts.force); }
    if (step.kept.velocity) { slope("velocity_", "dH/dp", parts.velocity); }
    if (step.kept.any()) { writer.line("bool known_ = false;  // whether it is kept"); }
    return writer.str();
}

}  // namespace

std::string weights_text(const Step& step) {
    if (step.from_parameter) { return functions_of_parameter(step); }
    Writer writer(1);
    const auto write = [&](std::string_view name, const std::vector<StageValue>& values) {
        bool ones = true;
        for (const StageValue& value : values) { ones = ones && equal(value.weight, 1); }
        if (ones) { return; }
        table(writer, name, weights(values));
        refuse_float(writer, weights(values));
    };
    write("b_p", step.positions);
    write("b_q", step.momenta);
    writer.insert(times_text(step));
    return with_rounding(writer.str());
}

std::string emit_one(const OneStepMethod& method, const Step& step, const ExplicitStep& form,
                     const EmitOptions& options) {
    const ExplicitParts parts =
        form.sums == Sums::compensated ? compensated_parts(step) : plain_parts(step);
    const std::string weights = weights_text(step);
    const SystemPart system = system_part(method, step, options);
    const bool rounds = are_rounded(weights) || are_rounded(system.types);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"support", support(step, parts, options, rounds)},
                      {"parameter", parameter_text(step)},
                      {"along", along_argument(step, StepFunction::whole)},
                      {"begins", begins(step)},
                      {"weights", weights},
                      {"fits", fits_text(step, parts)},
                      {"moves", parts.moves},
                      {"state", system.state},
                      {"clock", clock_begins(step, "reset()")},
                      {"status", std::string(clock_ends_well(step))},
                      {"forget", parts.forget},
                      {"members", members_text(step, parts)}});
    return fill("explicit.hpp.in", holes);
}

}  // namespace hvi::gen
