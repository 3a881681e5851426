// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/explicit_moves.hpp"

#include "generator/emit/steps/header.hpp"
#include "generator/plan/equal.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr MoveNames kick{"p", "dHdq", "-", "b_p", "force_"};
constexpr MoveNames drift{"q", "dHdp", "+", "b_q", "velocity_"};

/// Writes the moves where increments are summed apart, of one trajectory or of several, and those
/// of several where they are not.
class SummedMoves {
public:
    SummedMoves(Writer& writer, const Scheme& scheme, std::size_t dimension)
        : writer_(writer), scheme_(scheme), dimension_(dimension) {}

    /// A move, and the stage value that it leads to unless the step ends there.
    void write(const Move& move, bool is_last) {
        evaluate(move);
        const MoveNames& its = names(move);
        bool& is_moved = move.kick ? kicked_ : drifted_;
        const bool is_loaded = is_moved || scheme_.has_trajectory_lanes;
        for_components([&](std::string_view k) {
            const std::string by = change(scheme_, move, k);
            // NOTE: not of the increment so far, or each evaluation would wait for two sums.
            if (!scheme_.keeps_remainder || !is_last) {
                writer_.line("{0}[{1}] = {2}{0}[{1}] {3} {4};", its.moved, k, is_loaded ? "" : "x.",
                             its.sign, by);
            }
            if (scheme_.keeps_remainder) {
                writer_.line("d{}[{}] {}= {};", its.moved, k, its.sign, by);
            }
        });
        is_moved = true;
    }

private:
    /// NOTE: of several trajectories a few components are written out, so that compilers keep them
    /// in registers also below -O3.
    template <class F>
    void for_components(F f) {
        constexpr std::size_t few = 4;
        if (scheme_.has_trajectory_lanes && dimension_ <= few) {
            for (std::size_t k = 0; k < dimension_; ++k) { f(std::to_string(k)); }
            return;
        }
        writer_.open("for ({}; ++k) {{", scheme_.has_trajectory_lanes
                                             ? "std::size_t k = 0; k < q.size()"
                                             : "Index k = 0; k < n");
        f("k");
        writer_.close();
    }

    /// NOTE: before the first move a stage is the state itself, since q + e_q rounds to q. And
    /// known_ is false while the step is under way, should the system throw.
    void evaluate(const Move& move) {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        const std::string at =
            fmt::format("{}{}", other_moved || scheme_.has_trajectory_lanes ? "" : "x.",
                        other_names(move).moved);
        const std::string call = evaluation(scheme_, move, at);
        if (!keeps(scheme_, move.kick) || other_moved) {
            writer_.line("{}", call);
        } else if (scheme_.has_trajectory_lanes) {
            writer_.line("if (!x.carried.is_known) {{ {} }}", call);
        } else {
            writer_.line("const bool kept = known_ && sums_.continues();");
            writer_.line("known_ = false;");
            writer_.line("if (!kept) {{ {} }}", call);
        }
    }

    Writer& writer_;
    const Scheme& scheme_;
    std::size_t dimension_;
    bool kicked_ = false, drifted_ = false;  // whether p, and q, have been moved
};

constexpr std::string_view weigh = "weights_.weigh(h, b_p, b_q);";

void write_moves(Writer& writer, const Scheme& scheme, std::size_t dimension) {
    SummedMoves code(writer, scheme, dimension);
    const std::vector<Move> all = moves(scheme);
    for (std::size_t i = 0; i < all.size(); ++i) { code.write(all[i], i + 1 == all.size()); }
    writer.blank();
}

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
    if (!keeps(scheme, move.kick)) { return "slope"; }
    return scheme.has_trajectory_lanes ? "kept" : std::string(names(move).kept);
}

std::string change(const Scheme& scheme, const Move& move, std::string_view k) {
    if (scheme.keeps_remainder) {
        return fmt::format("weights_.{}[{}] * {}[{}]", names(move).moved, move.index,
                           slope(scheme, move), k);
    }
    const StageValue& value = (move.kick ? scheme.positions : scheme.momenta)[move.index];
    return equal(value.weight, 1)
               ? fmt::format("h * {}[{}]", slope(scheme, move), k)
               : fmt::format("h * {}{}[{}] * {}[{}]", owner(scheme, "s_"), names(move).weights,
                             move.index, slope(scheme, move), k);
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
    writer.line("{}", weigh);
    write_moves(writer, scheme, 0);
    writer.line("if (!sums_.end(x, dq, dp, q, p)) {{ return Status(Status::Code::not_finite); }}");
    if (keeps(scheme)) { writer.line("known_ = true;"); }
    return writer.str();
}

std::string ensemble_moves_text(const Scheme& scheme, std::size_t dimension) {
    Writer writer(2);
    writer.line("if (!{}) {{ return x.status(); }}",
                scheme.keeps_remainder ? "sums_.begin(x, h)" : "x.begins(h)");
    const auto load = [&](std::string_view name, std::string_view from) {
        writer.line("Values {} = hvi::detail::load(x.{});", name, from);
    };
    load("q", "q");
    load("p", "p");
    if (scheme.keeps_remainder) {
        load("dq", "carried.q");
        load("dp", "carried.p");
        writer.line("{}", weigh);
    }
    writer.line("Values slope;");
    if (keeps(scheme)) { load("kept", "carried.slope"); }
    writer.blank();
    write_moves(writer, scheme, dimension);
    const std::string_view end = scheme.keeps_remainder
                                     ? "sums_.end(x, dq, dp"
                                     : "x.end(q, p, hvi::detail::where_finite(q, p)";
    if (keeps(scheme)) {
        writer.open("{}, [&](auto put) {{", end);
        writer.line("put(kept, x.carried.slope);").line("x.carried.is_known = true;").close("});");
    } else {
        writer.line("{});", end);
    }
    return writer.line("return x.status();").str();
}

std::string weights_member(const Scheme& scheme) {
    return fmt::format("hvi::detail::MoveWeights<Scalar, {}, {}> weights_;",
                       scheme.positions.size(), scheme.momenta.size());
}

std::vector<std::string> compensated_scratch(const Scheme& scheme) {
    std::vector<std::string> result{"q", "p", "dq", "dp"};
    if (!scheme.keeps_force || !scheme.keeps_velocity) { result.push_back("slope"); }
    return result;
}

}  // namespace hvi::gen
