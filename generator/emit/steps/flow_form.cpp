// Headers of steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/flow_form.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/copies.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/system/scene_code.hpp"

namespace hvi::gen {

namespace {

/// Returns the lines that compute the flows of all lengths.
std::string lengths_text(const FlowStep& form) {
    Writer writer(2);
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        writer.open("for (std::size_t i = 0; i < {}; ++i) {{", form.fractions[k].size());
        writer.line("flows_{0}_[i] = Flow{0}(parameters_, h * fractions_{0}[i]);", k + 1).close();
    }
    return writer.str();
}

std::string members_text(const Step& step, const FlowStep& form) {
    Writer writer(1);
    for (std::size_t k = 0; k < form.fractions.size(); ++k) {
        writer.line("Flow{0} flows_{0}_[{1}];", k + 1, form.fractions[k].size());
    }
    return writer.insert(clock_member(step)).str();
}

/// Moves of the same parts in the same order, again and again, over other fractions.
struct Cycles {
    std::size_t count;  ///< 0 where there are not two of them
    std::size_t moves;  ///< in a cycle

    [[nodiscard]] std::size_t end() const { return count * moves; }
};

Cycles cycles_of(const std::vector<FlowStep::Move>& moves) {
    const auto same = [](const auto& a, const auto& b) { return a.part == b.part; };
    for (std::size_t period = 1; 2 * period <= moves.size(); ++period) {
        const auto shift = static_cast<std::ptrdiff_t>(period);
        if (std::equal(moves.begin() + shift, moves.end(), moves.begin(), moves.end() - shift,
                       same)) {
            return {moves.size() / period, period};
        }
    }
    return {0, 0};
}

/// Writes the flow of a move; `place` is that of its fraction.
void write_move(Writer& writer, const FlowStep::Move& move, const std::string& place) {
    writer.line("flows_{}_[{}](path);", move.part + 1, place);
}

/// Writes flows in turn: cycles in a loop over a table of this name, and what follows them.
void write_moves(Writer& writer, const std::vector<FlowStep::Move>& moves,
                 const std::string& table) {
    const Cycles cycles = cycles_of(moves);
    if (cycles.count > 0) {
        writer.open("static constexpr std::size_t {}[{}][{}] = {{", table, cycles.count,
                    cycles.moves);
        for (std::size_t first = 0; first < cycles.end(); first += cycles.moves) {
            std::vector<std::size_t> places;
            for (std::size_t k = 0; k < cycles.moves; ++k) {
                places.push_back(moves[first + k].fraction);
            }
            writer.line("{{{}}},", fmt::join(places, ", "));
        }
        writer.close("};").open("for (const auto& cycle : {}) {{", table);
        for (std::size_t k = 0; k < cycles.moves; ++k) {
            write_move(writer, moves[k], fmt::format("cycle[{}]", k));
        }
        writer.close();
    }
    for (std::size_t k = cycles.end(); k < moves.size(); ++k) {
        write_move(writer, moves[k], std::to_string(moves[k].fraction));
    }
}

/// Writes rounds in turn.
void write_rounds(Writer& writer, const std::vector<FlowStep::Round>& rounds) {
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        const auto& [moves, times] = rounds[i];
        const bool is_repeated = times > 1;
        if (is_repeated) { writer.open("for (int k = 0; k < {}; ++k) {{", times); }
        write_moves(writer, moves, fmt::format("cycles_{}", i + 1));
        if (is_repeated) { writer.close(); }
    }
}

/// Returns the flows of steps in turn. `at`: the state, or where its numbers are in a row.
std::string moves_text(const FlowStep& form, const std::string& at) {
    if (!form.joined) { return rounds_text(form); }
    Writer writer(2);
    const FlowStep::Move& first = form.rounds.front().moves.front();
    const FlowStep::Move& last = form.rounds.back().moves.back();
    write_move(writer, first, std::to_string(first.fraction));
    writer.open("for (std::int64_t step = 1;; ++step) {{");
    write_rounds(writer, form.between());
    writer.line("if (step == steps) {{ break; }}");
    write_move(writer, first, std::to_string(*form.joined));
    writer.line("if (!sums_.pass({}, path)) {{ return Status(Status::Code::not_finite); }}", at);
    if (form.clock) {
        writer.line("if (!clock_.pass(x.t, h)) {{ return Status(Status::Code::not_finite); }}");
    }
    writer.close();
    write_move(writer, last, std::to_string(last.fraction));
    return writer.str();
}

/// Returns the template of the way of a state through a step.
std::string path_template(const System& system) {
    return moves_forms(*system.parts) ? "hvi::detail::LongFlowPath" : "hvi::detail::FlowPath";
}

/// Returns the declaration of the way through a step.
std::string path_text(const FlowStep& form, const System& system, std::string_view numbers) {
    const std::string path = fmt::format("{}<{}>", path_template(system), numbers);
    if (!form.clock) { return path + " path"; }
    return fmt::format("hvi::detail::TimedPath<{}, Scalar> path(clock_)", path);
}

/// Returns the type of the directions that a step carries along.
std::string along_text(const FlowStep& form, const System& system, Carries carries) {
    if (carries == Carries::nothing) { return {}; }
    Writer writer(1);
    if (form.clock) {
        writer.line("template <class At>");
        writer.line("using PathInTime = hvi::detail::TimedPath<{}<At>, Scalar>;",
                    path_template(system));
        writer.blank();
    }
    return writer.line("/// Directions that a step carries along; see hvi/directions.hpp.")
        .line("using Along = hvi::detail::FlowsAlong<State, {}>;",
              form.clock ? "PathInTime" : path_template(system))
        .blank()
        .str();
}

/// Returns the member that carries directions along a step.
///
/// NOTE: the flows are those of the state: their tables depend on h and parameters, which have no
/// derivatives. So nothing of the step of the state itself changes, nor do its bits.
std::string carry_text(const FlowStep& form, Carries carries) {
    if (carries == Carries::nothing) { return {}; }
    Writer writer(1);
    writer.line("/// Carries directions along the step from x.")
        .open("Status carry(const State& x, Scalar h, Along& along) {{")
        .line("if (!hvi::detail::is_finite(h)) {{ return Status(Status::Code::not_finite); }}")
        .line("if (h != h_) {{ set_size(h); }}");
    if (form.clock) {
        writer.line("hvi::detail::FlowClock<Scalar> clock = clock_;");
        writer.line("if (!clock.begin(x.t, h)) {{ along.forget(); }}");
    }
    return writer.open("const auto flows = [this](auto& path) {{")
        .insert(rounds_text(form))
        .close("};")
        .line("return along.carry(x, flows{});", form.clock ? ", clock" : "")
        .close()
        .blank()
        .str();
}

/// Returns the member that takes a step.
std::string one_step_text(const FlowStep& form, Carries carries) {
    const std::string take = fmt::format("return take(x, h{});", form.joined ? ", 1" : "");
    Writer writer(1);
    if (carries == Carries::nothing) {
        return writer.line("[[nodiscard]] Status step(State& x, Scalar h) {{ {} }}", take).str();
    }
    return writer.open("[[nodiscard]] Status step(State& x, Scalar h, Along* along = nullptr) {{")
        .open("if (along != nullptr && h != 0) {{")
        .line("const Status status = carry(x, h, *along);")
        .line("if (!status.ok()) {{ return status; }}")
        .close()
        .line("{}", take)
        .close()
        .str();
}

/// Returns the members that take steps.
std::string step_text(const FlowStep& form, Carries carries) {
    Writer writer(1);
    writer.insert(one_step_text(form, carries));
    if (!form.joined) { return writer.str(); }
    return writer.blank()
        .comment("Takes steps of size h in a row. The last flow of a step and the first one of "
                 "the next are one: the end differs from that of single steps in round-off. A step "
                 "that fails ends the run, and x is then the state after the last good step.",
                 "/// ")
        .open("hvi::Run advance(State& x, Scalar h, std::int64_t steps) {{")
        .line("const auto more = [&](std::int64_t count) {{ return take(x, h, count); }};")
        .line("return hvi::detail::take_in_a_row(x, steps, more);")
        .close()
        .str();
}

/// Returns whether flows are inlined: where the step's code moves few numbers. NOTE: what a flow
/// has moved then stays in registers, and the next one waits for no memory: turns of one body or
/// two take a tenth of the time less. Those of eight, whose code is then too long for the nearest
/// cache, would take two to three times as long.
bool are_inlined(const System& system, const FlowStep& form) {
    constexpr std::size_t most = 100;
    std::size_t numbers = 0;
    for (const FlowStep::Round& round : form.rounds) {
        const Cycles cycles = cycles_of(round.moves);
        for (std::size_t k = 0; k < round.moves.size(); ++k) {
            const bool is_written = k < cycles.moves || k >= cycles.end();
            if (is_written) { numbers += system.parts->parts[round.moves[k].part].moved.size(); }
        }
    }
    return numbers <= most;
}

/// Returns the headers of the runtime: copies, which need the standard library alone, but where
/// bodies turn, orbits go side by side or directions go along. `code`: all that calls functions.
std::string support(const Step& step, const System& system, std::string_view code) {
    std::vector<std::string> names;
    const auto add = [&](bool is_needed, const std::vector<std::string>& more) {
        if (is_needed) { names.insert(names.end(), more.begin(), more.end()); }
    };
    const auto calls = [&](std::string_view name) {
        return code.find(name) != std::string_view::npos;
    };
    const bool calls_math = calls("hvi::math::"), turns = calls("hvi::math::small_");
    const bool has_bodies = rotations_of(system) > 0,
               has_orbits = gen::calls(*system.parts, RuntimeFunction::orbits),
               has_directions = step.carries == Carries::directions,
               is_runtime = has_bodies || has_orbits || has_directions;
    add(has_bodies, {"detail/groups/chart_space"});
    add(!is_runtime, {"state", "detail/numbers/scalar"});
    add(calls_math && !is_runtime, {"detail/numbers/math"});
    add(calls_math, {"detail/numbers/more_math"});
    add(turns, {"detail/numbers/small_turns"});
    add(are_rounded(code) && !is_runtime, {"detail/coefficients/rounded"});
    add(!is_runtime,
        {"detail/stages/system", "detail/numbers/arithmetic", "detail/numbers/compensated"});
    add(!is_runtime, {"detail/run"});
    add(true, clock_runtime(step));
    add(true, {"detail/stages/flow_sums"});
    add(moves_forms(*system.parts) && !is_runtime,
        {"detail/numbers/two_product", "detail/numbers/pair"});
    add(moves_forms(*system.parts), {"detail/stages/form_flow"});
    add(has_orbits, {"detail/stages/two_bodies"});
    add(gen::calls(*system.parts, RuntimeFunction::turn_about_momentum),
        {"detail/groups/turn_about_momentum"});
    add(has_directions, {"detail/directions/flows_along"});
    add(has_directions && has_orbits, {"detail/stages/orbits_in_duals"});
    if (!is_runtime) { return copies_of(names); }
    names.emplace_back("detail/stepper");
    std::string text;
    for (const std::string& name : names) { text += fmt::format("#include <hvi/{}.hpp>\n", name); }
    return text + "\n";
}

}  // namespace

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

std::string rounds_text(const FlowStep& form) {
    Writer writer(2);
    write_rounds(writer, form.rounds);
    return writer.str();
}

std::string flows_text(const System& system, const FlowStep& form, std::string_view library,
                       Constants constants, Carries carries) {
    const FlowCalls calls = are_inlined(system, form) ? FlowCalls::inlined : FlowCalls::called;
    std::string text;
    for (std::size_t k = 0; k < system.parts->parts.size(); ++k) {
        text +=
            (text.empty() ? "" : "\n\n") + flow_text(system, k, library, calls, constants, carries);
    }
    return text;
}

std::string emit_one(const OneStepMethod& method, const Step& step, const FlowStep& form,
                     const EmitOptions& options) {
    const System& system = *options.system;
    const bool are_in_members = rotations_of(system) > 0;
    const auto in_members = [&](std::string_view text, std::string_view otherwise) {
        return are_in_members ? text : otherwise;
    };
    const SystemPart part = system_part(method, step, options);
    const std::string at(in_members(numbers_of_bodies::name, "x"));
    const std::string_view numbers = in_members(numbers_of_bodies::type, "State");
    const std::string fractions = fractions_text(form);
    const Carries carries = step.carries;
    const std::string flows = flows_text(
        system, form, carries == Carries::nothing ? library(options.wishes) : "hvi::math",
        Constants::are_numbers, carries);
    Holes holes = holes_of(part);
    holes.merge(
        Holes{{"support", support(step, system, fractions + flows + part.types + part.construct)},
              {"state", part.state},
              {"numbers", std::string(numbers)},
              {"along", along_text(form, system, carries)},
              {"clock", clock_begins(step, "sums_.forget()")},
              {"path", path_text(form, system, numbers)},
              {"begin", std::string(in_members(numbers_of_bodies::taken, ""))},
              {"at", at},
              {"step", step_text(form, carries)},
              {"carry", carry_text(form, carries)},
              {"count", form.joined ? ", std::int64_t steps" : ""},
              {"moves", moves_text(form, at)},
              {"set", std::string(in_members(numbers_of_bodies::put_back, ""))},
              {"status", std::string(clock_ends_well(step))},
              {"flows", flows},
              {"fractions", fractions},
              {"lengths", lengths_text(form)},
              {"members", members_text(step, form)}});
    return fill("flows.hpp.in", holes);
}

}  // namespace hvi::gen
