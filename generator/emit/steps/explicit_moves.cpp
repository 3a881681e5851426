// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/explicit_moves.hpp"

#include <optional>

#include "generator/emit/steps/along.hpp"
#include "generator/emit/steps/clock.hpp"
#include "generator/emit/steps/header.hpp"
#include "generator/emit/steps/slope_calls.hpp"
#include "generator/ir/equal.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

constexpr MoveNames kick{"p", "dHdq", "-", "b_p", "force_"};
constexpr MoveNames drift{"q", "dHdp", "+", "b_q", "velocity_"};

/// Writes the moves where increments are summed apart, of one trajectory or of several, and those
/// of several where they are not.
class SummedMoves {
public:
    /// `dimension`: of several trajectories.
    SummedMoves(Writer& writer, const Step& step, Sums sums,
                std::optional<std::size_t> dimension = {})
        : writer_(writer), step_(step), sums_(sums), dimension_(dimension) {}

    void write_all() {
        const std::vector<Move> all = moves(step_);
        for (std::size_t i = 0; i < all.size(); ++i) { write(all[i], i + 1 == all.size()); }
        writer_.blank();
    }

private:
    /// A move, and the stage value that it leads to unless the step ends there.
    void write(const Move& move, bool is_last) {
        evaluate(move);
        if (!dimension_) {
            writer_.insert(
                carry_by_move(step_, move, value(!move.kick),
                              sums_ == Sums::compensated ? weight(move) : size(step_, move)));
        }
        const MoveNames& its = names(move);
        const bool is_apart = sums_ == Sums::compensated;
        for_components([&](std::string_view k) {
            const std::string by = is_apart ? weighed(move, k) : change(step_, move, k);
            // NOTE: not of the increment so far, or each evaluation would wait for two sums.
            if (!is_apart || !is_last) {
                writer_.line("{0}[{1}] = {2}[{1}] {3} {4};", its.moved, k, value(move.kick),
                             its.sign, by);
            }
            if (is_apart) { writer_.line("d{}[{}] {}= {};", its.moved, k, its.sign, by); }
        });
        (move.kick ? kicked_ : drifted_) = true;
    }

    [[nodiscard]] std::string weighed(const Move& move, std::string_view k) const {
        return fmt::format("{} * {}[{}]", weight(move), slope(step_, move), k);
    }

    [[nodiscard]] std::string weight(const Move& move) const {
        return fmt::format("{}.{}[{}]", step_.layout == Layout::threads ? "by" : "weights_",
                           names(move).moved, move.index);
    }

    /// Where p, or q, is: of one trajectory in the state until it is moved.
    [[nodiscard]] std::string value(bool of_kick) const {
        const bool is_loaded = dimension_ || (of_kick ? kicked_ : drifted_);
        return fmt::format("{}{}", is_loaded ? "" : "x.", of_kick ? "p" : "q");
    }

    /// NOTE: of several trajectories a few components are written out, so that compilers keep them
    /// in registers also below -O3.
    template <class F>
    void for_components(F f) {
        constexpr std::size_t few = 4;
        if (dimension_ && *dimension_ <= few) {
            for (std::size_t k = 0; k < *dimension_; ++k) { f(std::to_string(k)); }
            return;
        }
        writer_.open("for ({}; ++k) {{",
                     dimension_ ? "std::size_t k = 0; k < q.size()" : "Index k = 0; k < n");
        f("k");
        writer_.close();
    }

    /// NOTE: before the first move a stage is the state itself, since q + e_q rounds to q. And
    /// known_ is false while the step is under way, should the system throw.
    void evaluate(const Move& move) {
        const bool other_moved = move.kick ? drifted_ : kicked_;
        const std::string call = evaluation(step_, move, value(!move.kick));
        if (!keeps(step_, move.kick) || other_moved) {
            writer_.line("{}", call);
        } else if (step_.layout == Layout::threads) {
            writer_.line("if (!x.knows_slope) {{ {} }}", call);
        } else if (dimension_) {
            writer_.open("if (!x.carried.are_known) {{")
                .line("{}", evaluation(step_, move, value(!move.kick), "slope"))
                .line("x.carried.fill(slope, kept);")
                .close();
        } else {
            writer_.line("const bool kept = known_ && sums_.continues();");
            writer_.line("known_ = false;");
            writer_.line("if (!kept) {{ {} }}", call);
        }
    }

    Writer& writer_;
    const Step& step_;
    Sums sums_;
    std::optional<std::size_t> dimension_;
    bool kicked_ = false, drifted_ = false;  // whether p, and q, have been moved
};

}  // namespace

std::vector<Move> moves(const Step& step) {
    std::vector<Move> result;
    for (const Block& block : step.blocks) {
        const StageNode node = block.nodes.front();
        if (node.kind == Kind::Lp) { result.push_back({true, node.index}); }
        if (node.kind == Kind::Lq) { result.push_back({false, node.index}); }
    }
    return result;
}

const MoveNames& names(const Move& move) { return move.kick ? kick : drift; }
const MoveNames& other_names(const Move& move) { return move.kick ? drift : kick; }

bool keeps(const Step& step, bool of_kick) {
    return of_kick ? step.kept.force : step.kept.velocity;
}

std::string slope(const Step& step, const Move& move) {
    if (!keeps(step, move.kick)) { return "slope"; }
    return step.takes_several() ? "kept" : std::string(names(move).kept);
}

std::string size(const Step& step, const Move& move) {
    const StageValue& value = (move.kick ? step.positions : step.momenta)[move.index];
    if (step.layout == Layout::threads) {
        return equal(value.weight, 1) ? "by.h"
                                      : fmt::format("by.{}[{}]", names(move).moved, move.index);
    }
    return equal(value.weight, 1)
               ? "h"
               : fmt::format("h * {}{}[{}]", owner(step, "s_"), names(move).weights, move.index);
}

std::string change(const Step& step, const Move& move, std::string_view k) {
    return fmt::format("{} * {}[{}]", size(step, move), slope(step, move), k);
}

std::string evaluation(const Step& step, const Move& move, std::string_view at) {
    return evaluation(step, move, at, slope(step, move));
}

std::string evaluation(const Step& step, const Move& move, std::string_view at,
                       const std::string& out) {
    const std::string point(at);
    const std::string i = std::to_string(move.index);
    const auto time_of = [&]() -> std::string {
        switch (step.layout) {
        case Layout::trajectories:
            return time_of_trajectories(step, fmt::format("x.clock.at(c[{}])", i));
        case Layout::threads: return time_of_thread(step, i);
        default: return time_of_stage(step, i, "s_");
        }
    };
    const std::string time = time_of();
    const SlopePoint where{point, point, time};
    const std::string call =
        move.kick ? force_call(step, where, out) : velocity_call(step, where, out);
    return fmt::format("system_.{};", call);
}

std::string scratch_text(const std::vector<std::string>& names) {
    Writer writer(2);
    for (const std::string& name : names) {
        writer.line("auto&& {0} = hvi::detail::scratch({0}_);", name);
    }
    return writer.str();
}

std::string compensated_moves_text(const Step& step) {
    Writer writer(2);
    writer.insert(scratch_text(compensated_scratch(step)));
    writer.line(
        "if (!sums_.begin(x, dq, dp)) {{ return Status(Status::Code::unsafe_arithmetic); }}");
    writer.line("weights_.weigh(h, b_p, b_q);");
    SummedMoves(writer, step, Sums::compensated).write_all();
    writer.insert(end_of_moves(step));
    writer.line("if (!sums_.end(x, dq, dp, q, p)) {{ return Status(Status::Code::not_finite); }}");
    if (step.kept.any()) { writer.line("known_ = true;"); }
    return writer.str();
}

std::string ensemble_moves_text(const Step& step, Sums sums, std::size_t dimension) {
    const bool is_apart = sums == Sums::compensated;
    Writer writer(2);
    writer.line("if (!{}) {{ return x.status(); }}",
                is_apart ? "sums_.begin(x, h_)" : "x.begins(h_)");
    const auto load = [&](std::string_view name, std::string_view from) {
        writer.line("Values {} = hvi::detail::load(x.{});", name, from);
    };
    load("q", "q");
    load("p", "p");
    if (is_apart) {
        load("dq", "carried.q");
        load("dp", "carried.p");
    } else {
        writer.line("const Lane h(h_);");
    }
    writer.line("Values slope;");
    if (step.kept.any()) { load("kept", "carried.slope"); }
    writer.blank();
    SummedMoves(writer, step, sums, dimension).write_all();
    const std::string_view end =
        is_apart ? "sums_.end(x, dq, dp" : "x.end(q, p, hvi::detail::where_finite(q, p)";
    if (step.kept.any()) {
        writer.open("{}, [&](auto put) {{", end);
        writer.line("put(kept, x.carried.slope);").line("x.carried.know();").close("});");
    } else {
        writer.line("{});", end);
    }
    return writer.line("return x.status();").str();
}

std::string thread_moves_text(const Step& step, Sums sums, std::size_t dimension) {
    Writer writer(2);
    SummedMoves(writer, step, sums, dimension).write_all();
    return writer.str();
}

std::string weights_member(const Step& step) {
    return fmt::format("hvi::detail::{}Weights<Scalar, {}, {}> weights_;",
                       step.layout == Layout::trajectories ? "Trajectory" : "Move",
                       step.positions.size(), step.momenta.size());
}

std::vector<std::string> compensated_scratch(const Step& step) {
    std::vector<std::string> result{"q", "p", "dq", "dp"};
    if (!step.kept.force || !step.kept.velocity) { result.push_back("slope"); }
    return result;
}

}  // namespace hvi::gen
