// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/explicit_moves.hpp"

#include "generator/emit/steps/header.hpp"
#include "generator/plan/equal.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr MoveNames kick{"p", "dHdq", "-", "b_p", "force_"};
constexpr MoveNames drift{"q", "dHdp", "+", "b_q", "velocity_"};

/// Writes the moves where increments are summed apart.
class CompensatedMovesWriter {
public:
    CompensatedMovesWriter(Writer& writer, const Scheme& scheme)
        : writer_(writer), scheme_(scheme) {}

    /// A move, and the stage value that it leads to unless the step ends there.
    void write(const Move& move, bool is_last) {
        evaluate(move);
        const std::string_view moved = names(move).moved;
        writer_.open("for (Index k = 0; k < n; ++k) {{");
        writer_.line("d{}[k] {}= {};", moved, names(move).sign, change(scheme_, move));
        if (!is_last) { writer_.line("{0}[k] = x.{0}[k] + d{0}[k];", moved); }
        writer_.close();
        (move.kick ? kicked_ : drifted_) = true;
    }

private:
    /// NOTE: before the first move a stage is the state itself, since q + e_q rounds to q. And
    /// known_ is false while the step is under way, should the system throw.
    void evaluate(const Move& move) {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        const std::string at =
            fmt::format("{}{}", other_moved ? "" : "x.", other_names(move).moved);
        if (!keeps(scheme_, move.kick) || other_moved) {
            writer_.line("{}", evaluation(scheme_, move, at));
            return;
        }
        writer_.line("const bool kept = known_ && sums_.continues();");
        writer_.line("known_ = false;");
        writer_.line("if (!kept) {{ {} }}", evaluation(scheme_, move, at));
    }

    Writer& writer_;
    const Scheme& scheme_;
    bool kicked_ = false, drifted_ = false;  // whether p, and q, have been moved
};

}  // namespace

std::vector<Move> moves(const Scheme& scheme) {
    std::vector<Move> result;
    for (const Block& block : scheme.blocks) {
        const StageNode node = block.nodes.front();
        if (node.kind == Kind::Lp) { result.push_back({true, node.index}); }
        if (node.kind == Kind::Lq) { result.push_back({false, node.index}); }
    }
    return result;
}

const MoveNames& names(const Move& move) { return move.kick ? kick : drift; }
const MoveNames& other_names(const Move& move) { return move.kick ? drift : kick; }

bool keeps(const Scheme& scheme, bool of_kick) {
    return of_kick ? scheme.keeps_force : scheme.keeps_velocity;
}

bool keeps(const Scheme& scheme) { return scheme.keeps_force || scheme.keeps_velocity; }

std::string slope(const Scheme& scheme, const Move& move) {
    return keeps(scheme, move.kick) ? std::string(names(move).kept) : "slope";
}

std::string change(const Scheme& scheme, const Move& move) {
    const StageValue& value = (move.kick ? scheme.positions : scheme.momenta)[move.index];
    return equal(value.weight, 1)
               ? fmt::format("h * {}[k]", slope(scheme, move))
               : fmt::format("h * {}{}[{}] * {}[k]", owner(scheme, "s_"), names(move).weights,
                             move.index, slope(scheme, move));
}

std::string evaluation(const Scheme& scheme, const Move& move, std::string_view at) {
    return fmt::format("system_.{}({}, {}{});", names(move).gradient, at,
                       move.kick ? stage_time(scheme, move.index, "s_") : "", slope(scheme, move));
}

std::string scratch_text(const std::vector<std::string>& names) {
    Writer writer(2);
    for (const std::string& name : names) {
        writer.line("auto&& {0} = hvi::detail::scratch({0}_);", name);
    }
    return writer.str();
}

std::string compensated_moves_text(const Scheme& scheme) {
    Writer writer(2);
    writer.insert(scratch_text(compensated_scratch(scheme)));
    writer.line(
        "if (!sums_.begin(x, dq, dp)) {{ return Status(Status::Code::unsafe_arithmetic); }}");
    CompensatedMovesWriter code(writer, scheme);
    const std::vector<Move> all = moves(scheme);
    for (std::size_t i = 0; i < all.size(); ++i) { code.write(all[i], i + 1 == all.size()); }
    writer.blank();
    writer.line("if (!sums_.end(x, dq, dp, q, p)) {{ return Status(Status::Code::not_finite); }}");
    if (keeps(scheme)) { writer.line("known_ = true;"); }
    return writer.str();
}

std::vector<std::string> compensated_scratch(const Scheme& scheme) {
    std::vector<std::string> result{"q", "p", "dq", "dp"};
    if (!scheme.keeps_force || !scheme.keeps_velocity) { result.push_back("slope"); }
    return result;
}

}  // namespace hvi::gen
