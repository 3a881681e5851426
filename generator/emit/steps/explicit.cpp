// Headers of methods that solve nothing.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <sstream>

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/text/embedded.hpp"
#include "generator/plan/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

/// Writes the kicks and drifts of a step in turn.
class PlainMoves {
public:
    PlainMoves(Writer& writer, const Scheme& scheme) : writer_(writer), scheme_(scheme) {}

    void write(const Move& move) {
        evaluate(move);
        add(move, within(move.kick));
        (move.kick ? kicked_ : drifted_) = true;
    }

    /// The last move, into `end`, and the end of the step. NOTE: where the sum is finite it is
    /// computed once more, into x, which compilers see is the same. A copy of many components would
    /// be a call of memcpy; see hvi::detail::copy().
    void finish(const Move& last) {
        evaluate(last);
        add(last, "end");
        const std::string other = within(!last.kick);
        writer_.blank();
        writer_.line("if (!hvi::detail::finite({}, end)) {{ {} }}", other,
                     "return Status(Status::Code::not_finite);");
        if (keeps(scheme_)) { writer_.line("known_ = true;"); }
        writer_.line("hvi::detail::copy({}, x.{});", other, other_names(last).moved);
        add(last, fmt::format("x.{}", names(last).moved));
    }

private:
    /// Where the variable is within the step that kicks, or drifts, move. NOTE: that which a kept
    /// slope belongs to is a member, as the slope is; the other is not, so that compilers keep it
    /// in registers.
    [[nodiscard]] std::string within(bool of_kick) const {
        return fmt::format("{}{}", of_kick ? "p" : "q", keeps(scheme_, !of_kick) ? "_" : "");
    }

    /// The sum of a move.
    void add(const Move& move, std::string_view target) {
        const bool is_moved = move.kick ? kicked_ : drifted_;
        const std::string from =
            is_moved ? within(move.kick) : fmt::format("x.{}", names(move).moved);
        writer_.open("for (Index k = 0; k < n; ++k) {{");
        if (from == target) {
            writer_.line("{}[k] {}= {};", target, names(move).sign, change(scheme_, move, "k"));
        } else {
            writer_.line("{}[k] = {}[k] {} {};", target, from, names(move).sign,
                         change(scheme_, move, "k"));
        }
        writer_.close();
    }

    void evaluate(const Move& move) {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        const std::string at =
            other_moved ? within(!move.kick) : fmt::format("x.{}", other_names(move).moved);
        const std::string call = evaluation(scheme_, move, at);
        if (!keeps(scheme_, move.kick) || other_moved) {
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
    const Scheme& scheme_;
    bool kicked_ = false, drifted_ = false;  // whether p, and q, have been moved
};

/// The vectors that a step computes in and leaves nothing in.
std::vector<std::string> scratch(const Scheme& scheme) {
    if (scheme.keeps_remainder) { return compensated_scratch(scheme); }
    std::vector<Move> before = moves(scheme);
    before.pop_back();
    std::vector<std::string> result;
    for (const bool of_kick : {false, true}) {
        const bool is_moved = std::any_of(before.begin(), before.end(),
                                          [&](const Move& move) { return move.kick == of_kick; });
        if (is_moved && !keeps(scheme, !of_kick)) { result.push_back(of_kick ? "p" : "q"); }
    }
    if (!scheme.keeps_force || !scheme.keeps_velocity) { result.push_back("slope"); }
    result.push_back("end");
    return result;
}

std::string moves_text(const Scheme& scheme) {
    if (scheme.keeps_remainder) { return compensated_moves_text(scheme); }
    Writer writer(2);
    writer.insert(scratch_text(scratch(scheme)));
    PlainMoves code(writer, scheme);
    const std::vector<Move> all = moves(scheme);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) { code.write(all[i]); }
    code.finish(all.back());
    return writer.str();
}

/// NOTE: what a kept slope belongs to is fitted where that is not known: see PlainMoves.
std::string fits_text(const Scheme& scheme) {
    Writer writer(2);
    const auto fit = [&](std::string_view vector) {
        writer.line("hvi::detail::fit({}_, n);", vector);
    };
    for (const std::string& name : scratch(scheme)) { fit(name); }
    if (scheme.keeps_force) { fit("force"); }
    if (scheme.keeps_velocity) { fit("velocity"); }
    return writer.str();
}

/// A header of the runtime as part of this one, which then has what that includes of hvi. What its
/// doc comments tell users under a heading, `/// # Use`, with an example, stays in the runtime.
std::string copy_of(std::string_view name) {
    std::string text;
    std::istringstream file{std::string(embedded_template(fmt::format("hvi/{}.hpp", name)))};
    bool is_for_users = false;
    for (std::string line; std::getline(file, line);) {
        is_for_users = line.rfind(is_for_users ? "///" : "/// # ", 0) == 0;
        const bool is_included = line.rfind("#include <hvi/", 0) == 0;
        if (!is_for_users && !is_included) { text += line + '\n'; }
    }
    return text;
}

std::string support(const Scheme& scheme, const SceneWishes& wishes, bool with_rounded) {
    std::vector<std::string_view> names{"state", "detail/numbers/scalar"};
    if (wishes.float128) { names.push_back("detail/numbers/math"); }
    if (with_rounded) { names.push_back("detail/coefficients/rounded"); }
    names.push_back("detail/stages/system");
    if (scheme.from_parameter || scheme.depends_on_time || scheme.keeps_remainder) {
        names.insert(names.end(), {"detail/numbers/arithmetic", "detail/numbers/compensated"});
    }
    if (scheme.from_parameter) {
        names.insert(names.end(), {"detail/numbers/pair", "detail/coefficients/series",
                                   "detail/coefficients/parameter"});
    }
    if (scheme.depends_on_time) { names.push_back("detail/stages/clock"); }
    if (scheme.keeps_remainder) {
        names.insert(names.end(), {"detail/stages/step_sums", "detail/coefficients/weights"});
    }
    std::string text;
    for (const std::string_view name : names) {
        text += (text.empty() ? "" : "\n") + copy_of(name);
    }
    return text;
}

/// NOTE: a slope is kept for a step that goes on with the sums.
std::string_view forget(const Scheme& scheme) {
    if (scheme.keeps_remainder) { return "sums_.forget();"; }
    return keeps(scheme) ? "known_ = false;" : "";
}

std::string members_of_moves(const Scheme& scheme) {
    Writer writer(1);
    writer.line("System system_;");
    if (scheme.from_parameter) { writer.line("Coefficients coefficients_;"); }
    if (scheme.depends_on_time) { writer.line("{} clock_;", clock_type(scheme)); }
    if (scheme.keeps_remainder) {
        writer.line("hvi::detail::StepSums<Vector> sums_;").line("{}", weights_member(scheme));
    }
    // NOTE: in this order. In others g++ finds it harder to keep the state in registers.
    std::vector<std::string> vectors = scratch(scheme);
    if (!scheme.keeps_remainder) {
        if (scheme.keeps_velocity) { vectors.insert(vectors.begin(), "p"); }
        if (scheme.keeps_force) { vectors.insert(vectors.begin(), "q"); }
    }
    writer.line("Vector {}_{{}};", fmt::join(vectors, "_{}, "));
    const auto slope = [&](std::string_view name, std::string_view what, std::string_view where) {
        writer.line("Vector {}{{}};  // {} where the last step ended{}", name, what,
                    scheme.keeps_remainder ? "" : where);
    };
    if (scheme.keeps_force) { slope("force_", "dH/dq", ", at q_"); }
    if (scheme.keeps_velocity) { slope("velocity_", "dH/dp", ", at p_"); }
    if (keeps(scheme)) { writer.line("bool known_ = false;  // whether it is kept"); }
    return writer.str();
}

}  // namespace

std::string weights_text(const Scheme& scheme) {
    if (scheme.from_parameter) { return functions_of_parameter(scheme); }
    Writer writer(1);
    const auto write = [&](std::string_view name, const std::vector<StageValue>& values) {
        bool ones = true;
        for (const StageValue& value : values) { ones = ones && equal(value.weight, 1); }
        if (ones) { return; }
        table(writer, name, weights(values));
        refuse_float(writer, weights(values));
    };
    write("b_p", scheme.positions);
    write("b_q", scheme.momenta);
    if (scheme.depends_on_time) { writer.insert(times_text(scheme)); }
    return with_rounding(writer.str());
}

std::string emit_explicit(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    HVI_CHECK(scheme.separable);
    const std::string weights = weights_text(scheme);
    const SystemPart system = system_part(tableau, scheme, options);
    const bool rounds = are_rounded(weights) || are_rounded(system.types);
    Holes holes = holes_of(system);
    holes.merge(Holes{{"banner", banner(tableau, scheme, options)},
                      {"support", support(scheme, options.wishes, rounds)},
                      {"parameter", parameter_text(scheme)},
                      {"begins", begins(scheme)},
                      {"weights", weights},
                      {"fits", fits_text(scheme)},
                      {"moves", moves_text(scheme)},
                      {"state", system.state},
                      {"clock", clock_begins(scheme)},
                      {"status", scheme.depends_on_time ? "clock_.end(x.t, Status{})" : "{}"},
                      {"forget", std::string(forget(scheme))},
                      {"members", members_of_moves(scheme)}});
    return fill("explicit.hpp.in", holes);
}

}  // namespace hvi::gen
