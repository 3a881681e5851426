// Headers of steps that are flows of parts of H.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

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

/// Returns the flows of a step in turn.
std::string moves_text(const FlowStep& form) {
    Writer writer(2);
    for (std::size_t i = 0; i < form.rounds.size(); ++i) {
        const auto& [moves, times] = form.rounds[i];
        const bool is_repeated = times > 1;
        if (is_repeated) { writer.open("for (int k = 0; k < {}; ++k) {{", times); }
        write_moves(writer, moves, fmt::format("cycles_{}", i + 1));
        if (is_repeated) { writer.close(); }
    }
    return writer.str();
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

std::string flows_text(const System& system, const FlowStep& form, std::string_view library) {
    const bool inlined = are_inlined(system, form);
    std::string text;
    for (std::size_t k = 0; k < system.parts->parts.size(); ++k) {
        text += (text.empty() ? "" : "\n\n") + flow_text(system, k, library, inlined);
    }
    return text;
}

/// Returns the headers of the runtime: copies, which need the standard library alone, but where
/// bodies turn or orbits go side by side. `code`: all that calls functions.
std::string support(const System& system, std::string_view code) {
    std::vector<std::string> names;
    const auto add = [&](bool is_needed, const std::vector<std::string>& more) {
        if (is_needed) { names.insert(names.end(), more.begin(), more.end()); }
    };
    const auto calls = [&](std::string_view name) {
        return code.find(name) != std::string_view::npos;
    };
    const bool calls_math = calls("hvi::math::"), turns = calls("hvi::math::small_");
    const bool has_bodies = rotations_of(system) > 0,
               is_runtime = has_bodies || moves_on_orbits(*system.parts);
    add(has_bodies, {"detail/groups/chart_space"});
    add(!is_runtime, {"state", "detail/numbers/scalar"});
    add(calls_math && !is_runtime, {"detail/numbers/math"});
    add(calls_math, {"detail/numbers/more_math"});
    add(turns, {"detail/numbers/small_turns"});
    add(are_rounded(code) && !is_runtime, {"detail/coefficients/rounded"});
    add(!is_runtime,
        {"detail/stages/system", "detail/numbers/arithmetic", "detail/numbers/compensated"});
    add(true, {"detail/stages/flow_sums"});
    add(moves_forms(*system.parts) && !is_runtime,
        {"detail/numbers/two_product", "detail/numbers/pair"});
    add(moves_forms(*system.parts), {"detail/stages/form_flow"});
    add(moves_on_orbits(*system.parts), {"detail/stages/two_bodies"});
    if (!is_runtime) { return copies_of(names); }
    names.emplace_back("detail/stepper");
    std::string text;
    for (const std::string& name : names) { text += fmt::format("#include <hvi/{}.hpp>\n", name); }
    return text + "\n";
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
    const std::string flows = flows_text(system, form, library(options.wishes));
    Holes holes = holes_of(part);
    holes.merge(Holes{{"support", support(system, fractions + flows + part.types + part.construct)},
                      {"state", part.state},
                      {"numbers", in_members(numbers_of_bodies::type, "State")},
                      {"path", moves_forms(*system.parts) ? "LongFlowPath" : "FlowPath"},
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
