// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/plan/chart_step.hpp"

namespace hvi::gen {

void check_no_rotations(const std::optional<Place>& place, const SystemProperties& system) {
    if (system.rotations == 0) { return; }
    throw MathError("with rotations a method has as many nodes as functions", place,
                    "for example --method gauss:2");
}

void set_charts(Step& step) {
    using Kind = StageNode::Kind;
    Block all{true, {}};
    for (const Kind kind : {Kind::Q, Kind::P, Kind::Lq, Kind::Lp}) {
        for (std::size_t i = 0; i < step.positions.size(); ++i) { all.nodes.push_back({kind, i}); }
    }
    step.blocks = {std::move(all)};
    step.form = ChartStep{};
    step.decisions.push_back({"rotations move in a chart at the start of the step, in which they "
                              "are curves of the method's functions",
                              "interpolation in natural charts commutes with rotations of space: "
                              "momentum maps are kept (Lemmas 5.4 and 5.5)"});
    step.decisions.push_back({"the momentum of a chart at the start is solved for as well",
                              "the chart moves with the state; to begin with the momentum of the "
                              "body makes no symplectic step"});
}

}  // namespace hvi::gen
