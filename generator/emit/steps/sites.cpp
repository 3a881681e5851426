// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/steps/explicit_moves.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/system_part.hpp"
#include "generator/emit/system/loop_files.hpp"
#include "generator/ir/equal.hpp"
#include "src/hvi/version.hpp"

namespace hvi::gen {

namespace {

/// Returns the weight of a move, 1 where there is no table of weights.
std::string weight_of(const Step& step, const Move& move) {
    const std::vector<StageValue>& values = move.kick ? step.positions : step.momenta;
    const bool are_ones = std::all_of(values.begin(), values.end(), [](const StageValue& value) {
        return equal(value.weight, 1);
    });
    return are_ones ? "Scalar(1)" : fmt::format("b_{}[{}]", move.kick ? "p" : "q", move.index);
}

std::string moves_text(const Step& step) {
    Writer writer(3);
    for (const Move& move : moves(step)) {
        writer.line("Move{{Move::{}, {}}},", move.kick ? "kick" : "drift", weight_of(step, move));
    }
    return writer.str();
}

/// Returns the number of forces of `steps` steps that go well. NOTE: the last kick of a step and
/// the first of the next one share a force.
std::string forces_of(const std::vector<Move>& all, std::string_view steps) {
    const auto kicks =
        std::count_if(all.begin(), all.end(), [](const Move& move) { return move.kick; });
    const bool are_shared = kicks > 1 && all.front().kick && all.back().kick;
    return are_shared ? fmt::format("({} > 0 ? {} * {} + 1 : 0)", steps, kicks - 1, steps)
                      : fmt::format("{} * {}", kicks, steps);
}

}  // namespace

std::string emit_sites(const OneStepMethod& method, const Step& step, const EmitOptions& options) {
    const auto& form = std::get<ExplicitStep>(step.form);
    const System& system = *options.system;
    const SystemPart part = system_part(method, step, options);
    const std::vector<Move> all = moves(step);
    // NOTE: the stepper itself knows how many evaluations it takes.
    SceneWishes members = options.wishes;
    members.evaluations = false;
    const std::string include = include_of_files(system) + own_includes(system.own_headers) +
                                "#include <hvi/detail/coefficients/rounded.hpp>\n"
                                "#include <hvi/detail/lanes/lane_functions.hpp>\n"
                                "#include <hvi/detail/loops/along.hpp>\n"
                                "#include <hvi/detail/loops/ranges.hpp>\n"
                                "#include <hvi/detail/loops/site_moves.hpp>\n"
                                "#include <hvi/integrate.hpp>\n"
                                "#include <hvi/version.hpp>";
    return fill("sites.hpp.in",
                {{"include", include},
                 {"format", std::to_string(hvi::runtime_format)},
                 {"name", part.class_name},
                 {"purpose", part.purpose},
                 {"condition", part.condition},
                 {"types", part.types},
                 {"members", scene_members_text(system, members, step)},
                 {"weights", weights_text(step)},
                 {"moves", moves_text(step)},
                 {"forces", forces_of(all, "run.steps")},
                 {"sums", form.sums == Sums::plain ? "PlainSums" : "CompensatedSums"},
                 {"alias", part.alias}});
}

}  // namespace hvi::gen
