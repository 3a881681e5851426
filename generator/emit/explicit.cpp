// Headers of methods that solve nothing.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sstream>

#include "generator/emit/banner.hpp"
#include "generator/emit/embedded.hpp"
#include "generator/emit/header.hpp"
#include "generator/emit/system_part.hpp"
#include "generator/plan/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {
namespace {

using Kind = StageNode::Kind;

/// NOTE: in an explicit scheme for separable H every m_ij is 0 or 1, since one that is neither
/// makes Q_i and P_j depend on each other. So each stage value is the one before it plus one slope:
/// p -= h b dH/dq and q += h b dH/dp in turn, in the order of the blocks.
struct Move {
    bool kick;          // of p, else a drift of q
    std::size_t index;  // of the slope
};

std::vector<Move> moves(const Scheme& scheme) {
    std::vector<Move> result;
    for (const Block& block : scheme.blocks) {
        const StageNode node = block.nodes.front();
        if (node.kind == Kind::Lp) { result.push_back({true, node.index}); }
        if (node.kind == Kind::Lq) { result.push_back({false, node.index}); }
    }
    return result;
}

/// What kicks and drifts call their things.
struct Names {
    std::string_view moved, other;  // p_ and q_
    std::string_view from;          // x.p
    std::string_view gradient, sign, weights, kept;
};

constexpr Names kick{"p_", "q_", "x.p", "dHdq", "-", "b_p", "force_"};
constexpr Names drift{"q_", "p_", "x.q", "dHdp", "+", "b_q", "velocity_"};

/// One kick or drift. `first_of_kind`: nothing has been added to this variable yet; `moved_other`:
/// the other variable stands where it is evaluated, not in x.
void write(Writer& writer, const Scheme& scheme, const Move& move, bool first_of_kind,
           bool moved_other) {
    const Names& names = move.kick ? kick : drift;
    const bool keeps = move.kick ? scheme.keeps_force : scheme.keeps_velocity;
    const StageValue& value = (move.kick ? scheme.positions : scheme.momenta)[move.index];
    const std::string_view slope = keeps ? names.kept : "slope_";
    const std::string other_start = move.kick ? "x.q" : "x.p";

    // NOTE: what a kept slope belongs to, is equal to x and at hand.
    const bool other_keeps = move.kick ? scheme.keeps_velocity : scheme.keeps_force;
    const bool in_place = !first_of_kind || other_keeps;
    const std::string change = equal(value.weight, 1)
                                   ? fmt::format("h * {}[k]", slope)
                                   : fmt::format("h * {}{}[{}] * {}[k]", owner(scheme, "s_"),
                                                 names.weights, move.index, slope);
    const auto add = [&] {
        writer.open("for (Index k = 0; k < n; ++k) {{");
        if (in_place) {
            writer.line("{}[k] {}= {};", names.moved, names.sign, change);
        } else {
            writer.line("{}[k] = {}[k] {} {};", names.moved, names.from, names.sign, change);
        }
        writer.close();
    };
    const auto evaluate = [&](std::string_view at) {
        writer.line("system_.{}({}, {}{});", names.gradient, at,
                    move.kick ? stage_time(scheme, move.index, "s_") : "", slope);
    };
    if (!keeps || moved_other) {
        evaluate(moved_other ? std::string(names.other) : other_start);
        add();
        return;
    }
    // NOTE: known_ is false while the step is under way, should the system throw. The sum comes
    // before the test: after it, g++ keeps x in memory for the call of the system in the branch
    // that is hardly ever taken, and a step waits for that memory.
    HVI_CHECK(!in_place);
    writer.line("const bool kept = known_ && hvi::detail::same_bits({}, {});", names.other,
                other_start);
    writer.line("known_ = false;");
    add();
    writer.open("if (!kept) {{").line("{} = {};", names.other, other_start);
    evaluate(names.other);
    add();
    writer.close();
}

std::string moves_text(const Scheme& scheme) {
    Writer writer(2);
    bool kicked = false;
    bool drifted = false;
    for (const Move& move : moves(scheme)) {
        bool& moved = move.kick ? kicked : drifted;
        write(writer, scheme, move, !moved, move.kick ? drifted : kicked);
        moved = true;
    }
    return writer.str();
}

bool keeps(const Scheme& scheme) { return scheme.keeps_force || scheme.keeps_velocity; }

std::string ends_text(const Scheme& scheme) {
    Writer writer(2);
    constexpr std::string_view failed = "return Status(Status::Code::not_finite);";
    if (keeps(scheme)) {
        writer.line("known_ = hvi::detail::finite(q_) && hvi::detail::finite(p_);");
        writer.line("if (!known_) {{ {} }}", failed);
    } else {
        writer.open("if (!hvi::detail::finite(q_) || !hvi::detail::finite(p_)) {{")
            .line("{}", failed)
            .close();
    }
    return writer.str();
}

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

/// NOTE: what a kept slope belongs to is not fitted but copied, dimension and all: see write().
std::string fits_text(const Scheme& scheme) {
    Writer writer(2);
    const auto fit = [&](std::string_view vector) {
        writer.line("hvi::detail::fit({}, n);", vector);
    };
    if (!scheme.keeps_force) { fit("q_"); }
    if (!scheme.keeps_velocity) { fit("p_"); }
    if (scheme.keeps_force) { fit("force_"); }
    if (scheme.keeps_velocity) { fit("velocity_"); }
    fit("slope_");
    return writer.str();
}

/// A file of the runtime as part of the header, which then has what that file includes of hvi.
std::string copy_of(std::string_view name) {
    std::string text;
    std::istringstream file{std::string(embedded_template(name))};
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("#include <hvi/", 0) != 0) { text += line + '\n'; }
    }
    return text;
}

std::string support(const Scheme& scheme, bool with_rounded) {
    std::vector<std::string_view> names{"state.hpp", "scalar.hpp"};
    if (with_rounded) { names.push_back("rounded.hpp"); }
    names.push_back("system.hpp");
    if (scheme.from_parameter) {
        for (const std::string_view name :
             {"arithmetic.hpp", "compensated.hpp", "pair.hpp", "series.hpp", "parameter.hpp"}) {
            names.push_back(name);
        }
    }
    if (scheme.depends_on_time) {
        for (const std::string_view name : {"arithmetic.hpp", "compensated.hpp", "clock.hpp"}) {
            names.push_back(name);
        }
    }
    std::string text;
    for (const std::string_view name : names) {
        text += (text.empty() ? "" : "\n") + copy_of(name);
    }
    return text;
}

std::string members_text(const Scheme& scheme) {
    Writer writer(1);
    writer.line("System system_;");
    if (scheme.from_parameter) { writer.line("Coefficients coefficients_;"); }
    if (scheme.depends_on_time) { writer.line("{} clock_;", clock_type(scheme)); }
    writer.line("Vector q_{{}}, p_{{}}, slope_{{}};");
    if (scheme.keeps_force) {
        writer.line("Vector force_{{}};  // dH/dq where the last step ended, at q_");
    }
    if (scheme.keeps_velocity) {
        writer.line("Vector velocity_{{}};  // dH/dp where the last step ended, at p_");
    }
    if (keeps(scheme)) { writer.line("bool known_ = false;  // whether it is kept"); }
    return writer.str();
}

}  // namespace

std::string emit_explicit(const Tableau& tableau, const Scheme& scheme,
                          const EmitOptions& options) {
    HVI_CHECK(scheme.separable);
    const std::string weights = weights_text(scheme);
    const SystemPart system = system_part(tableau, scheme, options);
    const bool rounds = are_rounded(weights) || are_rounded(system.types);
    return fill("explicit.hpp.in",
                {{"banner", banner(tableau, scheme, options)},
                 {"include", system.include},
                 {"support", support(scheme, rounds)},
                 {"purpose", system.purpose},
                 {"head", system.head},
                 {"name", system.class_name},
                 {"condition", system.condition},
                 {"types", system.types},
                 {"parameter", parameter_text(scheme)},
                 {"construct", system.construct},
                 {"alias", system.alias},
                 {"begins", begins(scheme)},
                 {"weights", weights},
                 {"fits", fits_text(scheme)},
                 {"moves", moves_text(scheme)},
                 {"ends", ends_text(scheme)},
                 {"state", system.state},
                 {"clock", clock_begins(scheme)},
                 {"status", scheme.depends_on_time ? "clock_.end(x.t, Status{})" : "{}"},
                 {"forget", keeps(scheme) ? "known_ = false;" : ""},
                 {"members", members_text(scheme)}});
}

}  // namespace hvi::gen
